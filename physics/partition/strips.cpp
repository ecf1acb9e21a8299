#include <partition/strips.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fettle::physics::detail {
namespace {

/// Two strips from 4 · `unit` constraints on, four from 16 · `unit` on, because the constraints
/// between strips must be few compared with those inside strips.
constexpr std::size_t unit = 512;

/// If the correlation between the index in the list and the position along an axis is at least
/// this, the cut is across that axis. Then a thread works on neighboring memory in all stages.
constexpr float in_order = 0.8f;

/// Other worlds are cut by horizontal lines only if their height is this many times their width.
/// Otherwise a body and the body below it would be in different strips.
constexpr float upright_ratio = 2.0f;

float along(const StripSample& sample, bool upright) {
    return upright ? sample.place.y : sample.place.x;
}

/// Absolute correlation of the positions with the indices in the list.
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

/// True if the strips lie on top of each other.
bool lie_upright(std::span<const StripSample> samples) {
    const float x = order(samples, false), y = order(samples, true);
    if (std::max(x, y) > in_order) return y > x;
    return extent(samples, true) > upright_ratio * extent(samples, false);
}

/// Work up to a position. The range from the first sample to the last between `from` and `to` is
/// divided into equal intervals.
class WorkAlong {
  public:
    WorkAlong(std::span<const StripSample> samples, bool upright, float from, float to)
        : samples_(samples), upright_(upright), begin_(to) {
        const auto each = [&](auto&& visit) {
            for (const StripSample& sample : samples) {
                const float place = along(sample, upright);
                if (place >= from && place <= to) visit(place, sample.work);
            }
        };
        float end = from;
        each([&](float place, float) {
            begin_ = std::min(begin_, place);
            end = std::max(end, place);
        });
        if (end - begin_ > narrowest * (1.0f + std::fabs(begin_)))
            step_ = (end - begin_) / float(steps);
        const float per_step = step_ > 0.0f ? 1.0f / step_ : 0.0f;
        each([&](float place, float work) {
            const auto i = std::size_t((place - begin_) * per_step);
            up_to_[1 + std::min(i, steps - 1)] += work;
        });
        std::partial_sum(up_to_.begin(), up_to_.end(), up_to_.begin());
    }

    /// Position with this share of the work in front of it.
    float at(float share) const {
        const float wanted = share * up_to_.back();
        const auto end = std::lower_bound(up_to_.begin() + 1, up_to_.end() - 1, wanted);
        const float work = *end - end[-1];
        const float part = work > 0.0f ? (wanted - end[-1]) / work : 0.0f;
        const float begin = begin_ + step_ * float(end - up_to_.begin() - 1);
        // A large part of the work is in one interval: one sample is far from all others, or bodies
        // are in rows.
        if (step_ > 0.0f && work > most_in_a_step * up_to_.back())
            return WorkAlong(samples_, upright_, begin, begin + step_).at(part);
        return begin + step_ * part;
    }

  private:
    static constexpr std::size_t steps = 512;
    static constexpr float most_in_a_step = 0.02f;
    static constexpr float narrowest = 1e-5f;  // samples closer than this, relative to their
                                               // distance from the origin, count as one position

    const std::span<const StripSample> samples_;
    const bool upright_;
    std::array<float, steps + 1> up_to_ = {};
    float begin_, step_ = 0.0f;  // m
};

}  // namespace

uint32_t Strips::count_for(std::size_t constraints) {
    uint32_t count = 1;
    while (count < most_strips && constraints >= unit * (4 * count * count)) count *= 2;
    return count;
}

void Strips::cut(std::span<const StripSample> samples, uint32_t count) {
    count_ = samples.empty() ? 1 : count;
    if (count_ == 1) return;
    upright_ = lie_upright(samples);
    constexpr float anywhere = std::numeric_limits<float>::infinity();
    const WorkAlong work(samples, upright_ != 0, -anywhere, anywhere);
    for (uint32_t node = 1; node < count_; ++node) {
        const uint32_t level = std::bit_floor(node);
        limits_[node] = work.at(float(2 * (node - level) + 1) / float(2 * level));
    }
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
            // Above the parts there are 2^depth nodes at each depth; the deepest nodes come first.
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
