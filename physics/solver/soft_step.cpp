#include <solver/contact_solver.h>
#include <world/world_data.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <tuple>

// The soft step (E. Catto, "Solver2D", 2024) over all blocks: per sub-step velocities, warm start,
// biased solve, positions, relax; at the end restitution; joints before contacts, what is solved
// one at a time before what is solved sixteen at a time.

namespace fettle::physics::detail {
namespace {

// What a thread takes at a time.
constexpr uint32_t groups_at_a_time = 8, bodies_at_a_time = 512;

/// Holds more than one island that is itself enough for a block.
bool is_large(const SolverBlock& block) {
    return block.groups() > 2 * SolverBlocks::enough_contacts / lanes;
}
/// Whether sharing out a pass takes less than the pass.
bool worth_sharing(const SolverBlock& block) {
    return block.groups() >= 4 * groups_at_a_time;
}

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
struct WorldData::BlockStep {
    const WideKernels& kernels;
    PrepareStep prepare;
    float h;
    SubstepLimits limits;
};

/// Color by color, where several threads do it.
void WorldData::pass(void (*kernel)(const WideStep&), const SolverBlock& block, WideBlock& wide,
                     const BlockStep& step, ThreadPool* helpers) {
    const WideStep all = {solver_bodies.data(), wide.contacts.data(), block.groups(), 1.0f / step.h,
                          settings.push_speed};
    if (helpers == nullptr) {
        kernel(all);
        return;
    }
    const auto* first = &first_groups[size_t(&block - &blocks[0]) * color_count];
    for (size_t color = 0; color < color_count; ++color) {
        const uint32_t from = first[color], count = first[color + 1] - from;
        // Parts of a size, and an even number of them: nobody waits for who has one more.
        const uint32_t pairs_of_parts = (count + 2 * groups_at_a_time - 1) / (2 * groups_at_a_time);
        const uint32_t parts = count > groups_at_a_time ? 2 * pairs_of_parts : 1;
        share_out(count > 0 ? helpers : nullptr, parts, [&](uint32_t part) {
            const uint32_t begin = count * part / parts, end = count * (part + 1) / parts;
            WideStep some = all;
            some.contacts = wide.contacts_of(from + begin);
            some.count = end - begin;
            kernel(some);
        });
    }
}

/// `work(begin, end)` over the groups of a block in parts. A part has its share of every color, the
/// same one as in the passes: so what a thread prepares is in its cache when it solves.
template <typename Work>
void WorldData::for_groups(const SolverBlock& block, ThreadPool* helpers, Work&& work) {
    const uint32_t groups = block.groups();
    if (helpers == nullptr) {
        work(block.first_group, block.group_end);
        return;
    }
    const auto* first = &first_groups[size_t(&block - &blocks[0]) * color_count];
    const auto parts = uint32_t(groups / (2 * groups_at_a_time));
    share_out(helpers, parts, [&](uint32_t part) {
        for (size_t color = 0; color < color_count; ++color) {
            const size_t from = first[color], count = first[color + 1] - from;
            const size_t begin = count * part / parts, end = count * (part + 1) / parts;
            if (begin < end) work(from + begin, from + end);
        }
    });
}

void WorldData::prepare_block(const SolverBlock& block, WideBlock& wide, const BlockStep& step,
                              ThreadPool* helpers) {
    wide.make_groups(block.first_group, block.group_end);
    for_groups(block, helpers, [&](size_t begin, size_t end) {
        for (size_t i = begin; i < end; i += groups_at_a_time) {
            const size_t next = std::min(i + groups_at_a_time, end);
            WideContact* const groups = wide.contacts_of(i);
            ContactLanes* const from = wide.lanes_of(i);
            for (size_t k = 0; k < next - i; ++k) fill_group(i + k, groups[k], from[k]);
            step.kernels.prepare(step.prepare, {from, next - i}, groups);
        }
    });
}

void WorldData::store_block(const SolverBlock& block, WideBlock& wide, const BlockStep& step,
                            ThreadPool* helpers) {
    for_groups(block, helpers, [&](size_t begin, size_t end) {
        const std::span to(wide.lanes_of(begin), end - begin);
        step.kernels.store(wide.contacts_of(begin), to, touch_distance);
        for (size_t k = 0; k < to.size(); ++k) note_news(begin + k, to[k]);
    });
}

void WorldData::begin_substep(const SolverBlock& block, const BlockStep& step, bool again,
                              ThreadPool* helpers) {
    const std::span which = blocks.bodies_of(block);
    share_out_range(helpers, which.size(), bodies_at_a_time, [&](size_t begin, size_t end) {
        integrate_velocities(which.subspan(begin, end - begin), solver_bodies, solver_forces,
                             step.limits, again);
    });
}

void WorldData::move_bodies(const SolverBlock& block, const BlockStep& step, ThreadPool* helpers) {
    const std::span which = blocks.bodies_of(block);
    share_out_range(helpers, which.size(), bodies_at_a_time, [&](size_t begin, size_t end) {
        integrate_positions(which.subspan(begin, end - begin), solver_bodies, step.h);
    });
}

/// A block of nothing but wide contacts, through all sub-steps.
void WorldData::solve_block(const SolverBlock& block, WideBlock& wide, const BlockStep& step,
                            ThreadPool* helpers) {
    const WideKernels& kernels = step.kernels;
    prepare_block(block, wide, step, helpers);
    for (int substep = 0; substep < settings.substeps; ++substep) {
        begin_substep(block, step, substep > 0, helpers);
        if (substep == 0) pass(kernels.warm_start, block, wide, step, helpers);
        pass(kernels.solve_biased, block, wide, step, helpers);
        move_bodies(block, step, helpers);
        pass(kernels.relax, block, wide, step, helpers);
    }
    store_block(block, wide, step, helpers);
}

/// Whether sub-steps after the first repeat what the contacts gave the bodies, rather than warm
/// start them one by one. What many joints do besides takes longer to tell apart than that saves.
bool WorldData::repeats_pushes(const SolverBlock& block) {
    joint_share.clear();
    if (!rolling_contacts.empty()) return false;  // what they gave had another direction
    size_t ends = 0;
    std::apply([&](const auto&... list) { ((ends += 2 * list.size()), ...); }, joint_constraints);
    if (ends > (size_t{block.groups()} * lanes + constraints.size()) / 4) return false;
    const auto add = [&](const auto& list) {
        for (const auto& c : list) joint_share.add(c.ends.a), joint_share.add(c.ends.b);
    };
    std::apply([&](const auto&... list) { (add(list), ...); }, joint_constraints);
    joint_share.unite();
    return true;
}

/// The first block, with all that the others do not have.
void WorldData::solve_first_block(const BlockStep& step, const JointStep& joint_step) {
    const WideKernels& kernels = step.kernels;
    const SolverBlock& block = blocks[0];
    WideBlock& wide = wide_blocks[0];
    ThreadPool* const helpers = worth_sharing(block) ? threads : nullptr;
    ContactSolver serial;
    serial.bodies = solver_bodies;
    serial.constraints = constraints;
    serial.extras = extras;
    serial.rolling = rolling_contacts;
    serial.inverse_h = 1.0f / step.h;
    serial.push_speed = settings.push_speed;
    serial.restitution_threshold = settings.restitution_threshold;

    const bool repeats = repeats_pushes(block);
    const auto around_joints = [&](auto&& pass) {
        if (repeats)
            joint_share.around(solver_bodies, solver_forces, pass);
        else
            pass();
    };
    prepare_block(block, wide, step, helpers);
    serial.bounce(step.h * float(settings.substeps));
    zero_locked();
    for (int substep = 0; substep < settings.substeps; ++substep) {
        const bool again = repeats && substep > 0;
        begin_substep(block, step, again, helpers);
        zero_locked();
        solver_bodies[0] = {};  // joints write it back unmoved; whatever happens, it stays so
        around_joints([&] { warm_start_joints(); });
        if (!again) {
            serial.warm_start();
            pass(kernels.warm_start, block, wide, step, helpers);
        }
        around_joints([&] { solve_joints(joint_step); });
        serial.solve_biased();
        pass(kernels.solve_biased, block, wide, step, helpers);
        zero_locked();
        move_bodies(block, step, helpers);
        around_joints([&] { relax_joints(joint_step); });
        serial.relax();
        pass(kernels.relax, block, wide, step, helpers);
        zero_locked();
        strain_joints();
    }
    serial.restitute();
    zero_locked();
    store_block(block, wide, step, helpers);
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
    for (uint32_t block = 1; block <= whole; ++block) {
        if (is_large(blocks[block])) solve_block(blocks[block], wide_blocks[0], step, threads);
    }
    IdleBlocks idle(wide_blocks);
    share_out(threads, whole, [&](uint32_t block) {
        if (is_large(blocks[block + 1])) return;
        WideBlock& wide = idle.take();
        solve_block(blocks[block + 1], wide, step, nullptr);
        idle.give_back(wide);
    });
}

}  // namespace fettle::physics::detail
