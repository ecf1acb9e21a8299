#pragma once
// What the design asks of a figure, and which figures of a table miss it.

#include <iosfwd>
#include <string>
#include <utility>
#include <vector>

namespace fettle::bench {

/// The bound of a figure. None where `kind` is none; `note` may say in words what is hoped for.
struct Bound {
    enum class Kind { none, below, at_most, at_least, exactly, other_than };
    Kind kind = Kind::none;
    double value = 0;
    std::string note{};

    explicit operator bool() const { return kind != Kind::none; }
    /// No bound holds for a figure that is not a number; none at all holds always.
    bool holds(double figure) const;
    /// "< 50", "<= 1.75", ">= 1.7", "15", "not 0"; nothing where there is none.
    std::string text() const;
};

inline Bound below(double value, std::string note = {}) {
    return {Bound::Kind::below, value, std::move(note)};
}
inline Bound at_most(double value, std::string note = {}) {
    return {Bound::Kind::at_most, value, std::move(note)};
}
inline Bound at_least(double value) {
    return {Bound::Kind::at_least, value};
}
inline Bound exactly(double value) {
    return {Bound::Kind::exactly, value};
}
inline Bound other_than(double value) {
    return {Bound::Kind::other_than, value};
}

/// The bound and its note, for a column of a table: "< 50: stands".
std::string words_of(const Bound& bound);

/// Looks at the figures of one table: marks those beyond their bounds and tells them at the end.
class Verdict {
  public:
    /// `table` is what the subcommand is called.
    explicit Verdict(std::string table) : table_(std::move(table)) {}

    /// Looks at a figure of a row. `shown` is the figure as the table shows it; `against` says what
    /// it is measured in or compared with. Returns `shown`, with " !" behind it when the figure is
    /// beyond its bound.
    std::string look(const std::string& row, double figure, const Bound& bound,
                     const std::string& shown, const std::string& against = {});
    /// A line for each figure beyond its bound, which `./check --full` collects, and how many
    /// bounds were looked at: `exceeded: tree "get ball.mass" 1.82 of the barest (bound <= 1.75)`.
    void print(std::ostream& out) const;

  private:
    std::string table_;
    std::vector<std::string> exceeded_;
    std::size_t bounds_ = 0;
};

}  // namespace fettle::bench
