#include <solver/accounting.h>
#include <solver/contacts/contact_solver.h>
#include <solver/contacts/lanes_of_rows.h>
#include <solver/joints/joint_passes.h>
#include <solver/joints/joint_response.h>
#include <solver/motion.h>
#include <solver/solvers.h>
#include <state/limits.h>

#include <algorithm>
#include <atomic>
#include <bit>

// The soft step (E. Catto, "Solver2D", 2024) over all blocks. In each sub-step: velocities, warm
// start, biased solve, positions, relax. At the end: restitution. Joints come before contacts, and
// contacts that are solved one at a time before those that are solved sixteen at a time.

namespace fettle::physics::detail {
namespace {

// Numbers of groups and bodies in a task of a thread.
constexpr size_t groups_at_a_time = 8, bodies_at_a_time = 1024;

/// The memory for wide contacts, one per thread. A thread takes an idle one for the block that it
/// solves, and returns it.
class IdleBlocks {
  public:
    explicit IdleBlocks(std::vector<WideBlock>& blocks)
        : blocks_(blocks), idle_(~uint64_t{0} >> (64 - blocks.size())) {}
    WideBlock& acquire() {
        for (uint64_t idle = idle_.load(std::memory_order_relaxed);;)
            if (idle_.compare_exchange_weak(idle, idle & (idle - 1), std::memory_order_acquire))
                return blocks_[size_t(std::countr_zero(idle))];
    }
    void release(const WideBlock& block) {
        idle_.fetch_or(uint64_t{1} << (&block - blocks_.data()), std::memory_order_release);
    }

  private:
    std::vector<WideBlock>& blocks_;
    std::atomic<uint64_t> idle_;  // one bit per memory; a world has at most 64 threads
};

/// The soft step over all blocks: their common data, and the loops over their sections.
struct alignas(cache_line_size) SoftStep {
    const SolverInput& input;
    const WideKernels& kernels;
    PrepareStep prepare;
    float h;
    SubstepLimits limits;
    BodyScratch& bodies = input.bodies;
    ContactScratch& contacts = input.contacts;
    ScheduleScratch& schedule = input.schedule;

    using WidePass = void (*)(const WideStep&);

    ThreadPool* threads_of(const SolverBlock& block) const {
        return block.cut ? input.threads : nullptr;
    }

    /// Runs `work(section, nodes)` for each section of a block, on all threads if they share the
    /// block.
    auto section_loop(const SolverBlock& block, auto work) {
        const Sections& plan = schedule.sections_of(block);
        return SectionLoop(plan, threads_of(block),
                           [this, &plan, work, before = block.first_section](uint32_t section) {
                               const StripNodes nodes = plan.nodes_of(section);
                               const bool strip = nodes.begin >= input.strips.first_leaf();
                               const bool root = nodes.begin == 1;
                               if (strip) schedule.hubs.write_copies(nodes, bodies.solver_bodies);
                               if (root && !strip)
                                   schedule.hubs.average_copies(bodies.solver_bodies);
                               work(before + section, nodes);
                               if (root && strip)
                                   schedule.hubs.average_copies(bodies.solver_bodies);
                           });
    }

    /// Called before a group is prepared: sets the contacts in its lanes.
    void fill_group(size_t group, WideContact& wide, ContactLanes& from) {
        from.touching = from.reports_always = 0;
        for (uint32_t lane = 0; lane < uint32_t(group_size); ++lane) {
            const uint32_t i = contacts.lane_contacts[group * group_size + lane];
            if (i == none) {  // empty lane: body 0 against itself, without mass
                wide.a[lane] = wide.b[lane] = 0;
                wide.friction[lane] = 0.0f;
                from.spare = {};
                from.manifolds[lane] = &from.spare;
                continue;
            }
            const ActingContact& c = contacts.acting[i];
            wide.a[lane] = c.a();
            wide.b[lane] = c.b();
            wide.friction[lane] = input.objects.contacts[c.slot].friction;
            from.manifolds[lane] = &input.objects.contacts[c.slot].manifold;
            from.touching |= uint32_t{c.touching()} << lane;
            from.reports_always |= uint32_t{c.hit_events()} << lane;
        }
    }

    /// Called after a group is stored: computes which touches begin or end, and which contacts
    /// report hits.
    void store_results(size_t group, const ContactLanes& of, uint32_t pushed) {
        const uint32_t touches =
            (of.near & ~of.touching) | (of.within_twice & of.touching) | pushed;
        contacts.group_results[group] = {uint16_t((touches ^ of.touching) | of.reports_always),
                                         uint16_t(touches)};
    }

    void pass(WidePass kernel, uint32_t section, WideBlock& wide) {
        const size_t begin = schedule.first_groups[section],
                     end = schedule.first_groups[section + 1];
        run(kernel, begin, end, wide);
    }
    void run(WidePass kernel, size_t begin, size_t end, WideBlock& wide) const {
        kernel({bodies.solver_bodies.data(), wide.contacts_of(begin), wide.pushed_of(begin),
                wide.unsettled_of(begin), end - begin, 1.0f / h, input.settings.push_speed});
    }

    void prepare_block(const SolverBlock& block, WideBlock& wide) {
        wide.make_groups(block.first_group, block.group_end);
        section_loop(block, [&](uint32_t section, const StripNodes&) {
            const size_t end = schedule.first_groups[section + 1];
            for (size_t i = schedule.first_groups[section]; i < end; i += groups_at_a_time) {
                const size_t next = std::min(i + groups_at_a_time, end);
                WideContact* const groups = wide.contacts_of(i);
                ContactLanes* const from = wide.lanes_of(i);
                for (size_t k = 0; k < next - i; ++k) fill_group(i + k, groups[k], from[k]);
                kernels.prepare(prepare, {from, next - i}, groups);
            }
        }).run();
    }

    void store_section(uint32_t section, WideBlock& wide) {
        store_groups(schedule.first_groups[section], schedule.first_groups[section + 1], wide);
    }
    void store_groups(size_t begin, size_t end, WideBlock& wide) {
        const std::span to(wide.lanes_of(begin), end - begin);
        kernels.store(wide.contacts_of(begin), to, touch_distance);
        for (size_t k = 0; k < to.size(); ++k)
            store_results(begin + k, to[k], wide.pushed_of(begin)[k]);
    }

    auto begin_loop(const SolverBlock& block, bool again) {
        const std::span which = schedule.blocks.bodies_of(block);
        return RangeLoop(threads_of(block), which.size(), bodies_at_a_time,
                         [this, which, again](size_t begin, size_t end) {
                             begin_substep(bodies, which.subspan(begin, end - begin), h, limits,
                                           again);
                         });
    }

    auto move_loop(const SolverBlock& block) {
        const std::span which = schedule.blocks.bodies_of(block);
        return RangeLoop(threads_of(block), which.size(), bodies_at_a_time,
                         [this, which, h = h](size_t begin, size_t end) {
                             integrate_positions(which.subspan(begin, end - begin),
                                                 bodies.solver_bodies, h);
                         });
    }

    /// Solves contacts of the first block one at a time; of other blocks (null), none.
    ContactSolver solver_of(SingleContacts* single) const {
        ContactSolver solver;
        solver.bodies = bodies.solver_bodies;
        solver.forces = bodies.solver_forces;
        solver.inverse_h = 1.0f / h;
        solver.push_speed = input.settings.push_speed;
        solver.restitution_threshold = input.settings.restitution_threshold;
        if (single == nullptr) return solver;
        solver.constraints = single->constraints;
        solver.extras = single->extras;
        solver.rolling = single->rolling_contacts;
        solver.relaxed = single->relaxed;
        return solver;
    }
    /// Called after a relax pass over a block: further passes over the contacts that it left
    /// unsettled, and those of the same bodies. `serial`: the contacts of the block that are solved
    /// one at a time. `at_end`: this is the last sub-step.
    void settle(const SolverBlock& block, WideBlock& wide, ContactSolver& serial, bool at_end) {
        // The copies of a hub are averaged only after a pass over the whole block.
        if (!schedule.hubs.empty()) return;
        UnsettledScratch& scratch = schedule.unsettled[size_t(&wide - schedule.wide_blocks.data())];
        UnsettledContacts& unsettled = scratch.contacts;
        unsettled.begin(bodies.solver_bodies.size());
        const std::vector<uint8_t>& jointed = contacts.jointed;
        const auto add = [&](uint32_t a, uint32_t b) {
            const bool any = !jointed.empty() && (jointed[a] | jointed[b]) != 0;
            unsettled.add(bodies.solver_bodies, a, b, any);
        };
        serial.for_unsettled(add);
        for (uint32_t group = block.first_group; group < block.group_end; ++group)
            for (uint32_t left = *wide.unsettled_of(group); left != 0; left &= left - 1) {
                const WideContact& c = *wide.contacts_of(group);
                add(c.a[std::countr_zero(left)], c.b[std::countr_zero(left)]);
            }
        if (unsettled.empty() || !unsettled.find_rows()) return;
        list_lanes_of_rows(block, wide, bodies.solver_bodies, scratch);
        serial.count_in_rows(unsettled);
        if (!unsettled.leave_out_heaps()) return;
        copy_lanes_of_rows(wide, bodies.solver_bodies, scratch);
        ContactSolver in_rows = serial;
        in_rows.constraints = scratch.constraints;
        in_rows.relaxed = scratch.relaxed;
        for (int i = 0; i < UnsettledContacts::most_passes; ++i) {
            serial.relax_again(unsettled);
            in_rows.relax_again(unsettled);
            if (!unsettled.next_pass()) break;
        }
        write_lanes_of_rows(scratch, wide);
        if (!at_end) return;
        uint32_t last = none;
        for (const uint32_t lane : scratch.lanes)
            if (const uint32_t group = lane / group_size; group != std::exchange(last, group))
                store_groups(group, group + 1, wide);
    }

    /// Solves a block that has only wide contacts, through all sub-steps.
    void solve_block(const SolverBlock& block, WideBlock& wide) {
        const auto all = [&](WidePass kernel) {
            return section_loop(block, [&, kernel](uint32_t section, const StripNodes&) {
                pass(kernel, section, wide);
            });
        };
        const auto warm_start = all(kernels.warm_start), solve_biased = all(kernels.solve_biased);
        const auto relax = all(kernels.relax);
        const auto relax_and_store = section_loop(block, [&](uint32_t section, const StripNodes&) {
            pass(kernels.relax, section, wide);
            store_section(section, wide);
        });
        const auto begin = begin_loop(block, false), begin_again = begin_loop(block, true);
        const auto move_bodies = move_loop(block);
        ContactSolver serial = solver_of(nullptr);
        prepare_block(block, wide);
        begin_substeps(input, block);
        for (int substep = 0; substep < input.settings.substeps; ++substep) {
            (substep > 0 ? begin_again : begin).run();
            if (substep == 0) warm_start.run();
            solve_biased.run();
            move_bodies.run();
            if (substep + 1 < input.settings.substeps)
                relax.run();
            else
                relax_and_store.run();
            settle(block, wide, serial, substep + 1 == input.settings.substeps);
            add_substep(input, block, wide);
        }
    }

    /// True if later sub-steps repeat the change of velocity that the contacts caused, instead of a
    /// warm start of each contact. With many joints, separating their effect from that of the
    /// contacts would take longer than the warm start.
    bool repeats_pushes(const SolverBlock& block) {
        if (!contacts.serial.rolling_contacts.empty()) return false;  // their direction has changed
        if (2 * input.joints.acting_joints() >
            (block.contacts + contacts.serial.constraints.size()) / 4)
            return false;
        find_jointed(input.objects, input.joints, input.strips);
        return true;
    }
};

/// The passes over the first block, which also has joints and serial contacts.
struct alignas(cache_line_size) FirstBlock {
    SoftStep& step;
    const JointStep& joint_step;
    WideBlock& wide;
    ContactSolver serial, passing;  // all constraints
    bool repeats = false;

    static ContactSolver part_of(const ContactSolver& all, const NodeRanges& ranges,
                                 const StripNodes& nodes) {
        ContactSolver some = all;
        const size_t begin = ranges.begin(nodes), end = ranges.end(nodes);
        some.constraints = some.constraints.subspan(begin, end - begin);
        some.relaxed = some.relaxed.subspan(begin, end - begin);
        return some;
    }
    ContactSolver serial_of(const StripNodes& nodes) const {
        return part_of(serial, step.contacts.serial.nodes, nodes);
    }
    ContactSolver passing_of(const StripNodes& nodes) const {
        return part_of(passing, step.contacts.passing.nodes, nodes);
    }
    void around_joints(const StripNodes& nodes, auto&& pass) const {
        if (repeats)
            step.input.joints.joint_share.around(nodes, step.bodies.solver_bodies,
                                                 step.bodies.solver_forces, pass);
        else
            pass();
    }
    void repeat_joints(const StripNodes& nodes) const {
        around_joints(nodes, [&] {
            pass_joints(&JointKind::warm_start, step.input.joints, step.bodies.solver_bodies,
                        joint_step, nodes);
        });
    }
    void warm_start(uint32_t section, const StripNodes& nodes) const {
        repeat_joints(nodes);
        serial_of(nodes).warm_start();
        step.pass(step.kernels.warm_start, section, wide);
    }
    /// A pass over the joints of some nodes. Contacts of bodies whose joints bear a heavy load are
    /// solved in each of its sweeps. If they were solved only after all sweeps, a contact of a
    /// light body would meet it with the speed of the heavy body that stands on it, and remove no
    /// more than the momentum of the light body: it would be a spring without damping, and a table
    /// on light legs would never rest.
    void pass_joints_of(const StripNodes& nodes, JointPass joints,
                        void (ContactSolver::*contacts)(std::span<const uint32_t>)) const {
        const auto& loaded = step.contacts.loaded;
        JointScratch& scratch = step.input.joints;
        std::vector<SolverBody>& bodies = step.bodies.solver_bodies;
        const bool any = std::any_of(loaded.begin(), loaded.end(), [&](const LoadedContacts& of) {
            return !of.of(nodes).empty();
        });
        if (!any)
            return around_joints(nodes,
                                 [&] { pass_joints(joints, scratch, bodies, joint_step, nodes); });
        ContactSolver all = serial;
        for (size_t load = 0; load < JointScratch::classes; ++load) {
            for (int i = 0; i < sweeps_of(load, joints); ++i) {
                around_joints(
                    nodes, [&] { sweep_joints(joints, load, scratch, bodies, joint_step, nodes); });
                if (load < loaded.size()) (all.*contacts)(loaded[load].of(nodes));
            }
        }
    }
    void solve_biased(uint32_t section, const StripNodes& nodes) const {
        pass_joints_of(nodes, &JointKind::solve, &ContactSolver::solve_biased);
        serial_of(nodes).solve_biased();
        step.pass(step.kernels.solve_biased, section, wide);
    }
    void relax_with(void (ContactSolver::*relax_serial)(), uint32_t section,
                    const StripNodes& nodes) const {
        pass_joints_of(nodes, &JointKind::relax, &ContactSolver::relax);
        (serial_of(nodes).*relax_serial)();
        step.pass(step.kernels.relax, section, wide);
    }
    void relax(uint32_t section, const StripNodes& nodes) const {
        relax_with(&ContactSolver::relax, section, nodes);
    }
    void relax_and_store(uint32_t section, const StripNodes& nodes) const {
        relax_with(&ContactSolver::relax_at_end, section, nodes);
        step.store_section(section, wide);
    }
    void bounce(const SolverBlock& block) const {
        if (!serial.may_bounce()) return;
        step.bodies.bounced.assign(step.bodies.solver_bodies.size(), 0);
        step.bodies.first_impacts.resize(step.bodies.solver_bodies.size());
        const Bounced bounced = {step.bodies.bounced, step.bodies.first_impacts};
        const int substeps = step.input.settings.substeps;
        if (step.input.joints.acting_joints() > 0) {
            // An impact that goes through joints may reach bodies of any strip.
            JointResponse joints(step.input, step.h);
            ContactSolver fast = serial, others = passing;
            bool any = true;
            for (uint8_t pass = 1; any && pass <= ContactSolver::most_passes; ++pass) {
                any = fast.bounce(substeps, pass, bounced, &joints);
                any |= others.bounce(substeps, pass, bounced, &joints);
            }
            joints.report();
            return;
        }
        std::atomic<bool> any = true;
        for (uint8_t pass = 1; any && pass <= ContactSolver::most_passes; ++pass) {
            any = false;
            step.section_loop(block,
                              [&](uint32_t, const StripNodes& nodes) {
                                  for (ContactSolver some : {serial_of(nodes), passing_of(nodes)})
                                      if (some.bounce(substeps, pass, bounced, nullptr)) any = true;
                              })
                .run();
        }
    }
    void restitute(const SolverBlock& block) const {
        step.section_loop(
                block, [this](uint32_t, const StripNodes& nodes) { serial_of(nodes).restitute(); })
            .run();
    }
};

void solve_first_block(SoftStep& step, const JointStep& joint_step) {
    const SolverInput& input = step.input;
    const ContactScratch& contacts = step.contacts;
    const SolverBlock& block = step.schedule.blocks[0];
    FirstBlock first = {step, joint_step, step.schedule.wide_blocks[0], {}, {}};
    first.serial = step.solver_of(&step.contacts.serial);
    first.passing = step.solver_of(&step.contacts.passing);
    first.repeats = step.repeats_pushes(block);
    const bool jointed = input.joints.acting_joints() > 0;

    const auto loop = [&](auto member) {
        return step.section_loop(block,
                                 [&first, member](uint32_t section, const StripNodes& nodes) {
                                     (first.*member)(section, nodes);
                                 });
    };
    const auto warm_start = loop(&FirstBlock::warm_start);
    const auto repeat_joints = step.section_loop(
        block, [&first](uint32_t, const StripNodes& nodes) { first.repeat_joints(nodes); });
    const auto solve_biased = loop(&FirstBlock::solve_biased), relax = loop(&FirstBlock::relax);
    const auto relax_and_store = loop(&FirstBlock::relax_and_store);
    const auto begin = step.begin_loop(block, false), begin_again = step.begin_loop(block, true);
    const auto move_bodies = step.move_loop(block);

    step.prepare_block(block, first.wide);
    if (!contacts.serial.extras.empty()) first.bounce(block);
    zero_locked(input);
    begin_substeps(input, block);
    for (int substep = 0; substep < input.settings.substeps; ++substep) {
        const bool again = first.repeats && substep > 0;
        (again ? begin_again : begin).run();
        zero_locked(input);
        if (!again)
            warm_start.run();
        else if (jointed)
            repeat_joints.run();
        solve_biased.run();
        add_biased(input);
        zero_locked(input);
        move_bodies.run();
        const bool at_end = substep + 1 == input.settings.substeps;
        (at_end ? relax_and_store : relax).run();
        step.settle(block, first.wide, first.serial, at_end);
        first.serial.record();
        zero_locked(input);
        add_strains(input.joints);
        add_substep(input, block, first.wide);
    }
    if (!contacts.serial.extras.empty()) {
        first.restitute(block);
        zero_locked(input);
    }
}

}  // namespace

void solve_softly(const SolverInput& input, const JointStep& joint_step,
                  const ContactStiffness& stiffness, const WideKernels& kernels) {
    const float h = joint_step.h;
    const SolverBlocks& blocks = input.schedule.blocks;
    std::vector<WideBlock>& wide_blocks = input.schedule.wide_blocks;
    SoftStep step = {input,
                     kernels,
                     {input.bodies.solver_bodies.data(), &stiffness, joint_step.impulse_ratio},
                     h,
                     {input.settings.max_speed, greatest_turn / h}};
    const auto whole = uint32_t(blocks.size() - 1);
    const int at_a_time = input.threads != nullptr && whole > 1 ? input.threads->threads() : 1;
    if (wide_blocks.size() < size_t(at_a_time)) wide_blocks.resize(size_t(at_a_time));
    input.schedule.unsettled.resize(wide_blocks.size());
    solve_first_block(step, joint_step);
    // The few large blocks are solved one after the other; all threads share each of them.
    for (uint32_t i = 1; i <= whole; ++i) {
        if (blocks[i].cut) step.solve_block(blocks[i], wide_blocks[0]);
    }
    IdleBlocks idle(wide_blocks);
    parallel_for(input.threads, whole, [&](uint32_t i) {
        if (blocks[i + 1].cut) return;
        WideBlock& wide = idle.acquire();
        step.solve_block(blocks[i + 1], wide);
        idle.release(wide);
    });
}

}  // namespace fettle::physics::detail
