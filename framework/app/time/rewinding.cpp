// Going to another step of the past, looking at the past, and repeating it differently.

#include <fettle/app/timeline.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <string>

#include <fettle/property/error.h>

#include <time/jumps.h>
#include <time/keyframe_compression.h>

namespace fettle::app {

using property::Snapshot;

void Timeline::require(std::int64_t step) const {
    if (!keeps())
        throw property::Error(property::ErrorKind::out_of_range,
                              "there is no past to go to: no step was made, time.rewind_limit is "
                              "0, or time.rewind_memory is too little for one state");
    if (step < oldest() || step > newest())
        throw property::Error(property::ErrorKind::out_of_range,
                              "step " + std::to_string(step) + ": the past is kept from step " +
                                  std::to_string(oldest()) + " to " + std::to_string(newest()));
}

void Timeline::require_between_steps(const char* what) const {
    if (place_.in_step || jumps_->travelling)
        throw property::Error(
            property::ErrorKind::bad_structure,
            std::string(what) +
                (place_.in_step ? " in the middle of a step" : " while time travels") +
                ": wait for the next barrier between steps");
}

void Timeline::go_to(std::int64_t step) {
    require_between_steps("the game cannot go back in time");
    save_changes();
    require(step);
    travel(step);
}

void Timeline::go_near(std::int64_t step) {
    require_between_steps("the game cannot go back in time");
    save_changes();
    if (keeps()) travel(std::clamp(step, oldest(), newest()));
}

void Timeline::rewind(double seconds) {
    require_between_steps("the game cannot go back in time");
    clock_.require_usable();
    if (std::isnan(seconds))
        throw property::Error(property::ErrorKind::out_of_range,
                              "rewind: nan: expected a time in seconds");
    save_changes();
    const double steps = std::clamp(std::round(seconds / clock_.dt), -1e15, 1e15);
    if (!keeps()) return;
    const std::int64_t to = clock_.step - static_cast<std::int64_t>(steps);
    travel(std::clamp(to, oldest(), newest()));
}

/// The keyframe from which the steps from `from` on are repeated; a later one if time jumped
/// meanwhile, because the steps before a jump do not lead to the present.
const Timeline::Keyframe& Timeline::start_of(std::int64_t from) const {
    const std::int64_t here = place_.here;
    auto frame = std::prev(keyframes_.end());
    while (frame != keyframes_.begin() && (frame->step > here || frame->step > from) &&
           !(frame->step <= here && frame->jumped_to))
        --frame;
    return *frame;
}

void Timeline::review(std::int64_t from, const std::function<void(std::int64_t step)>& visit) {
    require_between_steps("the past cannot be shown");
    save_changes();
    if (!keeps()) return;
    const Keyframe& frame = start_of(from);
    replay(frame, place_.here, [&](std::int64_t step) {
        if (step >= from) visit(step);
    });
}

void Timeline::review(std::int64_t from, std::int64_t to,
                      const std::function<void(std::int64_t step)>& visit) {
    if (to <= place_.here)
        return review(from, [&](std::int64_t step) {
            if (step <= to) visit(step);
        });
    require_between_steps("the past cannot be shown");
    save_changes();
    if (!keeps()) return;
    const Keyframe& frame = start_of(from);
    for (const Keyframe& each : keyframes_)
        if (each.step > place_.here && each.jumped_to) to = std::min(to, each.step - 1);
    run_in_past(frame, [&] { repeat_steps(frame, steps_, from, to, visit); });
}

void Timeline::repeat_with(std::int64_t from, const std::function<void()>& change,
                           const std::function<void(std::int64_t step)>& visit) {
    require_between_steps("the past cannot be shown");
    save_changes();
    require(from);
    const std::int64_t here = place_.here;
    const Keyframe& frame = start_of(from);
    from = std::max(from, frame.step);
    run_in_past(frame, [&] {
        for (const auto& each : steps_)
            if (each->number > frame.step && each->number <= from) redo(*each);
        change();
        visit(from);
        for (const auto& each : steps_) {
            if (each->number <= from || each->number > here) continue;
            redo(*each);
            visit(each->number);
        }
    });
}

/// Restores a keyframe, calls `repeat`, and restores the state in which the tree was, also if
/// `repeat` throws; then throws its exception.
void Timeline::run_in_past(const Keyframe& frame, const std::function<void()>& repeat) {
    const std::int64_t here = place_.here;
    auto back = std::prev(keyframes_.end());
    while (back != keyframes_.begin() && back->step > here) --back;
    std::exception_ptr problem;
    {
        const Travelling travelling(*jumps_);
        tree_.restore(Snapshot(frame.payload->payload(), frame.memories), [&] {
            try {
                repeat();
            } catch (...) {
                problem = std::current_exception();
            }
        });
    }
    replay(*back, here, {});
    if (problem) std::rethrow_exception(problem);
}

/// From the state of a keyframe to that after the step `to`. `visit`, which may be empty, is called
/// after each step from `from` on, of which that of the keyframe may be the first.
void Timeline::repeat_steps(const Keyframe& frame, const Steps& steps, std::int64_t from,
                            std::int64_t to, const std::function<void(std::int64_t step)>& visit) {
    if (visit && frame.step >= from) visit(frame.step);
    for (const auto& each : steps) {
        if (each->number <= frame.step || each->number > to) continue;
        redo(*each);
        if (visit && each->number >= from) visit(each->number);
    }
}

void Timeline::redo(const Piece& piece) {
    log_->play(piece.writes);
    for (const auto& [part, changes] : piece.changes) part->redo(changes);
}

/// The changes before the modules are made first: functions that the modules call during the step,
/// such as `accept`, see the time and random numbers of that step.
void Timeline::redo(const Step& step) {
    for (const Piece& piece : step.before) redo(piece);
    tree_.set_step(static_cast<std::uint64_t>(step.number));
    step_modules_(step.dt);
    redo(step.after);
}

/// Saves the changes since the step that the tree is at, so that they can be restored later.
void Timeline::save_changes() {
    note_jump();
    if (log_ == nullptr) return;
    Step& since = place_.here == newest() ? tail_ : edits_;
    // Time and random numbers after a step that failed are those of that step.
    const bool failed = std::ranges::any_of(tail_.before, &Piece::broken);
    note(since, since.before.emplace_back());
    if (failed) since.before.back().changes.clear();
    if (too_much(since)) restart();
}

void Timeline::travel(std::int64_t step) {
    edits_ = {};
    drop_broken();
    failure_.step = -1;
    const auto frame =
        std::prev(std::upper_bound(keyframes_.begin(), keyframes_.end(), step,
                                   [](std::int64_t s, const Keyframe& k) { return s < k.step; }));
    replay(*frame, step, {});
    place_.returned = step < newest();
    place_.by_script = tree_.cause().writer == property::Writer::script;
}

/// Restores the keyframe and repeats the steps after it up to `step`. Calls `visit`, unless it is
/// empty, for the keyframe and after each step.
void Timeline::replay(const Keyframe& frame, std::int64_t step,
                      const std::function<void(std::int64_t)>& visit) {
    const Snapshot from(frame.payload->payload(), frame.memories);
    const Travelling travelling(*jumps_);
    try {
        tree_.restore(from, [&] {
            repeat_steps(frame, steps_, frame.step, step, visit);
            if (step != newest()) {
                for (const Piece& piece : edits_.before) redo(piece);
                return;
            }
            for (const Piece& piece : tail_.before) redo(piece);
        });
    } catch (...) {
        // The tree has changed and its state is unknown; without `arrived` nothing has changed.
        if (jumps_->arrived) restart();
        throw;
    }
    place_.here = step;
    clock_.step = step;
    skip_changes();
}

}  // namespace fettle::app
