#include <views/playing_back.h>

#include <algorithm>
#include <cmath>

namespace fettle::console {

std::string PlayingBack::request(const GameTimes& now, double seconds) {
    if (now.newest <= now.oldest) return "there is no past to play";
    requested_ = seconds;
    return "the window plays steps " + std::to_string(first_step(now, seconds)) + " to " +
           std::to_string(now.newest) +
           (now.paused ? "; then the game is paused, as it was" : "; then the game goes on") +
           ". An edit meanwhile ends it";
}

std::int64_t PlayingBack::first_step(const GameTimes& now, double seconds) {
    if (now.in_past()) return now.step;
    const double steps = std::min(seconds / now.dt, static_cast<double>(now.newest));
    return std::max(now.oldest, now.newest - static_cast<std::int64_t>(std::llround(steps)));
}

void PlayingBack::begin(const GameTimes& now) {
    const std::int64_t from = first_step(now, *std::exchange(requested_, std::nullopt));
    playing_ = true;
    goes_on_ = !now.paused;
    played_to_ = static_cast<double>(from);
    edited_ = tree_.history_bytes_ever();
    go_to_(from);
}

bool PlayingBack::play_on(const GameTimes& now, bool drags) {
    const property::Value real = time_value(tree_, "real");
    const double now_real = real.is(property::Type::number) ? real.number() : 0;
    const double seconds = now_real - std::exchange(real_, now_real);
    if (requested_) {
        begin(now);
    } else if (playing_ && !now.paused) {
        stop();
    } else if (playing_ && (drags || tree_.history_bytes_ever() != edited_)) {
        stop();
        return true;
    } else if (playing_ && played_to_ < static_cast<double>(now.newest)) {
        played_to_ =
            std::min(played_to_ + std::max(0.0, seconds) / now.dt, static_cast<double>(now.newest));
        go_to_(static_cast<std::int64_t>(played_to_));
    } else if (playing_ && !now.in_past()) {  // the last step is shown from the next barrier on
        stop();
        if (goes_on_) set_time_flag(tree_, "paused", false);
    }
    return false;
}

void PlayingBack::stop() {
    playing_ = false;
    requested_.reset();
}

}  // namespace fettle::console
