#pragma once
// Draws many worlds, runs them, and minimizes those that fail.

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "wild/plan_run.h"

namespace fettle::bench::wild {

struct SurveyOptions {
    std::uint64_t seed = 1;  // of the first world; the next has the next seed
    int count = 200;
    double seconds = 0;  // of wall time, after which no further world begins; 0: no limit
    int size = 1;        // of `random_world`
    std::vector<std::string> invariants;  // empty: all
    bool box2d = false;                   // whether worlds are tried in Box2D as well
    int minimized = 3;                    // findings of each invariant that are minimized
};

struct Found {
    std::uint64_t seed = 0;
    Finding finding;
    bool peer_ran = false;    // whether Box2D can represent the world
    bool peer_holds = false;  // whether Box2D keeps the invariant in it
    std::string minimized;    // C++; empty if it was not minimized
};

struct Survey {
    int worlds = 0;
    int peer_worlds = 0;
    long long steps = 0;
    double seconds = 0;
    std::vector<Found> found;
    std::vector<Finding> peer_findings;
};

struct Listener {
    std::function<void(std::uint64_t seed, std::size_t found)> begins = {};  // before each world
    std::function<void(const Found&)> finds = {};  // at once, so that a crash loses nothing
};
Survey survey(const SurveyOptions& options, const Listener& listener = {});

/// Runs a plan in the library and finds which of these invariants it violates. `compare`: also runs
/// it in other ways that must have the same result (invariant `same`).
PlanRun try_in_fettle(const WorldPlan& plan, std::span<const Invariant> watched, bool compare);

}  // namespace fettle::bench::wild
