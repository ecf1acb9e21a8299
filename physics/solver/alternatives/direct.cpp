#include <geometry/motion.h>
#include <partition/union_find.h>
#include <solver/alternatives/direct_problem.h>
#include <solver/joints/direct_row.h>
#include <solver/joints/geometric_stiffness.h>
#include <solver/joints/joint_passes.h>
#include <solver/motion.h>
#include <solver/solvers.h>

#include <cmath>
#include <deque>
#include <limits>

// The direct solver: in each sub-step all joints and contacts of an island are solved at once,
// twice.
//
// 1. Velocities change by the forces. 2. Biased: impulses that remove a fifth of every error within
// the sub-step. 3. Bodies move. 4. Relaxed: the same rows at the new poses, without the correction,
// so that the correction does not stay in the velocities. (As in the soft step, the bias bends a
// path to a circle, and pendulums keep their energy.)
//
// At the end of the step fast hits bounce: like 4, with v_n = -e·(approach).

namespace fettle::physics::detail {
namespace {

class DirectSolver {
  public:
    DirectSolver(const SolverInput& input, float h, StepStatistics& statistics)
        : input_(input),
          constraints_(input.contacts.serial.constraints),
          extras_(input.contacts.serial.extras),
          bodies_(input.bodies.solver_bodies),
          h_(h),
          statistics_(statistics),
          scales_(mass_scales(input)) {
        write(DirectPass::biased);
        find_problems();
        for (const DirectProblem& problem : problems_)
            greatest_impulses_.push_back(greatest_impulse(problem));
    }

    void pass(DirectPass pass) {
        write(pass);
        raise_inertia_for_impulses();
        // The impulse of a bounce replaces that of the last sub-step, which was counted already.
        if (pass == DirectPass::bounced) {
            for_each_extra([](const ContactConstraint& c, ContactExtra& extra) {
                for (int k = 0; k < c.count; ++k) extra.total[k] -= c.points[k].normal_impulse;
            });
        }
        for (size_t i = 0; i < problems_.size(); ++i) {
            DirectProblem& problem = problems_[i];
            limit_contacts(problem, greatest_impulses_[i]);
            const bool solved = problem.solve(rows_, scales_, bodies_, pass != DirectPass::biased,
                                              input_.settings.push_speed);
            ++(solved ? statistics_.direct_solves : statistics_.direct_failures);
        }
        if (pass == DirectPass::biased) return;
        for_each_extra([](const ContactConstraint& c, ContactExtra& extra) { extra.record(c); });
    }

    bool anything_bounces() const {
        for (const ContactExtra& extra : extras_)
            if (extra.restitution > 0.0f) return true;
        return false;
    }
    /// Several impacts in a step, each with the speed of its approach, may give back more energy
    /// than they took. Appends the bodies of all that bounce.
    void list_bouncing(std::vector<uint32_t>& slots) const {
        for (const ContactConstraint& c : constraints_) {
            if (c.extra == 0 || !(extras_[c.extra - 1].restitution > 0.0f)) continue;
            for (const uint32_t body : {c.a, c.b})
                if (body != 0) slots.push_back(input_.active.awake_bodies[body - 1]);
        }
    }

  private:
    /// Every pass writes the same rows in the same order, with different numbers.
    void write(DirectPass pass) {
        RowWriter writer(rows_, scales_, h_, pass);
        follow_curved_contacts(input_);
        for (size_t i = 0; i < input_.joints.joint_arrays.size(); ++i) {
            JointArray& array = input_.joints.joint_arrays[i];
            joint_kind(JointScratch::type_of(i))
                .write_rows(array, bodies_, writer, {0, array.joints.size()});
        }
        joint_rows_ = writer.size();
        for (ContactConstraint& c : constraints_) {
            write_rows(writer, c, c.extra != 0 ? &extras_[c.extra - 1] : nullptr, bodies_[c.a],
                       bodies_[c.b], input_.settings.push_speed,
                       input_.settings.restitution_threshold);
        }
    }

    /// All joints pull at once here, and a load may hang on them from the first sub-step on, so the
    /// forces with which the step began are not enough. Within a step the inertia only grows: if it
    /// followed each change of a force, it would give energy to the bodies.
    void raise_inertia_for_impulses() {
        stiffness_.reset(bodies_.size());
        const auto add = [&](const JointKind& kind, JointArray& array, size_t k) {
            stiffness_.add(kind.ends(array, k), (1.0f / h_) * kind.load(array, k).push);
        };
        for_each_acting_joint(input_.joints, add);
        for (uint32_t i = 1; i < scales_.size(); ++i) {
            const auto inverse = float(scales_[i].turn * scales_[i].turn);
            const float raised = stiffness_.inverse_inertia(i, inverse, h_);
            if (raised < inverse) scales_[i].turn = std::sqrt(double(raised));
        }
    }

    void for_each_extra(auto&& visit) {
        for (const ContactConstraint& c : constraints_)
            if (c.extra != 0) visit(c, extras_[c.extra - 1]);
    }

    bool moves(uint32_t body) const { return scales_[body].moves(); }

    /// Finds islands.
    void find_problems() {
        const auto count = uint32_t(scales_.size());
        UnionFind islands;
        islands.reset(count);
        for (const DirectRow& row : rows_)
            if (moves(row.jacobian.a) && moves(row.jacobian.b))
                islands.unite(row.jacobian.a, row.jacobian.b);
        std::vector<std::vector<uint32_t>> bodies(count), rows(count);
        std::vector<int32_t> place(count, -1);
        for (uint32_t i = 1; i < count; ++i) {
            if (!moves(i)) continue;
            auto& island = bodies[islands.find(i)];
            place[i] = int32_t(island.size());
            island.push_back(i);
        }
        for (uint32_t i = 0; i < rows_.size(); ++i) {
            const Jacobian& j = rows_[i].jacobian;
            if (moves(j.a))
                rows[islands.find(j.a)].push_back(i);
            else if (moves(j.b))
                rows[islands.find(j.b)].push_back(i);
        }
        for (uint32_t i = 1; i < count; ++i) {
            if (rows[i].empty()) continue;
            problems_.emplace_back(std::move(bodies[i]), std::move(rows[i]), rows_, place);
        }
    }

    /// The greatest impulse of a contact in a sub-step, N s. Between a kinematic body that moves
    /// and something else that does not yield there may be no solution, and rigid contacts shot
    /// balls out of a row with 2400 m/s. There a contact passes on no more momentum than the whole
    /// island may have, and the kinematic body goes through. Joints may need more for their forces.
    double greatest_impulse(const DirectProblem& problem) const {
        constexpr double no_limit = std::numeric_limits<double>::infinity();
        uint32_t driver = 0;
        bool held = false;
        float fastest = input_.settings.push_speed;
        for (const uint32_t i : problem.rows()) {
            if (i < joint_rows_) return no_limit;
            for (const uint32_t end : {rows_[i].jacobian.a, rows_[i].jacobian.b}) {
                if (moves(end)) continue;
                const bool drives = end != 0 && !stands_still(bodies_[end]);
                held = held || !drives || (driver != 0 && end != driver);
                if (!drives) continue;
                driver = end;
                fastest = max(fastest, input_.settings.push_speed + speed_of(end));
            }
        }
        if (driver == 0 || !held) return no_limit;
        double mass = 0.0;
        for (const uint32_t body : problem.bodies()) {
            mass += double(inverse_or_zero(bodies_[body].inverse_mass));
            fastest = max(fastest, speed_of(body));
        }
        return mass * double(fastest);
    }
    /// The speed of the fastest point of a body, m/s.
    float speed_of(uint32_t body) const {
        const BodyRecord& record = input_.objects.bodies[input_.active.awake_bodies[body - 1]];
        return length(bodies_[body].velocity) +
               std::abs(bodies_[body].angular_velocity) * record.extent;
    }
    void limit_contacts(const DirectProblem& problem, double greatest) {
        if (!std::isfinite(greatest)) return;
        for (const uint32_t i : problem.rows())
            if (rows_[i].low == 0.0) rows_[i].high = greatest;
    }

    const SolverInput& input_;
    std::span<ContactConstraint> constraints_;
    std::span<ContactExtra> extras_;
    std::span<SolverBody> bodies_;
    float h_;
    StepStatistics& statistics_;
    std::vector<MassScale> scales_;  ///< by solver body
    GeometricStiffness stiffness_;
    std::vector<DirectRow> rows_;
    size_t joint_rows_ = 0;  ///< they come before those of contacts
    std::deque<DirectProblem> problems_;
    std::vector<double> greatest_impulses_;  ///< of the contacts of each problem
};

}  // namespace

void solve_directly(const SolverInput& input, const JointStep& joint_step,
                    StepStatistics& statistics) {
    const float h = joint_step.h;
    const SolverBlocks& blocks = input.schedule.blocks;
    DirectSolver solver(input, h, statistics);
    for (int substep = 0; substep < input.settings.substeps; ++substep) {
        apply_forces(input, h);
        solver.pass(DirectPass::biased);
        zero_locked(input);
        integrate_positions(blocks.bodies_of(blocks[0]), input.bodies.solver_bodies, h);
        solver.pass(DirectPass::relaxed);
        zero_locked(input);
        add_strains(input.joints);
    }
    if (!solver.anything_bounces()) return;
    solver.pass(DirectPass::bounced);
    zero_locked(input);
    solver.list_bouncing(input.bodies.strained);
}

}  // namespace fettle::physics::detail
