#include <contacts/overlaps/crushed_bodies.h>
#include <contacts/overlaps/overlaps.h>
#include <geometry/motion.h>
#include <state/place_shape.h>

#include <algorithm>

namespace fettle::physics::detail {
namespace {

/// A body counts as crushed once the overlaps on its two sides add up to this part of its smallest
/// width, or of that of the obstacle: beyond the middle of a thin plate, it would leave the plate
/// on the other side.
constexpr float crushed_share = 0.5f;
/// An overlap of two dynamic bodies passes the pressure on if it is deeper than this part of the
/// smaller width of the two. No load of a stack presses bodies together that much.
constexpr float passing_share = 0.125f;
/// The maximum of the cosine of the angle between the normals at the two sides of a crushed body.
constexpr float opposite = -0.5f;
/// Maximum number of bodies through which the pressure is followed.
constexpr size_t most_crushed_bodies = 64;

/// A body goes ahead of the presser if it is slower by less than this, m/s.
constexpr float keeping_up = 0.5f;

/// Bodies that overlap by more than this part of the smaller width are pressed together. Bodies in
/// a stack overlap by less.
constexpr float pressed_share = 0.02f;

float width_of(const ObjectState& objects, uint32_t body) {
    return 2.0f * objects.bodies[body].thickness;
}

class Pressure {
  public:
    Pressure(const ObjectState& objects, const Columns& columns)
        : objects_(objects), columns_(columns) {}

    /// True if the body of the contact that is not `presser` is crushed. Then `pressed` lists it
    /// and bodies that are pressed through it. A presser at rest counts if it is directly opposite
    /// to the obstacle: a game may set its position in each step.
    bool crushes(uint32_t presser, uint32_t contact) {
        const ContactRecord& c = objects_.contacts[contact];
        const uint32_t body = objects_.other_body(contact, presser);
        const float speed = speed_towards(body, presser, c);
        if (objects_.bodies[body].mobility != Mobility::dynamic || speed < 0.0f) return false;
        pressed_.assign(1, {body, contact});
        for (size_t i = 0; i < pressed_.size() && (i == 0 || speed > 0.0f); ++i)
            if (pressure_meets_fixed(pressed_[i])) return true;
        return false;
    }

    /// True if the presser moves away from the body of the contact, and no other contact presses
    /// the body against it any more; or if the body goes ahead of it at its speed, and touches
    /// nothing else.
    bool releases(uint32_t presser, uint32_t contact) const {
        const ContactRecord& c = objects_.contacts[contact];
        const uint32_t body = objects_.other_body(contact, presser);
        if (objects_.bodies[body].mobility != Mobility::dynamic || c.manifold.count == 0)
            return false;
        const float speed = speed_towards(body, presser, c);
        const bool moves_away = speed < 0.0f;
        if (!moves_away && !(speed + speed_towards(presser, body, c) < keeping_up)) return false;
        const Vec2 push = normal_towards(body, c);
        const uint32_t first = objects_.bodies[body].lists.first_contact;
        return !objects_.any_contact(first, none, [&](uint32_t other) {
            const ContactRecord& o = objects_.contacts[other];
            return moves_away ? opposes(body, o, push) : o.acts();
        });
    }

    /// A body, and the contact through which it is pressed.
    struct Pressed {
        uint32_t body, from;
    };
    const std::vector<Pressed>& pressed() const { return pressed_; }

  private:
    float width(uint32_t body) const { return width_of(objects_, body); }
    /// The smallest width of the body or of the fixed shape. Border, segments and chains have none:
    /// what touches them stays on its side.
    float least_width(uint32_t body, uint32_t shape) const {
        if (objects_.forms[shape].kind == FormKind::border) return width(body);
        const float inner = inner_radius(objects_, shape);
        return inner > 0.0f ? min(width(body), 2.0f * inner) : width(body);
    }
    /// True if the contact pushes the body against `push`.
    static bool opposes(uint32_t body, const ContactRecord& c, Vec2 push) {
        return c.acts() && dot(normal_towards(body, c), push) < opposite;
    }
    /// The speed of a body of the contact, at its first point, towards the other one, `body`.
    float speed_towards(uint32_t body, uint32_t presser, const ContactRecord& c) const {
        const BodyState& state = columns_.states[presser];
        const ManifoldPoint& point = c.manifold.points[0];
        const Vec2 arm = presser == c.body_a ? point.anchor_a : point.anchor_b;
        const Vec2 velocity = state.velocity + cross(state.angular_velocity, arm);
        return dot(velocity, normal_towards(body, c));
    }
    bool is_fixed(uint32_t body) const {
        return objects_.bodies[body].mobility != Mobility::dynamic &&
               stands_still(columns_.states[body]);
    }

    /// True if a fixed obstacle stops the body against the pressure. Otherwise adds the bodies to
    /// which it passes the pressure on to the list.
    bool pressure_meets_fixed(const Pressed pressed) {
        const uint32_t body = pressed.body;
        const uint32_t from = pressed.from;
        const ContactRecord& pressing = objects_.contacts[from];
        const Vec2 push = normal_towards(body, pressing);
        const float depth = overlap_of(pressing.manifold);
        const uint32_t first = objects_.bodies[body].lists.first_contact;
        return objects_.any_contact(first, none, [&](uint32_t contact) {
            const ContactRecord& c = objects_.contacts[contact];
            if (contact == from || !opposes(body, c, push)) return false;
            const float opposing = overlap_of(c.manifold);
            const uint32_t other = objects_.other_body(contact, body);
            if (is_fixed(other)) {
                const uint32_t obstacle = other == c.body_a ? c.shape_a : c.shape_b;
                return depth + opposing > crushed_share * least_width(body, obstacle);
            }
            if (objects_.bodies[other].mobility == Mobility::dynamic &&
                opposing > passing_share * min(width(body), width(other)))
                add(other, contact);
            return false;
        });
    }
    void add(uint32_t body, uint32_t from) {
        const bool known = std::any_of(pressed_.begin(), pressed_.end(),
                                       [&](const Pressed& p) { return p.body == body; });
        if (!known && pressed_.size() < most_crushed_bodies) pressed_.push_back({body, from});
    }

    const ObjectState& objects_;
    const Columns& columns_;
    std::vector<Pressed> pressed_;
};

}  // namespace

void clear_impulses_of(ObjectState& objects, uint32_t body) {
    objects.for_each_contact(body,
                             [&](uint32_t contact) { objects.contacts[contact].clear_impulses(); });
}

void drop_impulses(ObjectState& objects, std::vector<uint32_t>& bodies) {
    for (const uint32_t body : bodies) {
        clear_impulses_of(objects, body);
        objects.for_each_joint(
            body, [&](uint32_t joint, uint32_t) { objects.joints[joint].impulses = {}; });
    }
    bodies.clear();
}

bool skip_crushed(const Touching& touching, const ActiveLists& active) {
    ObjectState& objects = touching.objects;
    if (objects.kinematic_bodies == 0) return false;
    Pressure pressure(objects, touching.columns);
    bool any = false;
    for (const uint32_t body : active.awake_bodies) {
        if (objects.bodies[body].mobility != Mobility::kinematic) continue;
        objects.for_each_contact(body, [&](uint32_t contact) {
            ContactRecord& c = objects.contacts[contact];
            if (c.skipped == Skipped::crushed && pressure.releases(body, contact))
                c.skipped = Skipped::no;
            if (c.acts() && pressure.crushes(body, contact)) {
                skip_contact(touching, contact, Skipped::crushed);
                for (const auto& pressed : pressure.pressed())
                    clear_impulses_of(objects, pressed.body);
            }
            any = any || c.skipped == Skipped::crushed;
        });
    }
    return any;
}

void release_pressed(ObjectState& objects, const ContactRecord& ended) {
    std::vector<uint32_t> pressed;
    const auto add = [&](uint32_t body) {
        if (objects.bodies[body].mobility == Mobility::dynamic &&
            pressed.size() < most_crushed_bodies &&
            std::find(pressed.begin(), pressed.end(), body) == pressed.end())
            pressed.push_back(body);
    };
    add(ended.body_a), add(ended.body_b);
    for (size_t i = 0; i < pressed.size(); ++i) {
        const uint32_t body = pressed[i];
        objects.for_each_contact(body, [&](uint32_t contact) {
            ContactRecord& c = objects.contacts[contact];
            if (!c.acts()) return;
            const uint32_t other = objects.other_body(contact, body);
            const bool moves = objects.bodies[other].mobility == Mobility::dynamic;
            const float width = width_of(objects, body);
            const float least = moves ? min(width, width_of(objects, other)) : width;
            if (!(overlap_of(c.manifold) > pressed_share * least)) return;
            c.clear_impulses();
            add(other);
        });
    }
}

}  // namespace fettle::physics::detail
