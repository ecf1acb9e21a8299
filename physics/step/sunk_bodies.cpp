// A light body under a heavy pile is pressed into the ground: its contacts on both sides yield in
// proportion to their loads, and few sweeps do not bring the load of the pile to the ground. In
// small steps it got through what is fixed, which is what a player sees first. So a body that has
// sunk in deep goes no deeper: what presses it overlaps it instead, until it touches the ground
// itself. The same holds for a body that a joint presses into something fixed.

#include <contacts/border.h>
#include <distance/shape_core.h>
#include <step/obstacle.h>
#include <step/sunk_bodies.h>

#include <vector>

namespace fettle::physics::detail {
namespace {

/// The centroid of a shape stays as far as this from what is fixed, in inner radii. No load of a
/// stack presses a body so far in.
constexpr float least_apart = 0.5f;
/// A shape is looked at from this overlap on, as a part of the thickness of its body.
constexpr float noticed_share = 0.25f;
/// Between two slopes, a body is held by both in turn.
constexpr int rounds = 4;

/// A shape whose centroid may get too near to what is fixed.
struct SunkShape {
    SolverBody* body;
    Vec2 lever;  ///< from the center of mass to the centroid
    Vec2 out;    ///< away from what is fixed
    Vec2 free;   ///< the same without what is along locked axes
    float room;  ///< how far the centroid may move in, m

    /// Returns whether the body moved too far.
    bool hold() const {
        const float too_far = -dot(out, body->shift + cross(body->turn, lever)) - room;
        if (!(too_far > 0.0f)) return false;
        body->shift = body->shift + too_far * free;
        body->velocity = body->velocity + max(-dot(out, body->velocity), 0.0f) * free;
        return true;
    }
};

class SunkShapes {
  public:
    SunkShapes(const ObjectState& objects, const Columns& columns, const WorldDef& settings,
               BodyScratch& bodies)
        : objects_(objects), columns_(columns), settings_(settings), bodies_(bodies) {}

    /// `is_a`: a moves, and b is fixed; else the other way round.
    void add(const ContactRecord& c, bool is_a) {
        const BodyRecord& record = objects_.bodies[is_a ? c.body_a : c.body_b];
        if (!(deepest(c.manifold) > noticed_share * record.thickness)) return;
        const uint32_t shape = is_a ? c.shape_a : c.shape_b;
        const Vec2 lever = centroid_of(objects_, columns_, shape);
        const float inner = inner_radius(solid_of(objects_, columns_, shape), lever);
        const PointGap gap = gap_to(is_a ? c.shape_b : c.shape_a, record.center, lever, inner);
        // Behind the middle of a thin wall, the way out would be on the other side.
        const Vec2 normal = is_a ? -c.manifold.normal : c.manifold.normal;
        if (!(dot(gap.out, normal) > 0.0f)) return;
        const Vec2 free = {record.flags.locked_x ? 0.0f : gap.out.x,
                           record.flags.locked_y ? 0.0f : gap.out.y};
        sunk_.push_back({&bodies_.solver_bodies[record.solver_index], lever, gap.out, free,
                         max(gap.width - least_apart * inner, 0.0f)});
    }
    void hold() const {
        bool held = !sunk_.empty();
        for (int round = 0; held && round < rounds; ++round) {
            held = false;
            for (const SunkShape& shape : sunk_) held = shape.hold() || held;
        }
    }

  private:
    static float deepest(const Manifold& m) {
        float depth = 0.0f;
        for (int k = 0; k < m.count; ++k) depth = max(depth, -m.points[k].separation);
        return depth;
    }
    /// Between something fixed and a centroid that is nearer to it than `most`.
    PointGap gap_to(uint32_t fixed, const Position& center, Vec2 lever, float most) const {
        const ShapeForm& form = objects_.forms[fixed];
        if (form.kind == FormKind::border) {
            const BorderPlane plane = border_plane(*settings_.bounds, fixed);
            return {plane.normal, float(dot(plane.normal, center + lever) - plane.depth)};
        }
        const Vec2 centroid = (center - objects_.bodies[form.body].center) + lever;
        return gap_to_point(solid_of(objects_, columns_, fixed), centroid, most);
    }

    const ObjectState& objects_;
    const Columns& columns_;
    const WorldDef& settings_;
    BodyScratch& bodies_;
    std::vector<SunkShape> sunk_;
};

}  // namespace

void hold_sunk(const ObjectState& objects, const Columns& columns, const WorldDef& settings,
               const ContactScratch& contacts, BodyScratch& bodies) {
    SunkShapes sunk(objects, columns, settings, bodies);
    for (const ActingPiece& piece : contacts.acting_pieces) {
        for (uint32_t i = piece.begin; i < piece.end(); ++i) {
            const ActingContact& acting = contacts.acting[i];
            if (acting.both_move()) continue;
            const ContactRecord& c = objects.contacts[acting.slot];
            const bool is_a = acting.moves_a();
            if (objects.bodies[is_a ? c.body_b : c.body_a].mobility == Mobility::fixed)
                sunk.add(c, is_a);
        }
    }
    sunk.hold();
}

}  // namespace fettle::physics::detail
