#include <contacts/narrow_phase.h>
#include <distance/distance.h>
#include <step/time_of_impact.h>

#include <algorithm>
#include <tuple>

// Sensors that fast bodies move through between two steps, and fast sensors that move past bodies.
// Contacts report only what overlaps at the beginning of a step.

namespace fettle::physics::detail {
namespace {

/// Number of fast bodies in a task of a thread.
constexpr size_t crossed_bodies_at_a_time = 16;
/// A sensor detects a shape that comes as near as this part of the extent of the smaller body.
constexpr float crossing_gap = 1e-4f;

class Search {
  public:
    Search(const FinishInput& in, std::vector<Crossing>& found) : in_(in), found_(found) {}

    void find_crossings(size_t place) {
        const FastBody& fast = in_.scratch.fast_bodies[place];
        in_.objects.for_each_solid_of(fast.body, [&](uint32_t s) {
            const Box4 swept = swept_box(in_, s, fast.motion, 0.0f);
            const auto compare_with_slow = [&](uint32_t other) {
                const uint32_t body = in_.objects.forms[other].body;
                if (is_sensor(s) == is_sensor(other) || in_.scratch.mover_of[body] != none) return;
                compare(s, fast.motion, other, at_rest(in_.objects.bodies[body].center));
            };
            in_.boxes.fixed_tree.query(swept, compare_with_slow);
            in_.boxes.moving_tree.query(swept, compare_with_slow);
            if (is_sensor(s)) compare_with_fast(s, fast, swept);
        });
    }

  private:
    bool is_sensor(uint32_t shape) const { return in_.objects.shapes[shape].surface.sensor; }
    /// A fast body may be far from where it met the sensor, so that it is not found in the tree.
    void compare_with_fast(uint32_t sensor, const FastBody& fast, const Box4& swept) {
        for (const FastBody& other : in_.scratch.fast_bodies) {
            in_.objects.for_each_solid_of(other.body, [&](uint32_t o) {
                if (!is_sensor(o) && overlap(swept, swept_box(in_, o, other.motion, 0.0f)))
                    compare(sensor, fast.motion, o, other.motion);
            });
        }
    }
    void compare(uint32_t s, const Motion& motion, uint32_t other, const Motion& other_motion) {
        const ObjectState& objects = in_.objects;
        const uint32_t body = objects.forms[s].body, other_body = objects.forms[other].body;
        if (!filters_agree(objects, s, other) || joint_forbids_contact(objects, body, other_body))
            return;
        const BodyRecord &a = objects.bodies[body], &b = objects.bodies[other_body];
        const Solid shape = solid_of(objects, in_.columns, s);
        const Solid other_shape = solid_of(objects, in_.columns, other);
        const Sweep sweep = {shape, motion, a.extent};
        const Sweep other_sweep = {other_shape, other_motion, b.extent};
        // The extent of a static body is 0.
        const float gap = crossing_gap * min(a.extent > 0.0f ? a.extent : b.extent,
                                             b.extent > 0.0f ? b.extent : a.extent);
        float time = time_of_impact(sweep, other_sweep, gap);
        if (time == 0.0f) {
            // If they overlap at first, their contact decided. If not, they may part at once.
            if (time_of_impact(sweep, other_sweep, 0.0f) == 0.0f) return;
            time = time_of_impact(sweep, other_sweep, gap, 0.01f);
        }
        if (time >= 1.0f) return;
        const uint32_t sensor = is_sensor(s) ? s : other, visitor = is_sensor(s) ? other : s;
        found_.push_back({objects.named_shape(sensor), objects.named_shape(visitor), sensor,
                          visitor, overlap_at_end(s, shape, other, other_shape, gap)});
    }
    /// True if the contact of the two shapes will report them in the next step.
    bool overlap_at_end(uint32_t s, const Solid& shape, uint32_t other, const Solid& other_shape,
                        float gap) const {
        const ObjectState& objects = in_.objects;
        const uint32_t body = objects.forms[s].body, other_body = objects.forms[other].body;
        if (shape.kind != FormKind::piece && other_shape.kind != FormKind::piece) {
            const Vec2 apart = objects.bodies[other_body].center - objects.bodies[body].center;
            return nearest_points(shape, other_shape, apart).distance <= gap;
        }
        ContactRecord contact;
        contact.shape_a = s;
        contact.shape_b = other;
        contact.body_a = body;
        contact.body_b = other_body;
        Manifold manifold;
        collide_special_forms(objects, in_.columns, in_.settings, contact, 0.0f, false, manifold);
        return manifold.count > 0;
    }

    const FinishInput& in_;
    std::vector<Crossing>& found_;
};

}  // namespace

void report_crossings(const FinishInput& in) {
    const std::vector<FastBody>& fast = in.scratch.fast_bodies;
    std::vector<std::vector<Crossing>>& pieces = in.scratch.crossings;
    std::vector<uint32_t>& mover_of = in.scratch.mover_of;
    mover_of.resize(in.objects.bodies.size(), none);
    for (size_t i = 0; i < fast.size(); ++i) mover_of[fast[i].body] = uint32_t(i);
    pieces.resize((fast.size() + crossed_bodies_at_a_time - 1) / crossed_bodies_at_a_time);
    parallel_for(in.threads, fast.size(), crossed_bodies_at_a_time, [&](size_t begin, size_t end) {
        std::vector<Crossing>& found = pieces[begin / crossed_bodies_at_a_time];
        found.clear();
        Search search(in, found);
        for (size_t i = begin; i < end; ++i) search.find_crossings(i);
    });
    for (const FastBody& body : fast) mover_of[body.body] = none;

    std::vector<Crossing> all;
    for (const std::vector<Crossing>& found : pieces)
        all.insert(all.end(), found.begin(), found.end());
    const auto key = [](const Crossing& c) {
        return std::tuple(c.sensor, c.visitor, c.part_of_sensor, c.part_of_visitor);
    };
    std::sort(all.begin(), all.end(),
              [&](const Crossing& a, const Crossing& b) { return key(a) < key(b); });
    for (auto begin = all.begin(); begin != all.end();) {
        const auto end = std::find_if(begin, all.end(), [&](const Crossing& c) {
            return c.sensor != begin->sensor || c.visitor != begin->visitor;
        });
        const auto agrees = [&](const Crossing& c) {
            return is_allowed(in, c.part_of_sensor, c.part_of_visitor);
        };
        if (!touch(in.objects, begin->sensor, begin->visitor) &&
            std::none_of(begin, end, [](const Crossing& c) { return c.overlapped; }) &&
            std::any_of(begin, end, agrees))
            report_crossing(in.list.touching, in.later, begin->sensor, begin->visitor);
        begin = end;
    }
}

}  // namespace fettle::physics::detail
