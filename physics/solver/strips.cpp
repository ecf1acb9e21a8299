#include <solver/strips.h>

#include <algorithm>
#include <cmath>

namespace fettle::physics::detail {
namespace {

/// Two strips from four times as many constraints on, four from sixteen times: what is between them
/// must remain little beside what is in them.
constexpr std::size_t unit = 512;

/// Where the list runs along an axis, that axis is cut: a thread then has in all stages what lies
/// together in memory.
constexpr float in_order = 0.8f;

/// Others are cut from top to bottom unless they are this many times as high as wide: what bears
/// and what it bears stay together.
constexpr float upright_ratio = 2.0f;

float along(const StripSample& sample, bool upright) {
    return upright ? sample.place.y : sample.place.x;
}

/// Correlation of where they are with which place in the list they have, without its sign.
float order(std::span<const StripSample> samples, bool upright) {
    const auto n = float(samples.size());
    float mean = 0.0f;
    for (const StripSample& sample : samples) mean += along(sample, upright) / n;
    float place = 0.5f - 0.5f * n, both = 0.0f, spread = 0.0f, places = 0.0f;
    for (const StripSample& sample : samples) {
        const float d = along(sample, upright) - mean;
        both += place * d;
        spread += d * d;
        places += place * place;
        place += 1.0f;
    }
    return std::fabs(both) / std::sqrt(spread * places + 1e-30f);
}

float extent(std::span<const StripSample> samples, bool upright) {
    const auto before = [&](const StripSample& a, const StripSample& b) {
        return along(a, upright) < along(b, upright);
    };
    const auto [low, high] = std::minmax_element(samples.begin(), samples.end(), before);
    return along(*high, upright) - along(*low, upright);
}

/// Whether strips lie on each other.
bool lie_upright(std::span<const StripSample> samples) {
    const float x = order(samples, false), y = order(samples, true);
    if (std::max(x, y) > in_order) return y > x;
    return extent(samples, true) > upright_ratio * extent(samples, false);
}

}  // namespace

uint32_t Strips::count_for(std::size_t constraints) {
    uint32_t count = 1;
    while (count < most_strips && constraints >= unit * (4 * count * count)) count *= 2;
    return count;
}

void Strips::cut(std::span<StripSample> samples, uint32_t count) {
    count_ = samples.empty() ? 1 : count;
    if (count_ == 1) return;
    upright_ = lie_upright(samples);
    std::sort(samples.begin(), samples.end(), [&](const StripSample& a, const StripSample& b) {
        return along(a, upright_ != 0) < along(b, upright_ != 0);
    });
    cut_below(samples, 1);
}

/// Where half of the work of a node is on either side.
void Strips::cut_below(std::span<const StripSample> samples, uint32_t node) {
    float all = 0.0f, so_far = 0.0f;
    for (const StripSample& sample : samples) all += sample.work;
    std::size_t middle = 0;
    while (middle < samples.size() && 2.0f * (so_far + samples[middle].work) <= all)
        so_far += samples[middle++].work;
    middle = std::min(middle, samples.empty() ? 0 : samples.size() - 1);
    limits_[node] = samples.empty() ? limits_[node / 2] : along(samples[middle], upright_ != 0);
    if (2 * node >= count_) return;
    cut_below(samples.first(middle), 2 * node);
    cut_below(samples.subspan(middle), 2 * node + 1);
}

Sections::Sections(uint32_t strips, uint32_t parts) : parts_(parts) {
    const int levels = std::bit_width(strips), own = levels - int(std::bit_width(parts)) + 1;
    size_ = parts * uint32_t(own) + parts - 1;
    nodes_.fill({0, 0});
    for (uint32_t node = 2 * strips; node-- > 1;) {
        const int depth = int(std::bit_width(node)) - 1;
        const int level = levels - 1 - depth;  // 0: the strips
        uint32_t section;
        if (level < own) {
            const uint32_t part = (node >> (own - 1 - level)) - parts;
            section = part * uint32_t(own) + uint32_t(level);
            owner_[node] = uint8_t(part);
        } else {
            // Those above: 2^depth at each depth, the deepest first.
            const uint32_t above = (parts - (2u << depth)) + (node - (1u << depth));
            section = parts * uint32_t(own) + above;
            owner_[node] = uint8_t(parts + above);
        }
        of_[node] = uint8_t(section);
        StripNodes& nodes = nodes_[section];
        nodes = {node, nodes.end == 0 ? node + 1 : nodes.end};
    }
}

}  // namespace fettle::physics::detail
