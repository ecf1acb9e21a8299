#include <solver/contact_solver.h>
#include <solver/motion.h>
#include <world/world_data.h>

#include <algorithm>
#include <atomic>
#include <bit>

// The soft step (E. Catto, "Solver2D", 2024) over all blocks: per sub-step velocities, warm start,
// biased solve, positions, relax; at the end restitution; joints before contacts, what is solved
// one at a time before what is solved sixteen at a time.

namespace fettle::physics::detail {
namespace {

// What a thread takes at a time.
constexpr size_t groups_at_a_time = 8, bodies_at_a_time = 1024;

/// Who solves a block takes one that is idle and gives it back. There is one for every thread.
class IdleBlocks {
  public:
    explicit IdleBlocks(std::vector<WideBlock>& blocks)
        : blocks_(blocks), idle_(~uint64_t{0} >> (64 - blocks.size())) {}
    WideBlock& take() {
        for (uint64_t idle = idle_.load(std::memory_order_relaxed);;)
            if (idle_.compare_exchange_weak(idle, idle & (idle - 1), std::memory_order_acquire))
                return blocks_[size_t(std::countr_zero(idle))];
    }
    void give_back(const WideBlock& block) {
        idle_.fetch_or(uint64_t{1} << (&block - blocks_.data()), std::memory_order_release);
    }

  private:
    std::vector<WideBlock>& blocks_;
    std::atomic<uint64_t> idle_;  // a bit each: a world has at most 64 threads
};

}  // namespace

/// What holds for all blocks during a step.
struct alignas(line_size) WorldData::BlockStep {
    const WideKernels& kernels;
    PrepareStep prepare;
    float h;
    SubstepLimits limits;
};

/// `work(section, nodes)` for each section of a block, by all threads if they share it out.
template <typename Work>
auto WorldData::section_loop(const SolverBlock& block, Work work) {
    const Sections& plan = sections_of(block);
    return SectionLoop(plan, helpers_of(block),
                       [this, &plan, work, before = block.first_section](uint32_t section) {
                           const StripNodes nodes = plan.nodes_of(section);
                           const bool strip = nodes.begin >= strips.first_leaf();
                           const bool root = nodes.begin == 1;
                           if (strip) hubs.hand_out(nodes, solver_bodies);
                           if (root && !strip) hubs.take_back(solver_bodies);
                           work(before + section, nodes);
                           if (root && strip) hubs.take_back(solver_bodies);
                       });
}

void WorldData::pass(WidePass kernel, uint32_t section, WideBlock& wide, const BlockStep& step) {
    const size_t begin = first_groups[section], end = first_groups[section + 1];
    kernel({solver_bodies.data(), wide.contacts_of(begin), end - begin, 1.0f / step.h,
            settings.push_speed});
}

void WorldData::prepare_block(const SolverBlock& block, WideBlock& wide, const BlockStep& step) {
    wide.make_groups(block.first_group, block.group_end);
    section_loop(block, [&](uint32_t section, const StripNodes&) {
        const size_t end = first_groups[section + 1];
        for (size_t i = first_groups[section]; i < end; i += groups_at_a_time) {
            const size_t next = std::min(i + groups_at_a_time, end);
            WideContact* const groups = wide.contacts_of(i);
            ContactLanes* const from = wide.lanes_of(i);
            for (size_t k = 0; k < next - i; ++k) fill_group(i + k, groups[k], from[k]);
            step.kernels.prepare(step.prepare, {from, next - i}, groups);
        }
    }).run();
}

void WorldData::store_section(uint32_t section, WideBlock& wide, const BlockStep& step) {
    const size_t begin = first_groups[section], end = first_groups[section + 1];
    const std::span to(wide.lanes_of(begin), end - begin);
    step.kernels.store(wide.contacts_of(begin), to, touch_distance);
    for (size_t k = 0; k < to.size(); ++k) note_news(begin + k, to[k]);
}

auto WorldData::begin_loop(const SolverBlock& block, const BlockStep& step, bool again) {
    const std::span which = blocks.bodies_of(block);
    return RangeLoop(helpers_of(block), which.size(), bodies_at_a_time,
                     [this, which, &step, again](size_t begin, size_t end) {
                         integrate_velocities(which.subspan(begin, end - begin), solver_bodies,
                                              solver_forces, step.limits, again);
                     });
}

auto WorldData::move_loop(const SolverBlock& block, const BlockStep& step) {
    const std::span which = blocks.bodies_of(block);
    return RangeLoop(helpers_of(block), which.size(), bodies_at_a_time,
                     [this, which, h = step.h](size_t begin, size_t end) {
                         integrate_positions(which.subspan(begin, end - begin), solver_bodies, h);
                     });
}

/// A block of nothing but wide contacts, through all sub-steps.
void WorldData::solve_block(const SolverBlock& block, WideBlock& wide, const BlockStep& step) {
    const WideKernels& kernels = step.kernels;
    const auto all = [&](WidePass kernel) {
        return section_loop(block, [&, kernel](uint32_t section, const StripNodes&) {
            pass(kernel, section, wide, step);
        });
    };
    const auto warm_start = all(kernels.warm_start), solve_biased = all(kernels.solve_biased);
    const auto relax = all(kernels.relax);
    const auto relax_and_store = section_loop(block, [&](uint32_t section, const StripNodes&) {
        pass(kernels.relax, section, wide, step);
        store_section(section, wide, step);
    });
    const auto begin = begin_loop(block, step, false), begin_again = begin_loop(block, step, true);
    const auto move_bodies = move_loop(block, step);
    prepare_block(block, wide, step);
    for (int substep = 0; substep < settings.substeps; ++substep) {
        (substep > 0 ? begin_again : begin).run();
        if (substep == 0) warm_start.run();
        solve_biased.run();
        move_bodies.run();
        if (substep + 1 < settings.substeps)
            relax.run();
        else
            relax_and_store.run();
    }
}

/// Whether sub-steps after the first repeat what the contacts gave the bodies, rather than warm
/// start them one by one. What many joints do besides takes longer to tell apart than that saves.
bool WorldData::repeats_pushes(const SolverBlock& block) {
    if (!rolling_contacts.empty()) return false;  // what they gave had another direction
    if (2 * acting_joints() > (block.contacts + constraints.size()) / 4) return false;
    find_jointed();
    return true;
}

/// Passes over the first block, with all that the others do not have.
struct alignas(line_size) WorldData::FirstBlock {
    WorldData& world;
    const BlockStep& step;
    const JointStep& joint_step;
    WideBlock& wide;
    ContactSolver serial;  // all constraints
    bool repeats = false;

    ContactSolver serial_of(const StripNodes& nodes) const {
        ContactSolver some = serial;
        const size_t begin = world.serial_nodes.begin(nodes), end = world.serial_nodes.end(nodes);
        some.constraints = some.constraints.subspan(begin, end - begin);
        return some;
    }
    template <typename Pass>
    void around_joints(const StripNodes& nodes, Pass&& pass) const {
        if (repeats)
            world.joint_share.around(nodes, world.solver_bodies, world.solver_forces, pass);
        else
            pass();
    }
    void repeat_joints(const StripNodes& nodes) const {
        around_joints(nodes, [&] { world.warm_start_joints(nodes); });
    }
    void warm_start(uint32_t section, const StripNodes& nodes) const {
        repeat_joints(nodes);
        serial_of(nodes).warm_start();
        world.pass(step.kernels.warm_start, section, wide, step);
    }
    void solve_biased(uint32_t section, const StripNodes& nodes) const {
        around_joints(nodes, [&] { world.solve_joints(joint_step, nodes); });
        serial_of(nodes).solve_biased();
        world.pass(step.kernels.solve_biased, section, wide, step);
    }
    void relax(uint32_t section, const StripNodes& nodes) const {
        around_joints(nodes, [&] { world.relax_joints(joint_step, nodes); });
        serial_of(nodes).relax();
        world.pass(step.kernels.relax, section, wide, step);
    }
    void relax_and_store(uint32_t section, const StripNodes& nodes) const {
        relax(section, nodes);
        world.store_section(section, wide, step);
    }
    void bounce(const SolverBlock& block) const {
        world.bounced.assign(world.solver_bodies.size(), 0);
        std::atomic<bool> any = true;
        for (uint8_t pass = 1; any && pass <= ContactSolver::most_passes; ++pass) {
            any = false;
            world
                .section_loop(block,
                              [&](uint32_t, const StripNodes& nodes) {
                                  const float dt = step.h * float(world.settings.substeps);
                                  if (serial_of(nodes).bounce(dt, pass, world.bounced)) any = true;
                              })
                .run();
        }
    }
    void restitute(const SolverBlock& block) const {
        world
            .section_loop(
                block, [this](uint32_t, const StripNodes& nodes) { serial_of(nodes).restitute(); })
            .run();
    }
};

void WorldData::solve_first_block(const BlockStep& step, const JointStep& joint_step) {
    const SolverBlock& block = blocks[0];
    FirstBlock first = {*this, step, joint_step, wide_blocks[0], {}};
    first.serial.bodies = solver_bodies;
    first.serial.constraints = constraints;
    first.serial.extras = extras;
    first.serial.rolling = rolling_contacts;
    first.serial.inverse_h = 1.0f / step.h;
    first.serial.push_speed = settings.push_speed;
    first.serial.restitution_threshold = settings.restitution_threshold;
    first.repeats = repeats_pushes(block);
    const bool jointed = acting_joints() > 0;

    const auto loop = [&](auto member) {
        return section_loop(block, [&first, member](uint32_t section, const StripNodes& nodes) {
            (first.*member)(section, nodes);
        });
    };
    const auto warm_start = loop(&FirstBlock::warm_start);
    const auto repeat_joints = section_loop(
        block, [&first](uint32_t, const StripNodes& nodes) { first.repeat_joints(nodes); });
    const auto solve_biased = loop(&FirstBlock::solve_biased), relax = loop(&FirstBlock::relax);
    const auto relax_and_store = loop(&FirstBlock::relax_and_store);
    const auto begin = begin_loop(block, step, false), begin_again = begin_loop(block, step, true);
    const auto move_bodies = move_loop(block, step);

    prepare_block(block, first.wide, step);
    if (!extras.empty()) first.bounce(block);
    zero_locked();
    for (int substep = 0; substep < settings.substeps; ++substep) {
        const bool again = first.repeats && substep > 0;
        (again ? begin_again : begin).run();
        zero_locked();
        if (!again)
            warm_start.run();
        else if (jointed)
            repeat_joints.run();
        solve_biased.run();
        zero_locked();
        move_bodies.run();
        (substep + 1 < settings.substeps ? relax : relax_and_store).run();
        zero_locked();
        strain_joints();
    }
    if (!extras.empty()) {
        first.restitute(block);
        zero_locked();
    }
}

void WorldData::solve_softly(const JointStep& joint_step, const ContactStiffness& stiffness) {
    const float h = joint_step.h;
    const BlockStep step = {wide_kernels(most_lanes),
                            {solver_bodies.data(), &stiffness, joint_step.impulse_ratio},
                            h,
                            {greatest_speed, greatest_turn / h}};
    const auto whole = uint32_t(blocks.size() - 1);
    const int at_a_time = threads != nullptr && whole > 1 ? threads->threads() : 1;
    if (wide_blocks.size() < size_t(at_a_time)) wide_blocks.resize(size_t(at_a_time));
    solve_first_block(step, joint_step);
    // The few that are large are solved one by one, by all threads together.
    for (uint32_t i = 1; i <= whole; ++i) {
        if (blocks[i].cut) solve_block(blocks[i], wide_blocks[0], step);
    }
    IdleBlocks idle(wide_blocks);
    share_out(threads, whole, [&](uint32_t i) {
        if (blocks[i + 1].cut) return;
        WideBlock& wide = idle.take();
        solve_block(blocks[i + 1], wide, step);
        idle.give_back(wide);
    });
}

}  // namespace fettle::physics::detail
