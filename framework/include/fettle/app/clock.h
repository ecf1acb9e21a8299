#pragma once
// The clock: how simulation time passes. Seen in the tree as `time`.

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <fettle/app/export.h>
#include <fettle/app/frame_log.h>
#include <fettle/property/tree.h>

FETTLE_APP_BEGIN

namespace fettle::app {

/// Steps that are no longer part of the past of the running game, because it went back to an
/// earlier step and continued from there.
struct Branch {
    std::string name;
    std::int64_t fork = 0;    ///< the last step that it has in common with the present branch
    std::int64_t newest = 0;  ///< its last step
};

/// Going to other steps and branches, where there is a timeline (Timeline); otherwise empty.
struct TimelineAccess {
    std::function<void(std::int64_t step)> go_to{};
    std::function<std::vector<Branch>()> branches{};  // besides the present one
    std::function<void(const std::string&branch)> switch_to{}, forget_branch{};
    std::function<void(const std::string& branch, const std::string& name)> name_branch{};
};

struct Clock {
    // Settings that any code may write; a frame or a turn with an unusable one throws
    // (`require_usable`).
    double dt = 1.0 / 60;           // s, one fixed step
    double scale = 1;               // simulated seconds a real second
    bool paused = false;            // no steps are made
    bool step_once = false;         // one step while paused; false again after it
    std::int32_t max_steps = 5;     // steps one frame may make to catch up
    double rewind_limit = 60;       // s of the past that are kept; 0: none
    double rewind_memory = 128;     // MiB, limit of the memory for the kept past
    std::int32_t branch_limit = 4;  // branches that are kept besides the present one; 0: none

    // Kept by the loop.
    std::int64_t step = 0;           // number of fixed steps
    double now = 0;                  // s, simulation time
    double real = 0;                 // s of real time, the sum of `real_dt` of all updates
    std::int64_t frame = 0;          // number of frames
    std::int64_t dropped_steps = 0;  // steps that were skipped because the game was too slow
    double alpha = 1;                // position of drawing between the last two steps, 0 to 1
    double fps = 0;                  // frames a second, smoothed
    std::int64_t oldest = 0;         // the earliest step that one can go back to
    std::int64_t newest = 0;
    Timings timings{};  // smoothed
    FrameLog frames{};
    std::string branch = "1";  // the name of the present branch
    TimelineAccess timeline{};

    /// One fixed step passes.
    void advance();
    /// Throws Error(out_of_range) for unusable settings: a `dt` that is not a number above 0, or
    /// another number that is negative or not a number.
    void require_usable() const;

  private:
    friend class ClockPart;
    // Time is a multiple of dt from the last change of dt, so that 60 steps of 1/60 s are 1 s.
    struct Origin {
        double now = 0;
        std::int64_t step = 0;
        double dt = 0;
    };
    Origin origin_{};
};

/// Simulation time in snapshots. Settings of users are saved by value; `paused` is not part of a
/// snapshot.
class ClockPart : public property::SnapshotPart {
  public:
    explicit ClockPart(Clock& clock) : clock_(clock) {}
    std::string_view part_name() const override { return "time"; }
    property::Memory save(property::ByteWriter& to) const override;
    std::function<void()> restore(property::ByteReader& from,
                                  const property::Memory& memory) override;
    property::Memory changes() override;
    void redo(const property::Memory& changes) override;
    std::size_t size_of(const property::Memory& changes) const override;

  private:
    struct FETTLE_APP_PRIVATE State;
    State state() const;
    void set(const State& state);

    Clock& clock_;
};

/// Adds the clock to the tree as `time`, with `time.timings`. It must outlive all use by the tree.
property::Handle define_clock(property::Tree& tree, Clock& clock);

}  // namespace fettle::app

FETTLE_APP_END
