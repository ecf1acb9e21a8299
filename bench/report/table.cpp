#include "report/table.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace fettle::bench {

std::string figure(double number, int digits) {
    if (number == 0 || !std::isfinite(number)) return number == 0 ? "0" : std::to_string(number);
    const int before = static_cast<int>(std::floor(std::log10(std::abs(number)))) + 1;
    char text[64];
    if (before < -3)
        std::snprintf(text, sizeof text, "%.*e", digits - 1, number);
    else
        std::snprintf(text, sizeof text, "%.*f", std::max(0, digits - before), number);
    return text;
}

Table::Table(std::vector<std::string> headers) : rows_{std::move(headers)} {}

void Table::add(std::vector<std::string> row) {
    rows_.push_back(std::move(row));
}

std::string Table::text() const {
    std::vector<std::size_t> widths(rows_.front().size(), 0);
    for (const auto& row : rows_) {
        for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
    }
    std::string text;
    for (std::size_t r = 0; r < rows_.size(); ++r) {
        std::string line;
        for (std::size_t i = 0; i < rows_[r].size(); ++i) {
            const std::string& cell = rows_[r][i];
            const std::string space(widths[i] - cell.size(), ' ');
            line += i == 0 ? cell + space : "  " + space + cell;
        }
        line.erase(line.find_last_not_of(' ') + 1);
        text += line + "\n";
        if (r > 0) continue;
        std::size_t width = 2 * (widths.size() - 1);
        for (const std::size_t w : widths) width += w;
        text += std::string(width, '-') + "\n";
    }
    return text;
}

}  // namespace fettle::bench
