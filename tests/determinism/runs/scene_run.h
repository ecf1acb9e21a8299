#pragma once
// The ten benchmark scenes, shortened so that they end when most of their bodies touch something.

#include <fettle/physics/physics.h>

#include <cstdint>
#include <functional>
#include <span>
#include <string_view>

namespace fettle::scene_run {

struct ShortScene {
    std::string_view name;
    int steps;
};
std::span<const ShortScene> short_scenes();
/// A hundred boxes and circles, for the slow solvers.
inline constexpr ShortScene small_crowd = {"small_crowd", 90};

struct RunOptions {
    physics::Solver solver = physics::Solver::soft_step;
    int simd_width = 0;  ///< 0: the widest of the machine
    /// Called in the middle of the run; may save, change and restore the world.
    std::function<void(physics::World&)> in_the_middle{};
    /// Called after each step.
    std::function<void(physics::World&)> after_step{};
    int threads = 1;
    int times = 0;  ///< multiples of the length in the benchmark; 0: the length of the short scene
};

/// The hash of all bodies at the end of a scene.
std::uint64_t run_scene(const ShortScene& scene, const RunOptions& options = {});

}  // namespace fettle::scene_run
