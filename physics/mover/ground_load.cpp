#include <mover/ground_load.h>
#include <mover/obstacles.h>
#include <step/gather.h>

#include <algorithm>
#include <vector>

namespace fettle::physics::detail {
namespace {

bool is_pushed(const Load& load) {
    return load.force.x != 0.0f || load.force.y != 0.0f || load.torque != 0.0f;
}

/// True if a field or a force of the host acts on a body. It may carry the body; how much of the
/// weight it carries is not known.
bool is_carried(const WorldData& data, uint32_t body) {
    const BodyRecord& record = data.bodies[body];
    return is_pushed(record.load) || is_pushed(record.step_load) ||
           in_any_field(data, data, data.boxes, body);
}

/// True for the body of a mover that stands on a body: it has no contact with its ground in a step.
bool stands_on(const WorldData& data, uint32_t other, uint32_t body) {
    const MoverBody* const mover = mover_of(data, other);
    return mover != nullptr && mover->ground == data.body_id(body);
}

/// A mover weighs at most this many times as much as the part of a body that its feet move:
/// contacts and joints yield by some cm under more than that, and throw the body when it slips out.
/// On ground that cannot move a body holds most; what floats should sink no faster than the mover
/// falls.
constexpr float most_on_ground = 30.0f, most_on_others = 8.0f, most_afloat = 2.0f;

/// A direction in which something holds a point of a body.
struct Hold {
    Vec2 arm, direction;
    enum class Kind { normal, tangent, pin } kind;  ///< a tangent follows its normal
    float friction = 0.0f;                          ///< of a tangent
    float impulse = 0.0f;
};

/// What an impulse of 1 N s does to a body that its neighbors hold.
struct Response {
    float inverse_mass, inverse_inertia;
    Vec2 velocity;
    float angular_velocity = 0.0f;

    void push(Vec2 arm, Vec2 impulse) {
        velocity = velocity + inverse_mass * impulse;
        angular_velocity += inverse_inertia * cross(arm, impulse);
    }
    float speed(Vec2 arm, Vec2 direction) const {
        return dot(direction, velocity + cross(angular_velocity, arm));
    }
};

void add_contact(const ContactRecord& contact, uint32_t body, std::vector<Hold>& holds) {
    const bool is_b = contact.body_b == body;
    const Vec2 normal = is_b ? contact.manifold.normal : -contact.manifold.normal;
    for (int i = 0; i < contact.manifold.count; ++i) {
        const ManifoldPoint& point = contact.manifold.points[i];
        const Vec2 arm = is_b ? point.anchor_b : point.anchor_a;
        holds.push_back({arm, normal, Hold::Kind::normal});
        holds.push_back({arm, right_perp(normal), Hold::Kind::tangent, contact.friction});
    }
}

/// Projected Gauss-Seidel: each hold in turn stops the motion that it does not allow.
void hold(Response& response, std::vector<Hold>& holds) {
    constexpr int rounds = 32;  // enough for one body
    for (int round = 0; round < rounds; ++round) {
        for (size_t i = 0; i < holds.size(); ++i) {
            Hold& each = holds[i];
            const float lever = cross(each.arm, each.direction);
            const float yielding = response.inverse_mass + response.inverse_inertia * lever * lever;
            if (!(yielding > 0.0f)) continue;
            const float before = each.impulse;
            float now = before - response.speed(each.arm, each.direction) / yielding;
            if (each.kind == Hold::Kind::tangent) {
                const float most = each.friction * holds[i - 1].impulse;
                now = clamp(now, -most, most);
            } else if (each.kind == Hold::Kind::normal) {
                now = max(now, 0.0f);
            }
            each.impulse = now;
            response.push(each.arm, (now - before) * each.direction);
        }
    }
}

}  // namespace

bool is_supported(const WorldData& data, uint32_t body, uint32_t left_out) {
    constexpr size_t most = 64;  // examined bodies; a larger heap counts as supported
    std::vector<uint32_t> group = {body};
    bool supported = false;
    const auto reach = [&](uint32_t other) {
        if (other == left_out) return;
        supported = supported || data.bodies[other].mobility != Mobility::dynamic;
        if (std::find(group.begin(), group.end(), other) == group.end()) group.push_back(other);
    };
    for (size_t i = 0; i < group.size() && !supported; ++i) {
        if (i >= most || is_carried(data, group[i])) return true;
        data.for_each_joint(group[i], [&](uint32_t joint, uint32_t side) {
            if (!data.may_act(data.joints[joint])) return;
            reach(data.joints[joint].bodies[side ^ 1]);
            // Its rope hangs on wheels of the world.
            supported = supported || data.joints[joint].type == JointType::pulley;
        });
        data.for_each_contact(group[i], [&](uint32_t contact) {
            const uint32_t other = data.other_body(contact, group[i]);
            if (data.contacts[contact].acts() && !stands_on(data, other, group[i])) reach(other);
        });
    }
    return supported;
}

float weight_share(const WorldData& data, uint32_t body, const Position& point, Vec2 down,
                   float mass, uint32_t left_out) {
    const BodyRecord& record = data.bodies[body];
    const BodyState& state = data.states[body];
    const Vec2 arm = point - record.center;
    Response response{record.inverse_mass, record.inverse_inertia, {}};
    response.push(arm, down);
    const auto at_most = [own = 1.0f / (mass * response.speed(arm, down))](float times) {
        return min(1.0f, times * own);
    };
    if (is_carried(data, body)) return at_most(most_afloat);
    std::vector<Hold> holds;
    bool fixed = false, on_ground = false;
    data.for_each_joint(body, [&](uint32_t slot, uint32_t side) {
        const JointRecord& joint = data.joints[slot];
        if (!data.may_act(joint)) return;
        // A motor, a spring or a limit holds the angle, too; other joints hold more or less.
        fixed = fixed || joint.type != JointType::revolute || joint.torque != 0.0f;
        const Vec2 anchor = joint.anchors[side] - Position();
        const Vec2 held =
            state.position + rotate({state.cosine, state.sine}, anchor) - record.center;
        for (const Vec2 direction : {Vec2(1.0f, 0.0f), Vec2(0.0f, 1.0f)})
            holds.push_back({held, direction, Hold::Kind::pin});
    });
    if (fixed) return at_most(most_on_others);
    const bool jointed = !holds.empty();
    data.for_each_contact(body, [&](uint32_t contact) {
        const uint32_t other = data.other_body(contact, body);
        if (!data.contacts[contact].acts() || other == left_out || stands_on(data, other, body))
            return;
        add_contact(data.contacts[contact], body, holds);
        on_ground |= data.bodies[other].mobility != Mobility::dynamic;
    });
    const float most = at_most(on_ground && !jointed ? most_on_ground : most_on_others);
    hold(response, holds);
    return min(most, 1.0f / (1.0f + mass * max(0.0f, response.speed(arm, down))));
}

}  // namespace fettle::physics::detail
