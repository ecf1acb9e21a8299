#pragma once
// What happened at the steps of the past: edits of people, errors of scripts, breaks, and
// bookmarks.

#include <cstdint>
#include <string>
#include <vector>

#include <fettle/property/tree.h>

namespace fettle::console {

struct TimeMark {
    enum class Kind : std::uint8_t { edit, stop, error, bookmark };
    Kind kind;
    std::int64_t step;
    std::string text;  // one line
};

class TimeMarks {
  public:
    explicit TimeMarks(const property::Tree& tree) : tree_(tree) {}

    void error(const std::string& message) { add(TimeMark::Kind::error, message); }
    void stop(const std::string& line) { add(TimeMark::Kind::stop, line); }
    /// Sets a bookmark, or removes the one that is there.
    void toggle_bookmark(std::int64_t step);
    /// Call once a frame: finds new edits in the history of the tree, four times a second.
    void look();
    /// In the order in which they are drawn: edits first, bookmarks last.
    const std::vector<TimeMark>& edits() const { return edits_; }
    const std::vector<TimeMark>& others() const { return others_; }

  private:
    static constexpr std::size_t most = 200;  ///< of the edits, and of the others
    static constexpr int frames_apart = 15;
    void add(TimeMark::Kind kind, const std::string& text);

    const property::Tree& tree_;
    std::vector<TimeMark> edits_, others_;
    int frames_ = 0;
};

}  // namespace fettle::console
