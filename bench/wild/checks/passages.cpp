#include "wild/checks/passages.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "wild/checks/facts.h"

namespace fettle::bench::wild {
namespace {

bool joined_without_contact(const WorldPlan& plan, int a, int b) {
    return std::ranges::any_of(plan.joints, [&](const JointPlan& joint) {
        return !joint.collide && ((joint.a == a && joint.b == b) || (joint.a == b && joint.b == a));
    });
}

/// The way of a point at distance `lever` from the origin of a body that turns is a row of chords,
/// which differ from the arc by less than a tenth of `depth`.
int chords(float lever, float turn, float depth) {
    if (lever * std::abs(turn) < 1e-3f) return 1;
    return std::clamp(int(std::abs(turn) * std::sqrt(1.25f * lever / std::max(depth, 1e-3f))), 1,
                      32);
}

/// True if the body enters a solid on one side and leaves it on the opposite one.
bool leaves_opposite(const std::vector<Passage>& way) {
    return way.size() > 1 && way.front().sense > 0 &&
           way.back().normal.dot(way.front().normal) < Passage::opposite;
}

/// The share of the step after which an impact stopped a body: it keeps the speed of its arrival,
/// but has not moved as far.
float end_of_motion(const BodyNow& before, const BodyNow& after, float dt) {
    if (after.type != BodyType::dynamic_body) return 1;
    const float way = (after.center - before.center).length();
    const float free_way = after.velocity.length() * dt;
    return way < 0.9f * free_way ? way / free_way : 1;
}

}  // namespace

Passages::Passages(const WorldPlan& plan, const Judged& judged)
    : outlines_(plan.bodies.size()), left_out_(plan.bodies.size(), false) {
    for (std::size_t i = 0; i < plan.bodies.size(); ++i)
        for (const ShapePlan& shape : plan.bodies[i].shapes)
            outlines_[i].push_back(outline_of(shape.geometry));
    for (int b = 0; b < int(plan.bodies.size()); ++b) {
        const BodyPlan& body = plan.bodies[std::size_t(b)];
        if (is_fixed(body)) continue;
        int number = 0;
        for (const ShapePlan& shape : body.shapes)
            for (const Core& core : cores_of(shape.geometry)) {
                ++number;
                for (int o = 0; o < int(plan.bodies.size()); ++o) {
                    const BodyPlan& obstacle = plan.bodies[std::size_t(o)];
                    if (o == b) continue;
                    for (int s = 0; s < int(obstacle.shapes.size()); ++s)
                        if (judged(obstacle, obstacle.shapes[std::size_t(s)], body, shape) &&
                            !joined_without_contact(plan, o, b))
                            pairs_.push_back({b, number - 1, o, s, core});
                }
            }
    }
}

std::vector<Passage> Passages::of(const Moment& moment) {
    for (std::size_t i = 0; i < left_out_.size(); ++i)
        if (moment.edited_bodies[i]) left_out_[i] = true;
    std::vector<Passage> found;
    for (const Pair& pair : pairs_) {
        const auto body = std::size_t(pair.body), obstacle = std::size_t(pair.obstacle);
        if (left_out_[body] || left_out_[obstacle]) continue;
        if (!moment.before[body].exists || !moment.before[obstacle].exists) continue;
        if (!moment.after[body].awake && !moment.before[body].awake) continue;
        add_passages(pair, moment, found);
    }
    return found;
}

bool Passages::is_around_line(int body, const Moment& moment) const {
    const BodyNow& around = moment.after[std::size_t(body)];
    return std::ranges::any_of(pairs_, [&](const Pair& pair) {
        const auto obstacle = std::size_t(pair.obstacle);
        const Outline& outline = outlines_[obstacle][std::size_t(pair.shape)];
        const BodyNow& line = moment.after[obstacle];
        if (pair.body != body || outline.kind == Outline::Kind::solid || !line.exists) return false;
        const Vec2 deep = local(placed(pair.deep.point, around.position, around.angle),
                                line.position, line.angle);
        return std::ranges::any_of(outline.edges, [&](const Edge& edge) {
            return distance_to(edge, deep) < pair.deep.depth - 0.01f;
        });
    });
}

bool Passages::is_past(const Passage& passage, const Moment& moment) const {
    // A pile presses a body that is thinner than this in by half of it, and the body comes back.
    constexpr float pressed_in = 0.01f;
    const auto obstacle = std::size_t(passage.obstacle), shape = std::size_t(passage.shape);
    const BodyNow& body = moment.after[std::size_t(passage.body)];
    const BodyNow& other = moment.after[obstacle];
    float least = pressed_in;
    for (const Core& core : cores_of(moment.plan.bodies[obstacle].shapes[shape].geometry))
        if (passage.kind == Outline::Kind::solid) least = std::min(least, 0.5f * core.depth);
    return std::ranges::any_of(pairs_, [&](const Pair& pair) {
        if (std::tuple(pair.body, pair.core, pair.obstacle, pair.shape) != passage.pair())
            return false;
        const Vec2 deep =
            local(placed(pair.deep.point, body.position, body.angle), other.position, other.angle);
        return std::ranges::all_of(outlines_[obstacle][shape].edges, [&](const Edge& edge) {
            return distance_to(edge, deep) > std::min(least, pair.deep.depth);
        });
    });
}

namespace {

/// The way of a deep point of a body in a step, in coordinates of an obstacle. Two bodies that move
/// on straight ways meet only if they are at one place at the same time.
class RelativeWay {
  public:
    RelativeWay(const Moment& moment, int body, int obstacle, const Core& deep)
        : b0_(moment.before[std::size_t(body)]),
          b1_(moment.after[std::size_t(body)]),
          o0_(moment.before[std::size_t(obstacle)]),
          o1_(moment.after[std::size_t(obstacle)]),
          deep_(deep),
          dt_(moment.dt),
          b_end_(end_of_motion(b0_, b1_, dt_)),
          o_end_(end_of_motion(o0_, o1_, dt_)),
          carried_(o1_.type == BodyType::kinematic_body && b_end_ < 1),
          last_(in_obstacle(placed(deep.point, b1_.position, b1_.angle), 1)) {
        constexpr int samples = 64;
        for (int i = 1; carried_ && i <= samples; ++i) {
            const float t = float(i) / samples;
            if (to_last(t) < to_last(arrival_)) arrival_ = t;
        }
    }

    const Vec2& last() const { return last_; }

    Vec2 place(float t) const {
        if (carried_) return t < arrival_ ? free_place(t) : last_;
        const float b = std::min(t / std::max(b_end_, 1e-6f), 1.0f);
        const float o = std::min(t / std::max(o_end_, 1e-6f), 1.0f);
        const Vec2 origin = b0_.position + b * (b1_.position - b0_.position);
        return in_obstacle(placed(deep_.point, origin, b0_.angle + b * (b1_.angle - b0_.angle)), o);
    }

    /// The ends of straight parts of the way, as shares of the step. Seen from an obstacle that
    /// turns, the body moves on an arc, too.
    std::vector<float> times() const {
        const float reach = std::max(place(0).length(), place(1).length());
        const int count = std::max(chords(deep_.point.length(), b1_.angle - b0_.angle, deep_.depth),
                                   chords(reach, o1_.angle - o0_.angle, deep_.depth));
        std::vector<float> times;
        const float first_end = carried_ ? arrival_ : std::min(b_end_, o_end_);
        for (const float end : {first_end, std::max({first_end, b_end_, o_end_}), 1.0f}) {
            const float begin = times.empty() ? 0 : times.back();
            for (int i = 1; i <= count && begin < end; ++i)
                times.push_back(begin + (end - begin) * float(i) / float(count));
        }
        return times;
    }

  private:
    Vec2 in_obstacle(const Vec2& at, float o) const {
        return local(at, o0_.position + o * (o1_.position - o0_.position),
                     o0_.angle + o * (o1_.angle - o0_.angle));
    }
    Vec2 free_place(float t) const {
        return in_obstacle(placed(deep_.point, b0_.position + t * dt_ * b1_.velocity,
                                  b0_.angle + t * (b1_.angle - b0_.angle)),
                           t);
    }
    float to_last(float t) const { return (free_place(t) - last_).length(); }

    const BodyNow &b0_, &b1_, &o0_, &o1_;
    const Core& deep_;
    float dt_, b_end_, o_end_;
    /// A body that moves by command carries along the body that it stopped: until the impact that
    /// body moved freely, and afterwards it stayed in its place on the other one.
    bool carried_;
    Vec2 last_;
    float arrival_ = 0;
};

}  // namespace

void Passages::add_crossings(const Pair& pair, const Vec2& begin, const Vec2& end,
                             std::vector<Passage>& crossed) const {
    const Outline& outline = outlines_[std::size_t(pair.obstacle)][std::size_t(pair.shape)];
    const Vec2 low = begin.min(end), high = begin.max(end);
    if (low.x > outline.box.max.x || low.y > outline.box.max.y || high.x < outline.box.min.x ||
        high.y < outline.box.min.y)
        return;
    // In the order of the way: a body that clips a corner enters before it leaves.
    std::vector<std::pair<float, Passage>> at;
    for (const Edge& edge : outline.edges)
        if (const int sense = crossing(edge, begin, end); sense != 0) {
            const Vec2 along = (edge.to - edge.from).normalized();
            at.push_back({part_of_way(edge, begin, end),
                          {pair.body, pair.core, pair.obstacle, pair.shape, sense,
                           Vec2{-along.y, along.x}, outline.kind}});
        }
    std::ranges::stable_sort(at, {}, &std::pair<float, Passage>::first);
    for (const auto& [part, passage] : at) crossed.push_back(passage);
}

void Passages::add_passages(const Pair& pair, const Moment& moment,
                            std::vector<Passage>& found) const {
    const RelativeWay relative(moment, pair.body, pair.obstacle, pair.deep);
    std::vector<Passage> on_way, straight;
    Vec2 from = relative.place(0);
    const Vec2 first = from;
    for (const float time : relative.times()) {
        const Vec2 to = relative.place(time);
        add_crossings(pair, from, to, on_way);
        from = to;
    }
    // How a body slid along an obstacle that carried it or struck it is not known: between the ends
    // of the step its way may be an arc, or straight as seen from the obstacle. A body that passed
    // through it crosses it on each. A bullet and what it meets keep their places beside each other
    // after an impact as well.
    add_crossings(pair, first, relative.last(), straight);
    const auto body = std::size_t(pair.body), obstacle = std::size_t(pair.obstacle);
    const bool unknown = moment.after[obstacle].type == BodyType::kinematic_body ||
                         moment.plan.bodies[obstacle].def.bullet ||
                         moment.plan.bodies[body].def.bullet;
    const bool harmless =
        straight.size() < on_way.size() || (leaves_opposite(on_way) && !leaves_opposite(straight));
    const auto& way = unknown && harmless ? straight : on_way;
    found.insert(found.end(), way.begin(), way.end());
}

bool touches_others(const Moment& moment, int body, int obstacle) {
    const auto other = [&](int index) { return index != obstacle; };
    return std::ranges::any_of(moment.before[std::size_t(body)].touched, other) ||
           std::ranges::any_of(moment.after[std::size_t(body)].touched, other);
}

bool is_near_other_fixed(const Moment& moment, int body, int obstacle) {
    const BodyNow& now = moment.after[std::size_t(body)];
    const float reach = reach_of(moment.plan.bodies[std::size_t(body)]) + 0.1f;
    if (const auto& bounds = moment.plan.def.bounds;
        bounds && ((now.position - bounds->min).smallest() < reach ||
                   (bounds->max - now.position).smallest() < reach))
        return true;
    for (std::size_t o = 0; o < moment.after.size(); ++o) {
        const BodyNow& other = moment.after[o];
        if (!other.exists || int(o) == obstacle || other.type == BodyType::dynamic_body) continue;
        const Vec2 place = local(now.position, other.position, other.angle);
        for (const ShapePlan& shape : moment.plan.bodies[o].shapes)
            for (const Edge& edge : outline_of(shape.geometry).edges)
                if (distance_to(edge, place) < reach) return true;
    }
    return false;
}

}  // namespace fettle::bench::wild
