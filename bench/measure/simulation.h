#pragma once
// A running simulation of a scene in an engine, including events in time: bodies that follow paths,
// arriving groups, and an edit in the middle.

#include <memory>

#include "engines/engine.h"
#include "scenes/scene.h"

namespace fettle::bench {

struct StepTime {
    double wall_ms = 0;
    double thread_ms = 0;  // processor time, which is less sensitive to other load
    StepTime& operator+=(const StepTime& other) {
        wall_ms += other.wall_ms;
        thread_ms += other.thread_ms;
        return *this;
    }
};

class Simulation {
  public:
    /// `scene` must outlive it.
    Simulation(const Scene& scene, const EngineKind& kind);
    Simulation(const Scene& scene, std::string name, std::unique_ptr<Engine> engine);

    /// Makes steps and returns their time. After half of the scene's steps, the velocity of the
    /// topmost body is edited, which is not timed: 1 m/s upwards, or downwards if the next step
    /// does not move the body up. If neither moves it, the next lower body is tried, so more steps
    /// than `steps` may be made. Throws std::runtime_error if no body moves. Scenes with groups
    /// have no edit.
    StepTime advance(int steps);
    int steps() const { return steps_; }
    const Engine& engine() const { return *engine_; }
    Engine& engine() { return *engine_; }
    std::uint64_t hash() const { return hash_of(*engine_, scene_.bodies.size()); }

  private:
    StepTime timed_steps(int steps);
    void make_steps(int steps);
    StepTime edited_step();
    /// The highest dynamic body lower than `below` (m), without joints if `free`; the number of
    /// bodies if there is none.
    std::size_t topmost(bool free, float below) const;

    const Scene& scene_;
    std::string name_;
    std::unique_ptr<Engine> engine_;
    std::vector<std::size_t> driven_;
    std::size_t arrived_ = 0;      // number of arrivals so far
    std::vector<bool> has_joint_;  // whether a joint holds the body
    int steps_ = 0;
};

/// Makes the steps and nothing else: profilers measure this function.
[[gnu::noinline]] void measured_steps(Engine& engine, int steps);

}  // namespace fettle::bench
