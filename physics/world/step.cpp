#include <contacts/narrow_phase.h>
#include <contacts/pairs.h>
#include <contacts/reports.h>
#include <geometry/trigonometry.h>
#include <schedule/coloring.h>
#include <schedule/cutting.h>
#include <solver/joint_passes.h>
#include <solver/serial_contacts.h>
#include <solver/solvers.h>
#include <solver/store_contacts.h>
#include <step/field_forces.h>
#include <step/gather.h>
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

void WorldData::solve(float dt) {
    const float h = dt / float(settings.substeps);
    const bool groups = settings.solver == Solver::soft_step;
    cut_into_strips(*this, *this, groups, steps, strips);
    gather_bodies(*this, *this, *this, settings, strips, h, *this, hubs, threads);
    apply_fields(*this, *this, boxes, awake_bodies, to_v2(settings.gravity), h, dt, solver_forces);
    const float ratio = last_substep > 0.0f ? h / last_substep : 1.0f;
    const JointStep joint_step =
        prepare_joints(*this, *this, *this, *this, *this, h, ratio, threads);
    const float gravity = length(to_v2(settings.gravity));
    const ContactStiffness stiffness(settings.contact_hertz, settings.contact_damping, h,
                                     gravity > 0.0f ? gravity : usual_gravity);
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
            keep_pushed_awake(*this, *this, *this, settings.sleep_speed * dt);
            break;
        case Solver::direct:
            solve_directly(input, joint_step, statistics);
            keep_pushed_awake(*this, *this, *this, settings.sleep_speed * dt);
            break;
    }
    last_substep = h;
    store_joints(*this, *this, joint_step, threads);
    break_joints(joint_step);
    store_contacts(*this, touching(), settings.hit_threshold, threads);
    if (settings.persist_events)
        report_persisting(*this, *this, *this, uint32_t(steps), settings.substeps, events);
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
    const WideKernels& kernels = wide_kernels(most_lanes);
    find_pairs(*this, *this, *this, *this, settings.bounds.has_value(), user_filter(),
               kernels.overlaps, threads);
    wake_jointed(activity());
    statistics.pairs_ms = clock.lap();
    narrow_phase({*this, *this, *this, *this, settings, *this, contact_list(), activity(), kernels,
                  threads});
    consult_callbacks();
    statistics.narrow_ms = clock.lap();
    solve(dt);
    statistics.solve_ms = clock.lap();
    finish_bodies(dt);
    stop_fast_bodies();
    report_parted(touching());
    order_lists(*this, *this, strips, *this, steps, reordering, threads);
    statistics.finish_ms = clock.lap();
    ++steps;
    sleep_resting_islands(activity(), settings, sleep_candidates, steps);
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
