#pragma once

#include <constraints/joint_ends.h>
#include <state/step_scratch.h>
#include <state/world_state.h>

// Interface of a type of joint: a table of functions. A function of a step processes a range of the
// joints of a type, so one call handles many joints; the code for a joint is compiled per type.

namespace fettle::physics::detail {

struct JointSource;
class RowWriter;

/// A range of the joints in an array.
struct JointRange {
    size_t begin = 0, end = 0;
};

/// The load that a joint puts on body b in a sub-step, as impulses.
struct JointLoad {
    Vec2 push;
    float twist = 0.0f;
    /// Push times lever: rounding errors of the twist are small compared with it, even if the push
    /// goes through the center of mass. Only in `load_on`.
    float moment = 0.0f;
};

using JointImpulses = decltype(JointRecord::impulses);

/// Where the ends of a joint are.
struct JointPlace {
    Position anchor_a, anchor_b;  ///< world
    Rotation a;                   ///< of body a
    Position local_anchor_a;      ///< in the coordinates of body a

    /// From anchor a to anchor b.
    Vec2 gap() const { return anchor_b - anchor_a; }
};

/// Where the ends of a joint are now.
inline JointPlace place_of(const Columns& columns, const JointRecord& joint) {
    const auto anchor = [&](size_t side) {
        const BodyState& state = columns.states[joint.bodies[side]];
        return state.position + rotate({state.cosine, state.sine}, Vec2(joint.anchors[side]));
    };
    const BodyState& a = columns.states[joint.bodies[0]];
    return {anchor(0), anchor(1), {a.cosine, a.sine}, joint.anchors[0]};
}

/// The motor of a joint in a step, or its pull towards a place. A motor without a speed is
/// friction, which presses nothing: it is left out.
struct Drive {
    float* greatest = nullptr;  ///< greatest impulse in a sub-step, N s or N m s; null: none
    float impulse = 0.0f;       ///< of the last sub-step; positive pushes body b as below
    Vec2 along;                 ///< the direction in which it pushes body b
    bool turns = false;         ///< it turns body b about its anchor instead
    bool limited = false;       ///< it drives a coordinate that has limits

    static Drive of_force(float& greatest, Vec2 impulse) {
        const float size = length(impulse);
        if (!(size > 0.0f)) return {};
        return {&greatest, size, (1.0f / size) * impulse, false};
    }
};

/// A rope, a rod or a pulley: whether its length is wrong by more than `obstructed_gap`, and where
/// it draws its bodies. A rod that is too short pushes them apart.
struct Pull {
    bool is_strained = false;
    bool only_pulls = true;  ///< it is no rod
    bool pushes = false;     ///< a rod that is too short, or bears a load
    Vec2 towards[2];         ///< unit vectors
};

/// What the force of a joint may concern. Bits.
enum HardPush : uint8_t {
    pull = 1,    ///< solver/joints/geometric_stiffness.h and solver/joints/obstructed_joints.h
    press = 2,   ///< only the latter: a motor that presses, or a length that is wrong
    strong = 4,  ///< a motor with limits is so strong that its joint counts as loaded
    lever = 8    ///< a body is far from the joint: solver/joints/long_levers.h
};

struct JointKind {
    const char* name;
    size_t constraint_size;
    bool pushes_at_b;  ///< it pushes both bodies at the anchor of b
    /// Writes the default settings into a new joint.
    void (*begin)(JointRecord& joint);
    /// Throws std::invalid_argument for settings that a setter refuses.
    void (*check)(const JointRecord& joint);
    /// How far the rigid parts of a joint with its ends at `place` are from where they should hold,
    /// m. Null: it has no such parts.
    float (*separation)(const JointRecord& joint, const JointPlace& place);

    /// Whether the joint holds a point or a length rigidly. Null: it cannot, and ignores
    /// `JointEnds::share`.
    bool (*holds)(const JointRecord& joint);
    /// Whether a motor or a spring of the joint may give energy to its bodies. Null: it has none.
    bool (*gives_energy)(const JointRecord& joint);
    /// Writes constraints from the records of the joints. Returns bits of `HardPush`.
    uint8_t (*prepare)(const JointSource& source, JointArray& array, const JointStep& step,
                       JointRange range);
    using Pass = void (*)(JointArray& array, std::span<SolverBody> bodies, const JointStep& step,
                          JointRange range);
    Pass warm_start, solve, relax;
    JointLoad (*load)(const JointArray& array, size_t index);
    JointEnds& (*ends)(JointArray& array, size_t index);
    /// Null: the joint has no length.
    Pull (*pull)(const JointArray& array, size_t index);
    /// Null: the type has no motor.
    Drive (*drive)(JointArray& array, size_t index);
    /// The impulses of a joint in a sub-step, as its type defines them.
    JointImpulses (*impulses)(const JointArray& array, size_t index);
    /// The effect of such impulses, with the current levers, on the body of a side, 0 or 1: an
    /// impulse on its center of mass and an angular impulse about it.
    JointLoad (*load_on)(const JointArray& array, size_t index, const JointImpulses& impulses,
                         size_t side);
    /// Writes the rows of some joints, at the current poses of their bodies. The conditions of
    /// `solve` and `relax` are all written at once.
    void (*write_rows)(JointArray& array, std::span<SolverBody> bodies, RowWriter& rows,
                       JointRange range);
    /// Writes impulses back to the records, and stores which motors move their bodies.
    void (*store)(JointArray& array, std::span<const SolverBody> bodies, ObjectState& objects,
                  const JointStep& step, JointRange range);
};

using JointPass = JointKind::Pass JointKind::*;

/// Each type is defined in its file in `joints`, and listed in joints/joint_types.h.
const JointKind& joint_kind(JointType type);

/// Calls `visit(kind, array, index)` for each acting joint.
template <typename Visit>
void for_each_acting_joint(JointScratch& joints, Visit&& visit) {
    for (size_t i = 0; i < joints.joint_arrays.size(); ++i) {
        JointArray& array = joints.joint_arrays[i];
        const JointKind& kind = joint_kind(JointScratch::type_of(i));
        for (size_t k = 0; k < array.joints.size(); ++k) visit(kind, array, k);
    }
}

}  // namespace fettle::physics::detail
