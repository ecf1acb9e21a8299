#include <fettle/app/timeline.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include <time/jumps.h>
#include <time/keyframe_compression.h>

namespace fettle::app {

using property::Snapshot;

namespace {

constexpr std::int64_t min_spacing = 60, max_spacing = 480;  // steps
// If there was no room for one keyframe, try again after this time: the state may be smaller then.
constexpr std::int64_t retry_interval = 600;  // steps
// Estimated overhead of a step: containers and their memory.
constexpr std::size_t step_overhead = 256;                  // bytes
constexpr std::size_t max_history = std::size_t{64} << 20;  // bytes

/// How many steps are kept.
std::int64_t limit_of(const Clock& clock) {
    return static_cast<std::int64_t>(
        std::clamp(std::ceil(clock.rewind_limit / clock.dt), 0.0, 1e15));
}

double now() {
    const auto since = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double>(since).count();
}

}  // namespace

/// Memory for the next keyframe.
struct Timeline::Room {
    PackedBytes::Buffer buffer;
};

Timeline::Timeline(property::Tree& tree, Clock& clock, std::function<void(double)> step_modules)
    : tree_(tree),
      clock_(clock),
      step_modules_(std::move(step_modules)),
      jumps_(std::make_unique<Jumps>(tree)),
      pace_{.spacing = min_spacing} {}

Timeline::~Timeline() = default;

// --- Keeping

bool Timeline::on() const {
    return clock_.rewind_limit > 0;
}

void Timeline::clear() {
    require_between_steps("the past cannot be cleared");
    drop_all();
}

void Timeline::drop_all() {
    log_.reset();
    keyframes_.clear();
    steps_.clear();
    others_.clear();
    tail_ = edits_ = {};
    bytes_.logged = bytes_.logged_since = 0;
    pace_.spacing = min_spacing;
    clock_.oldest = clock_.newest = clock_.step;
}

/// Divides the memory limit between keyframes and history. A lower limit applies from the next
/// step.
void Timeline::share_room() {
    const auto room = static_cast<std::size_t>(clock_.rewind_memory * 1048576.0);
    if (room == bytes_.room) return;
    bytes_.room = room;
    tree_.set_history_limit(std::min(room / 4, max_history));
}

bool Timeline::memory_available() const {
    return bytes_.no_room_at < 0 || bytes_.room > bytes_.no_room ||
           clock_.step >= bytes_.no_room_at + retry_interval || clock_.step < bytes_.no_room_at;
}

void Timeline::begin_log() {
    log_ = std::make_unique<property::WriteLog>(tree_);
    log_->set_limit(bytes_.room / 8);
}

void Timeline::begin_step() {
    place_.in_step = true;
    failure_.step = -1;
    share_room();
    place_.stepping = on() && memory_available();
    if (!place_.stepping) {
        if (log_ != nullptr) drop_all();
        clock_.oldest = clock_.newest = clock_.step;
        return;
    }
    note_jump();
    if (log_ == nullptr) {
        begin_log();
        skip_changes();
    }
    log_->set_limit(bytes_.room / 8);
    if (keyframes_.empty()) {
        place_.here = clock_.step;
        take_keyframe();
    }
    pace_.begun = now();
    // A step from here replaces the later steps, which become another branch.
    if (place_.here < newest()) {
        keep_branch();
        drop_after(place_.here);
        tail_ = std::exchange(edits_, {});
    }
    // If the step fails, the edits before it are no part of it.
    if (log_->any()) note(tail_, tail_.before.emplace_back());
    open_ = {};
}

void Timeline::modules_step(double dt) {
    if (!place_.stepping) return;
    // The changes of a step that failed belong to the next step, unless the game went back in
    // between.
    open_ = std::exchange(tail_, {});
    open_.dt = dt;
    note(open_, open_.before.emplace_back());
}

void Timeline::end_step() {
    place_.in_step = false;
    if (!std::exchange(place_.stepping, false)) {
        clock_.oldest = clock_.newest = clock_.step;
        return;
    }
    open_.number = place_.here = clock_.step;
    note(open_, open_.after);
    log_->end_step();
    if (too_much(open_)) return restart();
    open_.bytes += sizeof(Step) + step_overhead;
    bytes_.logged += open_.bytes;
    bytes_.logged_since += open_.bytes;
    steps_.push_back(std::make_shared<Step>(std::move(open_)));
    pace_.worked += now() - pace_.begun;
    if (keyframe_is_due()) take_keyframe();
    trim();
    clock_.oldest = oldest();
    clock_.newest = newest();
}

void Timeline::leave_step() {
    place_.in_step = false;
    const bool broken = std::exchange(place_.stepping, false);
    if (log_ == nullptr || (!broken && failure_.step != clock_.step)) return;
    Piece& piece = tail_.before.emplace_back();
    note(tail_, piece);
    piece.broken = broken;
    failure_.pieces = tail_.before.size();
    if (too_much(tail_)) restart();
}

void Timeline::note_failure() {
    if (place_.in_step) failure_.step = clock_.step;
}

bool Timeline::go_before_failure() {
    const std::int64_t failed = std::exchange(failure_.step, -1);
    if (place_.in_step || failed < 0 || clock_.step != failed || !keeps()) return false;
    save_changes();
    if (place_.here == failed) {  // a handler failed after the modules had stepped
        bool edited = false;
        for (std::size_t i = failure_.pieces; i < tail_.before.size(); ++i)
            edited = edited || !tail_.before[i].writes.empty();
        if (edited || failed <= oldest()) return false;
        travel(failed - 1);
    } else {
        travel(place_.here);
    }
    return true;
}

void Timeline::note(Step& of, Piece& piece) {
    piece.writes = log_->take();
    piece.bytes = sizeof piece + piece.writes.memory();
    for (property::SnapshotPart* part : tree_.parts())
        if (property::Memory changes = part->changes()) {
            piece.bytes += part->size_of(changes);
            piece.changes.emplace_back(part, std::move(changes));
        }
    of.bytes += piece.bytes;
}

/// Drops what steps have written that an error ended early.
void Timeline::drop_broken() {
    std::erase_if(tail_.before, [this](const Piece& piece) {
        if (piece.broken) tail_.bytes -= piece.bytes;
        return piece.broken;
    });
}

/// Drops the changes of the parts up to now, so that the next changes begin here.
void Timeline::skip_changes() {
    for (property::SnapshotPart* part : tree_.parts()) (void)part->changes();
}

bool Timeline::too_much(const Step& step) const {
    return step.bytes > bytes_.room / 2 || step.after.writes.too_much ||
           std::any_of(step.before.begin(), step.before.end(),
                       [](const Piece& piece) { return piece.writes.too_much; });
}

/// A step that cannot be repeated ends the past: the timeline starts again here.
void Timeline::restart() {
    const std::int64_t step = clock_.step;
    drop_all();
    begin_log();
    place_.here = step;
    take_keyframe();
    trim();
    clock_.oldest = clock_.newest = step;
}

void Timeline::take_keyframe() {
    const double before = now();
    Room room = room_of_packed();
    Snapshot taken = tree_.snapshot(std::move(room.buffer.bytes));
    (void)log_->take();  // these writes are in the snapshot
    if (packer_ == nullptr) packer_ = std::make_unique<Packer>();
    Keyframe frame{.step = place_.here,
                   .payload = nullptr,
                   .memories = taken.memories(),
                   .held = taken.held(),
                   .history = tree_.history_bytes(),
                   .forgotten = forgotten()};
    room.buffer.bytes = std::move(taken).release_payload();
    // The first state is often before any contact, so later states need more memory.
    const std::size_t later = keyframes_.empty() ? 3 * room.buffer.bytes.size() : 0;
    frame.payload =
        std::make_shared<PackedBytes>(std::move(room.buffer), later <= bytes_.room / 4 ? later : 0);
    packer_->pack(frame.payload);
    keyframes_.push_back(std::move(frame));
    bytes_.logged_since = 0;
    pace_.cost = now() - before;
    pace_.worked = 0;
}

/// Returns the memory of the latest packed state for the next keyframe and frees that of the
/// others.
Timeline::Room Timeline::room_of_packed() {
    Room found;
    for (Keyframe& frame : keyframes_)
        if (auto plain = frame.payload->spare_buffer()) found.buffer = std::move(*plain);
    for (Other& other : others_)
        for (Keyframe& frame : other.keyframes) (void)frame.payload->spare_buffer();
    // Memory that is far larger than the current states is not used again.
    if (!keyframes_.empty() && found.buffer.touched / 4 > keyframes_.back().payload->plain_size())
        found = {};
    return found;
}

/// A keyframe is due often enough to reach any step quickly, but not so often that it slows the
/// game. It is also due after many writes, because then older log entries can be dropped.
bool Timeline::keyframe_is_due() const {
    const Keyframe& last = keyframes_.back();
    const std::int64_t since = place_.here - last.step;
    return since >= max_spacing ||
           (since >= pace_.spacing && pace_.worked * pace_.share >= pace_.cost) ||
           bytes_.logged_since > std::max(bytes_.room / 8, last.payload->plain_size());
}

// Handles a snapshot that other code has restored. The next steps start from there; steps before
// the step of the snapshot can still be restored.
void Timeline::note_jump() {
    if (!std::exchange(jumps_->jumped, false) || log_ == nullptr) return;
    const std::int64_t step = clock_.step;
    if (keyframes_.empty() || step < oldest() || step > newest())
        drop_all();
    else
        drop_after(step - 1);
    if (log_ == nullptr) begin_log();
    tail_ = edits_ = {};
    failure_.step = -1;
    place_.here = step;
    take_keyframe();
    keyframes_.back().jumped_to = true;
}

void Timeline::drop(Steps::iterator step) {
    bytes_.logged -= (*step)->bytes;
    steps_.erase(step);
}

void Timeline::drop_after(std::int64_t step) {
    while (!keyframes_.empty() && keyframes_.back().step > step) keyframes_.pop_back();
    while (!steps_.empty() && steps_.back()->number > step) drop(std::prev(steps_.end()));
    bytes_.logged_since = 0;
    for (auto each = steps_.rbegin();
         each != steps_.rend() && (keyframes_.empty() || (*each)->number > keyframes_.back().step);
         ++each)
        bytes_.logged_since += (*each)->bytes;
}

void Timeline::drop_oldest() {
    keyframes_.pop_front();
    while (!steps_.empty() && steps_.front()->number <= keyframes_.front().step)
        drop(steps_.begin());
}

/// Halves the number of keyframes. The kept time stays the same, but going to a step takes longer.
void Timeline::thin_out() {
    pace_.spacing *= 2;
    std::deque<Keyframe> kept;
    for (Keyframe& frame : keyframes_)
        if (kept.empty() || frame.jumped_to || frame.step - kept.back().step >= pace_.spacing)
            kept.push_back(std::move(frame));
    keyframes_ = std::move(kept);
}

void Timeline::trim() {
    while (keyframes_.size() > 1 && keyframes_[1].step <= newest() - limit_of(clock_))
        drop_oldest();
    trim_branches();
    const std::size_t room = bytes_.room - std::min(bytes_.room, tree_.history_bytes());
    while (!others_.empty() && memory() > room) drop_branch("time.rewind_memory is full");
    while (keyframes_.size() > 1 && memory() > room) {
        if (pace_.spacing < max_spacing && keyframes_.size() > 2 && bytes_.logged < room / 2)
            thin_out();
        else
            drop_oldest();
    }
    bytes_.no_room_at = -1;
    if (memory() <= room) return;
    bytes_.no_room_at = clock_.step;
    bytes_.no_room = bytes_.room;
    drop_all();
}

/// Keyframes are made when there is time for them. The steps that can be reached must not depend on
/// that, so steps older than the limit are not offered, even if a keyframe is before them, also
/// after going back.
std::int64_t Timeline::oldest() const {
    if (keyframes_.empty()) return clock_.step;
    const std::int64_t offered = std::max(newest() - limit_of(clock_), clock_.oldest);
    return std::max(keyframes_.front().step, std::min(offered, place_.here));
}

Timeline::KeptSteps Timeline::kept_steps() const {
    if (!jumps_->jumped) return {clock_.oldest, clock_.newest};
    // The same as `note_jump` will do: later steps are dropped, or all, if the step is not one of
    // them.
    const std::int64_t step = clock_.step;
    const bool is_known =
        log_ != nullptr && !keyframes_.empty() && step >= oldest() && step <= newest();
    if (!is_known) return {step, step};
    const std::int64_t offered = std::max(step - limit_of(clock_), clock_.oldest);
    return {std::max(keyframes_.front().step, std::min(offered, step)), step};
}

std::int64_t Timeline::newest() const {
    if (keyframes_.empty()) return clock_.step;
    // After a jump, the step of the last keyframe may have no entry in the log.
    const std::int64_t last = keyframes_.back().step;
    return steps_.empty() ? last : std::max(last, steps_.back()->number);
}

std::size_t Timeline::Keyframe::memory() const {
    return payload->memory() + held + sizeof *this + step_overhead;
}

/// Total bytes of edits that the history has dropped.
std::size_t Timeline::forgotten() const {
    return tree_.history_bytes_ever() - tree_.history_bytes();
}

std::size_t Timeline::memory() const {
    std::size_t sum =
        bytes_.logged + tail_.bytes + edits_.bytes + (log_ != nullptr ? log_->memory() : 0);
    for (const Keyframe& frame : keyframes_) sum += frame.memory();
    for (const Other& other : others_) sum += other.memory();
    if (keyframes_.empty()) return sum;
    // The part of the history at the first keyframe that is kept only for the timeline.
    const Keyframe& first = keyframes_.front();
    const std::size_t since = forgotten();
    return sum + std::min(first.history, since - std::min(since, first.forgotten));
}

}  // namespace fettle::app
