// Branches of the past: steps that are no longer part of the past of the running game, because it
// went back to an earlier step and continued from there.

#include <fettle/app/timeline.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include <fettle/property/error.h>
#include <fettle/property/spelling.h>

#include <time/jumps.h>
#include <time/keyframe_compression.h>

namespace fettle::app {

namespace {

constexpr std::size_t longest_branch_name = 40;  // bytes

bool is_control(unsigned char c) {
    return c < 0x20 || c == 0x7f;
}

}  // namespace

std::int64_t Timeline::Other::newest() const {
    const std::int64_t last = keyframes.back().step;
    return steps.empty() ? last : std::max(last, steps.back()->number);
}

/// The memory that it takes besides the present branch.
std::size_t Timeline::Other::memory() const {
    std::size_t sum = bytes + sizeof *this;
    for (const Keyframe& frame : keyframes)
        if (frame.step > fork) sum += frame.memory();
    return sum;
}

/// A number that no branch has had as its name.
std::string Timeline::new_branch_name() {
    for (;;) {
        std::string name = std::to_string(++last_name_);
        if (name != clock_.branch && !has_branch(name)) return name;
    }
}

/// Keeps the steps that are newer than the present one as a branch; the steps that follow get a new
/// name.
void Timeline::keep_branch() {
    if (clock_.branch_limit <= 0) {
        others_.clear();
        return;
    }
    for (Other& other : others_)
        if (other.fork > place_.here) {
            other.fork = place_.here;
            count_bytes(other);
        }
    Other left{.name = clock_.branch,
               .named = std::exchange(named_, false),
               .by_script = place_.by_script,
               .fork = place_.here,
               .keyframes = keyframes_,
               .steps = steps_,
               .tail = std::move(tail_)};
    count_bytes(left);
    clock_.branch = new_branch_name();
    others_.push_back(std::move(left));
    while (std::cmp_greater(others_.size(), clock_.branch_limit))
        drop_branch("time.branch_limit is " + std::to_string(clock_.branch_limit));
}

void Timeline::count_bytes(Other& branch) const {
    branch.bytes = branch.tail.bytes;
    for (auto each = branch.steps.rbegin();
         each != branch.steps.rend() && (*each)->number > branch.fork; ++each)
        branch.bytes += (*each)->bytes;
}

/// Drops the steps of branches that are older than the limit of the past, and branches that have no
/// later step.
void Timeline::trim_branches() {
    const std::int64_t first = oldest();
    for (Other& other : others_) {
        while (other.keyframes.size() > 1 && other.keyframes[1].step <= first) {
            other.keyframes.pop_front();
            while (!other.steps.empty() &&
                   other.steps.front()->number <= other.keyframes.front().step)
                other.steps.pop_front();
            if (other.keyframes.front().step > other.fork) count_bytes(other);
        }
    }
    std::erase_if(others_, [&](const Other& other) { return other.newest() <= first; });
}

/// A game that goes back by itself leaves branches all the time: they do not push out those that a
/// person may want to look at again.
void Timeline::drop_branch(const std::string& limit) {
    constexpr std::size_t most_remembered = 100;
    const auto rank = [](const Other& other) { return other.named ? 2 : other.by_script ? 0 : 1; };
    const auto least =
        std::min_element(others_.begin(), others_.end(),
                         [&](const Other& a, const Other& b) { return rank(a) < rank(b); });
    if (dropped_.size() == most_remembered) dropped_.pop_front();
    dropped_.emplace_back(least->name, limit);
    const bool tells = !least->by_script || !std::exchange(script_drop_told_, true);
    const std::string line = "branch \"" + least->name + "\" is dropped: " + limit +
                             (least->by_script ? " (the game goes back by itself; its further "
                                                 "branches are dropped without a line)"
                                               : "");
    others_.erase(least);
    if (tells && told_dropped_) told_dropped_(line);
}

std::vector<Branch> Timeline::branches() const {
    std::vector<Branch> all;
    for (const Other& other : others_) all.push_back({other.name, other.fork, other.newest()});
    return all;
}

bool Timeline::has_branch(const std::string& branch) const {
    return std::any_of(others_.begin(), others_.end(),
                       [&](const Other& other) { return other.name == branch; });
}

void Timeline::require_branch(const std::string& branch) const {
    if (has_branch(branch)) return;
    if (branch == clock_.branch)
        throw property::Error(property::ErrorKind::unknown_name,
                              "the branch \"" + branch + "\" is the present one");
    const auto dropped = std::find_if(dropped_.rbegin(), dropped_.rend(),
                                      [&](const auto& each) { return each.first == branch; });
    if (dropped != dropped_.rend())
        throw property::Error(property::ErrorKind::unknown_name,
                              "the branch \"" + branch + "\" was dropped: " + dropped->second);
    std::vector<std::string> names;
    for (const Other& other : others_) names.push_back(other.name);
    throw property::Error(property::ErrorKind::unknown_name,
                          "there is no branch \"" + branch + "\"" +
                              (names.empty() ? std::string(": there are no other branches")
                                             : property::suggestion(branch, names)));
}

std::vector<Timeline::Other>::iterator Timeline::other_branch(const std::string& name) {
    require_branch(name);
    return std::find_if(others_.begin(), others_.end(),
                        [&](const Other& other) { return other.name == name; });
}

void Timeline::name_branch(const std::string& branch, const std::string& name) {
    const bool present = branch == clock_.branch;
    if (!present) require_branch(branch);
    if (name.empty() || name.size() > longest_branch_name ||
        std::any_of(name.begin(), name.end(), is_control))
        throw property::Error(property::ErrorKind::bad_name,
                              "a branch needs a name of 1 to 40 bytes in one line");
    if (name != branch && (name == clock_.branch || has_branch(name)))
        throw property::Error(property::ErrorKind::bad_name,
                              "there is a branch \"" + name + "\" already");
    if (present) {
        clock_.branch = name;
        named_ = true;
    } else {
        Other& other = *other_branch(branch);
        other.name = name;
        other.named = true;
    }
}

void Timeline::forget_branch(const std::string& branch) {
    others_.erase(other_branch(branch));
}

/// The present branch becomes `other`, and `other` what the present one was.
void Timeline::exchange_with(Other& other) {
    drop_broken();
    std::swap(clock_.branch, other.name);
    std::swap(named_, other.named);
    other.by_script = tree_.cause().writer == property::Writer::script;
    std::swap(keyframes_, other.keyframes);
    std::swap(steps_, other.steps);
    std::swap(tail_, other.tail);
    edits_ = {};
    failure_.step = -1;
    bytes_.logged = bytes_.logged_since = 0;
    for (const auto& step : steps_) {
        bytes_.logged += step->bytes;
        if (step->number > keyframes_.back().step) bytes_.logged_since += step->bytes;
    }
    clock_.oldest = keyframes_.front().step;
    clock_.newest = newest();
    // The last common step of each other branch and the one that is now present.
    for (Other& each : others_) {
        if (&each != &other) {
            std::int64_t common = std::min(each.fork, other.fork);
            auto own = steps_.begin();
            for (const auto& step : each.steps) {
                while (own != steps_.end() && (*own)->number < step->number) ++own;
                if (own != steps_.end() && *own == step) common = std::max(common, step->number);
            }
            each.fork = common;
        }
        count_bytes(each);
    }
}

void Timeline::switch_to(const std::string& branch) {
    require_between_steps("the game cannot go to another branch");
    save_changes();
    const auto found = other_branch(branch);
    tree_.forget_writers_after(static_cast<std::uint64_t>(std::max<std::int64_t>(found->fork, 0)));
    exchange_with(*found);
    try {
        travel(newest());
    } catch (...) {
        // If the tree has changed, the timeline began anew.
        if (!jumps_->arrived) exchange_with(*found);
        throw;
    }
    // The former branch becomes the last in the list: it was left last.
    std::rotate(found, std::next(found), others_.end());
}

void Timeline::review_branch(const std::string& branch, std::int64_t from,
                             const std::function<void(std::int64_t step)>& visit) {
    require_between_steps("the past cannot be shown");
    save_changes();
    const Other& other = *other_branch(branch);
    auto frame = std::prev(other.keyframes.end());
    while (frame != other.keyframes.begin() && frame->step > from) --frame;
    run_in_past(*frame, [&] { repeat_steps(*frame, other.steps, from, other.newest(), visit); });
}

}  // namespace fettle::app
