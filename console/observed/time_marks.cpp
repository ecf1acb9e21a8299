#include <observed/time_marks.h>

#include <algorithm>

#include <fettle/property/error.h>

#include <observed/game_time.h>

namespace fettle::console {

void TimeMarks::add(TimeMark::Kind kind, const std::string& text) {
    const auto step = static_cast<std::int64_t>(tree_.step());
    const TimeMark mark{kind, step, text.substr(0, text.find('\n'))};
    // An error that comes in every frame of a step is one mark.
    for (const TimeMark& known : others_)
        if (known.kind == kind && known.step == step && known.text == mark.text) return;
    if (others_.size() >= most) {
        const auto oldest = std::find_if(others_.begin(), others_.end(), [](const TimeMark& known) {
            return known.kind != TimeMark::Kind::bookmark;
        });
        if (oldest == others_.end()) return;  // bookmarks stay
        others_.erase(oldest);
    }
    others_.push_back(mark);
}

std::string TimeMarks::new_name() const {
    for (int n = 1;; ++n) {
        std::string name = "bookmark " + std::to_string(n);
        if (std::ranges::none_of(others_,
                                 [&](const TimeMark& known) { return known.text == name; }))
            return name;
    }
}

void TimeMarks::toggle_bookmark(std::int64_t step) {
    const auto there = std::find_if(others_.begin(), others_.end(), [&](const TimeMark& known) {
        return known.kind == TimeMark::Kind::bookmark && known.step == step;
    });
    if (there != others_.end())
        others_.erase(there);
    else
        others_.push_back({TimeMark::Kind::bookmark, step, new_name()});
}

std::pair<std::string, std::int64_t> TimeMarks::bookmark(const std::string& name,
                                                         std::optional<std::int64_t> step) {
    constexpr std::size_t longest = 80;  // bytes
    if (name.size() > longest ||
        std::ranges::any_of(name, [](unsigned char c) { return c < 0x20; }))
        throw property::Error(property::ErrorKind::bad_name,
                              "bookmark: expected a name of one line and at most 80 bytes");
    const std::int64_t at = step.value_or(static_cast<std::int64_t>(tree_.step()));
    const property::Value oldest = time_value(tree_, "oldest"),
                          newest = time_value(tree_, "newest");
    const std::int64_t first = oldest.is(property::Type::integer) ? oldest.integer() : 0;
    const std::int64_t last =
        newest.is(property::Type::integer) ? newest.integer() : std::max(at, first);
    if (step && (at < first || at > last))
        throw property::Error(property::ErrorKind::out_of_range,
                              "bookmark: step " + std::to_string(at) + " is not kept: those from " +
                                  std::to_string(first) + " to " + std::to_string(last) + " are");
    if (!name.empty()) unbookmark(name);
    if (bookmarks().size() >= most)
        throw property::Error(property::ErrorKind::rejected,
                              "bookmark: there are " + std::to_string(most) +
                                  " bookmarks already; remove one with unbookmark");
    others_.push_back({TimeMark::Kind::bookmark, at, name.empty() ? new_name() : name});
    return {others_.back().text, at};
}

std::size_t TimeMarks::unbookmark(const std::string& name) {
    return std::erase_if(others_, [&](const TimeMark& known) {
        return known.kind == TimeMark::Kind::bookmark && (name.empty() || known.text == name);
    });
}

std::vector<std::pair<std::string, std::int64_t>> TimeMarks::bookmarks() const {
    std::vector<std::pair<std::string, std::int64_t>> all;
    for (const TimeMark& mark : others_)
        if (mark.kind == TimeMark::Kind::bookmark) all.emplace_back(mark.text, mark.step);
    return all;
}

void TimeMarks::follow(const std::string& branch,
                       const std::map<std::string, std::int64_t>& others) {
    if (branch != branch_) leave_for(branch, others);
    std::erase_if(left_, [&](const auto& left) { return !others.contains(left.first); });
}

void TimeMarks::leave_for(const std::string& branch,
                          const std::map<std::string, std::int64_t>& others) {
    // If another branch has the old name, that branch was left; otherwise the present branch was
    // renamed.
    if (const auto left = others.find(branch_); left != others.end()) {
        std::erase_if(edits_, [&](const TimeMark& mark) { return mark.step > left->second; });
        left_[branch_] = others_;
        if (const auto there = left_.find(branch); there != left_.end()) {
            others_ = there->second;
            left_.erase(there);
        } else {
            std::erase_if(others_, [&](const TimeMark& mark) { return mark.step > left->second; });
        }
    }
    branch_ = branch;
    frames_ = 0;  // the edits of this branch are read at once
}

void TimeMarks::update() {
    if (frames_++ % frames_apart != 0) return;
    // Going back restores the history as it was then. Marks of later steps that were seen before
    // stay.
    const auto now = static_cast<std::int64_t>(tree_.step());
    std::erase_if(edits_, [&](const TimeMark& mark) { return mark.step <= now; });
    for (const property::HistoryEntry& entry : tree_.history()) {
        const auto step = static_cast<std::int64_t>(entry.cause.step);
        if (edits_.size() == most) break;
        if (entry.undone || step > now) continue;
        edits_.push_back({TimeMark::Kind::edit, step, entry.name});
    }
}

}  // namespace fettle::console
