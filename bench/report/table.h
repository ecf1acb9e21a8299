#pragma once
// Output of a benchmark: a text table, and a chart of the same figures.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace fettle::bench {

/// A number with a few significant digits: "0.0123", "4.56", "123".
std::string figure(double number, int digits = 3);

/// Columns of text, the first aligned left, the others right.
class Table {
  public:
    explicit Table(std::vector<std::string> headers);
    void add(std::vector<std::string> row);
    /// The table with columns of fixed width and a line under the headers.
    std::string text() const;

  private:
    std::vector<std::vector<std::string>> rows_;
};

/// Groups of horizontal bars.
struct Chart {
    struct Group {
        std::string label;
        std::vector<std::optional<double>> values{};  // one per series; nullopt: no bar
    };
    std::string title{};
    std::string unit{};
    std::vector<std::string> series{};
    std::vector<Group> groups{};
};

/// The longest bar of each group fills the width, because groups differ by orders of magnitude.
std::string svg_of(const Chart& chart);
/// Throws std::runtime_error with the name of the file if it cannot be written.
void write_svg(const Chart& chart, const std::filesystem::path& file);

}  // namespace fettle::bench
