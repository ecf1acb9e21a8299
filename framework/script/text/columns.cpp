#include <algorithm>
#include <cmath>

#include <fettle/property/utf8.h>
#include <fettle/property/value.h>
#include <fettle/script/cells.h>

#include <text/columns.h>

namespace fettle::script {

std::size_t shown_width(std::string_view text) {
    return property::code_point_count(text);
}

std::string cut(std::string_view text, std::size_t width) {
    if (text.size() <= width) return std::string(text);  // has no more characters than bytes
    const std::size_t end = property::code_point_offset(text, width);
    if (end == text.size()) return std::string(text);
    return std::string(text.substr(0, end)) + "…";
}

std::string number_for_people(double number) {
    std::string text = property::number_text(number, property::shortest_precision(number));
    if (std::isfinite(number) && text.find_first_of(".e") == std::string::npos) text += ".0";
    return text;
}

namespace {

/// The width of a column with cells of such widths. A cell that is far wider than most of them does
/// not count: it moves the rest of its own row, and not that of all others.
std::size_t column_width(std::vector<std::size_t> cells) {
    constexpr std::size_t usual = 32;
    std::sort(cells.begin(), cells.end());
    const std::size_t widest = std::max(usual, 2 * cells[cells.size() / 2]);
    const auto end = std::upper_bound(cells.begin(), cells.end(), widest);
    return end == cells.begin() ? 0 : *(end - 1);
}

}  // namespace

std::vector<std::string> columns(const std::vector<std::vector<std::string>>& rows,
                                 std::vector<std::vector<std::size_t>>* cells) {
    std::vector<std::vector<std::size_t>> wide;
    for (const auto& row : rows) {
        wide.resize(std::max(wide.size(), row.size()));
        for (std::size_t i = 0; i < row.size(); ++i) wide[i].push_back(cell_count(row[i]));
    }
    std::vector<std::size_t> widths;
    widths.reserve(wide.size());
    for (std::vector<std::size_t>& column : wide) widths.push_back(column_width(column));
    std::vector<std::string> lines;
    for (const auto& row : rows) {
        std::string line;
        std::vector<std::size_t> begins;
        for (std::size_t i = 0; i < row.size(); ++i) {
            if (i) line += "  ";
            begins.push_back(line.size());
            line += row[i];
            if (const std::size_t width = cell_count(row[i]);
                i + 1 < row.size() && width < widths[i])
                line.append(widths[i] - width, ' ');
        }
        while (!line.empty() && line.back() == ' ') line.pop_back();
        lines.push_back(std::move(line));
        if (cells != nullptr) cells->push_back(std::move(begins));
    }
    return lines;
}

}  // namespace fettle::script
