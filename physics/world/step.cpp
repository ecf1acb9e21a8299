#include <geometry/trigonometry.h>
#include <schedule/coloring.h>
#include <solver/joint_passes.h>
#include <solver/serial_contacts.h>
#include <solver/solvers.h>
#include <solver/store_contacts.h>
#include <world/archive.h>
#include <world/world_data.h>

#include <algorithm>
#include <chrono>
#include <utility>

// One step: edits → pairs → manifolds → gather → sub-steps → store → poses → sleep.
// docs/design/physics.md tells the why.

namespace fettle::physics::detail {
namespace {

/// Where there is none, loads are told as if it were this, m/s².
constexpr float usual_gravity = 10.0f;

/// What a thread takes at a time.
constexpr size_t bodies_at_a_time = 256;

class StageClock {
  public:
    /// Milliseconds since the last call.
    float lap() {
        const auto now = std::chrono::steady_clock::now();
        const std::chrono::duration<float, std::milli> passed = now - last_;
        last_ = now;
        return passed.count();
    }

  private:
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

}  // namespace

/// What a piece of the awake bodies has that few have.
enum Gathered : uint8_t {
    some_locked = 1,
    some_axis_locked = 2,
    some_driven = 4,
    some_crowded = 8
};

uint8_t WorldData::gather_body(size_t i, float h) {
    const uint32_t slot = awake_bodies[i];
    const BodyRecord& record = bodies[slot];
    const BodyState& state = states[slot];
    const bool dynamic = record.mobility == Mobility::dynamic;
    solver_ends[slot] = {uint32_t(i + 1), strips.leaf_at(record.center), dynamic};
    previous[slot] = {state.position, state.angle};
    SolverBody& b = solver_bodies[i + 1];
    b.velocity = to_v2(state.velocity);
    b.angular_velocity = state.angular_velocity;
    b.inverse_mass = record.inverse_mass;
    b.inverse_inertia = record.inverse_inertia;
    b.shift = {};
    b.turn = 0.0f;
    SolverForce& f = solver_forces[i + 1];
    f = {};
    if (!dynamic) return some_driven;
    const V2 gravity = to_v2(settings.gravity);
    const V2 force = record.force + record.step_force;
    const float torque = record.torque + record.step_torque;
    f.change = {bounded(h * (record.gravity_scale * gravity.x + record.inverse_mass * force.x),
                        2 * greatest_speed),
                bounded(h * (record.gravity_scale * gravity.y + record.inverse_mass * force.y),
                        2 * greatest_speed)};
    f.turn_change = bounded(h * record.inverse_inertia * torque, 2 * greatest_speed);
    // Implicit: stable for any damping.
    f.keep.x = f.keep.y = 1.0f / (1.0f + h * record.linear_damping);
    f.turn_keep = 1.0f / (1.0f + h * record.angular_damping);
    const bool axis = record.locked_x || record.locked_y;
    return uint8_t((axis ? some_axis_locked | some_locked : 0) |
                   (record.locked_rotation ? some_locked : 0) |
                   (record.contact_count >= Hubs::least_contacts ? some_crowded : 0));
}

void WorldData::gather_bodies(float h) {
    const size_t count = awake_bodies.size();
    solver_bodies.resize(count + 1);
    solver_forces.resize(count + 1);
    solver_bodies[0] = {};
    solver_ends.assign(bodies.size(), {});
    gathered.resize((count + bodies_at_a_time - 1) / bodies_at_a_time);
    share_out_range(threads, count, bodies_at_a_time, [&](size_t begin, size_t end) {
        uint8_t found = 0;
        for (size_t i = begin; i < end; ++i) {
            if (i + bodies_ahead < end) bodies[awake_bodies[i + bodies_ahead]].prefetch();
            found |= gather_body(i, h);
        }
        gathered[begin / bodies_at_a_time] = found;
    });
    uint8_t found = 0;
    hubs.begin(strips.count());
    for (size_t piece = 0; piece < gathered.size(); ++piece) {
        found |= gathered[piece];
        // The solvers that take one contact after the other need none.
        if ((gathered[piece] & some_crowded) != 0 && settings.solver == Solver::soft_step)
            find_hubs(piece * bodies_at_a_time, std::min((piece + 1) * bodies_at_a_time, count));
    }
    axes_locked = (found & some_axis_locked) != 0;
    driven = (found & some_driven) != 0;
    locked.clear();
    for (size_t i = 0; (found & some_locked) != 0 && i < count; ++i) {
        const BodyRecord& record = bodies[awake_bodies[i]];
        if (record.mobility == Mobility::dynamic &&
            (record.locked_x || record.locked_y || record.locked_rotation))
            locked.push_back(uint32_t(i + 1));
    }
}

void WorldData::solve(float dt) {
    const float h = dt / float(settings.substeps);
    cut_into_strips();
    gather_bodies(h);
    apply_fields(h, dt);
    const float ratio = last_substep > 0.0f ? h / last_substep : 1.0f;
    const JointStep joint_step =
        prepare_joints(*this, *this, *this, *this, *this, h, ratio, threads);
    const float gravity = length(to_v2(settings.gravity));
    const ContactStiffness stiffness(settings.contact_hertz, settings.contact_damping, h,
                                     gravity > 0.0f ? gravity : usual_gravity);
    const bool groups = settings.solver == Solver::soft_step;
    find_acting(*this, *this, *this, *this, *this, groups, dt, threads);
    color_contacts(*this, *this, strips, acting_joints(), *this, *this, threads);
    prepare_serial(*this, *this, *this, *this, stiffness, dt, ratio, threads);
    const SolverInput input = {settings, *this, *this, strips, *this, *this, *this, *this, threads};
    statistics.direct_solves = statistics.direct_failures = 0;
    switch (settings.solver) {
        case Solver::soft_step:
            solve_softly(input, joint_step, stiffness, wide_kernels(most_lanes));
            break;
        case Solver::sequential:
            solve_sequentially(input, joint_step);
            keep_pushed_awake(dt);
            break;
        case Solver::direct:
            solve_directly(input, joint_step, statistics);
            keep_pushed_awake(dt);
            break;
    }
    last_substep = h;
    store_joints(*this, *this, joint_step, threads);
    break_joints(joint_step);
    store_contacts(*this, touching(), settings.hit_threshold, threads);
    tell_persisting();
}

void WorldData::step(float dt) {
    StageClock total, clock;
    refresh();
    std::swap(events, pending);
    const auto clear = [](auto& list) { list.clear(); };
    event_members(clear, pending);
    stepping = true;
    statistics.moved_proxies = 0;
    statistics.edits_ms = clock.lap();
    find_pairs();
    wake_jointed();
    statistics.pairs_ms = clock.lap();
    narrow_phase();
    consult_callbacks();
    statistics.narrow_ms = clock.lap();
    solve(dt);
    statistics.solve_ms = clock.lap();
    finish_bodies(dt);
    stop_fast_bodies();
    report_parted(touching());
    order_lists();
    statistics.finish_ms = clock.lap();
    ++steps;
    sleep_resting_islands();
    statistics.sleep_ms = clock.lap();
    stepping = false;
    statistics.total_ms = total.lap();

    statistics.steps = steps;
    statistics.bodies = body_slots.count;
    statistics.shapes = shape_slots.count;
    statistics.joints = joint_slots.count;
    statistics.awake_joints = 0;
    for (const auto& list : awake_joints) statistics.awake_joints += uint32_t(list.size());
    statistics.contacts = contact_slots.count;
    statistics.awake_bodies = uint32_t(awake_bodies.size());
    statistics.awake_contacts = uint32_t(awake_contacts.size());
    statistics.touching = uint32_t(constraints.size() + colored_count);
    statistics.islands = island_slots.count;
    trim();
}

}  // namespace fettle::physics::detail
