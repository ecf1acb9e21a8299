#include "report/plot.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "report/svg.h"

namespace fettle::bench {
namespace {

constexpr double width = 640, height = 380;
constexpr double left = 72, right = 20, top = 62, bottom = 52;

std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1f", value);
    return text;
}

/// The label of a tick: 0.001, 20, 1e6.
std::string tick_text(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", value);
    return text;
}

/// One axis: maps values to positions between two edges of the frame.
class Axis {
  public:
    Axis(bool logarithmic, double from, double to)
        : logarithmic_(logarithmic), from_(from), to_(to) {}

    void include(double value) {
        if (!std::isfinite(value) || (logarithmic_ && !(value > 0))) return;
        low_ = std::min(low_, scaled(value));
        high_ = std::max(high_, scaled(value));
    }

    /// Extends the range to whole ticks.
    void settle() {
        if (!(low_ <= high_)) low_ = 0, high_ = 1;
        if (logarithmic_) {
            low_ = std::floor(low_), high_ = std::ceil(high_);
            if (high_ <= low_) high_ = low_ + 1;
            step_ = std::max(1.0, std::ceil((high_ - low_) / 8));
            return;
        }
        if (low_ > 0 && low_ < 0.5 * high_) low_ = 0;
        if (high_ <= low_) high_ = low_ + 1;
        const double raw = (high_ - low_) / 5, power = std::pow(10, std::floor(std::log10(raw)));
        step_ = power * (raw / power > 5 ? 10 : raw / power > 2 ? 5 : raw / power > 1 ? 2 : 1);
        low_ = step_ * std::floor(low_ / step_ + 1e-9);
        high_ = step_ * std::ceil(high_ / step_ - 1e-9);
    }

    bool shows(double value) const { return std::isfinite(value) && (!logarithmic_ || value > 0); }
    double place(double value) const {
        return from_ + (to_ - from_) * (scaled(value) - low_) / (high_ - low_);
    }
    std::vector<double> ticks() const {
        std::vector<double> all;
        for (double at = low_; at <= high_ + 1e-9 * step_; at += step_) {
            const double near_zero = std::abs(at) < 1e-9 * step_ ? 0 : at;
            all.push_back(logarithmic_ ? std::pow(10, near_zero) : near_zero);
        }
        return all;
    }

  private:
    double scaled(double value) const { return logarithmic_ ? std::log10(value) : value; }

    bool logarithmic_;
    double from_, to_;
    double low_ = std::numeric_limits<double>::infinity(), high_ = -low_, step_ = 1;
};

std::string text_at(double x, double y, const std::string& text, const std::string& more) {
    return "<text x=\"" + number(x) + "\" y=\"" + number(y) + "\" " + more + ">" + escaped(text) +
           "</text>\n";
}

std::string line(double x1, double y1, double x2, double y2, const std::string& color) {
    return "<line x1=\"" + number(x1) + "\" y1=\"" + number(y1) + "\" x2=\"" + number(x2) +
           "\" y2=\"" + number(y2) + "\" stroke=\"" + color + "\"/>\n";
}

std::string frame(const Plot& plot, const Axis& x, const Axis& y) {
    std::string out;
    for (const double tick : x.ticks()) {
        out += line(x.place(tick), top, x.place(tick), height - bottom, "#e8e8e8");
        out +=
            text_at(x.place(tick), height - bottom + 18, tick_text(tick), "text-anchor=\"middle\"");
    }
    for (const double tick : y.ticks()) {
        out += line(left, y.place(tick), width - right, y.place(tick), "#e8e8e8");
        out += text_at(left - 8, y.place(tick) + 4, tick_text(tick), "text-anchor=\"end\"");
    }
    out += line(left, height - bottom, width - right, height - bottom, "#444");
    out += line(left, top, left, height - bottom, "#444");
    out += text_at(width / 2 + 20, height - 12, plot.x_label, "text-anchor=\"middle\"");
    const std::string turn = "text-anchor=\"middle\" transform=\"rotate(-90 16 " +
                             number((top + height - bottom) / 2) + ")\"";
    out += text_at(16, (top + height - bottom) / 2, plot.y_label, turn);
    return out + text_at(left, 22, plot.title, "font-size=\"15\" font-weight=\"bold\"");
}

std::string curve_of(const Curve& curve, const Axis& x, const Axis& y, const char* color,
                     bool points) {
    std::string path, marks;
    for (std::size_t i = 0; i < std::min(curve.x.size(), curve.y.size()); ++i) {
        if (!x.shows(curve.x[i]) || !y.shows(curve.y[i])) continue;
        const std::string at = number(x.place(curve.x[i])) + "," + number(y.place(curve.y[i]));
        path += (path.empty() ? "" : " ") + at;
        if (points) {
            marks += "<circle cx=\"" + number(x.place(curve.x[i])) + "\" cy=\"" +
                     number(y.place(curve.y[i])) + "\" r=\"3.5\" fill=\"" + color + "\"/>\n";
        }
    }
    return "<polyline points=\"" + path + "\" fill=\"none\" stroke=\"" + color +
           "\" stroke-width=\"2\" stroke-linejoin=\"round\"/>\n" + marks;
}

}  // namespace

std::string svg_of(const Plot& plot) {
    Axis x(plot.x_logarithmic, left, width - right), y(plot.y_logarithmic, height - bottom, top);
    for (const Curve& curve : plot.curves) {
        for (const double value : curve.x) x.include(value);
        for (const double value : curve.y) y.include(value);
    }
    x.settle();
    y.settle();
    std::string body = frame(plot, x, y);
    double at = left;
    for (std::size_t i = 0; i < plot.curves.size(); ++i) {
        const char* color = color_of(i);
        body += curve_of(plot.curves[i], x, y, color, plot.points);
        body += "<rect x=\"" + number(at) + "\" y=\"34\" width=\"12\" height=\"12\" fill=\"" +
                color + "\"/>\n" + text_at(at + 18, 44, plot.curves[i].name, "");
        at += 40 + 7.5 * static_cast<double>(plot.curves[i].name.size());
    }
    return svg_of_size(static_cast<int>(width), static_cast<int>(height), body);
}

void write_svg(const Plot& plot, const std::filesystem::path& file) {
    write_svg_text(svg_of(plot), file);
}

}  // namespace fettle::bench
