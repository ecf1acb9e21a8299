#pragma once
// The physics library without a tree as an engine, and access to its world for features that other
// engines do not have.

#include <fettle/physics/physics.h>

#include <memory>

#include "engines/engine.h"

namespace fettle::bench {

std::unique_ptr<Engine> make_fettle(const Scene& scene, physics::Solver solver, int substeps);

/// The world of an engine that `make_fettle` made.
physics::World& fettle_world(Engine& engine);

}  // namespace fettle::bench
