#include <partition/union_find.h>
#include <solver/joints/crowded_joints.h>
#include <solver/joints/geometric_stiffness.h>
#include <solver/joints/joint_passes.h>
#include <solver/joints/obstructed_joints.h>
#include <state/active_lists.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <utility>

namespace fettle::physics::detail {
namespace {

/// Number of joints in a task of a thread.
constexpr size_t joints_at_a_time = 128;

/// The code of an awake joint before it is prepared: its node, and these bits; 0 if it does not
/// act.
enum JointCode : uint8_t { node_bits = 0x0f, load_bits = 0x70, one_load = 0x10, can_break = 0x80 };
static_assert(2 * most_strips <= node_bits + 1 &&
              JointScratch::classes <= load_bits / one_load + 1);

/// The load of a joint by its code, or `tuned` or `crowded`.
size_t class_of(uint8_t code) {
    return (code & load_bits) / one_load;
}
bool bears_load(uint8_t code) {
    return code != 0 && class_of(code) < JointScratch::loads;
}

/// How joints under a load are solved. A joint yields by load / (m·ω²), where m is the mass of its
/// light body: with the usual stiffness, a heavy body would stretch light links on which it hangs.
/// More stiffness is stable only if more sweeps over the joints converge better.
///
/// An impact moves the bodies of a joint far apart, because contacts stop one of them and the joint
/// the other only some passes later. The relax pass does not remove all of the speed that closes
/// the gap, so the bodies spring back: the faster the gap is closed, the higher.

struct LoadSettings {
    float ratio;  ///< the load is heavier than the lighter body by more than this
    float hertz;  ///< stiffness
    float share;  ///< of the rate of sub-steps: the greatest stiffness
    int sweeps;   ///< in each pass
    float speed;  ///< at which a gap is closed at most, m/s
};
constexpr LoadSettings settings_of_load[JointScratch::loads] = {{0.0f, 60.0f, 0.25f, 1, 2.0f},
                                                                {10.0f, 120.0f, 0.5f, 4, 16.0f},
                                                                {100.0f, 240.0f, 1.0f, 16, 64.0f}};

/// A single strong motor comes to rest in one sweep.
constexpr uint32_t least_motors = 2;

/// The speed at which a rod, a rope or a limit closes a gap, m/s, if the load allows no greater
/// one.
constexpr float least_length_speed = 16.0f;
/// The speed at which an angle comes to its limit or to that of its joint, rad/s, at any load.
/// The bodies of a chain keep a part of the velocity of a correction.
constexpr float angle_speed = 5.0f;

/// Wider gaps, m, come from edits. Their excess is removed at this rate, 1/s.
constexpr float least_wide_gap = 0.5f, wide_rate = 60.0f;

/// Sets how the joints under a load are solved: see `LoadSettings`.
void use_load_settings(size_t load, JointStep& step) {
    const LoadSettings& settings = settings_of_load[load];
    step.rigid = make_softness(min(settings.hertz, settings.share / step.h), 2.0f, step.h);
    step.greatest_gap = settings.speed / step.rigid.bias_rate;
    step.greatest_length_gap = max(settings.speed, least_length_speed) / step.rigid.bias_rate;
    step.greatest_angle_gap = angle_speed / step.rigid.bias_rate;
    step.wide_gap = max(least_wide_gap, step.greatest_gap);
    step.wide_share = min(wide_rate * step.h, 0.5f);
}

/// Index of the load between two bodies with these inverse masses.
uint8_t load_of(float lighter, float heavier) {
    uint8_t load = JointScratch::loads - 1;
    while (lighter <= settings_of_load[load].ratio * heavier) --load;
    return load;
}

/// Index of the load that a joint bears.
uint8_t load_between(const SolverBody& a, const SolverBody& b) {
    if (a.inverse_mass == 0.0f || b.inverse_mass == 0.0f) return 0;
    return load_of(max(a.inverse_mass, b.inverse_mass), min(a.inverse_mass, b.inverse_mass));
}

/// Bodies that joints connect. One of them bears a heavy load.
struct Loaded {
    uint8_t load = 0;
    float lightest = 0.0f, heaviest = 1e30f;  ///< inverse masses

    void add(const SolverBody& body) {
        if (body.inverse_mass == 0.0f) return;
        lightest = max(lightest, body.inverse_mass);
        heaviest = min(heaviest, body.inverse_mass);
    }
    /// A crate below a hook is heavier than the hook, and that is heavier than the links of its
    /// chain, which bear both: the heaviest and the lightest body decide.
    uint8_t greatest_load() const {
        return load > 0 ? std::max(load, load_of(lightest, heaviest)) : load;
    }
};

struct JointLists {
    ObjectState& objects;
    const ActiveLists& active;
    const BodyScratch& bodies;
    JointScratch& joints;
    ThreadPool* threads;
    std::vector<float> shares{};  ///< see `shares_of_crowded`

    /// Calls `visit(type, awake joint, its code)`.
    void for_each(auto&& visit) {
        uint8_t* code = joints.joint_codes.data();
        for (size_t type = 0; type < joint_type_count; ++type)
            for (const uint32_t joint : active.awake_joints[type]) visit(type, joint, *code++);
    }
    std::pair<uint32_t, uint32_t> indices_of(uint32_t joint) const {
        const auto [a, b] = objects.joints[joint].bodies;
        return {bodies.solver_ends[a].index(), bodies.solver_ends[b].index()};
    }

    uint8_t code_of(uint32_t slot) {
        const JointRecord& joint = objects.joints[slot];
        const JointRole role = role_of(objects, joint);
        if (role == JointRole::idle) clear_impulses(objects, slot);
        if (role != JointRole::acting) return 0;  // it keeps its impulses until a body wakes
        // Unlike a contact, a joint also writes to a kinematic body. The nodes of all joints of
        // such a body are on one path from the root, so no two of them are solved at the same time.
        const SolverEnd a = bodies.solver_ends[joint.bodies[0]],
                        b = bodies.solver_ends[joint.bodies[1]];
        const StripNode node =
            above_both((a.index() != 0 ? a : b).strip(), (b.index() != 0 ? b : a).strip());
        const uint8_t load = joint.is_tuned() ? uint8_t(JointScratch::tuned)
                                              : load_between(bodies.solver_bodies[a.index()],
                                                             bodies.solver_bodies[b.index()]);
        return uint8_t(std::max<StripNode>(node, 1) | load * one_load |
                       (joint.is_measured() ? can_break : 0));
    }
    /// Returns true if a joint bears a heavy load.
    bool make_codes() {
        size_t count = 0;
        for (const auto& awake : active.awake_joints) count += awake.size();
        joints.joint_codes.resize(count);
        std::atomic<bool> heavy = false;
        uint8_t* codes = joints.joint_codes.data();
        for (const auto& awake : active.awake_joints) {
            parallel_for(threads, awake.size(), joints_at_a_time, [&](size_t begin, size_t end) {
                uint8_t all = 0;
                for (size_t i = begin; i < end; ++i) {
                    codes[i] = code_of(awake[i]);
                    if (bears_load(codes[i])) all |= codes[i];
                }
                if ((all & load_bits) != 0) heavy.store(true, std::memory_order_relaxed);
            });
            codes += awake.size();
        }
        return heavy;
    }

    /// Makes the joints of crowded bodies a class of their own, except those that have a stiffness
    /// of their own.
    void find_crowded(const JointSource& source) {
        shares = shares_of_crowded(source, active, joints.joint_codes);
        for (size_t i = 0; i < shares.size(); ++i)
            if (shares[i] < 1.0f && class_of(joints.joint_codes[i]) != JointScratch::tuned)
                joints.joint_codes[i] = uint8_t((joints.joint_codes[i] & ~load_bits) |
                                                JointScratch::crowded * one_load);
    }

    /// A load goes through all joints that connect its body with others. So all joints of such a
    /// component count as loaded, and no joint elsewhere.
    void spread_loads() {
        UnionFind components;
        components.reset(bodies.solver_bodies.size());
        for_each([&](size_t, uint32_t joint, uint8_t code) {
            const auto [a, b] = indices_of(joint);
            if (code != 0 && moves(bodies.solver_bodies[a]) && moves(bodies.solver_bodies[b]))
                components.unite(a, b);
        });
        std::vector<Loaded> all(bodies.solver_bodies.size());
        for_each([&](size_t, uint32_t joint, uint8_t code) {
            const auto [a, b] = indices_of(joint);
            if (!bears_load(code)) return;
            Loaded& loaded = all[components.find(moves(bodies.solver_bodies[a]) ? a : b)];
            loaded.load = std::max(loaded.load, uint8_t(class_of(code)));
            loaded.add(bodies.solver_bodies[a]);
            loaded.add(bodies.solver_bodies[b]);
        });
        for_each([&](size_t, uint32_t joint, uint8_t& code) {
            const auto [a, b] = indices_of(joint);
            if (!bears_load(code)) return;
            const Loaded& loaded = all[components.find(moves(bodies.solver_bodies[a]) ? a : b)];
            code = uint8_t((code & ~load_bits) | loaded.greatest_load() * one_load);
        });
    }

    /// Raises the load of the joints of arms with several strong motors, see `load_of_drive`. True
    /// if there are any. The constraints must be prepared.
    bool raise_driven() {
        UnionFind components;
        components.reset(bodies.solver_bodies.size());
        struct Driven {
            uint8_t load = 0;
            uint32_t motors = 0;
        };
        const auto ends_of = [&](const JointKind& kind, JointArray& array, size_t k) {
            const JointEnds& ends = kind.ends(array, k);
            return std::pair(ends.a, ends.b);
        };
        const auto moving = [&](uint32_t a, uint32_t b) {
            return moves(bodies.solver_bodies[a]) ? a : b;
        };
        for_each_acting_joint(joints, [&](const JointKind& kind, JointArray& array, size_t k) {
            const auto [a, b] = ends_of(kind, array, k);
            if (moves(bodies.solver_bodies[a]) && moves(bodies.solver_bodies[b]))
                components.unite(a, b);
        });
        std::vector<Driven> all(bodies.solver_bodies.size());
        for_each_acting_joint(joints, [&](const JointKind& kind, JointArray& array, size_t k) {
            if (kind.drive == nullptr) return;
            const auto [a, b] = ends_of(kind, array, k);
            const uint8_t load = load_of_drive(kind.drive(array, k), bodies.solver_bodies[a],
                                               bodies.solver_bodies[b]);
            if (load == 0) return;
            Driven& driven = all[components.find(moving(a, b))];
            driven.load = std::max(driven.load, load);
            ++driven.motors;
        });
        bool any = false;
        for_each([&](size_t, uint32_t joint, uint8_t& code) {
            if (code == 0 || class_of(code) >= JointScratch::loads) return;
            const auto [a, b] = indices_of(joint);
            const Driven& driven = all[components.find(moving(a, b))];
            if (driven.motors < least_motors || driven.load <= class_of(code)) return;
            code = uint8_t((code & ~load_bits) | driven.load * one_load);
            any = true;
        });
        return any;
    }

    /// Lists the joints that act, in the order of their nodes. Most arrays are empty and stay so:
    /// nothing is done for them, since a small world would need more time for that than for its
    /// joints.
    void fill() {
        std::array<size_t, JointScratch::classes* joint_type_count> sizes = {};
        const auto array_of = [&](size_t type, uint8_t code) {
            return type + class_of(code) * joint_type_count;
        };
        for_each([&](size_t type, uint32_t, uint8_t code) {
            if (code != 0) ++sizes[array_of(type, code)];
        });
        joints.acting_in_class = {};
        for (size_t i = 0; i < sizes.size(); ++i) {
            JointArray& array = joints.joint_arrays[i];
            joints.acting_in_class[i / joint_type_count] += sizes[i];
            if (sizes[i] == 0 && array.nodes.size() == 0) continue;
            array.nodes.clear();
            array.joints.resize(sizes[i]);
            array.drives.resize(sizes[i]);
            array.open.assign(sizes[i], 0);
            const bool shared = !shares.empty() && i / joint_type_count >= JointScratch::tuned;
            array.shares.resize(shared ? sizes[i] : 0);
        }
        for_each([&](size_t type, uint32_t, uint8_t code) {
            if (code != 0) joints.joint_arrays[array_of(type, code)].nodes.count(code & node_bits);
        });
        std::array<NodeRanges::Places, JointScratch::classes * joint_type_count> next;
        for (size_t i = 0; i < next.size(); ++i) {
            if (sizes[i] == 0) continue;
            joints.joint_arrays[i].nodes.sum_up();
            next[i] = joints.joint_arrays[i].nodes.places();
        }
        joints.strains.clear();
        size_t number = 0;
        for_each([&](size_t type, uint32_t joint, uint8_t code) {
            const size_t share = number++;
            if (code == 0) return;
            const size_t array = array_of(type, code);
            const uint32_t place = next[array][code & node_bits]++;
            joints.joint_arrays[array].joints[place] = joint;
            if (!joints.joint_arrays[array].shares.empty())
                joints.joint_arrays[array].shares[place] = shares[share];
            if ((code & can_break) != 0)
                joints.strains.push_back({joint, uint32_t(array), place, {}, 0.0f});
        });
    }
};

/// The softness of each joint that has a stiffness of its own. One that is stiffer than the
/// sub-steps can follow would throw a net of such joints apart.
void soften_tuned(const ObjectState& objects, JointScratch& joints, float h) {
    for (size_t type = 0; type < joint_type_count; ++type) {
        JointArray& array = joints.joint_arrays[JointScratch::tuned * joint_type_count + type];
        array.softness.clear();
        for (const uint32_t slot : array.joints) {
            const JointRecord& joint = objects.joints[slot];
            const float hertz = min(joint.constraint_hertz, ContactStiffness::greatest_share / h);
            array.softness.push_back(make_softness(hertz, joint.constraint_damping_ratio, h));
        }
    }
}

/// Returns which joints push hard: see `JointKind::prepare`.
uint8_t write_constraints(const JointSource& source, JointScratch& joints, const JointStep& step,
                          ThreadPool* threads) {
    std::atomic<uint8_t> hard = 0;
    for (size_t i = 0; i < joints.joint_arrays.size(); ++i) {
        JointArray& array = joints.joint_arrays[i];
        const JointKind& kind = joint_kind(JointScratch::type_of(i));
        array.constraints.resize(array.joints.size() * kind.constraint_size);
        parallel_for(threads, array.joints.size(), joints_at_a_time, [&](size_t begin, size_t end) {
            if (const uint8_t found = kind.prepare(source, array, step, {begin, end}))
                hard.fetch_or(found, std::memory_order_relaxed);
        });
    }
    return hard.load(std::memory_order_relaxed);
}

}  // namespace

JointStep prepare_joints(ObjectState& objects, const Columns& columns, const ActiveLists& active,
                         BodyScratch& bodies, JointScratch& joints, float h, float impulse_ratio,
                         float contact_hertz, Solver solver, ThreadPool* threads) {
    const JointSource source = {objects, columns, bodies};
    JointStep step;
    step.h = h;
    step.inverse_h = 1.0f / h;
    step.impulse_ratio = impulse_ratio;
    step.contact_hertz = contact_hertz;
    use_load_settings(0, step);
    JointLists lists = {objects, active, bodies, joints, threads};
    const bool heavy = lists.make_codes();
    lists.find_crowded(source);
    if (heavy) lists.spread_loads();
    lists.fill();
    soften_tuned(objects, joints, h);
    uint8_t hard = write_constraints(source, joints, step, threads);
    if ((hard & strong) != 0 && lists.raise_driven()) {
        lists.fill();
        soften_tuned(objects, joints, h);
        hard = write_constraints(source, joints, step, threads);
    }
    hard &= uint8_t(~strong);
    bodies.strained.clear();
    // `direct` solves all joints and contacts at once.
    const bool far = (hard & lever) != 0 && solver != Solver::direct;
    if ((hard & pull) != 0 || far) raise_inertia(source, step, joints, bodies, far);
    hard &= uint8_t(~lever);
    if (hard != 0 || may_have_no_solution(bodies, solver))
        yield_to_obstacles(source, step, joints, solver, bodies.strained);
    return step;
}

namespace {

/// One pass over the joints of some nodes that bear a load, type by type.
void sweep(JointPass pass, size_t load, JointScratch& joints, std::span<SolverBody> bodies,
           const JointStep& step, const StripNodes& nodes) {
    for (size_t type = 0; type < joint_type_count; ++type) {
        JointArray& array = joints.joint_arrays[load * joint_type_count + type];
        const JointRange range = {array.nodes.begin(nodes), array.nodes.end(nodes)};
        if (range.begin != range.end)
            (joint_kind(JointType(type)).*pass)(array, bodies, step, range);
    }
}

/// The same for the joints that have a stiffness of their own, one by one.
void sweep_tuned(JointPass pass, JointScratch& joints, std::span<SolverBody> bodies,
                 const JointStep& step, const StripNodes& nodes) {
    for (size_t type = 0; type < joint_type_count; ++type) {
        JointArray& array = joints.joint_arrays[JointScratch::tuned * joint_type_count + type];
        if (array.softness.empty()) continue;
        JointStep own = step;
        own.greatest_gap = own.greatest_length_gap = own.greatest_angle_gap = infinity;
        own.wide_share = 0.0f;

        for (size_t i = array.nodes.begin(nodes); i < array.nodes.end(nodes); ++i) {
            own.rigid = array.softness[i];
            (joint_kind(JointType(type)).*pass)(array, bodies, own, {i, i + 1});
        }
    }
}

}  // namespace

int sweeps_of(size_t load, JointPass pass) {
    if (pass == &JointKind::warm_start) return 1;
    if (load == JointScratch::crowded) return sweeps_of_crowded;
    return load < JointScratch::loads ? settings_of_load[load].sweeps : 1;
}

void sweep_joints(JointPass pass, size_t load, JointScratch& joints, std::span<SolverBody> bodies,
                  const JointStep& step, const StripNodes& nodes) {
    if (joints.acting_in_class[load] == 0) return;
    if (load == 0 || load == JointScratch::crowded)
        return sweep(pass, load, joints, bodies, step, nodes);
    if (load == JointScratch::tuned) return sweep_tuned(pass, joints, bodies, step, nodes);
    JointStep of_load = step;
    use_load_settings(load, of_load);
    sweep(pass, load, joints, bodies, of_load, nodes);
}

void pass_joints(JointPass pass, JointScratch& joints, std::span<SolverBody> bodies,
                 const JointStep& step, const StripNodes& nodes) {
    for (size_t load = 0; load < JointScratch::classes; ++load)
        for (int i = 0; i < sweeps_of(load, pass); ++i)
            sweep_joints(pass, load, joints, bodies, step, nodes);
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

void add_strains(JointScratch& joints) {
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
        parallel_for(threads, array.joints.size(), joints_at_a_time, [&](size_t begin, size_t end) {
            joint_kind(JointScratch::type_of(i))
                .store(array, bodies.solver_bodies, objects, step, {begin, end});
        });
    }
}

}  // namespace fettle::physics::detail
