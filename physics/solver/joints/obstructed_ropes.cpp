#include <solver/joints/encounters.h>
#include <solver/joints/obstructed_joints.h>
#include <solver/joints/obstructed_ropes.h>
#include <solver/joints/pressed_bodies.h>

#include <cmath>

namespace fettle::physics::detail {
namespace {

/// What ropes pull with besides their load, as an acceleration, m/s².
constexpr float ten_weights = 100.0f;

/// True for a kinematic body that is not at rest.
bool moves_by_itself(const JointSource& source, uint32_t body) {
    return source.objects.bodies[body].mobility == Mobility::kinematic &&
           !stands_still(source.columns.states[body]);
}

/// True if a body touches something that is not dynamic, or is joined to it.
bool is_supported(const ObjectState& objects, uint32_t body) {
    bool found = false;
    objects.for_each_contact(body, [&](uint32_t contact) {
        found = found || (objects.contacts[contact].acts() &&
                          !is_dynamic(objects, objects.other_body(contact, body)));
    });
    objects.for_each_joint(body, [&](uint32_t joint, uint32_t side) {
        found = found || !is_dynamic(objects, objects.joints[joint].bodies[1 - side]);
    });
    return found;
}

/// The greatest pull of the next sub-step, N s: twice that of the last one, some weights, and what
/// stops a mass whose speed makes the rope longer, as when something falls onto a load.
float next_pull(const JointSource& source, const JointRecord& joint, const Pull& pull,
                const JointStep& step, float mass) {
    float lengthening = 0.0f;  // m/s
    for (const size_t side : {0u, 1u})
        lengthening -= dot(source.columns.states[joint.bodies[side]].velocity, pull.towards[side]);
    return 2.0f * step.h * length(joint.force) +
           mass * (ten_weights * step.h + max(lengthening, 0.0f));
}

}  // namespace

void limit_pull(const JointSource& source, const JointRecord& joint, const Pull& pull,
                const JointStep& step, JointEnds& ends, std::vector<uint32_t>& strained) {
    bool moves[2], held[2];
    float load[2], inverse_mass = 0.0f;
    for (const size_t side : {0u, 1u}) {
        const uint32_t slot = joint.bodies[side];
        const BodyRecord& body = source.objects.bodies[slot];
        moves[side] = is_dynamic(source.objects, slot);
        held[side] = !moves[side];
        load[side] = infinity;
        if (!moves[side]) continue;
        const Vec2 towards = pull.towards[side];
        const JointPush push = {
            step.h * length(joint.force), side == 0 ? -towards : towards, 0.0f, {}};
        PressedBodies pressed(source, joint, push, step, true);
        pressed.follow(side);
        // What rolls or tips on another body bears nothing for a moment.
        const auto is_meant = [&](uint32_t other) {
            return !is_dynamic(source.objects, other) ||
                   (pull.is_strained && other != joint.bodies[1 - side] &&
                    is_supported(source.objects, other));
        };
        held[side] =
            pressed.is_borne() ||
            encounter_of(source.objects, slot, towards, -speculative_margin, is_meant).into > steep;
        load[side] = pressed.load();
        inverse_mass += body.inverse_mass;
    }
    if (held[0] != held[1]) {
        const size_t side = held[0] ? 0 : 1;
        const uint32_t slot = joint.bodies[side];
        if (!moves[side] || !pull.only_pulls ||
            length_squared(source.columns.states[slot].velocity) > 1.0f)
            return;
        ends.held = int(side);
        const float mass = source.objects.bodies[joint.bodies[1 - side]].mass;
        ends.greatest_pull = next_pull(source, joint, pull, step, mass);
    } else if (held[0]) {
        // Weights on the way may help to pull.
        ends.greatest_pull =
            max(min(load[0], load[1]), 0.0f) + ten_weights * step.h * inverse_or_zero(inverse_mass);
    } else {
        return;
    }
    for (const size_t side : {0u, 1u})
        if (moves[side]) strained.push_back(joint.bodies[side]);
}

void limit_growth(const JointSource& source, const JointRecord& joint, const Pull& pull,
                  const JointStep& step, JointEnds& ends) {
    float inverse_mass = 0.0f;
    bool limits = pull.only_pulls;
    for (const size_t side : {0u, 1u}) {
        const BodyRecord& body = source.objects.bodies[joint.bodies[side]];
        if (!is_dynamic(source.objects, joint.bodies[side])) continue;
        inverse_mass += body.inverse_mass;
        const auto moves = [&](uint32_t other) { return is_dynamic(source.objects, other); };
        const Encounter encounter = encounter_of(source.objects, joint.bodies[side],
                                                 pull.towards[side], -speculative_margin, moves);
        limits = limits || encounter.into > 0.0f;
    }
    if (limits)
        ends.greatest_pull = next_pull(source, joint, pull, step, inverse_or_zero(inverse_mass));
}

void limit_gap_of_rope(const JointSource& source, const JointRecord& joint, const Pull& pull,
                       Solver solver, JointEnds& ends) {
    const float least_into = solver == Solver::direct ? steep : 0.05f;  // a cosine
    for (const size_t side : {0u, 1u}) {
        const uint32_t body = joint.bodies[side];
        if (!is_dynamic(source.objects, body)) continue;
        // An impact makes a rod shorter, too.
        constexpr float slow = 2.0f;  // m/s
        if (pull.pushes && length_squared(source.columns.states[body].velocity) > slow * slow)
            continue;
        const bool any = pull.is_strained || moves_by_itself(source, joint.bodies[1 - side]);
        const auto is_meant = [&](uint32_t obstacle) {
            return !is_dynamic(source.objects, obstacle) &&
                   (any || moves_by_itself(source, obstacle));
        };
        const Vec2 towards = pull.towards[side];
        const Encounter first =
            encounter_of(source.objects, body, towards, -speculative_margin, is_meant);
        if (!(first.into > least_into) &&
            !is_wedged(source.objects, body, towards, first, is_meant))
            continue;
        const float gap = solver == Solver::direct ? obstructed_gap : obstructed_gap / first.into;
        ends.greatest_error = min(ends.greatest_error, gap);
    }
}

}  // namespace fettle::physics::detail
