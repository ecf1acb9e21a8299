#include <schedule/schedule.h>
#include <state/limits.h>
#include <step/gather.h>

#include <algorithm>

namespace fettle::physics::detail {
namespace {

/// Number of bodies in a task of a thread.
constexpr size_t gathered_at_a_time = 256;

/// Rare features of bodies, as bits: at least one body of a piece has it.
enum Gathered : uint8_t {
    some_locked = 1,
    some_axis_locked = 2,
    some_driven = 4,
    some_touched_by_many = 8,
    some_maybe_crowded = 16
};

uint8_t gather_body(const BodyRecord& record, const BodyState& state, Vec2 gravity, float h,
                    SolverBody& b, SolverForce& f) {
    b.velocity = state.velocity;
    b.angular_velocity = state.angular_velocity;
    b.inverse_mass = record.inverse_mass;
    b.inverse_inertia = record.inverse_inertia;
    b.shift = {};
    b.turn = 0.0f;
    f = {};
    if (record.mobility != Mobility::dynamic) return some_driven;
    const Vec2 force = record.load.force + record.step_load.force;
    const float torque = record.load.torque + record.step_load.torque;
    f.change = {bounded(h * (record.gravity_scale * gravity.x + record.inverse_mass * force.x),
                        2 * greatest_speed),
                bounded(h * (record.gravity_scale * gravity.y + record.inverse_mass * force.y),
                        2 * greatest_speed)};
    f.turn_change = bounded(h * record.inverse_inertia * torque, 2 * greatest_speed);
    // Implicit integration, which is stable for any damping.
    f.keep.x = f.keep.y = 1.0f / (1.0f + h * record.linear_damping);
    f.turn_keep = 1.0f / (1.0f + h * record.angular_damping);
    const bool axis = record.flags.locked_x || record.flags.locked_y;
    return uint8_t((axis ? some_axis_locked | some_locked : 0) |
                   (record.flags.locked_rotation ? some_locked : 0) |
                   (record.lists.contact_count >= Hubs::least_contacts ? some_touched_by_many : 0) |
                   (record.may_be_crowded ? some_maybe_crowded : 0));
}

}  // namespace

void gather_bodies(const ObjectState& objects, Columns& columns, const ActiveLists& active,
                   const WorldDef& settings, const Strips& strips, float h, BodyScratch& bodies,
                   Hubs& hubs, ThreadPool* threads) {
    const std::vector<uint32_t>& awake = active.awake_bodies;
    const std::vector<BodyRecord>& records = objects.bodies;
    const Vec2 gravity = settings.gravity;
    const size_t count = awake.size();
    bodies.solver_bodies.resize(count + 1);
    bodies.solver_forces.resize(count + 1);
    bodies.solver_bodies[0] = {};
    bodies.solver_ends.resize(records.size());
    bodies.gathered.resize((count + gathered_at_a_time - 1) / gathered_at_a_time);
    parallel_for(threads, count, gathered_at_a_time, [&](size_t begin, size_t end) {
        uint8_t found = 0;
        for (size_t i = begin; i < end; ++i) {
            if (i + bodies_ahead < end) records[awake[i + bodies_ahead]].prefetch();
            const uint32_t slot = awake[i];
            const BodyRecord& record = records[slot];
            const BodyState& state = columns.states[slot];
            bodies.solver_ends[slot] = {uint32_t(i + 1), strips.leaf_at(Vec2(record.center)),
                                        record.mobility == Mobility::dynamic};
            columns.previous[slot] = {state.position, state.angle};
            found |= gather_body(record, state, gravity, h, bodies.solver_bodies[i + 1],
                                 bodies.solver_forces[i + 1]);
            if (objects.max_speed_of(record) < infinity) found |= some_locked;
            if (record.mobility != Mobility::dynamic)
                objects.limit_velocity(record, bodies.solver_bodies[i + 1]);
        }
        bodies.gathered[begin / gathered_at_a_time] = found;
    });
    uint8_t found = 0;
    hubs.begin(strips.count());
    bodies.maybe_crowded.clear();
    for (size_t piece = 0; piece < bodies.gathered.size(); ++piece) {
        found |= bodies.gathered[piece];
        const size_t begin = piece * gathered_at_a_time;
        const size_t end = std::min(begin + gathered_at_a_time, count);
        for (size_t i = begin; (bodies.gathered[piece] & some_maybe_crowded) != 0 && i < end; ++i)
            if (records[awake[i]].may_be_crowded) bodies.maybe_crowded.push_back(awake[i]);
        // Solvers that solve one contact after the other need no hubs.
        if ((bodies.gathered[piece] & some_touched_by_many) != 0 &&
            settings.solver == Solver::soft_step)
            find_hubs(objects, awake, begin, end, bodies, hubs);
    }
    bodies.axes_locked = (found & some_axis_locked) != 0;
    bodies.driven = (found & some_driven) != 0;
    bodies.locked.clear();
    for (size_t i = 0; (found & some_locked) != 0 && i < count; ++i) {
        const BodyRecord& record = records[awake[i]];
        if (record.mobility == Mobility::dynamic &&
            (record.flags.locked_x || record.flags.locked_y || record.flags.locked_rotation ||
             objects.max_speed_of(record) < infinity))
            bodies.locked.push_back(uint32_t(i + 1));
    }
}

void clear_ends(const ActiveLists& active, BodyScratch& bodies) {
    for (const uint32_t body : active.awake_bodies) bodies.solver_ends[body] = {};
}

}  // namespace fettle::physics::detail
