#include <partition/union_find.h>
#include <solver/joint_passes.h>
#include <state/active_lists.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <utility>

namespace fettle::physics::detail {
namespace {

/// Number of joints in a task of a thread.
constexpr size_t joints_at_a_time = 128;

/// Notes about an awake joint before it is prepared: its node, and these bits; 0 if it does not
/// act.
enum JointNote : uint8_t { loaded = 0x40, can_break = 0x80, node_bits = 0x3f };
static_assert(2 * most_strips <= loaded);

/// Number of sweeps in each pass over the joints of components that bear heavy loads.
constexpr int heavy_sweeps = 4;

bool moves(const SolverBody& body) {
    return body.inverse_mass > 0.0f || body.inverse_inertia > 0.0f;
}

/// A joint yields by load / (m·ω²), where m is the mass of its light body: with the usual
/// stiffness, a heavy body would stretch light links on which it hangs. Twice the stiffness is
/// stable only if the sweeps over the joints converge better: four sweeps instead of one.
bool bears_heavy_load(const SolverBody& a, const SolverBody& b) {
    constexpr float most = 10.0f;  // ratio of the masses
    if (a.inverse_mass == 0.0f || b.inverse_mass == 0.0f) return false;
    return a.inverse_mass > most * b.inverse_mass || b.inverse_mass > most * a.inverse_mass;
}

struct JointLists {
    ObjectState& objects;
    const ActiveLists& active;
    const BodyScratch& bodies;
    JointScratch& joints;
    ThreadPool* threads;

    /// Calls `visit(type, awake joint, its note)`.
    void for_each(auto&& visit) {
        uint8_t* note = joints.joint_notes.data();
        for (size_t type = 0; type < joint_type_count; ++type)
            for (const uint32_t joint : active.awake_joints[type]) visit(type, joint, *note++);
    }
    std::pair<uint32_t, uint32_t> indices_of(uint32_t joint) const {
        const auto [a, b] = objects.joints[joint].bodies;
        return {bodies.solver_ends[a].index(), bodies.solver_ends[b].index()};
    }

    uint8_t note_of(uint32_t slot) {
        const JointRecord& joint = objects.joints[slot];
        const JointRole role = role_of(objects, joint);
        if (role == JointRole::idle) forget_impulses(objects, slot);
        if (role != JointRole::acting) return 0;  // it keeps its impulses until a body wakes
        // Unlike a contact, a joint also writes to a body that moves on its own. The nodes of all
        // joints of such a body are on one path from the root, so no two of them are solved at the
        // same time.
        const SolverEnd a = bodies.solver_ends[joint.bodies[0]],
                        b = bodies.solver_ends[joint.bodies[1]];
        const StripNode node =
            above_both((a.index() != 0 ? a : b).strip(), (b.index() != 0 ? b : a).strip());
        const bool heavy =
            bears_heavy_load(bodies.solver_bodies[a.index()], bodies.solver_bodies[b.index()]);
        return uint8_t(std::max<StripNode>(node, 1) | (heavy ? loaded : 0) |
                       (joint.breakable() ? can_break : 0));
    }
    /// Returns true if a joint bears a heavy load.
    bool make_notes() {
        size_t count = 0;
        for (const auto& awake : active.awake_joints) count += awake.size();
        joints.joint_notes.resize(count);
        std::atomic<bool> heavy = false;
        uint8_t* notes = joints.joint_notes.data();
        for (const auto& awake : active.awake_joints) {
            share_out_range(threads, awake.size(), joints_at_a_time, [&](size_t begin, size_t end) {
                uint8_t all = 0;
                for (size_t i = begin; i < end; ++i) all |= notes[i] = note_of(awake[i]);
                if ((all & loaded) != 0) heavy.store(true, std::memory_order_relaxed);
            });
            notes += awake.size();
        }
        return heavy;
    }

    /// A load goes through all joints that connect its body with others. So all joints of such a
    /// component count as loaded, and no joint elsewhere.
    void spread_loads() {
        UnionFind components;
        components.reset(bodies.solver_bodies.size());
        for_each([&](size_t, uint32_t joint, uint8_t note) {
            const auto [a, b] = indices_of(joint);
            if (note != 0 && moves(bodies.solver_bodies[a]) && moves(bodies.solver_bodies[b]))
                components.unite(a, b);
        });
        std::vector<bool> heavy(bodies.solver_bodies.size());
        for_each([&](size_t, uint32_t joint, uint8_t note) {
            if ((note & loaded) != 0) heavy[components.find(indices_of(joint).first)] = true;
        });
        for_each([&](size_t, uint32_t joint, uint8_t& note) {
            const auto [a, b] = indices_of(joint);
            if (note != 0 && heavy[components.find(moves(bodies.solver_bodies[a]) ? a : b)])
                note |= loaded;
        });
    }

    /// Lists the joints that act, in the order of their nodes.
    void fill() {
        for (JointArray& array : joints.joint_arrays) array.nodes.clear();
        const auto array_of = [&](size_t type, uint8_t note) {
            return type + ((note & loaded) != 0 ? joint_type_count : 0);
        };
        for_each([&](size_t type, uint32_t, uint8_t note) {
            if (note != 0) joints.joint_arrays[array_of(type, note)].nodes.count(note & node_bits);
        });
        std::array<NodeRanges::Places, 2 * joint_type_count> next;
        for (size_t i = 0; i < next.size(); ++i) {
            JointArray& array = joints.joint_arrays[i];
            array.nodes.sum_up();
            next[i] = array.nodes.places();
            array.joints.resize(array.nodes.size());
            array.drives.resize(array.nodes.size());
        }
        joints.strains.clear();
        for_each([&](size_t type, uint32_t joint, uint8_t note) {
            if (note == 0) return;
            const size_t array = array_of(type, note);
            const uint32_t place = next[array][note & node_bits]++;
            joints.joint_arrays[array].joints[place] = joint;
            if ((note & can_break) != 0)
                joints.strains.push_back({joint, uint32_t(array), place, {}, 0.0f});
        });
    }
};

}  // namespace

JointStep prepare_joints(ObjectState& objects, const Columns& columns, const ActiveLists& active,
                         const BodyScratch& bodies, JointScratch& joints, float h,
                         float impulse_ratio, ThreadPool* threads) {
    const JointSource source = {objects, columns, bodies};
    JointStep step;
    step.h = h;
    step.inverse_h = 1.0f / h;
    step.impulse_ratio = impulse_ratio;
    step.rigid = make_softness(min(60.0f, 0.25f / h), 2.0f, h);
    step.rigid_under_load = make_softness(min(120.0f, 0.5f / h), 2.0f, h);
    JointLists lists = {objects, active, bodies, joints, threads};
    if (lists.make_notes()) lists.spread_loads();
    lists.fill();
    for (size_t i = 0; i < joints.joint_arrays.size(); ++i) {
        JointArray& array = joints.joint_arrays[i];
        const JointKind& kind = joint_kind(JointScratch::type_of(i));
        array.constraints.resize(array.joints.size() * kind.constraint_size);
        share_out_range(threads, array.joints.size(), joints_at_a_time,
                        [&](size_t begin, size_t end) {
                            kind.prepare(source, array, step, {begin, end});
                        });
    }
    return step;
}

namespace {

/// Calls `visit(kind, array, range)` for the joints of some nodes, type by type. `first`: the
/// arrays of the usual components, or those of the components that bear heavy loads.
void for_each_type(JointScratch& joints, size_t first, const StripNodes& nodes, auto&& visit) {
    for (size_t type = 0; type < joint_type_count; ++type) {
        JointArray& array = joints.joint_arrays[first + type];
        const JointRange range = {array.nodes.begin(nodes), array.nodes.end(nodes)};
        if (range.begin != range.end) visit(joint_kind(JointType(type)), array, range);
    }
}

}  // namespace

void pass_joints(JointPass pass, JointScratch& joints, std::span<SolverBody> bodies,
                 const JointStep& step, const StripNodes& nodes) {
    const auto sweep = [&](size_t first, const JointStep& of) {
        for_each_type(joints, first, nodes,
                      [&](const JointKind& kind, JointArray& array, JointRange range) {
                          (kind.*pass)(array, bodies, of, range);
                      });
    };
    sweep(0, step);
    JointStep under_load = step;
    under_load.rigid = step.rigid_under_load;
    const int sweeps = pass == &JointKind::warm_start ? 1 : heavy_sweeps;
    for (int i = 0; i < sweeps; ++i) sweep(joint_type_count, under_load);
}

void find_jointed(const ObjectState& objects, JointScratch& joints, const Strips& strips) {
    joints.joint_share.clear();
    for (uint32_t node = 1; node < strips.all_nodes().end; ++node) {
        for (const JointArray& array : joints.joint_arrays) {
            for (size_t i = array.nodes.begin({node, node + 1});
                 i < array.nodes.end({node, node + 1}); ++i) {
                for (const uint32_t body : objects.joints[array.joints[i]].bodies) {
                    const uint32_t index = objects.bodies[body].solver_index;
                    if (index != 0) joints.joint_share.add(node, index);
                }
            }
        }
    }
    joints.joint_share.unite();
}

void strain_joints(JointScratch& joints) {
    for (Strain& strain : joints.strains) {
        const JointLoad load = joint_kind(JointScratch::type_of(strain.array))
                                   .load(joints.joint_arrays[strain.array], strain.index);
        strain.force = strain.force + load.push;
        strain.torque += load.twist;
    }
}

void store_joints(ObjectState& objects, const BodyScratch& bodies, JointScratch& joints,
                  const JointStep& step, ThreadPool* threads) {
    for (size_t i = 0; i < joints.joint_arrays.size(); ++i) {
        JointArray& array = joints.joint_arrays[i];
        share_out_range(threads, array.joints.size(), joints_at_a_time,
                        [&](size_t begin, size_t end) {
                            joint_kind(JointScratch::type_of(i))
                                .store(array, bodies.solver_bodies, objects, step, {begin, end});
                        });
    }
}

}  // namespace fettle::physics::detail
