#include <contacts/overlaps/crushed_bodies.h>
#include <contacts/overlaps/held_open.h>
#include <state/joint_kind.h>

#include <algorithm>

namespace fettle::physics::detail {
namespace {

/// Contacts hold a joint open if those of each of its bodies push it outwards with this part of the
/// force of the joint. A load on a chain or a bridge pulls the joint apart through other joints.
constexpr float least_part = 0.7f;
/// A gap that is narrower than this part of the width of what is in it may come from a load.
constexpr float least_gap = 0.1f;
/// What is heavier than a body of the joint by more than this is a load, and must not fall through.
constexpr float most_masses = 20.0f;

class OpenJoint {
  public:
    OpenJoint(const ObjectState& objects, const Columns& columns, const JointRecord& joint)
        : objects_(objects), joint_(joint) {
        const Vec2 gap = place_of(columns, joint).gap();
        width_ = length(gap);
        if (width_ > 0.0f) outward_ = (1.0f / width_) * gap;
    }

    /// True if contacts hold the joint open. Then `bodies` has the body through which they pass:
    /// the lighter one, unless they press it against something fixed. `pull`: impulse of the joint.
    bool is_held(float pull) {
        const auto [a, b] = joint_.bodies;
        if (!is_dynamic(a) || !is_dynamic(b)) return false;
        const Push by_a = push_of(0), by_b = push_of(1);
        if (!(min(by_a.all, by_b.all) > least_part * pull)) return false;
        const size_t lighter = objects_.bodies[a].mass < objects_.bodies[b].mass ? 0 : 1;
        for (const size_t side : {lighter, 1 - lighter}) {
            const Push& push = side == 0 ? by_a : by_b;
            side_ = side;
            if (push.by_fixed < 0.5f * push.all) return true;
        }
        return false;
    }
    uint32_t passed() const { return joint_.bodies[side_]; }

    /// True if the contact, of the body that is passed, is one of those that hold the joint open.
    bool is_held_by(uint32_t contact) const {
        const uint32_t body = passed(), other = objects_.other_body(contact, body);
        const BodyRecord &own = objects_.bodies[body], &holding = objects_.bodies[other];
        return outward_impulse(contact, side_) > 0.0f && is_dynamic(other) &&
               holding.mass < most_masses * own.mass &&
               width_ > least_gap * 2.0f * holding.thickness;
    }

  private:
    /// Impulse of the contacts of a body, outwards.
    struct Push {
        float all = 0.0f, by_fixed = 0.0f;
    };

    bool is_dynamic(uint32_t body) const {
        return objects_.bodies[body].mobility == Mobility::dynamic;
    }
    Push push_of(size_t side) const {
        const uint32_t body = joint_.bodies[side];
        Push push;
        objects_.for_each_contact(body, [&](uint32_t contact) {
            const float impulse = outward_impulse(contact, side);
            push.all += impulse;
            if (impulse > 0.0f && !is_dynamic(objects_.other_body(contact, body)))
                push.by_fixed += impulse;
        });
        return push;
    }
    /// The normal impulse of a contact on the body of a side, away from the other one. 0 for a
    /// contact between the two.
    float outward_impulse(uint32_t contact, size_t side) const {
        const ContactRecord& c = objects_.contacts[contact];
        const uint32_t body = joint_.bodies[side];
        if (!c.acts() || objects_.other_body(contact, body) == joint_.bodies[1 - side]) return 0.0f;
        float impulse = 0.0f;
        for (int k = 0; k < c.manifold.count; ++k) impulse += c.manifold.points[k].normal_impulse;
        const float along = dot(c.manifold.normal, outward_);
        return (c.body_b == body) == (side == 1) ? impulse * along : -impulse * along;
    }

    const ObjectState& objects_;
    const JointRecord& joint_;
    Vec2 outward_;  ///< from body a to body b
    float width_ = 0.0f;
    size_t side_ = 0;
};

void release(const Touching& touching, uint32_t slot, float h) {
    ObjectState& objects = touching.objects;
    JointRecord& joint = objects.joints[slot];
    for (const uint32_t body : joint.bodies)
        if (objects.bodies[body].lists.first_contact == none) return;
    OpenJoint open(objects, touching.columns, joint);
    if (!open.is_held(h * length(joint.force))) return;
    std::vector<uint32_t> pressed;
    const uint32_t passed = open.passed();
    objects.for_each_contact(passed, [&](uint32_t contact) {
        // A touch does not end in the step in which it began, so ends may be read before begins.
        if (objects.contact_links[contact].began == touching.step) return;
        if (!open.is_held_by(contact)) return;
        skip_contact(touching, contact, Skipped::crushed);
        pressed.push_back(objects.other_body(contact, passed));
    });
    if (pressed.empty()) return;
    pressed.insert(pressed.end(), joint.bodies, joint.bodies + 2);
    for (const uint32_t body : pressed) clear_impulses_of(objects, body);
    joint.impulses = {};
}

}  // namespace

void release_held_open(const Touching& touching, const JointScratch& joints, float h) {
    if (touching.objects.contact_slots.count == 0) return;
    for (const JointArray& array : joints.joint_arrays) {
        const auto begin = array.open.begin(), end = array.open.end();
        for (auto at = std::find(begin, end, 1); at != end; at = std::find(at + 1, end, 1))
            release(touching, array.joints[size_t(at - begin)], h);
    }
}

}  // namespace fettle::physics::detail
