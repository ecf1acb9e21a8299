#include <algorithm>

#include "report/svg.h"
#include "report/table.h"

namespace fettle::bench {
namespace {

constexpr int bar_height = 16;
constexpr int label_width = 220;
constexpr int bar_width = 420;
constexpr int total_width = label_width + bar_width + 140;

std::string label_at(int x, int y, const std::string& text, const std::string& attributes = "") {
    return "<text x=\"" + std::to_string(x) + "\" y=\"" + std::to_string(y) + "\"" +
           (attributes.empty() ? "" : " " + attributes) + ">" + escaped(text) + "</text>\n";
}

std::string bar_at(int x, int y, int width, int height, const char* color) {
    return "<rect x=\"" + std::to_string(x) + "\" y=\"" + std::to_string(y) + "\" width=\"" +
           std::to_string(width) + "\" height=\"" + std::to_string(height) + "\" fill=\"" + color +
           "\"/>\n";
}

/// The bars of one group, beginning at `y`; moves `y` below them.
std::string bars_of(const Chart& chart, const Chart::Group& group, int& y) {
    double longest = 0;
    for (const auto& value : group.values) longest = std::max(longest, value.value_or(0));
    std::string out = label_at(label_width - 10, y + 12, group.label, "text-anchor=\"end\"");
    for (std::size_t i = 0; i < group.values.size(); ++i) {
        if (!group.values[i]) continue;
        const double value = *group.values[i];
        const double share = longest > 0 ? std::max(0.0, value / longest) : 0;
        const int width = std::max(1, static_cast<int>(bar_width * share));
        out += bar_at(label_width, y, width, bar_height - 3, color_of(i));
        out += label_at(label_width + width + 6, y + 11, figure(value) + " " + chart.unit);
        y += bar_height;
    }
    y += 10;
    return out;
}

}  // namespace

std::string svg_of(const Chart& chart) {
    int y = 24;
    std::string body = label_at(10, y, chart.title, "font-size=\"15\" font-weight=\"bold\"");
    y += 14;
    if (chart.series.size() > 1) {
        int x = label_width;
        for (std::size_t i = 0; i < chart.series.size(); ++i) {
            body += bar_at(x, y, 10, 10, color_of(i)) + label_at(x + 15, y + 9, chart.series[i]);
            x += 110;
        }
        y += 26;
    }
    for (const Chart::Group& group : chart.groups) body += bars_of(chart, group, y);
    return svg_of_size(total_width, y, body);
}

void write_svg(const Chart& chart, const std::filesystem::path& file) {
    write_svg_text(svg_of(chart), file);
}

}  // namespace fettle::bench
