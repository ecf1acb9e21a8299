#pragma once
// Bounds of the design for figures, and reports of figures beyond them.

#include <iosfwd>
#include <string>
#include <utility>
#include <vector>

namespace fettle::bench {

/// The bound of a figure. There is no bound if `kind` is `none`; `note` may explain in words.
struct Bound {
    enum class Kind { none, below, at_most, at_least, exactly, other_than };
    Kind kind = Kind::none;
    double value = 0;
    std::string note{};

    explicit operator bool() const { return kind != Kind::none; }
    /// Whether the figure is within the bound. NaN is within no bound, and every figure is valid if
    /// there is none.
    bool holds(double figure) const;
    /// "< 50", "<= 1.75", ">= 1.7", "15", "not 0"; "" if there is no bound.
    std::string text() const;
};

inline Bound below(double value, std::string note = {}) {
    return {Bound::Kind::below, value, std::move(note)};
}
inline Bound at_most(double value) {
    return {Bound::Kind::at_most, value};
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
std::string text_with_note(const Bound& bound);

/// Checks the figures of one table: marks those beyond their bounds and lists them at the end.
class Verdict {
  public:
    /// `table`: name of the subcommand.
    explicit Verdict(std::string table) : table_(std::move(table)) {}

    /// Checks a figure of a row. `shown`: the figure as the table shows it. `against`: its unit, or
    /// what it is compared with. Returns `shown`, followed by " !" if the figure is beyond its
    /// bound.
    std::string mark(const std::string& row, double figure, const Bound& bound,
                     const std::string& shown, const std::string& against = {});
    /// Prints one line for each figure beyond its bound, which `./check --full` collects, and the
    /// number of checked bounds: `exceeded: tree "get ball.mass" 1.82 of the barest (bound <=
    /// 1.75)`.
    void print(std::ostream& out) const;

  private:
    std::string table_;
    std::vector<std::string> exceeded_;
    std::size_t bounds_ = 0;
};

}  // namespace fettle::bench
