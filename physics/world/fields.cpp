#include <collision/ellipse.h>
#include <collision/large_polygon.h>
#include <collision/piece.h>
#include <collision/submerged.h>
#include <geometry/trigonometry.h>
#include <world/arguments.h>
#include <world/world_data.h>

#include <stdexcept>

// Fields of force: once a step they add to what the sub-steps do to the awake bodies. A force that
// resists never takes more in a step than there is: that keeps thick air stable.

namespace fettle::physics {

using namespace detail;

namespace detail {
namespace {

/// What fields do to one body.
struct Push {
    V2 force;
    float torque = 0.0f;

    void at(V2 arm, V2 f) {
        force = force + f;
        torque += cross(arm, f);
    }
};

bool inside(const std::optional<Aabb>& region, V2 p) {
    return !region || (p.x >= region->min.x() && p.x <= region->max.x() && p.y >= region->min.y() &&
                       p.y <= region->max.y());
}

bool reaches(const std::optional<Aabb>& region, const Box4& box) {
    return !region || overlap(box, Box4{to_v2(region->min), to_v2(region->max)});
}

class FieldOnBody {
  public:
    FieldOnBody(const WorldData& data, uint32_t body, uint64_t mask, float dt, Push& push)
        : data_(data),
          dt_(dt),
          body_(data.bodies[body]),
          velocity_(to_v2(data.states[body].velocity)),
          spin_(data.states[body].angular_velocity),
          mask_(mask),
          push_(push) {}

    void operator()(const WindField& wind) {
        each_shape([&](uint32_t shape) {
            const PlainCopy plain(data_.solid(shape));
            const Solid& solid = plain.solid();
            if (solid.kind == FormKind::ellipse)
                blow_on_ellipse(wind, ellipse_of(solid.form));
            else
                blow_on_polygon(wind, solid);
        });
    }

    void operator()(const DragField& drag) {
        each_shape([&](uint32_t shape) {
            const ShapeRecord& m = data_.shapes[shape];
            const V2 arm = centroid_of(shape);
            const V2 u = to_v2(drag.flow) - velocity_at(arm);
            push_.at(arm, (m.area * (drag.linear + drag.quadratic * length(u))) * u);
            push_.torque -= m.moment * drag.linear * spin_;
        });
    }

    void operator()(const BuoyancyField& liquid) {
        const V2 normal = normalized(to_v2(liquid.normal));
        const V2 gravity = to_v2(data_.settings.gravity);
        each_shape([&](uint32_t shape) {
            const double depth = double(liquid.level) - (double(normal.x) * double(body_.center.x) +
                                                         double(normal.y) * double(body_.center.y));
            const AreaPart part = part_below(data_.solid(shape), normal, depth);
            if (!(part.area > 0.0)) return;
            const float mass = liquid.density * float(part.area);
            push_.at(part.centroid, -(mass * gravity));
            const V2 u = to_v2(liquid.flow) - velocity_at(part.centroid);
            push_.at(part.centroid, (liquid.drag * mass) * u);
            const ShapeRecord& m = data_.shapes[shape];
            const float share = m.area > 0.0f ? float(part.area / double(m.area)) : 0.0f;
            push_.torque -= liquid.drag * liquid.density * share * m.moment * spin_;
        });
    }

    void operator()(const AttractorField& attractor) {
        // Where the body is in the middle of the step: a leapfrog, which keeps orbits closed.
        const V2 d = to_v2(attractor.center) - (body_.center + (0.5f * dt_) * velocity_);
        const float distance = length(d);
        const float far = max(distance, attractor.core);
        float acceleration = attractor.strength;
        for (int i = 0; i < attractor.falloff; ++i) acceleration /= far;
        // Within the core it falls linearly to nothing.
        push_.force = push_.force + (body_.mass * acceleration / max(far, 1e-6f)) * d;
    }

  private:
    template <class Visit>
    void each_shape(Visit&& visit) const {
        for (uint32_t s = body_.first_shape; s != none; s = data_.shapes[s].next) {
            const ShapeDef& surface = data_.shapes[s].surface;
            if (!data_.is_solid(s)) continue;  // its parts are
            if ((surface.category & mask_) != 0 && !surface.sensor) visit(s);
        }
    }
    V2 blow(const WindField& wind, V2 arm) const { return to_v2(wind.velocity) - velocity_at(arm); }
    void blow_on_edge(const WindField& wind, V2 arm, V2 n, float length) {
        const float speed = dot(blow(wind, arm), n);
        if (speed >= 0.0f) return;  // on the lee
        push_.at(arm, (-0.5f * wind.density * speed * speed * length) * n);
    }
    void blow_on_polygon(const WindField& wind, const Solid& solid) {
        const Convex& form = solid.form;
        V2 middle;
        for (int i = 0; i < form.count; ++i) {
            const V2 v = form.vertices[i], next = form.vertices[(i + 1) % form.count];
            middle = middle + (1.0f / float(form.count)) * v;
            if (form.count == 1) break;
            if (solid.kind == FormKind::piece && Piece(solid).is_inner(i)) continue;
            const V2 n = form.normals[i], arm = 0.5f * (v + next) + form.radius * n;
            blow_on_edge(wind, arm, n, length(next - v));
        }
        // The round corners together are a circle: ∫ cos³θ r dθ over its windward half.
        const V2 u = blow(wind, middle);
        push_.at(middle, (0.5f * wind.density * (4.0f / 3.0f) * form.radius * length(u)) * u);
    }
    /// The same integral over the rim, by the midpoint rule.
    void blow_on_ellipse(const WindField& wind, const EllipseForm& e) {
        constexpr int parts = 64;
        const V2 across = {-e.axis.y, e.axis.x};
        const Rotation step = rotation_of(2.0 * double(pi) / parts);
        Rotation q = rotation_of(double(pi) / parts);
        for (int i = 0; i < parts; ++i) {
            const V2 arm = e.center + (e.first * q.c) * e.axis + (e.second * q.s) * across;
            const V2 outwards = (e.second * q.c) * e.axis + (e.first * q.s) * across;
            blow_on_edge(wind, arm, normalized(outwards), 2.0f * pi / parts * length(outwards));
            q = {q.c * step.c - q.s * step.s, q.s * step.c + q.c * step.s};
        }
    }
    V2 velocity_at(V2 arm) const { return velocity_ + cross(spin_, arm); }
    V2 centroid_of(uint32_t shape) const {
        const V2 local = data_.shapes[shape].centroid - body_.local_center;
        const BodyState& state = data_.states[data_.forms[shape].body];
        return rotate({state.cosine, state.sine}, local);
    }

    const WorldData& data_;
    float dt_;
    const BodyRecord& body_;
    V2 velocity_;
    float spin_;
    uint64_t mask_;
    Push& push_;
};

bool concerns(const WorldData& data, uint32_t body, const FieldDef& field) {
    const bool liquid = std::holds_alternative<BuoyancyField>(field.force);
    if (!liquid && !inside(field.region, data.bodies[body].center)) return false;
    bool any = data.bodies[body].first_shape == none;
    for (uint32_t s = data.bodies[body].first_shape; s != none && !any; s = data.shapes[s].next) {
        any = (data.shapes[s].surface.category & field.mask) != 0 &&
              (!liquid || reaches(field.region, data.boxes[s]));
    }
    return any;
}

/// Resistance changes a velocity by no more than what it is against its surroundings.
V2 limited(V2 force, float mass, float dt, V2 against) {
    const float most = mass * length(against) / dt, size = length(force);
    return size > most && size > 0.0f ? (most / size) * force : force;
}

}  // namespace

/// Adds to the forces of a sub-step of length `h` of a step of `dt`.
void WorldData::apply_fields(float h, float dt) {
    if (field_slots.count == 0) return;
    for (size_t i = 0; i < awake_bodies.size(); ++i) {
        const uint32_t body = awake_bodies[i];
        const BodyRecord& record = bodies[body];
        if (record.mobility != Mobility::dynamic) continue;
        Push sum;
        for (const FieldRecord& field : fields) {
            if (field.generation == 0 || !field.def.enabled || !concerns(*this, body, field.def))
                continue;
            Push push;
            std::visit(FieldOnBody(*this, body, field.def.mask, dt, push), field.def.force);
            const V2 velocity = to_v2(states[body].velocity);
            if (const auto* wind = std::get_if<WindField>(&field.def.force))
                push.force = limited(push.force, record.mass, dt, to_v2(wind->velocity) - velocity);
            if (const auto* drag = std::get_if<DragField>(&field.def.force))
                push.force = limited(push.force, record.mass, dt, to_v2(drag->flow) - velocity);
            if (std::get_if<AttractorField>(&field.def.force) == nullptr)
                push.torque =
                    clamp(push.torque, -record.inertia * 10.0f / dt, record.inertia * 10.0f / dt);
            sum.force = sum.force + push.force;
            sum.torque += push.torque;
        }
        SolverForce& f = solver_forces[i + 1];
        const float limit = 2 * greatest_speed;
        f.change = bounded(f.change + (h * record.inverse_mass) * sum.force, limit);
        f.turn_change = bounded(f.turn_change + h * record.inverse_inertia * sum.torque, limit);
    }
}

}  // namespace detail

namespace {

struct FieldCheck {
    void operator()(const WindField& f) const {
        check_finite("velocity", f.velocity);
        check_not_negative("density", f.density);
    }
    void operator()(const DragField& f) const {
        check_finite("flow", f.flow);
        check_not_negative("linear", f.linear);
        check_not_negative("quadratic", f.quadratic);
    }
    void operator()(const BuoyancyField& f) const {
        check_finite("level", f.level);
        check_direction("normal", f.normal);
        check_not_negative("density", f.density);
        check_not_negative("drag", f.drag);
        check_finite("flow", f.flow);
    }
    void operator()(const AttractorField& f) const {
        check_coordinates("center", f.center);
        check_finite("strength", f.strength);
        check_count("falloff", f.falloff, 0, 3);
        check_not_negative("core", f.core);
    }
};

}  // namespace

void detail::check(const FieldDef& def) {
    std::visit(FieldCheck{}, def.force);
    if (def.region) check_box("region", *def.region);
}

Field World::create_field(const FieldDef& def) {
    WorldData& data = populate(__func__);
    check(def);
    uint32_t slot = data.field_slots.free;
    if (slot != none) {
        data.field_slots.free = data.fields[slot].next_free;
    } else {
        slot = uint32_t(data.fields.size());
        data.fields.emplace_back();
    }
    data.fields[slot] = {def, data.new_generation(), none};
    ++data.field_slots.count;
    data.wake_all();
    return {this, {slot, data.fields[slot].generation}};
}

namespace {

bool lives(const WorldData& data, FieldId id) {
    return id.generation != 0 && id.index < data.fields.size() &&
           data.fields[id.index].generation == id.generation;
}

}  // namespace

bool World::is_valid(FieldId id) const {
    return lives(*data_, id);
}

std::vector<Field> World::fields() const {
    std::vector<Field> all;
    for (uint32_t i = 0; i < data_->fields.size(); ++i) {
        if (data_->fields[i].generation != 0)
            all.emplace_back(self(), FieldId{i, data_->fields[i].generation});
    }
    return all;
}

bool Field::is_valid() const {
    return link_ != nullptr && link_->data != nullptr && lives(*link_->data, id_);
}

WorldData& Field::live() const {
    if (!is_valid()) dangling("field", link_, id_.index, id_.generation);
    return *link_->data;
}

World& Field::world() const {
    live();
    return *link_->world;
}

const FieldDef& Field::definition() const {
    return live().fields[id_.index].def;
}

void Field::set(const FieldDef& wanted) {
    WorldData& data = live();
    FieldDef& def = data.fields[id_.index].def;
    if (wanted.user_data != def.user_data || wanted.force.index() != def.force.index())
        data.self.may_populate("Field", __func__);
    else
        data.self.may_edit("Field", __func__);
    check(wanted);
    def = wanted;
    data.wake_all();
}

void Field::destroy() {
    WorldData& data = live();
    data.self.may_populate("Field", __func__);
    data.fields[id_.index] = {{}, 0, data.field_slots.free};
    data.field_slots.free = id_.index;
    --data.field_slots.count;
    data.wake_all();
}

}  // namespace fettle::physics
