#pragma once
// Invariants: statements that are true after each step of any world.

#include <algorithm>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "wild/plans/running_world.h"

namespace fettle::bench::wild {

struct Finding {
    std::string invariant;
    int step = 0;
    std::string what;  // one line with the bodies and the figures
};

/// One step, with the bodies before and after it.
struct Moment {
    const WorldPlan& plan;  // its gravity, sub-steps and settings of joints are the present ones
    int step = 0;
    float dt = 0;
    bool edited = false;  // something was made or edited before this step
    const std::vector<bool>&
        edited_bodies;                   // true: shape, pose or kind was edited before this step
    const std::vector<BodyNow>& before;  // after these edits
    const std::vector<BodyNow>& after;
    World* world = nullptr;  // of the library; null for another engine

    /// Length of a sub-step, s. Long steps of the library have more of them.
    float substep() const {
        return dt / float(world != nullptr ? world->last_substeps() : plan.def.substeps);
    }
    /// Joints act as springs of at least this rate, Hz.
    double joint_hertz() const { return std::min(60.0, 0.25 / double(substep())); }
    bool is_last() const { return step + 1 == plan.steps; }
};

/// Watches one invariant in one run.
class Check {
  public:
    Check() = default;
    Check(const Check&) = delete;
    Check& operator=(const Check&) = delete;
    virtual ~Check() = default;
    /// Describes the violation; nullopt if the invariant holds.
    virtual std::optional<std::string> violation(const Moment& moment) = 0;
};

struct Invariant {
    std::string name;
    std::function<std::unique_ptr<Check>(const WorldPlan& plan)> make_check;
};

/// All invariants except the comparison of runs (same_runs.h).
std::span<const Invariant> invariants();

std::unique_ptr<Check> check_finite(const WorldPlan& plan);
std::unique_ptr<Check> check_through(const WorldPlan& plan);
std::unique_ptr<Check> check_bullets(const WorldPlan& plan);
std::unique_ptr<Check> check_frozen(const WorldPlan& plan);
std::unique_ptr<Check> check_energy(const WorldPlan& plan);
std::unique_ptr<Check> check_momentum(const WorldPlan& plan);
std::unique_ptr<Check> check_speed(const WorldPlan& plan);
std::unique_ptr<Check> check_joints(const WorldPlan& plan);
std::unique_ptr<Check> check_events(const WorldPlan& plan);
std::unique_ptr<Check> check_sensors(const WorldPlan& plan);
std::unique_ptr<Check> check_rest(const WorldPlan& plan);
std::unique_ptr<Check> check_consistent(const WorldPlan& plan);

}  // namespace fettle::bench::wild
