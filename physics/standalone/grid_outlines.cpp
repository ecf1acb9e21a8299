#include <checks/arguments.h>
#include <fettle/physics/outlines.h>
#include <geometry/vector.h>

#include <cmath>
#include <stdexcept>
#include <string>

// Marching squares (the two-dimensional case of W. Lorensen and H. Cline, "Marching Cubes", 1987).
// Between two samples of which one is filled, the outline crosses the line between them. Each
// square of four samples joins the crossings on its sides in pairs, with the filled area on the
// right; the pairs of all squares together are closed lines.

namespace fettle::physics {

using namespace detail;

namespace {

constexpr uint32_t nowhere = 0xffffffffu;

/// The grid with a border of empty samples around it.
class Samples {
  public:
    Samples(std::span<const float> values, const GridLayout& layout, float threshold)
        : width(layout.columns + 2),
          height(layout.rows + 2),
          values_(values),
          layout_(layout),
          threshold_(threshold) {}

    const uint32_t width, height;

    bool filled(uint32_t i, uint32_t k) const { return !outside(i, k) && above(i, k) > 0.0f; }
    /// Of the four samples with the lower left one at (i, k).
    bool mean_is_filled(uint32_t i, uint32_t k) const {
        double sum = 0.0;
        for (const auto& [x, y] : {std::pair(i, k), {i + 1, k}, {i, k + 1}, {i + 1, k + 1}}) {
            if (outside(x, y)) return false;
            sum += double(above(x, y));
        }
        return sum > 0.0;
    }
    /// A crossing is numbered by the sample below or left of it, and by its direction.
    uint32_t crossing(uint32_t i, uint32_t k, bool upwards) const {
        return 2 * (k * width + i) + uint32_t{upwards};
    }
    uint32_t crossings() const { return 2 * width * height; }
    Vec2 place(uint32_t crossing) const {
        const uint32_t i = crossing / 2 % width, k = crossing / 2 / width;
        const bool upwards = crossing % 2 != 0;
        const uint32_t to_i = i + uint32_t{!upwards}, to_k = k + uint32_t{upwards};
        float t = 0.5f;
        if (!outside(i, k) && !outside(to_i, to_k)) {
            // Away from the samples, so that lines do not touch each other there.
            const float from = above(i, k), to = above(to_i, to_k);
            t = clamp(from / (from - to), 0.01f, 0.99f);
        }
        const float x = float(i) - 1.0f + (upwards ? 0.0f : t);
        const float y = float(k) - 1.0f + (upwards ? t : 0.0f);
        return layout_.origin + layout_.cell * Vec2(x, y);
    }

  private:
    bool outside(uint32_t i, uint32_t k) const {
        return i == 0 || k == 0 || i > layout_.columns || k > layout_.rows;
    }
    float above(uint32_t i, uint32_t k) const {
        return values_[size_t{k - 1} * layout_.columns + (i - 1)] - threshold_;
    }

    std::span<const float> values_;
    const GridLayout& layout_;
    float threshold_;
};

/// For each crossing, the next crossing on the same line.
std::vector<uint32_t> linked(const Samples& samples) {
    enum Side { bottom, right, top, left };
    // From side to side, by the filled corners: 1 lower left, 2 lower right, 4 upper right, 8 upper
    // left. The filled area is on the right of a line.
    constexpr Side lines[][2] = {
        {}, {left, bottom}, {bottom, right}, {left, right},   {right, top},
        {}, {bottom, top},  {left, top},     {top, left},     {top, bottom},
        {}, {top, right},   {right, left},   {right, bottom}, {bottom, left},
        {}};
    std::vector<uint32_t> next(samples.crossings(), nowhere);
    for (uint32_t k = 0; k + 1 < samples.height; ++k) {
        for (uint32_t i = 0; i + 1 < samples.width; ++i) {
            const uint32_t sides[] = {
                samples.crossing(i, k, false), samples.crossing(i + 1, k, true),
                samples.crossing(i, k + 1, false), samples.crossing(i, k, true)};
            const auto join = [&](Side from, Side to) { next[sides[from]] = sides[to]; };
            const auto corner = [&](uint32_t x, uint32_t y) {
                return uint32_t{samples.filled(i + x, k + y)};
            };
            const uint32_t filled =
                corner(0, 0) + 2 * corner(1, 0) + 4 * corner(1, 1) + 8 * corner(0, 1);
            if (filled == 5 || filled == 10) {  // two opposite corners: two lines
                const bool joined = samples.mean_is_filled(i, k);
                if (filled == 5)
                    join(joined ? right : left, bottom), join(joined ? left : right, top);
                if (filled == 10)
                    join(bottom, joined ? left : right), join(top, joined ? right : left);
            } else if (filled != 0 && filled != 15) {
                join(lines[filled][0], lines[filled][1]);
            }
        }
    }
    return next;
}

}  // namespace

std::vector<Chain> grid_outlines(std::span<const float> values, const GridLayout& layout,
                                 float threshold, float straight) {
    constexpr uint64_t most = 1u << 24;
    if (uint64_t{layout.columns} * layout.rows != values.size() || values.size() > most ||
        layout.columns > most || layout.rows > most)
        throw std::invalid_argument(
            "values: expected columns · rows of them, at most 16777216, got " +
            std::to_string(values.size()) + " for " + std::to_string(layout.columns) + " · " +
            std::to_string(layout.rows));
    check_point("origin", layout.origin);
    check_range("cell", layout.cell, 1e-5f, 1e6f);
    check_finite("threshold", threshold);
    check_not_negative("straight", straight);
    for (const float& value : values)
        if (!std::isfinite(value))
            check_finite(("values: value " + std::to_string(&value - values.data() + 1)).c_str(),
                         value);
    if (values.empty()) return {};
    check_point("the last sample", layout.origin + layout.cell * Vec2(float(layout.columns + 1),
                                                                      float(layout.rows + 1)));
    const Samples samples(values, layout, threshold);
    std::vector<uint32_t> next = linked(samples);
    std::vector<Chain> chains;
    for (uint32_t first = 0; first < next.size(); ++first) {
        std::vector<Vec2> line;
        for (uint32_t at = first; next[at] != nowhere;) {
            line.push_back(samples.place(at));
            const uint32_t after = next[at];
            next[at] = nowhere;
            at = after;
        }
        if (line.empty()) continue;
        line = without_straight_points(line, true, straight);
        if (line.size() > 2) chains.push_back({std::move(line), true});
    }
    return chains;
}

std::vector<Chain> grid_outlines(std::span<const bool> filled, const GridLayout& layout,
                                 float straight) {
    std::vector<float> values;
    values.reserve(filled.size());
    for (const bool cell : filled) values.push_back(cell ? 1.0f : 0.0f);
    return grid_outlines(values, layout, 0.5f, straight);
}

}  // namespace fettle::physics
