#pragma once
// Plots as SVG: lines in a frame with axes.

#include <filesystem>
#include <string>
#include <vector>

namespace fettle::bench {

struct Curve {
    std::string name{};
    std::vector<double> x{};
    std::vector<double> y{};
};

struct Plot {
    std::string title{};
    std::string x_label{}, y_label{};
    bool x_logarithmic = false, y_logarithmic = false;
    bool points = false;  ///< also marks the points of the curves
    std::vector<Curve> curves{};
};

/// On logarithmic axes, only positive values are shown.
std::string svg_of(const Plot& plot);
/// Throws std::runtime_error with the name of the file if it cannot be written.
void write_svg(const Plot& plot, const std::filesystem::path& file);

}  // namespace fettle::bench
