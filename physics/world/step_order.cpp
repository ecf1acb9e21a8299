#include <checks/hooks.h>
#include <contacts/narrow_phase.h>
#include <contacts/overlaps/crushed_bodies.h>
#include <contacts/overlaps/held_open.h>
#include <contacts/pairs.h>
#include <contacts/reports.h>
#include <schedule/schedule.h>
#include <solver/accounting.h>
#include <solver/contacts/serial_contacts.h>
#include <solver/joints/joint_passes.h>
#include <solver/solvers.h>
#include <state/member_list.h>
#include <step/finish.h>
#include <step/gather.h>
#include <step/sunk_bodies.h>
#include <world/world_data.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

// The order of the stages of a step. docs/design/physics.md explains it.

namespace fettle::physics::detail {
namespace {

/// Without gravity in the world, loads are measured with this gravity, m/s².
constexpr float usual_gravity = 10.0f;

/// The impulses of a resting load grow with the length of a step, but those of an impact do not.
/// Stored impulses may contain both, so they grow by this factor at most when the step grows.
constexpr float greatest_growth = 2.0f;
/// A step has at most this many times the usual number of sub-steps.
constexpr float most_times = 4;
/// The number of sub-steps is meant for steps of this length, s.
constexpr float usual_length = 1.0f / 60;

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

/// What moves fast for the length of a sub-step is not stable: a contact is stiff by a part of the
/// rate of the sub-steps only, so a load sinks in by the square of their length, and a light ball
/// between two rods under a heavy load is thrown out of them. So steps of 1/30 and 1/20 s get twice
/// and three times the sub-steps of 1/60 s.
float needed_for_length(float substeps, float dt) {
    return std::round(substeps * dt / usual_length);
}

/// A sub-step of `soft_step` begins with the impulses of the last one. If it is much longer, they
/// are far too small, and heavy bodies sink into light ones until they have grown, and spring back
/// in shorter steps. So a step that is much longer than the last one gets more sub-steps: never
/// more than short steps would need for the same time.
float needed_for_growth(float substeps, float dt, float last_length) {
    // Lengths of steps are compared, so that an edit of the number of sub-steps is not growth.
    return last_length > 0.0f ? std::ceil(substeps * (dt / last_length) / greatest_growth) : 0.0f;
}

int substeps_of(const WorldDef& settings, float dt, float last_length) {
    // Each sub-step of `sequential` lets points bounce by themselves, which adds energy to jointed
    // bodies.
    if (settings.solver == Solver::sequential) return settings.substeps;
    const auto usual = float(settings.substeps);
    float needed = needed_for_length(usual, dt);
    if (settings.solver == Solver::soft_step)
        needed = max(needed, needed_for_growth(usual, dt, last_length));
    return int(clamp(needed, usual, most_times * usual));
}

/// `longest`: the longest recent sub-step, s.
ContactStiffness stiffness_of(const WorldDef& settings, float h, float longest) {
    const float gravity = length(settings.gravity);
    const float hertz = min(settings.contact_hertz, ContactStiffness::greatest_share / longest);
    return {hertz, settings.contact_damping, h, gravity > 0.0f ? gravity : usual_gravity};
}

}  // namespace

/// How a step is divided.
struct SubSteps {
    WorldDef settings;  ///< with the number of sub-steps of this step
    float h;            ///< length of a sub-step, s
    float ratio;        ///< of this length to the last one; scales stored impulses
    ContactStiffness stiffness;
};

namespace {

SubSteps divide(WorldState& state, float dt) {
    WorldDef of_step = state.settings;
    of_step.substeps = substeps_of(state.settings, dt, state.last_length);
    const float h = dt / float(of_step.substeps);
    const float ratio =
        state.last_substep > 0.0f ? min(h / state.last_substep, greatest_growth) : 1.0f;
    // Softer contacts yield more. If the stiffness followed each length of a step at once, steps of
    // different lengths would press a stack together and let it spring up in turn.
    float& longest = state.long_substep;
    longest = max(h, longest + (h - longest) * min(dt, 1.0f));
    return {of_step, h, ratio, stiffness_of(state.settings, h, longest)};
}

void store_lengths(WorldState& state, const SubSteps& sub) {
    state.last_substep = sub.h;
    state.last_length = sub.h * float(state.settings.substeps);
    state.last_substeps = sub.settings.substeps;
}

}  // namespace

void WorldData::step(float dt) {
    const WideKernels& kernels = wide_kernels(most_width);
    const SubSteps sub = divide(*this, dt);
    StageClock total, clock;

    begin_step();
    statistics.edits_ms = clock.lap();
    find_pairs(objects(), columns(), broad_phase(), settings, steps, pair_scratch(), user_filter(),
               kernels.overlaps, threads);
    wake_jointed(activity());
    statistics.pairs_ms = clock.lap();
    narrow_phase({objects(), columns(), broad_phase(), active(), settings, pair_scratch(),
                  contact_list(), activity(), kernels, threads});
    const bool crushed = skip_crushed(touching(), active());
    call_contact_callbacks();
    statistics.narrow_ms = clock.lap();

    gather_objects(sub, dt);
    const JointStep joint_step = prepare_constraints(sub, dt);
    solve_constraints(sub, joint_step, kernels);
    store_results(sub, joint_step, dt);
    statistics.solve_ms = clock.lap();

    sleep_candidates = finish_bodies(
        {objects(), columns(), broad_phase(), active(), settings, body_scratch(),
         sub.settings.substeps, *this, pair_scratch(), contact_list(), activity(), pending,
         user_filter(), user_decision(),
         crushed || self.has_contact_callbacks() || !ignored_pairs.empty() || !mover_pairs.empty(),
         statistics, threads, self.sums},
        dt);
    store_velocities_after(self.sums, columns());
    report_parted(touching());
    mark_ended_contacts();
    order_lists(objects(), active(), strips, body_scratch(), steps, reordering, threads);
    clear_ends(active(), body_scratch());
    statistics.finish_ms = clock.lap();
    ++steps;
    since_search += dt;
    sleep_resting_islands(activity(), joint_scratch(), settings, sleep_candidates, steps,
                          since_search);
    statistics.sleep_ms = clock.lap();
    statistics.total_ms = total.lap();
    end_step();
}

void WorldData::gather_objects(const SubSteps& sub, float dt) {
    cut_into_strips(objects(), active(), solves_in_groups(), steps, strips);
    gather_bodies(objects(), columns(), active(), settings, strips, sub.h, body_scratch(), hubs,
                  threads);
    apply_fields(objects(), columns(), boxes, awake_bodies, settings.gravity, sub.h, dt,
                 body_scratch());
    if (!self.functions.empty()) call_velocity_functions(dt, sub.settings.substeps);
}

JointStep WorldData::prepare_constraints(const SubSteps& sub, float dt) {
    const JointStep joint_step =
        prepare_joints(objects(), columns(), active(), body_scratch(), joint_scratch(), sub.h,
                       sub.ratio, sub.stiffness.loaded_hertz(), settings.solver, threads);
    find_acting(objects(), active(), body_scratch(), joint_scratch(), settings, schedule(),
                contact_scratch(), dt, threads);
    color_contacts(active(), body_scratch(), strips, acting_joints(), contact_scratch(), schedule(),
                   threads);
    prepare_serial(objects(), columns(), body_scratch(), contact_scratch(), sub.stiffness, dt,
                   sub.ratio, threads);
    return joint_step;
}

void WorldData::solve_constraints(const SubSteps& sub, const JointStep& joint_step,
                                  const WideKernels& kernels) {
    const bool groups = solves_in_groups();
    const SolverInput input = {
        sub.settings,      objects(),
        active(),          strips,
        body_scratch(),    joint_scratch(),
        contact_scratch(), schedule(),
        threads,           groups ? std::span(self.sums) : std::span<VelocitySums>()};
    begin_sums(input, columns(), steps, sub.h);
    solve(input, joint_step, sub.stiffness, kernels, statistics);
    limit_squeezed(input, columns(), sub.h * float(sub.settings.substeps));
    size_t jammed = 0;
    if (groups) {
        jammed = find_jammed(input, columns(), pressed);
        if (crowded_shapes > 0) limit_pushes(input, columns());
    }
    limit_strained(input, columns(), groups ? std::span(pressed) : std::span<uint32_t>(), sub.h);
    pressed.resize(jammed);
    hold_sunk(objects(), columns(), settings, contact_scratch(), body_scratch());
    end_sums(input, columns());
}

void WorldData::store_results(const SubSteps& sub, const JointStep& joint_step, float dt) {
    if (!solves_in_groups()) keep_pushed_awake(objects(), active(), body_scratch(), settings, dt);
    store_lengths(*this, sub);
    store_joints(objects(), body_scratch(), joint_scratch(), joint_step, threads);
    break_joints(editing(), joint_scratch(), joint_step.inverse_h / float(sub.settings.substeps));
    store_contacts(contact_scratch(), touching(), settings.hit_threshold, threads);
    drop_impulses(objects(), body_scratch().limited);
    release_held_open(touching(), joint_scratch(), joint_step.h);
    for (const uint32_t contact : pair_scratch().pressed)
        skip_contact(touching(), contact, Skipped::crushed);
    if (settings.persist_events)
        report_persisting(objects(), columns(), active(), uint32_t(steps), sub.settings.substeps,
                          events);
}

void WorldData::apply_mover_weights() {
    for (const MoverWeight& weight : mover_weights) {
        if (!is_valid(weight.body)) continue;
        BodyRecord& record = bodies[weight.body.index];
        const bool moves = record.mobility == Mobility::dynamic && record.solver_index != 0;
        if (moves) record.step_load.add(weight.load);
    }
    mover_weights.clear();
}

void WorldData::begin_step() {
    if (lacks_refused_pairs()) search_all_pairs();
    filtered = bool(self.filter);
    detail::refresh(editing());
    apply_mover_weights();
    clear_ended_contacts();
    std::swap(events, pending);
    const auto clear = [](auto& list) { list.clear(); };
    event_members(clear, pending);
    stepping = true;
    statistics.moved_proxies = 0;
}

namespace {

/// A recording that fails ends, and the step goes on; the exception is thrown after it.
void end_recording(WorldSelf& self) {
    self.set_observer(nullptr);
    log(LogLevel::error,
        "the recording of a world ended: the function that takes it (World::start_recording) "
        "threw, or the world was destroyed");
}

}  // namespace

void WorldData::notify_step_begin(float dt) {
    const Callbacks callbacks = {bool(self.filter), bool(self.mix), bool(self.before_solve)};
    if (!self.call_user(in_recording, [&] {
            self.observer()->step_begins(*this, callbacks, self.functions, dt);
        }))
        end_recording(self);
}

void WorldData::notify_step_end() {
    if (!self.call_user(in_recording, [&] { self.observer()->step_ends(*this, hash_of(*this)); }))
        end_recording(self);
}

void WorldData::end_step() {
    stepping = false;
    end_moves();
    statistics.steps = steps;
    statistics.bodies = body_slots.count;
    statistics.shapes = shape_slots.count;
    statistics.joints = joint_slots.count - dormant_joints;
    statistics.awake_joints = 0;
    for (const auto& list : awake_joints) statistics.awake_joints += uint32_t(list.size());
    statistics.contacts = contact_slots.count;
    statistics.awake_bodies = uint32_t(awake_bodies.size());
    statistics.awake_contacts = uint32_t(awake_contacts.size());
    statistics.touching = uint32_t(serial.acting.size() + colored_count);
    statistics.islands = island_slots.count;
    trim();
}

}  // namespace fettle::physics::detail
