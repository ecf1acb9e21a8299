#pragma once

#include <state/joint_kind.h>
#include <threads/pool.h>

// A step writes the acting joints into constraints, by type and in the order of their nodes; solves
// the joints of some nodes at a time; and reads their impulses back.

namespace fettle::physics::detail {

/// The data from which constraints are written.
struct JointSource {
    const ObjectState& objects;
    const Columns& columns;
    const BodyScratch& bodies;

    JointEnds ends_of(const JointRecord& joint) const {
        const auto [a, b] = joint.bodies;
        const BodyRecord &body_a = objects.bodies[a], &body_b = objects.bodies[b];
        JointEnds ends;
        ends.a = body_a.solver_index;
        ends.b = body_b.solver_index;
        const End end_a = end_of(a, joint.anchors[0]), end_b = end_of(b, joint.anchors[1]);
        ends.start_a = end_a.lever;
        ends.start_b = end_b.lever;
        ends.lever_a = ends.start_a;
        ends.lever_b = ends.start_b;
        ends.apart = end_b.center - end_a.center;
        ends.angle = (columns.states[b].angle - columns.states[a].angle) +
                     (body_b.angle_rest - body_a.angle_rest);
        const float mass_a = bodies.solver_bodies[ends.a].inverse_mass;
        const float mass_b = bodies.solver_bodies[ends.b].inverse_mass;
        ends.inverse_a = {body_a.flags.locked_x ? 0.0f : mass_a,
                          body_a.flags.locked_y ? 0.0f : mass_a};
        ends.inverse_b = {body_b.flags.locked_x ? 0.0f : mass_b,
                          body_b.flags.locked_y ? 0.0f : mass_b};
        for (const BodyRecord* body : {&body_a, &body_b})
            if (body->mobility == Mobility::dynamic)
                ends.joints = std::max(ends.joints, body->lists.joint_count);
        return ends;
    }

    JointFrame frame_of(const JointRecord& joint) const {
        const auto [a, b] = joint.bodies;
        return {.a = rotation_of(a),
                .center_a = end_of(a, joint.anchors[0]).center,
                .center_b = end_of(b, joint.anchors[1]).center,
                .anchor_a = joint.anchors[0],
                .angle_a = double(columns.states[a].angle) + double(objects.bodies[a].angle_rest),
                .angle_b = double(columns.states[b].angle) + double(objects.bodies[b].angle_rest)};
    }

  private:
    /// A point that a body turns about, and the lever arm from there to an anchor.
    struct End {
        Position center;
        Vec2 lever;
    };
    /// A body turns about its center of mass. For a body that does not move, any point will do: the
    /// anchor itself is precise also if it is fixed to the world far from the origin.
    End end_of(uint32_t body, const Position& anchor) const {
        const BodyRecord& record = objects.bodies[body];
        if (double_positions && body == 0) return {anchor, {}};
        const Vec2 local = Vec2(anchor);
        if (double_positions && record.solver_index == 0)
            return {columns.states[body].position + rotate(rotation_of(body), local), {}};
        return {record.center, rotate(rotation_of(body), local - record.local_center)};
    }
    Rotation rotation_of(uint32_t body) const {
        return {columns.states[body].cosine, columns.states[body].sine};
    }
};

JointStep prepare_joints(ObjectState& objects, const Columns& columns, const ActiveLists& active,
                         BodyScratch& bodies, JointScratch& joints, float h, float impulse_ratio,
                         float contact_hertz, Solver solver, ThreadPool* threads);

/// The load as which a motor with limits counts, by the speed that it could give its bodies in a
/// sub-step. An arm of several links whose motors press against their limits is solved one joint
/// after the other: where a motor undoes in one sweep what its neighbors need, the arm never comes
/// to rest, unless there are more sweeps.
inline uint8_t load_of_drive(const Drive& drive, const SolverBody& a, const SolverBody& b) {
    constexpr float fast = 0.3f, very_fast = 5.0f;  // m/s or rad/s
    if (drive.greatest == nullptr || !drive.limited) return 0;
    const float inverse =
        drive.turns ? a.inverse_inertia + b.inverse_inertia : a.inverse_mass + b.inverse_mass;
    const float speed = *drive.greatest * inverse;
    return speed > very_fast ? 2 : speed > fast ? 1 : 0;
}

/// Passes the bodies with joints to `JointShare`.
void find_jointed(const ObjectState& objects, JointScratch& joints, const Strips& strips);

/// Number of sweeps of a pass over the joints of a class: a load, `tuned` or `crowded`.
int sweeps_of(size_t load, JointPass pass);
/// Solves the joints of a class on some nodes once.
void sweep_joints(JointPass pass, size_t load, JointScratch& joints, std::span<SolverBody> bodies,
                  const JointStep& step, const StripNodes& nodes);
/// Runs a pass over the joints of some nodes; several times over those that bear heavy loads.
void pass_joints(JointPass pass, JointScratch& joints, std::span<SolverBody> bodies,
                 const JointStep& step, const StripNodes& nodes);

/// Called after each sub-step: adds up the loads of the joints that can break.
void add_strains(JointScratch& joints);
void store_joints(ObjectState& objects, const BodyScratch& bodies, JointScratch& joints,
                  const JointStep& step, ThreadPool* threads);

}  // namespace fettle::physics::detail
