#include <solver/alternatives/direct_problem.h>

#include <algorithm>
#include <cmath>

// Computes all impulses of an island at once. Let v be the velocities of its bodies, v₀ those
// before the impulses, M their masses and J the Jacobian of its rows. Each row i requires
//
//     M·(v - v₀) = Jᵀ·λ,   λᵢ = clamp(-(dᵢ·(J·v)ᵢ + fᵢ), lowᵢ, highᵢ).                          (1)
//
// For a stiff row (d → ∞) that is the complementarity condition: at a bound, or J·v = -f/d. Rows of
// springs have the stiffness of the spring. Contacts have low = 0, friction has bounds of ±μ times
// the impulse of its contact (boxed friction), joints have no bounds.
//
// For fixed bounds, (1) is the minimum of a strictly convex, piecewise quadratic function:
// ½|u|² + Σψᵢ with u = √M·(v - v₀) and ψᵢ' = -λᵢ. Newton's method on active sets finds it, with a
// line search along each step: the rows at a bound are guessed, then the others follow from
//
//     (I + Σ dᵢ·ĵᵢᵀ·ĵᵢ)·u = Σ_bound ĵᵢᵀ·λᵢ - Σ_free ĵᵢᵀ·(dᵢ·(J·v₀)ᵢ + fᵢ),   ĵ = J·M^(-½),
//
// whose matrix is as sparse as the graph of contacts and joints, symmetric, and positive definite
// even if rows are redundant: a sparse Cholesky factorization with three unknowns per body. The
// search begins with the sets of the previous pass, which are correct in most cases. (M. Anitescu
// and F. Potra, "Formulating dynamic multi-rigid-body contact problems with friction as solvable
// linear complementarity problems", 1997, for the problem; L. Qi and J. Sun, "A nonsmooth version
// of Newton's method", 1993, for the method. Changing all rows in a wrong state at once, without a
// line search, cycles if contacts are redundant, as in a pyramid of ten rows.)
//
// If very stiff rows begin and cease to act within a tiny range of velocity, a Newton step goes too
// far and the line search stops it at once. Then a few sweeps of Gauss-Seidel find the rows that
// push, and the problem is solved in rounds, with a millionth of the rigidity at first. Rows keep
// the impulse λ' of the last round: λᵢ = clamp(λ' - dᵢ·…), the method of multipliers (M. Hestenes
// and M. Powell, 1969). The rigidity increases while a round takes few Newton steps, until rigid
// rows leave less than 10⁻⁵ m/s. Heavy chains are solved with full rigidity in one or two steps;
// piles, in which hundreds of rows are near a bound, never are.
//
// Friction bounds follow the normal impulses from round to round; after some rounds, the mean of
// old and new bounds is used. Bounds that have not settled after ten rounds are used as they are.

namespace fettle::physics::detail {
namespace {

/// Islands with more bodies are solved by sweeps.
constexpr size_t most_bodies_of_problem = 500;
constexpr int most_first_steps = 6, most_steps = 15, most_factorizations = 120;
constexpr int most_rounds_of_problem = 25, most_friction_rounds = 9;
/// Share of the rigidity of rows with which the search begins if no solution is found at once.
constexpr double softest = 3e-6;
/// Velocities that rigid rows may leave, m/s: `tolerance` for a good result, `acceptable` for a
/// result that is accepted when the limit of work is reached. Changes of friction bounds that
/// change velocities by less are ignored.
constexpr double tolerance = 1e-5, acceptable = 1e-3;
/// If the rows leave a higher velocity than this, m/s, the search begins from the impulses of the
/// previous pass instead.
constexpr double worst_begin = 1e-2;
/// Bodies that are faster than plausible by this factor get no correction at all.
constexpr double much_excess = 1.5;
/// Number of sweeps, which depends on the number of rows, and the change of velocities that ends
/// them, m/s.
constexpr int first_sweeps = 20, least_sweeps = 40, most_sweeps = 200;
constexpr size_t most_visits = 100'000;
constexpr double settled_change = 1e-7;
/// Relative tolerance of friction bounds; the minimum reference is a tenth of the largest bound.
constexpr double bound_tolerance = 3e-3;
/// Limit of multiplications of all problems in a step of the world, distributed by rows: a few
/// tenths of a second. `least_work`: minimum for a small problem; `work_of_row`: additional work of
/// a factorization per row.
constexpr double most_work = 2e8, least_work = 1e6, work_of_row = 200.0;

}  // namespace

DirectProblem::DirectProblem(std::vector<uint32_t> bodies, std::vector<uint32_t> rows,
                             std::span<const DirectRow> all, std::span<const int32_t> place)
    : bodies_(std::move(bodies)), rows_(std::move(rows)) {
    lines_.resize(rows_.size());
    for (size_t i = 0; i < rows_.size(); ++i) {
        lines_[i].a = place[all[rows_[i]].jacobian.a];
        lines_[i].b = place[all[rows_[i]].jacobian.b];
    }
    const auto unknowns = Eigen::Index(3 * bodies_.size());
    u_ = before_ = forced_ = right_ = trial_ = Eigen::VectorXd::Zero(unknowns);
    work_left_ = std::max(least_work, most_work * double(rows_.size()) / double(all.size()));
}

/// Finds the nonzero entries of the matrix: a block of 3 × 3 for each body, and for each two bodies
/// with a common row.
void DirectProblem::analyze() {
    std::vector<Eigen::Triplet<double>> entries;
    for (int32_t body = 0; body < int32_t(bodies_.size()); ++body) {
        for (int column = 0; column < 3; ++column)
            for (int r = column; r < 3; ++r)
                entries.emplace_back(3 * body + r, 3 * body + column, 0.0);
    }
    for (const Line& line : lines_) {
        if (line.a < 0 || line.b < 0) continue;
        const int32_t low = std::min(line.a, line.b), high = std::max(line.a, line.b);
        for (int column = 0; column < 3; ++column)
            for (int r = 0; r < 3; ++r) entries.emplace_back(3 * high + r, 3 * low + column, 0.0);
    }
    matrix_.resize(Eigen::Index(3 * bodies_.size()), Eigen::Index(3 * bodies_.size()));
    matrix_.setFromTriplets(entries.begin(), entries.end());
    matrix_.makeCompressed();
    for (Line& line : lines_) {
        if (line.a < 0 || line.b < 0) continue;
        const int32_t low = std::min(line.a, line.b), high = std::max(line.a, line.b);
        const int* first = matrix_.innerIndexPtr() + matrix_.outerIndexPtr()[3 * low];
        const int* last = matrix_.innerIndexPtr() + matrix_.outerIndexPtr()[3 * low + 1];
        line.block = uint32_t(std::lower_bound(first, last, 3 * high) - first);
    }
    factor_.analyzePattern(matrix_);
    analyzed_ = true;
}

double DirectProblem::along(const Line& line, const Eigen::VectorXd& u) const {
    double sum = 0.0;
    if (line.a >= 0)
        for (int k = 0; k < 3; ++k) sum += line.on_a[k] * u[3 * line.a + k];
    if (line.b >= 0)
        for (int k = 0; k < 3; ++k) sum += line.on_b[k] * u[3 * line.b + k];
    return sum;
}

void DirectProblem::add(const Line& line, double impulse, Eigen::VectorXd& to) const {
    if (line.a >= 0)
        for (int k = 0; k < 3; ++k) to[3 * line.a + k] += line.on_a[k] * impulse;
    if (line.b >= 0)
        for (int k = 0; k < 3; ++k) to[3 * line.b + k] += line.on_b[k] * impulse;
}

/// The change of a row's velocity by a unit impulse along it, J·M⁻¹·Jᵀ.
double DirectProblem::inverse_mass(const Line& line) {
    const auto squared = [](const double(&on)[3]) {
        return on[0] * on[0] + on[1] * on[1] + on[2] * on[2];
    };
    return (line.a >= 0 ? squared(line.on_a) : 0.0) + (line.b >= 0 ? squared(line.on_b) : 0.0);
}

double DirectProblem::wanted(size_t i, double velocity) {
    const DirectRow& r = row(i);
    if (!r.rigid) return -(r.stiffness * velocity + r.push);
    return lines_[i].memory - share_ * (r.stiffness * velocity + r.push);
}

double DirectProblem::allowed(size_t i, double velocity) {
    return std::min(std::max(wanted(i, velocity), row(i).low), row(i).high);
}

void DirectProblem::add_block(const Line& line, double stiffness) {
    double* values = matrix_.valuePtr();
    const int* outer = matrix_.outerIndexPtr();
    const auto square = [&](int32_t body, const double(&on)[3]) {
        for (int column = 0; column < 3; ++column)
            for (int r = column; r < 3; ++r)
                values[outer[3 * body + column] + r - column] += stiffness * on[r] * on[column];
    };
    if (line.a >= 0) square(line.a, line.on_a);
    if (line.b >= 0) square(line.b, line.on_b);
    if (line.a < 0 || line.b < 0) return;
    const bool in_order = line.a < line.b;
    const int32_t low = in_order ? line.a : line.b;
    const double(&columns)[3] = in_order ? line.on_a : line.on_b;
    const double(&on_rows)[3] = in_order ? line.on_b : line.on_a;
    for (int column = 0; column < 3; ++column)
        for (int r = 0; r < 3; ++r)
            values[outer[3 * low + column] + int(line.block) - column + r] +=
                stiffness * on_rows[r] * columns[column];
}

void DirectProblem::assemble() {
    std::fill_n(matrix_.valuePtr(), matrix_.nonZeros(), 0.0);
    for (Eigen::Index i = 0; i < matrix_.cols(); ++i)
        matrix_.valuePtr()[matrix_.outerIndexPtr()[i]] = 1.0;
    right_.setZero();
    for (size_t i = 0; i < lines_.size(); ++i) {
        const Line& line = lines_[i];
        if (line.state == State::free) {
            const double stiffness = row(i).rigid ? share_ * row(i).stiffness : row(i).stiffness;
            if (stiffness > 0.0) add_block(line, stiffness);
            add(line, wanted(i, line.base), right_);
        } else {
            add(line, line.state == State::low ? row(i).low : row(i).high, right_);
        }
    }
}

/// A row at its bound keeps its state if its pull is within the rounding error: a pull that changes
/// a velocity of 1 m/s by 10⁻⁷.
DirectProblem::State DirectProblem::next_state(size_t i, double velocity) {
    const double impulse = wanted(i, velocity);
    const double slack = 1e-14 * (row(i).rigid ? share_ : 1.0) * row(i).stiffness *
                         std::max(1.0, std::fabs(lines_[i].base));
    const double low = row(i).low, high = row(i).high;
    switch (lines_[i].state) {
        case State::low:
            if (impulse <= low + slack) return State::low;
            break;
        case State::high:
            if (impulse >= high - slack) return State::high;
            break;
        case State::free:
            if (impulse >= low - slack && impulse <= high + slack) return State::free;
            break;
    }
    if (impulse <= low) return State::low;
    return impulse >= high ? State::high : State::free;
}

/// The length of the step from u along `direction`: to the minimum of the function, at most 1.
double DirectProblem::step_length(const Eigen::VectorXd& direction) {
    for (Line& line : lines_) {
        line.velocity = line.base + along(line, u_);
        line.ahead = along(line, direction);
    }
    const double begin = u_.dot(direction), curvature = direction.squaredNorm();
    const auto rises = [&](double t) {
        double slope = begin + t * curvature;
        for (size_t i = 0; i < lines_.size(); ++i) {
            const Line& line = lines_[i];
            slope -= allowed(i, line.velocity + t * line.ahead) * line.ahead;
        }
        return slope > 0.0;
    };
    if (!rises(1.0)) return 1.0;
    double low = 0.0, high = 1.0;
    for (int halving = 0; halving < 40; ++halving) {
        const double middle = 0.5 * (low + high);
        (rises(middle) ? high : low) = middle;
    }
    return high;
}

/// Multiplications of a factorization: the number of pairs of entries in each column.
double DirectProblem::work_of_factorization() const {
    const auto& lower = factor_.matrixL().nestedExpression();
    double work = work_of_row * double(lines_.size());
    for (Eigen::Index i = 0; i < lower.cols(); ++i) {
        const auto entries = double(lower.outerIndexPtr()[i + 1] - lower.outerIndexPtr()[i]);
        work += entries * entries;
    }
    return work;
}

/// Number of factorizations that this problem may still make in a pass.
int DirectProblem::factorizations_left() const {
    if (work_ == 0.0) return most_factorizations;
    return int(std::clamp(work_left_ / work_, 0.0, double(most_factorizations)));
}

/// Solves with the current bounds.
bool DirectProblem::solve_boxed(int most) {
    for (int step = 0; step < most && budget_ > 0; ++step, --budget_) {
        assemble();
        factor_.factorize(matrix_);
        if (factor_.info() != Eigen::Success) return false;
        if (work_ == 0.0) {
            work_ = work_of_factorization();
            budget_ = std::max(factorizations_left(), 1);
        }
        work_left_ -= work_;
        trial_ = factor_.solve(right_);
        if (!trial_.allFinite()) return false;
        bool right = true;
        for (size_t i = 0; i < lines_.size(); ++i)
            right &= next_state(i, lines_[i].base + along(lines_[i], trial_)) == lines_[i].state;
        if (right) {
            u_ = trial_;
            return true;
        }
        trial_ -= u_;
        // The first step has no earlier point to compare with, so it uses the full length.
        u_ += (step == 0 ? 1.0 : step_length(trial_)) * trial_;
        for (size_t i = 0; i < lines_.size(); ++i)
            lines_[i].state = next_state(i, lines_[i].base + along(lines_[i], u_));
    }
    return false;
}

/// Computes impulses from velocities, then the bounds that depend on impulses. True if the bounds
/// were correct.
bool DirectProblem::update_bounds(bool average) {
    for (size_t i = 0; i < lines_.size(); ++i)
        row(i).impulse = allowed(i, lines_[i].base + along(lines_[i], u_));
    double largest = 0.0;
    for (size_t i = 0; i < lines_.size(); ++i)
        if (row(i).bearers > 0) largest = std::max(largest, row(i).high);
    bool settled = true;
    const auto rebound = [&](size_t i, double bound) {
        DirectRow& r = row(i);
        const double old = r.high;
        const bool at_bound = std::fabs(r.impulse) >= old;
        const double off = at_bound ? std::fabs(bound - old) : std::fabs(r.impulse) - bound;
        if (off > bound_tolerance * std::max({bound, old, 0.1 * largest}) &&
            off * inverse_mass(lines_[i]) > tolerance) {
            settled = false;
            if (average) bound = 0.5 * (bound + old);
        }
        r.high = bound;
        r.low = -bound;
    };
    for (size_t i = 0; i < lines_.size(); ++i) {
        DirectRow& r = row(i);
        if (r.bearers > 0) {
            double load = 0.0;
            for (uint32_t k = 0; k < r.bearers; ++k) load += all_[r.bearer + k].impulse;
            rebound(i, r.friction * std::max(load, 0.0));
        }
        if (r.circle != 1 || r.greatest == DirectRow::no_limit || i + 1 >= lines_.size()) continue;
        const double x = wanted(i, lines_[i].base + along(lines_[i], u_));
        const double y = wanted(i + 1, lines_[i + 1].base + along(lines_[i + 1], u_));
        const double size = std::sqrt(x * x + y * y);
        const double share = size > r.greatest ? 1.0 / size : 0.0;
        rebound(i, share > 0.0 ? r.greatest * std::fabs(x) * share : r.greatest);
        rebound(i + 1, share > 0.0 ? r.greatest * std::fabs(y) * share : r.greatest);
    }
    return settled;
}

/// Chooses the first states from the current impulses.
void DirectProblem::guess_states() {
    for (size_t i = 0; i < lines_.size(); ++i) {
        Line& line = lines_[i];
        // A row without an impulse is free if its shapes approach. A row whose impulse is almost at
        // a bound is at the bound, because the impulse was stored in single precision.
        const double impulse = line.memory != 0.0 ? line.memory : wanted(i, line.base);
        const double nearly = 1e-6 * std::fabs(impulse);
        line.state = impulse - nearly <= row(i).low    ? State::low
                     : impulse + nearly >= row(i).high ? State::high
                                                       : State::free;
    }
}

/// The largest velocity that a rigid row should have stopped, m/s.
double DirectProblem::residual() {
    double worst = 0.0;
    for (size_t i = 0; i < lines_.size(); ++i) {
        const DirectRow& r = row(i);
        if (r.rigid && r.stiffness > 0.0)
            worst = std::max(worst, std::fabs(r.impulse - lines_[i].memory) / r.stiffness);
    }
    return worst / share_;
}

bool DirectProblem::solve_exactly() {
    least_left_ = worst_begin;
    if (bodies_.size() > most_bodies_of_problem || search_failed_) return false;
    if (!analyzed_) analyze();
    budget_ = factorizations_left();
    share_ = begin_;
    guess_states();
    for (int round = 0; round < most_rounds_of_problem && budget_ > 0; ++round) {
        const int before = budget_;
        if (!solve_boxed(share_ == 1.0 ? most_first_steps : most_steps)) {
            if (budget_ == 0) break;
            begin_from_sweeps();
            share_ = share_ == 1.0 ? softest : 0.1 * share_;
            begin_ = softest;  // also for the rest of the step
            guess_states();
            continue;
        }
        const bool settled = update_bounds(round > 3);
        const double left = residual();
        if (left < tolerance && (settled || round >= most_friction_rounds)) return true;
        if (left < least_left_) {
            least_left_ = left;
            for (size_t i = 0; i < lines_.size(); ++i) lines_[i].best = row(i).impulse;
        }
        for (size_t i = 0; i < lines_.size(); ++i) lines_[i].memory = row(i).impulse;
        const int steps = before - budget_;
        if (left >= tolerance)
            share_ = std::min(1.0, share_ * (steps < 3 ? 10.0 : steps < 8 ? 3.0 : 1.0));
    }
    return false;
}

/// Projected Gauss-Seidel: used if there are too many bodies or no solution. Each row in turn gets
/// the impulse that satisfies (1) for this row alone. It begins with the best impulses found so
/// far, because velocities and impulses of an unfinished search do not match.
void DirectProblem::sweep(int most) {
    u_.setZero();
    share_ = 1.0;
    for (size_t i = 0; i < lines_.size(); ++i) {
        DirectRow& r = row(i);
        r.impulse = std::isfinite(lines_[i].best) ? lines_[i].best : 0.0;
        lines_[i].memory = 0.0;
        add(lines_[i], r.impulse, u_);
    }
    for (int pass = 0; pass < most; ++pass) {
        double change = 0.0;
        for (size_t i = 0; i < lines_.size(); ++i) {
            const Line& line = lines_[i];
            DirectRow& r = row(i);
            bound_friction(i);
            const double velocity = line.base + along(line, u_);
            const double inverse = inverse_mass(line);
            double total =
                r.impulse + (wanted(i, velocity) - r.impulse) / (1.0 + r.stiffness * inverse);
            total = std::min(std::max(total, r.low), r.high);
            if (!std::isfinite(total)) total = 0.0;
            add(line, total - r.impulse, u_);
            change = std::max(change, std::fabs(total - r.impulse) * inverse);
            r.impulse = total;
        }
        if (change < settled_change) break;
    }
}

/// If the rows of the previous pass are of little use, a few sweeps find the rows that push.
void DirectProblem::begin_from_sweeps() {
    sweep(first_sweeps);
    for (size_t i = 0; i < lines_.size(); ++i) lines_[i].memory = row(i).impulse;
}

/// Sets impulses and `u_`. False if they come from sweeps.
bool DirectProblem::find_velocities() {
    if (solve_exactly()) return true;
    // The search is not repeated in this step; it would take a hundred times as long.
    search_failed_ = least_left_ > acceptable;
    sweep(std::clamp(int(most_visits / lines_.size()), least_sweeps, most_sweeps));
    return false;
}

bool DirectProblem::solve(std::span<DirectRow> all, std::span<const MassScale> scales,
                          std::span<SolverBody> solver_bodies, bool applied, float push_speed) {
    all_ = all;
    read(scales, solver_bodies, applied);
    bool solved = find_velocities();
    if (const double first = excess(scales, push_speed); first > 1.0) {
        restart(1.0 / first);
        solved = find_velocities();
        if (excess(scales, push_speed) > much_excess) {
            restart(0.0);
            solved = find_velocities();
        }
    }
    write(scales, solver_bodies);
    return solved || least_left_ <= acceptable;
}

}  // namespace fettle::physics::detail
