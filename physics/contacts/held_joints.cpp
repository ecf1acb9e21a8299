#include <contacts/held_joints.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <cstdio>

namespace fettle::physics::detail {
namespace {
float env_of(const char* n, float d) { const char* s = getenv(n); return s ? float(atof(s)) : d; }

const float env_mode = env_of("HELD", 0.0f), env_part = env_of("HELD_PART", 0.7f), env_share = env_of("HELD_W", 0.1f), env_mass = env_of("HELD_M", 20.0f);
const float env_verbose = env_of("HELD_V", 0);

class HeldJoint {
  public:
    HeldJoint(ObjectState& objects, const Columns& columns, const JointRecord& joint)
        : objects_(objects), columns_(columns), joint_(joint) {}

    /// The side
    int held_side(float h) {
        const Vec2 gap = anchor(1) - anchor(0);
        width_ = length(gap);
        along_ = (1.0f / width_) * gap;
        float push[2], fixed[2];
        for (int side = 0; side < 2; ++side) {
            const uint32_t body = joint_.bodies[side];
            if (objects_.bodies[body].mobility != Mobility::dynamic) return -1;
            push[side] = fixed[side] = 0.0f;
            objects_.for_each_contact(body, [&](uint32_t contact) {
                const float out = outward(contact, side);
                push[side] += out;
                if (out > 0.0f && objects_.bodies[objects_.other_body(contact, body)].mobility != Mobility::dynamic) fixed[side] += out;
            });
        }
        const float pull = h * length(joint_.force);
        if (!(min(push[0], push[1]) > env_part * pull)) return -1;
        if (env_verbose > 0) std::printf("held gap %.3f pull %.2f push %.2f %.2f\n", width_, pull/h, push[0]/h, push[1]/h);
        const int lighter = objects_.bodies[joint_.bodies[0]].mass < objects_.bodies[joint_.bodies[1]].mass ? 0 : 1;
        for (const int side : {lighter, 1 - lighter})
            if (fixed[side] < 0.5f * push[side]) return side;
        return -1;
    }
    template <class Visit>
    void for_each_holding(int side, Visit&& visit) {
        const uint32_t body = joint_.bodies[side];
        objects_.for_each_contact(body, [&](uint32_t contact) {
            if (!(outward(contact, side) > 0.0f)) return;
            const BodyRecord& other = objects_.bodies[objects_.other_body(contact, body)];
            const BodyRecord& own = objects_.bodies[body];
            if (other.mobility != Mobility::dynamic || other.mass > env_mass * own.mass) return;
            if (width_ < env_share * 2.0f * min(own.thickness, other.thickness)) return;
            visit(contact, objects_.other_body(contact, body));
        });
    }

  private:
    Position anchor(int side) const {
        const uint32_t body = joint_.bodies[side];
        const BodyState& state = columns_.states[body];
        return state.position + rotate(Rotation{state.cosine, state.sine}, Vec2(joint_.anchors[side]));
    }
    float outward(uint32_t contact, int side) const {
        const ContactRecord& c = objects_.contacts[contact];
        if (!c.acts()) return 0.0f;
        float impulse = 0.0f;
        for (int k = 0; k < c.manifold.count; ++k) impulse += c.manifold.points[k].normal_impulse;
        const float along = dot(c.manifold.normal, along_);
        return impulse * ((c.body_b == joint_.bodies[side]) == (side == 1) ? along : -along);
    }
    ObjectState& objects_;
    const Columns& columns_;
    const JointRecord& joint_;
    Vec2 along_;
    float width_ = 0.0f;
};

void clear_impulses_around(ObjectState& objects, uint32_t body) {
    objects.for_each_contact(body, [&](uint32_t contact) { objects.contacts[contact].clear_impulses(); });
}

}  // namespace

void release_held_joints(const Touching& touching, const JointScratch& joints, float h) {
    if (env_mode == 0.0f) return;
    ObjectState& objects = touching.objects;
    for (const JointArray& array : joints.joint_arrays) {
        for (size_t i = 0; i < array.joints.size(); ++i) {
            if ((array.drives[i] & 2) == 0) continue;
            JointRecord& joint = objects.joints[array.joints[i]];
            HeldJoint held(objects, touching.columns, joint);
            const int side = held.held_side(h);
            if (side < 0) continue;
            std::array<uint32_t, 8> others;
            size_t count = 0;
            held.for_each_holding(side, [&](uint32_t contact, uint32_t other) {
                skip_contact(touching, contact, Skipped::crushed);
                if (count < others.size()) others[count++] = other;
            });
            if (count == 0) continue;
            if (env_verbose > 0) std::printf("  released %d\n", int(count));
            joint.impulses = {};
            clear_impulses_around(objects, joint.bodies[0]);
            clear_impulses_around(objects, joint.bodies[1]);
            for (size_t k = 0; k < count; ++k) clear_impulses_around(objects, others[k]);
        }
    }
}

}  // namespace fettle::physics::detail
