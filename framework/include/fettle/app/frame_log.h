#pragma once
// Where the time of the last frames went, frame by frame.

#include <cstddef>
#include <cstdint>
#include <deque>

#include <fettle/app/export.h>

FETTLE_APP_BEGIN

namespace fettle::app {

/// Duration of the parts of a frame, in milliseconds. In the tree, as `time.timings`, smoothed over
/// about half a second.
struct Timings {
    double input = 0;     // delivering input to the game
    double update = 0;    // the game's update(dt)
    double scripts = 0;   // timers, coroutines and step(dt)
    double modules = 0;   // modules' steps and reports: the physics
    double handlers = 0;  // barriers: watchers and handlers of events
    double draw = 0;      // drawing, with layers
    double wait = 0;      // the rest: waiting for the screen, reading events of the window
    double frame = 0;     // the whole frame
    /// The sum of the parts without `wait`.
    double work() const { return input + update + scripts + modules + handlers + draw; }
};

struct FrameTimes {
    Timings ms{};
    std::int64_t frame = 0;  // `time.frame`
    std::int64_t step = 0;   // `time.step` at its end
};

/// The last frames. While the game is paused, frames without a step are not added, so the frames
/// from before the pause stay for inspection.
class FrameLog {
  public:
    static constexpr std::size_t most = 300;

    const std::deque<FrameTimes>& frames() const { return frames_; }
    void add(const FrameTimes& times);
    /// Adds a time of drawing to the newest frame; does nothing if that frame is complete.
    void add_drawing(double ms);
    /// Sets the duration of the whole newest frame, and `wait` to what its parts leave of it.
    /// Returns that frame; null if it was complete already.
    const FrameTimes* complete(double ms);

  private:
    std::deque<FrameTimes> frames_;
    bool open_ = false;  // the newest frame is not complete
};

}  // namespace fettle::app

FETTLE_APP_END
