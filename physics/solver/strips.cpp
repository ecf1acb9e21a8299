#include <solver/strips.h>

#include <algorithm>

namespace fettle::physics::detail {
namespace {

constexpr std::size_t least_in_strip = 1024;

/// Stacks are cut from top to bottom unless they are this many times as high as wide: what bears
/// and what it bears stay together.
constexpr float upright_ratio = 2.0f;

float along(const StripSample& sample, bool upright) {
    return upright ? sample.place.y : sample.place.x;
}

float extent(std::span<const StripSample> samples, bool upright) {
    const auto before = [&](const StripSample& a, const StripSample& b) {
        return along(a, upright) < along(b, upright);
    };
    const auto [low, high] = std::minmax_element(samples.begin(), samples.end(), before);
    return along(*high, upright) - along(*low, upright);
}

}  // namespace

uint32_t Strips::count_for(std::size_t constraints) {
    const auto fit = std::bit_floor(std::max<std::size_t>(constraints / least_in_strip, 1));
    return uint32_t(std::min<std::size_t>(fit, most_strips));
}

void Strips::cut(std::span<StripSample> samples, uint32_t count) {
    count_ = samples.empty() ? 1 : count;
    if (count_ == 1) return;
    upright_ = extent(samples, true) > upright_ratio * extent(samples, false);
    std::sort(samples.begin(), samples.end(), [&](const StripSample& a, const StripSample& b) {
        return along(a, upright_) < along(b, upright_);
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
    limits_[node] = samples.empty() ? limits_[node / 2] : along(samples[middle], upright_);
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
