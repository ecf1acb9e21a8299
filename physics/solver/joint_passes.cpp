#include <solver/joint_passes.h>
#include <state/active_lists.h>

#include <algorithm>
#include <atomic>
#include <cmath>

namespace fettle::physics::detail {
namespace {

/// Number of joints in a task of a thread.
constexpr size_t joints_at_a_time = 128;

/// Note about an awake joint before it is prepared: its node, plus this bit if it can break; 0 if
/// it does not act.
constexpr uint8_t can_break = 0x80;
static_assert(2 * most_strips <= can_break);

/// Lists the awake joints of a type that act, in the order of their nodes.
void list_acting(ObjectState& objects, const BodyScratch& bodies,
                 const std::vector<uint32_t>& awake, JointScratch& scratch, JointArray& array,
                 ThreadPool* threads) {
    scratch.joint_notes.resize(awake.size());
    share_out_range(threads, awake.size(), joints_at_a_time, [&](size_t begin, size_t end) {
        for (size_t i = begin; i < end; ++i) {
            const JointRecord& joint = objects.joints[awake[i]];
            const JointRole role = role_of(objects, joint);
            if (role == JointRole::idle) forget_impulses(objects, awake[i]);
            scratch.joint_notes[i] = 0;
            if (role != JointRole::acting) continue;  // it keeps its impulses until a body wakes
            // Unlike a contact, a joint also writes to a body that moves on its own. The nodes of
            // all joints of such a body are on one path from the root, so no two of them are solved
            // at the same time.
            const SolverEnd a = bodies.solver_ends[joint.bodies[0]],
                            b = bodies.solver_ends[joint.bodies[1]];
            const StripNode node =
                above_both((a.index() != 0 ? a : b).strip(), (b.index() != 0 ? b : a).strip());
            scratch.joint_notes[i] =
                uint8_t(std::max<StripNode>(node, 1) | (joint.breakable() ? can_break : 0));
        }
    });
    array.nodes.clear();
    for (const uint8_t note : scratch.joint_notes)
        if (note != 0) array.nodes.count(note & ~can_break);
    array.nodes.sum_up();
    auto next = array.nodes.places();
    array.joints.resize(array.nodes.size());
    for (size_t i = 0; i < awake.size(); ++i) {
        if (scratch.joint_notes[i] == 0) continue;
        const uint32_t place = next[scratch.joint_notes[i] & ~can_break]++;
        array.joints[place] = awake[i];
        if ((scratch.joint_notes[i] & can_break) != 0)
            scratch.strains.push_back({awake[i], place, {}, 0.0f});
    }
}

}  // namespace

JointStep prepare_joints(ObjectState& objects, const Columns& columns, const ActiveLists& active,
                         const BodyScratch& bodies, JointScratch& joints, float h,
                         float impulse_ratio, ThreadPool* threads) {
    const JointSource source = {objects, columns, bodies};
    JointStep step;
    step.h = h;
    step.inverse_h = 1.0f / h;
    step.impulse_ratio = impulse_ratio;
    joints.strains.clear();
    std::atomic<bool> heavy = false;
    for (size_t type = 0; type < joint_type_count; ++type) {
        const JointKind& kind = joint_kind(JointType(type));
        JointArray& array = joints.joint_arrays[type];
        list_acting(objects, bodies, active.awake_joints[type], joints, array, threads);
        array.constraints.resize(array.joints.size() * kind.constraint_size);
        share_out_range(threads, array.joints.size(), joints_at_a_time,
                        [&](size_t begin, size_t end) {
                            if (kind.prepare(source, array, step, {begin, end}))
                                heavy.store(true, std::memory_order_relaxed);
                        });
    }
    step.sweeps = heavy ? 4 : 1;
    step.rigid = make_softness(heavy ? min(120.0f, 0.5f / h) : min(60.0f, 0.25f / h), 2.0f, h);
    return step;
}

namespace {

/// Calls `visit(kind, array, range)` for the joints of some nodes, type by type.
void for_each_type(JointScratch& joints, const StripNodes& nodes, auto&& visit) {
    for (size_t type = 0; type < joint_type_count; ++type) {
        JointArray& array = joints.joint_arrays[type];
        const JointRange range = {array.nodes.begin(nodes), array.nodes.end(nodes)};
        if (range.begin != range.end) visit(joint_kind(JointType(type)), array, range);
    }
}

}  // namespace

void pass_joints(JointPass pass, JointScratch& joints, std::span<SolverBody> bodies,
                 const JointStep& step, const StripNodes& nodes) {
    const int sweeps = pass == &JointKind::warm_start ? 1 : step.sweeps;
    for (int sweep = 0; sweep < sweeps; ++sweep) {
        for_each_type(joints, nodes,
                      [&](const JointKind& kind, JointArray& array, JointRange range) {
                          (kind.*pass)(array, bodies, step, range);
                      });
    }
}

void find_jointed(const ObjectState& objects, JointScratch& joints, const Strips& strips) {
    joints.joint_share.clear();
    for (uint32_t node = 1; node < strips.all_nodes().end; ++node) {
        for_each_type(joints, {node, node + 1},
                      [&](const JointKind&, JointArray& array, JointRange range) {
                          for (size_t i = range.begin; i < range.end; ++i) {
                              for (const uint32_t body : objects.joints[array.joints[i]].bodies) {
                                  const uint32_t index = objects.bodies[body].solver_index;
                                  if (index != 0) joints.joint_share.add(node, index);
                              }
                          }
                      });
    }
    joints.joint_share.unite();
}

void strain_joints(const ObjectState& objects, JointScratch& joints) {
    for (Strain& strain : joints.strains) {
        const JointType type = objects.joints[strain.joint].type;
        const JointLoad load =
            joint_kind(type).load(joints.joint_arrays[size_t(type)], strain.index);
        strain.force = strain.force + load.push;
        strain.torque += load.twist;
    }
}

void store_joints(ObjectState& objects, const JointScratch& joints, const JointStep& step,
                  ThreadPool* threads) {
    for (size_t type = 0; type < joint_type_count; ++type) {
        const JointArray& array = joints.joint_arrays[type];
        share_out_range(threads, array.joints.size(), joints_at_a_time,
                        [&](size_t begin, size_t end) {
                            joint_kind(JointType(type)).store(array, objects, step, {begin, end});
                        });
    }
}

}  // namespace fettle::physics::detail
