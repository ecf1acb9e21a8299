#pragma once
// Marks for events at past steps: edits of people, errors of scripts, breaks, and bookmarks. Each
// branch of the past has its own.

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fettle/property/tree.h>

namespace fettle::console {

struct TimeMark {
    enum class Kind : std::uint8_t { edit, stop, error, bookmark };
    Kind kind;
    std::int64_t step;
    std::string text;  // one line; the name of a bookmark
};

class TimeMarks {
  public:
    explicit TimeMarks(const property::Tree& tree) : tree_(tree) {}

    void error(const std::string& message) { add(TimeMark::Kind::error, message); }
    void stop(const std::string& line) { add(TimeMark::Kind::stop, line); }
    /// Sets a bookmark, or removes the one that is there.
    void toggle_bookmark(std::int64_t step);
    /// Sets a bookmark at a step; without one, at the present step. "" gets a new name; a bookmark
    /// with that name is moved. Throws Error(rejected) if there are too many, Error(bad_name) for a
    /// name of several lines or of more than 80 bytes, and Error(out_of_range) for a step before 0.
    std::pair<std::string, std::int64_t> bookmark(const std::string& name,
                                                  std::optional<std::int64_t> step);
    /// Returns how many were removed; "" is all of them.
    std::size_t unbookmark(const std::string& name);
    std::vector<std::pair<std::string, std::int64_t>> bookmarks() const;
    /// Call once a frame: finds new edits in the history of the tree, four times a second.
    void update();
    /// Call once a frame with the name of the present branch, and the names of the others with the
    /// last steps that they have in common with it. If another branch has become the present one,
    /// the marks become those of that branch.
    void follow(const std::string& branch, const std::map<std::string, std::int64_t>& others);
    /// In the order in which they are drawn: edits first, bookmarks last.
    const std::vector<TimeMark>& edits() const { return edits_; }
    const std::vector<TimeMark>& others() const { return others_; }

  private:
    static constexpr std::size_t most = 200;  ///< of the edits, and of the others
    static constexpr int frames_apart = 15;
    void add(TimeMark::Kind kind, const std::string& text);
    void leave_for(const std::string& branch, const std::map<std::string, std::int64_t>& others);
    std::string new_name() const;

    const property::Tree& tree_;
    std::vector<TimeMark> edits_, others_;
    std::string branch_;                                 // that `others_` belong to
    std::map<std::string, std::vector<TimeMark>> left_;  // of the other branches
    int frames_ = 0;
};

}  // namespace fettle::console
