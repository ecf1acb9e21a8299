#include <fettle/app/timeline.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include <fettle/property/error.h>

#include "packing.h"

namespace fettle::app {

using property::LoggedWrites;
using property::Snapshot;

namespace {

constexpr std::int64_t least_spacing = 60, most_spacing = 480;  // steps

double now() {
    const auto since = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double>(since).count();
}

}  // namespace

/// Snapshots that somebody else restores: time has jumped.
class Timeline::Jumps : public property::Observer {
  public:
    explicit Jumps(property::Tree& tree) : tree_(tree) { tree_.observe(*this); }
    ~Jumps() override { tree_.unobserve(*this); }
    void restored() override { jumped = !travelling; }
    void wrote_plain(const property::PlainWrites&) override {
        // not one by one
    }

    bool jumped = false;
    bool travelling = false;

  private:
    property::Tree& tree_;
};

Timeline::Timeline(property::Tree& tree, Clock& clock, std::function<void(double)> step_modules)
    : tree_(tree),
      clock_(clock),
      step_modules_(std::move(step_modules)),
      jumps_(std::make_unique<Jumps>(tree)),
      spacing_(least_spacing) {}

Timeline::~Timeline() = default;

// --- Keeping
// ----------------------------------------------------------------------------------------------------------

bool Timeline::on() const {
    return clock_.rewind_limit > 0;
}

void Timeline::clear() {
    log_.reset();
    keyframes_.clear();
    steps_.clear();
    tail_ = {};
    logged_ = 0;
    spacing_ = least_spacing;
    clock_.oldest = clock_.newest = clock_.step;
}

void Timeline::begin_step() {
    stepping_ = on();
    if (!stepping_) {
        if (log_ != nullptr) clear();
        clock_.oldest = clock_.newest = clock_.step;
        return;
    }
    note_jump();
    if (log_ == nullptr) {
        log_ = std::make_unique<property::WriteLog>(tree_);
        Step begun;
        note_changes(begun);
    }
    if (keyframes_.empty()) {
        here_ = clock_.step;
        take_keyframe();
    }
    begun_ = now();
    // From here on this is what has been.
    if (here_ < newest()) {
        drop_after(here_);
        tail_ = {};
    }
    open_ = {};
}

void Timeline::modules_step(double dt) {
    if (!stepping_) return;
    open_.dt = dt;
    open_.before = std::move(tail_.before);
    open_.changes = std::move(tail_.changes);
    tail_ = {};
    open_.before.push_back(log_->take());
}

void Timeline::end_step() {
    if (!std::exchange(stepping_, false)) return;
    open_.number = here_ = clock_.step;
    open_.after = log_->take();
    note_changes(open_);
    if (too_much(open_)) return begin_anew();
    logged_ += open_.after.memory();
    for (const LoggedWrites& piece : open_.before) logged_ += piece.memory();
    steps_.push_back(std::move(open_));
    worked_ += now() - begun_;
    if (keyframe_is_due()) take_keyframe();
    trim();
    clock_.oldest = oldest();
    clock_.newest = newest();
}

void Timeline::note_changes(Step& of) {
    for (property::SnapshotPart* part : tree_.parts())
        if (property::Memory changes = part->changes())
            of.changes.emplace_back(part, std::move(changes));
}

bool Timeline::too_much(const Step& step) {
    return step.after.too_much || std::any_of(step.before.begin(), step.before.end(),
                                              [](const LoggedWrites& w) { return w.too_much; });
}

/// What cannot be done again cannot be gone back over.
void Timeline::begin_anew() {
    const std::int64_t step = here_;
    clear();
    log_ = std::make_unique<property::WriteLog>(tree_);
    here_ = step;
    take_keyframe();
    clock_.oldest = clock_.newest = step;
}

void Timeline::take_keyframe() {
    const double before = now();
    Snapshot taken = tree_.snapshot(memory_of_packed());
    (void)log_->take();  // it is in the snapshot
    if (packer_ == nullptr) packer_ = std::make_unique<Packer>();
    Keyframe frame{here_, nullptr, taken.memories()};
    frame.payload = std::make_shared<PackedBytes>(std::move(taken).take_payload());
    packer_->pack(frame.payload);
    keyframes_.push_back(std::move(frame));
    cost_ = now() - before;
    worked_ = 0;
}

/// Of a state that is packed by now, for the next one to be written to; others go back to the
/// system.
std::vector<std::byte> Timeline::memory_of_packed() {
    std::vector<std::byte> found;
    for (Keyframe& frame : keyframes_)
        if (auto plain = frame.payload->settle()) found = std::move(*plain);
    return found;
}

/// Often enough to be quick at any moment, and not so often that the game is slower for it.
bool Timeline::keyframe_is_due() const {
    const std::int64_t since = here_ - keyframes_.back().step;
    return since >= most_spacing || (since >= spacing_ && worked_ * share_ >= cost_);
}

// A snapshot was restored by somebody else. What comes next starts from there; what was before the
// step it was taken at may still be gone back to.
void Timeline::note_jump() {
    if (!std::exchange(jumps_->jumped, false) || log_ == nullptr) return;
    const std::int64_t step = clock_.step;
    if (keyframes_.empty() || step < oldest() || step > newest())
        clear();
    else
        drop_after(step - 1);
    if (log_ == nullptr) log_ = std::make_unique<property::WriteLog>(tree_);
    tail_ = {};
    here_ = step;
    take_keyframe();
}

void Timeline::drop_after(std::int64_t step) {
    while (!keyframes_.empty() && keyframes_.back().step > step) keyframes_.pop_back();
    while (!steps_.empty() && steps_.back().number > step) {
        logged_ -= steps_.back().after.memory();
        for (const LoggedWrites& piece : steps_.back().before) logged_ -= piece.memory();
        steps_.pop_back();
    }
}

void Timeline::drop_oldest() {
    keyframes_.pop_front();
    while (!steps_.empty() && steps_.front().number <= keyframes_.front().step) {
        logged_ -= steps_.front().after.memory();
        for (const LoggedWrites& piece : steps_.front().before) logged_ -= piece.memory();
        steps_.pop_front();
    }
}

/// Half as many keyframes: going somewhere takes longer, and the past is as long.
void Timeline::thin_out() {
    spacing_ *= 2;
    std::deque<Keyframe> kept;
    for (Keyframe& frame : keyframes_)
        if (kept.empty() || frame.step - kept.back().step >= spacing_)
            kept.push_back(std::move(frame));
    keyframes_ = std::move(kept);
}

void Timeline::trim() {
    const auto limit = static_cast<std::int64_t>(std::ceil(clock_.rewind_limit / clock_.dt));
    while (keyframes_.size() > 1 && keyframes_[1].step <= newest() - limit) drop_oldest();
    const auto room = static_cast<std::size_t>(clock_.rewind_memory * 1048576.0);
    // The latest keyframe is not packed yet. Where it is much of the room, it does not count: what
    // it is going to be is not known.
    const auto spared = [&] {
        const std::size_t latest = keyframes_.back().payload->size();
        return latest > room / 4 ? latest : 0;
    };
    while (keyframes_.size() > 2 && memory() - spared() > room) {
        if (spacing_ < most_spacing && logged_ < room / 2)
            thin_out();
        else
            drop_oldest();
    }
}

std::int64_t Timeline::oldest() const {
    return keyframes_.empty() ? clock_.step : keyframes_.front().step;
}

std::int64_t Timeline::newest() const {
    if (!steps_.empty()) return steps_.back().number;
    return keyframes_.empty() ? clock_.step : keyframes_.back().step;
}

std::size_t Timeline::memory() const {
    std::size_t sum = logged_;
    for (const Keyframe& frame : keyframes_) sum += frame.payload->size();
    return sum + steps_.size() * (sizeof(Step) + 512);
}

// --- Travelling
// -------------------------------------------------------------------------------------------------------

void Timeline::rewind(double seconds) {
    const double steps = std::min(std::round(seconds / clock_.dt), 1e15);
    go_to(std::max(oldest(), clock_.step - static_cast<std::int64_t>(steps)));
}

void Timeline::redo_writes(const Step& step) {
    for (const LoggedWrites& piece : step.before) log_->play(piece);
    for (const auto& [part, changes] : step.changes) part->redo(changes);
}

void Timeline::redo(const Step& step) {
    for (const LoggedWrites& piece : step.before) log_->play(piece);
    tree_.set_step(static_cast<std::uint64_t>(step.number));
    step_modules_(step.dt);
    log_->play(step.after);
    for (const auto& [part, changes] : step.changes) part->redo(changes);
}

void Timeline::go_to(std::int64_t step) {
    note_jump();
    if (log_ != nullptr && here_ == newest()) {
        tail_.before.push_back(log_->take());
        note_changes(tail_);
        if (too_much(tail_)) begin_anew();
    }
    if (log_ == nullptr || step < oldest() || step > newest())
        throw property::Error(
            property::ErrorKind::out_of_range,
            log_ == nullptr ? "there is no past to go to: no step was made, or time.rewind_limit "
                              "is 0"
                            : "step " + std::to_string(step) + ": the past is kept from step " +
                                  std::to_string(oldest()) + " to " + std::to_string(newest()));
    const auto frame =
        std::prev(std::upper_bound(keyframes_.begin(), keyframes_.end(), step,
                                   [](std::int64_t s, const Keyframe& k) { return s < k.step; }));
    const Snapshot from(frame->payload->payload(), frame->memories);
    jumps_->travelling = true;
    struct Arrive {
        bool& travelling;
        ~Arrive() { travelling = false; }
    } arrive{jumps_->travelling};
    tree_.restore(from, [&] {
        for (const Step& each : steps_)
            if (each.number > frame->step && each.number <= step) redo(each);
        if (step == newest()) redo_writes(tail_);
    });
    here_ = step;
    clock_.step = step;
    Step arrived;
    note_changes(arrived);
}

}  // namespace fettle::app
