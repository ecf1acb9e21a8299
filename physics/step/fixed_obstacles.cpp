#include <distance/shape_core.h>
#include <step/obstacle.h>

#include <algorithm>
#include <vector>

// When a moving body meets fixed shapes.

namespace fettle::physics::detail {
namespace {

/// A body that slides is stopped by what it would get into by more than this, in inner radii.
constexpr float blocked_share = 0.25f;

/// Visits the shapes of a body, each with the fixed shapes on its way from `now` to 1.
void for_each_fixed_on_way(const FinishInput& in, uint32_t body, const Motion& motion, float now,
                           auto&& visit) {
    for_each_pushing(in.objects, body, [&](uint32_t s) {
        const Box4 swept = swept_box(in, s, motion, now);
        const auto meet = [&](uint32_t other) {
            if (may_meet(in, s, other)) visit(s, other);
        };
        in.boxes.fixed_tree.query(swept, meet);
        for (uint32_t side = 0; in.settings.bounds && side < border_sides; ++side)
            if (overlap(swept, in.boxes.fat_boxes[side])) meet(side);
    });
}

/// The way of a body between fixed shapes.
class WayBetweenFixed {
  public:
    WayBetweenFixed(const FinishInput& in, uint32_t body, const Motion& motion, float now)
        : in_(in), record_(in.objects.bodies[body]), motion_(motion), now_(now) {
        for_each_fixed_on_way(in, body, motion, now, [&](uint32_t s, uint32_t other) {
            const float arrival = time_of(s, other, 0.0f, hit_gap);
            if (arrival < 1.0f) meetings_.push_back({s, other, arrival});
        });
        // Of obstacles that are met at the same time, the first one counts. The order in the tree
        // depends on its history.
        std::sort(meetings_.begin(), meetings_.end(), [](const Meeting& a, const Meeting& b) {
            return a.shape != b.shape ? a.shape < b.shape : a.other < b.other;
        });
    }

    Impact impact() {
        Impact first;
        if (!is_beside()) {
            for (const Meeting& meeting : meetings_) first.time = min(first.time, meeting.arrival);
            return first;
        }
        if (!(way_of(record_, motion_) > near_motion(record_))) return first;
        for (const auto& [s, other, arrival] : meetings_) {
            if (arrival < first.time && is_blocked(s, other, arrival)) first = {arrival, {}, {}};
            const Impact impact = time_of_impact(in_, s, motion_, other, motion_of(other), now_);
            if (impact.time < first.time) first = impact;
        }
        return first;
    }

  private:
    struct Meeting {
        uint32_t shape, other;
        float arrival;
    };

    Motion motion_of(uint32_t fixed) const {
        return at_rest(in_.objects.bodies[in_.objects.forms[fixed].body].center);
    }
    /// When the part of a shape that is deeper than `depth` gets as near as `gap`.
    float time_of(uint32_t s, uint32_t other, float depth, float gap) const {
        const Obstacle obstacle(in_, other, motion_of(other), now_);
        if (obstacle.is_from_behind(centroid_at(in_, s, motion_, now_))) return 1.0f;
        const Core core(solid_of(in_.objects, in_.columns, s), centroid_of(in_, s), depth);
        return obstacle.time_of({core.solid(), motion_, record_.extent}, gap);
    }
    /// True if the step may have solved a contact of the body with something fixed.
    bool is_beside() const {
        return std::any_of(meetings_.begin(), meetings_.end(), [&](const Meeting& m) {
            return !(time_of(m.shape, m.other, 0.0f, speculative_margin) > now_);
        });
    }
    /// True if a shape of a body that lies, slides or rolls on something would get deep into
    /// another obstacle: a wheel into a kerb. The seams of a floor do not count: they are met by no
    /// core that is deeper than what lies on the floor sinks in.
    bool is_blocked(uint32_t s, uint32_t other, float arrival) const {
        const Solid shape = solid_of(in_.objects, in_.columns, s);
        const float inner = inner_radius(shape, centroid_of(in_, s));
        const Obstacle obstacle(in_, other, motion_of(other), now_);
        if (!(arrival > now_)) return false;
        const Vec2 normal = obstacle.direction_to({shape, motion_, record_.extent}, arrival);
        const float deep = -dot(normal, motion_.velocity) * (1.0f - arrival);
        if (!(deep > blocked_share * inner)) return false;
        float depth = speculative_margin;
        while (depth < 0.5f * inner && lies_deeper(s, depth)) depth *= 2.0f;
        return depth < 0.5f * inner && time_of(s, other, depth, hit_gap) < 1.0f;
    }
    /// True if the shape is in something fixed by more than `depth` already.
    bool lies_deeper(uint32_t s, float depth) const {
        return std::any_of(meetings_.begin(), meetings_.end(), [&](const Meeting& m) {
            return m.shape == s && !(time_of(s, m.other, depth, hit_gap) > now_);
        });
    }

    const FinishInput& in_;
    const BodyRecord& record_;
    const Motion& motion_;
    const float now_;
    std::vector<Meeting> meetings_;
};

}  // namespace

Impact time_of_impact_with_fixed(const FinishInput& in, uint32_t body, const Motion& motion,
                                 float now) {
    return WayBetweenFixed(in, body, motion, now).impact();
}

}  // namespace fettle::physics::detail
