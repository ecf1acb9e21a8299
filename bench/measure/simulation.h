#pragma once
// A scene being simulated by an engine, with everything that belongs to the scene in time: bodies
// that follow paths, and an edit in mid-run.

#include <memory>

#include "engines/engine.h"
#include "scenes/scene.h"

namespace fettle::bench {

struct StepTime {
    double wall_ms = 0;
    double thread_ms = 0;  // on a processor: what others do to the machine counts less
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

    /// Steps and returns the time of the steps. At half of the scene's steps the topmost body is
    /// edited to move up, off the clock; throws std::runtime_error unless the next step moves it
    /// so.
    StepTime advance(int steps);
    int steps() const { return made_; }
    const Engine& engine() const { return *engine_; }
    Engine& engine() { return *engine_; }
    std::uint64_t hash() const { return hash_of(*engine_, scene_.bodies.size()); }

  private:
    StepTime timed_steps(int steps);
    void make_steps(int steps);
    StepTime edited_step();
    std::size_t topmost(bool free) const;

    const Scene& scene_;
    std::string name_;
    std::unique_ptr<Engine> engine_;
    std::vector<std::size_t> driven_;
    std::size_t arrived_ = 0;  // of the scene's arrivals
    std::vector<bool> tied_;   // by a joint
    int made_ = 0;
};

/// The steps themselves and nothing else: the function a profiler is told to look at.
[[gnu::noinline]] void measured_steps(Engine& engine, int steps);

}  // namespace fettle::bench
