#pragma once
// Finds instances by name, class or condition, a part of the tree in each frame, so that a search
// in a large game costs little.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fettle/property/condition.h>
#include <fettle/property/tree.h>

namespace fettle::console {

class InstanceSearch {
  public:
    explicit InstanceSearch(const property::Tree& tree) : tree_(tree) {}

    /// Begins a search. A text with an operator is a condition (property::Condition); another one
    /// is a part of a name, of a class or, with a dot, of a path, and then letters of a name.
    void begin(std::string_view text);
    /// Begins the same search again; earlier results stay until it has ended.
    void begin_again();
    /// Goes on with the search. Returns whether there is another result.
    bool advance();
    bool running() const { return static_cast<bool>(at_); }
    /// The instances that were found; during a first search, those found so far. By name: first the
    /// names that contain the text, then names with its letters, best first.
    const std::vector<property::Handle>& found() const { return found_; }
    /// Why the text is not a condition, or the name that nothing has; "" without a problem.
    const std::string& problem() const { return problem_; }

  private:
    void look_at(property::Handle instance);
    void end();

    const property::Tree& tree_;
    std::string text_, problem_;
    std::optional<property::Condition> condition_;
    property::Handle at_;  // the next instance to look at; null: the search has ended
    bool first_ = false;   // found_ has no earlier result
    std::vector<property::Handle> matches_;
    std::vector<std::pair<int, property::Handle>> similar_;  // with their scores
    std::vector<property::Handle> found_;
};

}  // namespace fettle::console
