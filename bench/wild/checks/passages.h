#pragma once
// Where the insides of bodies cross the outlines of others in a step. A point deep in a body cannot
// be in another solid, so a crossing means an overlap as deep as the body itself.

#include <functional>
#include <string>
#include <tuple>
#include <vector>

#include "wild/checks/check.h"
#include "wild/checks/outlines.h"

namespace fettle::bench::wild {

struct Passage {
    int body = 0, core = 0;       // of the moving body
    int obstacle = 0, shape = 0;  // of the other body
    int sense = 0;                // 1 from the front, -1 from behind
    Vec2 normal = {};             // of the edge, to its front; in coordinates of the obstacle
    Outline::Kind kind{};

    /// The cosine of the angle between the normals of two opposite sides is smaller.
    static constexpr float opposite = -0.3f;
    auto pair() const { return std::tuple(body, core, obstacle, shape); }
};

class Passages {
  public:
    /// `judged`: whether a shape of a body and a shape of an obstacle matter to the check.
    using Judged = std::function<bool(const BodyPlan& obstacle, const ShapePlan& of_obstacle,
                                      const BodyPlan& body, const ShapePlan& of_body)>;
    Passages(const WorldPlan& plan, const Judged& judged);

    /// Bodies whose shape, pose or kind was edited are left out from then on.
    std::vector<Passage> of(const Moment& moment);
    /// Whether a segment or a chain is deeper than 1 cm in a body. A one-sided one has no contact
    /// with a body that is mostly behind it.
    bool is_around_line(int body, const Moment& moment) const;
    /// Whether a body is farther in or behind the obstacle than a load presses it.
    bool is_past(const Passage& passage, const Moment& moment) const;
    bool is_left_out(int body) const { return left_out_[std::size_t(body)]; }

  private:
    struct Pair {
        int body, core, obstacle, shape;
        Core deep;
    };
    void add_passages(const Pair& pair, const Moment& moment, std::vector<Passage>& found) const;
    /// Adds the crossings of a straight part of the way, in coordinates of the obstacle.
    void add_crossings(const Pair& pair, const Vec2& begin, const Vec2& end,
                       std::vector<Passage>& crossed) const;

    std::vector<Pair> pairs_;
    std::vector<std::vector<Outline>> outlines_;  // by body and shape
    std::vector<bool> left_out_;
};

/// Whether a body touches anything else than this obstacle: then it may be pressed through.
bool touches_others(const Moment& moment, int body, int obstacle);

/// Whether another static or kinematic body, or the border, is within reach of a body: the two may
/// have pressed it within one step, before there was a contact with the other one.
bool is_near_other_fixed(const Moment& moment, int body, int obstacle);

}  // namespace fettle::bench::wild
