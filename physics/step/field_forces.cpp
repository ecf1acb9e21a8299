// Forces of fields on bodies.

#include <collision/ellipse.h>
#include <collision/large_polygon.h>
#include <collision/outline_piece.h>
#include <distance/distance.h>
#include <geometry/trigonometry.h>
#include <state/limits.h>
#include <step/field_effect.h>
#include <step/gather.h>
#include <step/shape_box.h>

#include <algorithm>

namespace fettle::physics::detail {
namespace {

bool inside(const std::optional<Aabb>& region, const Position& p) {
    return !region || (p.x >= region->min.x && p.x <= region->max.x && p.y >= region->min.y &&
                       p.y <= region->max.y);
}

class FieldOnBody {
  public:
    FieldOnBody(const ObjectState& objects, const Columns& columns, Vec2 gravity, uint32_t body,
                uint64_t mask, float h, float dt, FieldEffect& push, Attractions& attractions)
        : objects_(objects),
          columns_(columns),
          gravity_(gravity),
          lead_(0.5f * (dt - h)),
          body_(objects.bodies[body]),
          velocity_(columns.states[body].velocity),
          spin_(columns.states[body].angular_velocity),
          mask_(mask),
          effect_(push),
          attractions_(attractions) {}

    void operator()(const WindField& wind) {
        each_shape([&](uint32_t shape) {
            const PlainCopy plain(solid_of(objects_, columns_, shape));
            const Solid& solid = plain.solid();
            if (solid.kind == FormKind::ellipse)
                blow_on_ellipse(wind, ellipse_of(solid.form));
            else
                blow_on_polygon(wind, solid);
        });
    }

    void operator()(const DragField& drag) {
        each_shape([&](uint32_t shape) {
            const ShapeRecord& m = objects_.shapes[shape];
            const Vec2 arm = centroid_of(shape);
            const Vec2 u = velocity_at(arm) - drag.flow;
            const float per_area = drag.linear + drag.quadratic * length(u);
            effect_.resist(arm, double(m.area) * double(per_area), u);
            effect_.resist_turn(double(m.moment) * double(drag.linear), spin_);
        });
    }

    void operator()(const BuoyancyField& liquid) {
        const Vec2 normal = normalized(liquid.normal), shift = lead_ * velocity_;
        const Rotation turned = rotation_of(double(lead_) * double(spin_));
        const double depth =
            double(liquid.level) - (double(normal.x) * (double(body_.center.x) + double(shift.x)) +
                                    double(normal.y) * (double(body_.center.y) + double(shift.y)));
        each_shape([&](uint32_t shape) {
            const AreaPart part =
                part_below(solid_of(objects_, columns_, shape), unrotate(turned, normal), depth);
            if (!(part.area > 0.0)) return;
            const Vec2 arm = rotate(turned, part.centroid);
            const float mass = liquid.density * float(part.area);
            effect_.at(arm, -(mass * gravity_));
            effect_.resist(arm, double(liquid.drag) * double(mass), velocity_at(arm) - liquid.flow);
            const ShapeRecord& m = objects_.shapes[shape];
            const double share = m.area > 0.0f ? part.area / double(m.area) : 0.0;
            effect_.resist_turn(
                double(liquid.drag) * double(liquid.density) * share * double(m.moment), spin_);
        });
    }

    void operator()(const AttractorField& attractor) {
        // The mean force, for the resistances; each sub-step corrects it.
        effect_.at({}, body_.mass * pull_of(attractor, body_.center + lead_ * velocity_));
        attractions_.attractors.push_back(attractor);
    }

  private:
    void each_shape(auto&& visit) const {
        for (uint32_t s = body_.lists.first_shape; s != none; s = objects_.shapes[s].next) {
            const ShapeDef& surface = objects_.shapes[s].surface;
            if (!objects_.is_solid(s)) continue;  // its parts are used instead
            if ((surface.category & mask_) != 0 && !surface.sensor) visit(s);
        }
    }
    Vec2 blow(const WindField& wind, Vec2 arm) const { return wind.velocity - velocity_at(arm); }
    void blow_on_edge(const WindField& wind, Vec2 arm, Vec2 n, float length) {
        const float speed = dot(blow(wind, arm), n);
        if (speed >= 0.0f) return;  // on the side away from the wind
        effect_.resist_along(n, arm, 0.5 * double(wind.density) * double(-speed) * double(length),
                             -speed);
    }
    void blow_on_polygon(const WindField& wind, const Solid& solid) {
        const Convex& form = solid.form;
        Vec2 middle;
        for (int i = 0; i < form.count; ++i) {
            const Vec2 v = form.vertices[i], next = form.vertices[(i + 1) % form.count];
            middle = middle + (1.0f / float(form.count)) * v;
            if (form.count == 1) break;
            if (solid.kind == FormKind::piece && OutlinePiece(solid).is_inner(i)) continue;
            const Vec2 n = form.normals[i], arm = 0.5f * (v + next) + form.radius * n;
            blow_on_edge(wind, arm, n, length(next - v));
        }
        // The round corners together form a circle: ∫ cos³θ r dθ over its windward half.
        const Vec2 u = blow(wind, middle);
        const float resistance = 0.5f * wind.density * (4.0f / 3.0f) * form.radius * length(u);
        effect_.resist(middle, double(resistance), -u);
    }
    /// The same integral over the rim, by the midpoint rule.
    void blow_on_ellipse(const WindField& wind, const EllipseForm& e) {
        constexpr int parts = 64;
        const Vec2 across = {-e.axis.y, e.axis.x};
        const Rotation step = rotation_of(2.0 * double(pi) / parts);
        Rotation q = rotation_of(double(pi) / parts);
        for (int i = 0; i < parts; ++i) {
            const Vec2 arm = e.center + (e.first * q.c) * e.axis + (e.second * q.s) * across;
            const Vec2 outwards = (e.second * q.c) * e.axis + (e.first * q.s) * across;
            blow_on_edge(wind, arm, normalized(outwards), 2.0f * pi / parts * length(outwards));
            q = {q.c * step.c - q.s * step.s, q.s * step.c + q.c * step.s};
        }
    }
    Vec2 velocity_at(Vec2 arm) const { return velocity_ + cross(spin_, arm); }
    Vec2 centroid_of(uint32_t shape) const {
        const Vec2 local = objects_.shapes[shape].centroid - body_.local_center;
        const BodyState& state = columns_.states[objects_.forms[shape].body];
        return rotate({state.cosine, state.sine}, local);
    }

    const ObjectState& objects_;
    const Columns& columns_;
    Vec2 gravity_;
    /// The time from the start of the step to the moment at which forces that depend on the place
    /// are computed. The sub-steps move the body with the velocity after each share of the force.
    /// One impulse of the whole force, half a sub-step before the middle of the step, would have
    /// the same effect. With the force at the place of the body at that time this is a leapfrog
    /// method: orbits stay closed, and what floats gains no height.
    float lead_;
    const BodyRecord& body_;
    Vec2 velocity_;
    float spin_;
    uint64_t mask_;
    FieldEffect& effect_;
    Attractions& attractions_;
};

bool acts_on_body(const ObjectState& objects, const Columns& columns, std::span<const Box4> boxes,
                  uint32_t body, const FieldRecord& record) {
    const FieldDef& field = record.def;
    if (record.generation == 0 || !field.enabled) return false;
    const bool liquid = std::holds_alternative<BuoyancyField>(field.force);
    if (!liquid && !inside(field.region, objects.bodies[body].center)) return false;
    bool any = objects.bodies[body].lists.first_shape == none;
    for (uint32_t s = objects.bodies[body].lists.first_shape; s != none && !any;
         s = objects.shapes[s].next) {
        any = (objects.shapes[s].surface.category & field.mask) != 0 &&
              (!liquid || !field.region ||
               overlap(*field.region, box_of_shape(objects, columns, boxes, s)));
    }
    return any;
}

/// Adds the push to the forces of the sub-steps.
void add_push(const FieldEffect& push, const BodyRecord& record, float h, float dt,
              SolverForce& f) {
    const double substeps = double(dt) / double(h);
    const Twist inverse = {record.flags.locked_x ? 0.0 : double(record.inverse_mass),
                           record.flags.locked_y ? 0.0 : double(record.inverse_mass),
                           record.flags.locked_rotation ? 0.0 : double(record.inverse_inertia)};
    const Twist before = {substeps * double(f.change.x), substeps * double(f.change.y),
                          substeps * double(f.turn_change)};
    const Twist change = push.change(before, inverse, double(dt));
    const float limit = 2 * greatest_speed;
    f.change = {float(bounded(change[0] / substeps, limit)),
                float(bounded(change[1] / substeps, limit))};
    f.turn_change = float(bounded(change[2] / substeps, limit));
}

/// Adds a body that the attractors from `first` on pull. `place`: where their mean force, which its
/// forces contain, was computed.
void attract(const BodyRecord& record, uint32_t solver_index, uint32_t first, const Position& place,
             float h, Attractions& to) {
    AttractedBody body;
    body.center = record.center;
    body.moves = {record.flags.locked_x ? 0.0f : 1.0f, record.flags.locked_y ? 0.0f : 1.0f};
    body.begin = first;
    body.end = uint32_t(to.attractors.size());
    body.usual = body.now = to.change_at(body, place, h, greatest_speed);
    to.bodies.push_back(body);
    to.of_body.resize(solver_index + 1, 0);
    to.of_body[solver_index] = uint32_t(to.bodies.size());
}

}  // namespace

bool in_any_field(const ObjectState& objects, const Columns& columns, std::span<const Box4> boxes,
                  uint32_t body) {
    if (objects.field_slots.count == 0) return false;
    return std::any_of(objects.fields.begin(), objects.fields.end(), [&](const FieldRecord& each) {
        return acts_on_body(objects, columns, boxes, body, each);
    });
}

void apply_fields(const ObjectState& objects, const Columns& columns, std::span<const Box4> boxes,
                  std::span<const uint32_t> awake, Vec2 gravity, float h, float dt,
                  BodyScratch& bodies) {
    Attractions& attractions = bodies.attractions;
    attractions.clear();
    if (objects.field_slots.count == 0) return;
    for (size_t i = 0; i < awake.size(); ++i) {
        const uint32_t body = awake[i];
        const BodyRecord& record = objects.bodies[body];
        if (record.mobility != Mobility::dynamic) continue;
        FieldEffect push;
        bool pushed = false;
        const auto first = uint32_t(attractions.attractors.size());
        for (const FieldRecord& field : objects.fields) {
            if (!acts_on_body(objects, columns, boxes, body, field)) continue;
            pushed = true;
            std::visit(FieldOnBody(objects, columns, gravity, body, field.def.mask, h, dt, push,
                                   attractions),
                       field.def.force);
        }
        if (pushed) add_push(push, record, h, dt, bodies.solver_forces[i + 1]);
        if (attractions.attractors.size() == first) continue;
        const float lead = 0.5f * (dt - h);
        attract(record, uint32_t(i + 1), first,
                record.center + lead * columns.states[body].velocity, h, attractions);
    }
    if (!attractions.empty()) attractions.of_body.resize(awake.size() + 1, 0);
}

}  // namespace fettle::physics::detail
