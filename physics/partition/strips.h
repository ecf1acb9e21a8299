#pragma once

#include <geometry/vector.h>
#include <threads/pool.h>

#include <array>
#include <bit>
#include <cstdint>
#include <numeric>
#include <span>

// Strips divide a heap of touching bodies for several threads; each strip has about the same work.
// Constraints inside a strip do not depend on other strips; constraints between two strips are
// solved after both (nested dissection: A. George, "Nested Dissection of a Regular Finite Element
// Mesh", 1973). The strips are the leaves of a binary tree from left to right. A constraint belongs
// to the lowest node that is above both of its bodies.
//
// The result is the same whether one thread solves the nodes of a level or several threads share
// them, because no two nodes of a level have a body in common.

namespace fettle::physics::detail {

inline constexpr uint32_t most_strips = 8;

/// Node of a complete binary tree: 1 is the root, 2n and 2n + 1 are below n.
using StripNode = uint8_t;

/// The lowest node that is above both nodes or equal to one of them. 0 if one body is in no strip.
inline StripNode above_both(StripNode a, StripNode b) {
    return StripNode(a >> std::bit_width(unsigned(a ^ b)));
}

/// Nodes `begin` to `end`, all nodes of one level or all nodes of the tree.
struct StripNodes {
    uint32_t begin = 1, end = 2;
};

/// The range of each node in a list that is sorted by node. Call `count` for each entry, then
/// `sum_up`.
class NodeRanges {
  public:
    using Places = std::array<uint32_t, 2 * most_strips + 1>;

    void clear() { first_.fill(0); }
    void count(uint32_t node, uint32_t how_many = 1) { first_[node + 1] += how_many; }
    void sum_up() { std::partial_sum(first_.begin(), first_.end(), first_.begin()); }
    /// The first index of each node, as a copy that the caller counts up.
    Places places() const { return first_; }
    uint32_t begin(const StripNodes& nodes) const { return first_[nodes.begin]; }
    uint32_t end(const StripNodes& nodes) const { return first_[nodes.end]; }
    uint32_t size() const { return first_.back(); }

  private:
    Places first_ = {};
};

/// Position of a sampled body, and the cost of its constraints.
struct StripSample {
    Vec2 place;
    float work = 0.0f;
};

class Strips {
  public:
    /// The number of strips for this many constraints: a power of two.
    static uint32_t count_for(std::size_t constraints);

    /// Cuts into `count` strips: along the list of the samples if the list runs along an axis,
    /// otherwise across the longer side.
    void cut(std::span<const StripSample> samples, uint32_t count);
    uint32_t count() const { return count_; }
    StripNodes all_nodes() const { return {1, 2 * count_}; }
    StripNode first_leaf() const { return StripNode(count_); }
    StripNode leaf_at(Vec2 place) const {
        const float along = upright_ != 0 ? place.y : place.x;
        uint32_t node = 1;
        while (node < count_) node = 2 * node + (along >= limits_[node]);
        return StripNode(node);
    }

    /// False if deserialized data are damaged.
    bool is_valid() const { return count_ <= most_strips && std::has_single_bit(count_); }

  private:
    std::array<float, most_strips> limits_ = {};  ///< by node: the border between its two halves, m
    uint32_t count_ = 1;
    uint32_t upright_ = 0;  ///< 1: strips are above each other
};

/// The sections of a block, in the order in which they are solved. If several threads share a
/// block, each has a part of the strips, with all nodes below one node; the nodes above come last.
/// If one thread solves the block, the nodes of a level are one section.
class Sections {
  public:
    Sections() = default;
    /// `parts`: a power of two, at most the number of strips.
    Sections(uint32_t strips, uint32_t parts);

    uint32_t size() const { return size_; }
    bool shared() const { return parts_ > 1; }
    uint32_t of(StripNode node) const { return of_[node]; }
    StripNodes nodes_of(uint32_t section) const { return nodes_[section]; }
    /// Number of parts and of the nodes above them. Two threads never work for the same owner at
    /// the same time.
    uint32_t owners() const { return 2 * parts_ - 1; }
    uint32_t owner_of(StripNode node) const { return owner_[node]; }

    uint32_t parts() const { return parts_; }
    /// Number of sections of a part.
    uint32_t below() const { return (size_ - (parts_ - 1)) / parts_; }

  private:
    uint32_t parts_ = 1, size_ = 1;
    std::array<uint8_t, 2 *most_strips> of_ = {}, owner_ = {};
    std::array<StripNodes, 2 * most_strips> nodes_ = {};
};

/// Runs `work(section)` for each section, as often as `run` is called. A section runs after the
/// sections that it depends on.
template <typename Work>
class alignas(cache_line_size) SectionLoop {
  public:
    SectionLoop(const Sections& plan, ThreadPool* threads, Work work)
        : work_(std::move(work)), threads_(threads) {
        levels_[0] = {&work_, 0, plan.below()};
        uint32_t first = plan.parts() * plan.below();
        for (widths_[0] = plan.parts(); widths_[depth_ - 1] > 1; ++depth_) {
            levels_[depth_] = {&work_, first, 1};
            widths_[depth_] = widths_[depth_ - 1] / 2;
            first += widths_[depth_];
        }
    }
    SectionLoop(const SectionLoop&) = delete;
    SectionLoop& operator=(const SectionLoop&) = delete;

    void run() const {
        for (uint32_t i = 0; i < depth_; ++i) parallel_for(threads_, widths_[i], levels_[i]);
    }

  private:
    struct Level {
        const Work* work;
        uint32_t first, each;
        void operator()(uint32_t part) const {
            for (uint32_t i = 0; i < each; ++i) (*work)(first + part * each + i);
        }
    };
    static constexpr uint32_t most_levels = std::bit_width(most_strips);

    Work work_;
    ThreadPool* threads_;
    Level levels_[most_levels] = {};
    uint32_t widths_[most_levels] = {}, depth_ = 1;
};

}  // namespace fettle::physics::detail
