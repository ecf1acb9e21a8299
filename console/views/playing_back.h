#pragma once
// Playing back: the game goes through stored steps in real time.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>

#include <observed/game_time.h>

namespace fettle::console {

class PlayingBack {
  public:
    using GoTo = std::function<void(std::int64_t step)>;

    PlayingBack(property::Tree& tree, GoTo go_to) : tree_(tree), go_to_(std::move(go_to)) {}

    /// Plays the last seconds up to the newest step; in the past, the steps after the present one.
    /// At the newest step the game goes on, unless it was paused before. Begins with the next
    /// `play_on`, so that a command that calls this function changes nothing itself.
    /// Returns what is played, for a person who does not see it.
    std::string request(const GameTimes& now, double seconds);
    /// Call before each frame. An edit by a person ends it, because going to the next step would
    /// take the edit back: then returns true. `drags`: such an edit is under way.
    bool play_on(const GameTimes& now, bool drags);
    void stop();
    bool is_running() const { return playing_ || requested_; }

  private:
    static std::int64_t first_step(const GameTimes& now, double seconds);
    void begin(const GameTimes& now);

    property::Tree& tree_;
    GoTo go_to_;
    std::optional<double> requested_;  // seconds: begins with the next frame
    bool playing_ = false;
    bool goes_on_ = false;    // the game ran at the beginning
    std::size_t edited_ = 0;  // bytes of all edits at the beginning
    double real_ = 0;         // real time at the last `play_on`, s
    double played_to_ = 0;    // step, with the part of the next one
};

}  // namespace fettle::console
