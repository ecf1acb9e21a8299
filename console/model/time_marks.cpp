#include <model/time_marks.h>

#include <algorithm>

namespace fettle::console {

void TimeMarks::add(TimeMark::Kind kind, const std::string& text) {
    const auto step = static_cast<std::int64_t>(tree_.step());
    const TimeMark mark{kind, step, text.substr(0, text.find('\n'))};
    // An error that comes in every frame of a step is one mark.
    for (const TimeMark& known : others_)
        if (known.kind == kind && known.step == step && known.text == mark.text) return;
    if (others_.size() == most) {
        const auto oldest = std::find_if(others_.begin(), others_.end(), [](const TimeMark& known) {
            return known.kind != TimeMark::Kind::bookmark;
        });
        others_.erase(oldest == others_.end() ? others_.begin() : oldest);
    }
    others_.push_back(mark);
}

void TimeMarks::toggle_bookmark(std::int64_t step) {
    const auto there = std::find_if(others_.begin(), others_.end(), [&](const TimeMark& known) {
        return known.kind == TimeMark::Kind::bookmark && known.step == step;
    });
    if (there != others_.end())
        others_.erase(there);
    else
        others_.push_back({TimeMark::Kind::bookmark, step, "bookmark"});
}

void TimeMarks::look() {
    if (frames_++ % frames_apart != 0) return;
    edits_.clear();
    for (const property::HistoryEntry& entry : tree_.history()) {
        if (edits_.size() == most) break;
        if (entry.undone) continue;
        edits_.push_back(
            {TimeMark::Kind::edit, static_cast<std::int64_t>(entry.cause.step), entry.name});
    }
}

}  // namespace fettle::console
