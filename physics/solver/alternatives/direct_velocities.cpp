#include <solver/alternatives/direct_problem.h>

#include <algorithm>
#include <cmath>

// Reads the rows, impulses and velocities of an island into its problem, and writes the results
// back. Two guards keep the energy of an island: errors of position and rotated impulses add no
// more than is plausible.

namespace fettle::physics::detail {
namespace {

/// The greatest part of the velocities of an island that the rotation of impulses may add.
constexpr double most_rotated = 0.05;
/// The plausible energy of a body, in energies of its island before the impulses.
constexpr double most_growth = 4.0;

}  // namespace

/// Reads rows and velocities. The search begins with the impulses of the previous pass.
void DirectProblem::read(std::span<const MassScale> scales,
                         std::span<const SolverBody> solver_bodies, bool applied) {
    before_.setZero();
    for (size_t i = 0; i < lines_.size(); ++i) {
        const Jacobian& j = row(i).jacobian;
        Line& line = lines_[i];
        const auto scaled_by = [](const MassScale& s, const double(&on)[3], double(&to)[3]) {
            to[0] = s.x * on[0], to[1] = s.y * on[1], to[2] = s.turn * on[2];
        };
        scaled_by(scales[j.a], j.on_a, line.on_a);
        scaled_by(scales[j.b], j.on_b, line.on_b);
        if (applied) add(line, -row(i).impulse, before_);
    }
    remove_impulses(scales, solver_bodies, applied);
    for (size_t i = 0; i < lines_.size(); ++i) {
        Line& line = lines_[i];
        const Jacobian& j = row(i).jacobian;
        const auto moving = [](const SolverBody& body, const double(&on)[3]) {
            return on[0] * double(body.velocity.x) + on[1] * double(body.velocity.y) +
                   on[2] * double(body.angular_velocity);
        };
        line.base = moving(solver_bodies[j.a], j.on_a) + moving(solver_bodies[j.b], j.on_b) +
                    along(line, before_);
        bound_friction(i);
        line.best = line.memory = row(i).impulse;
    }
}

/// Chooses `before_`, which removes the impulses of the previous pass from the velocities. They
/// acted along the rows as these were before the bodies moved, and are removed along the rows as
/// they are now. The difference is a velocity of second order in the rotation; it keeps the energy
/// of a pendulum. A chain that is almost straight needs huge impulses, and there the difference
/// would throw it. Then the impulses are removed along the earlier rows.
void DirectProblem::remove_impulses(std::span<const MassScale> scales,
                                    std::span<const SolverBody> solver_bodies, bool applied) {
    const auto visit = [&](auto&& component) {
        for (size_t i = 0; i < bodies_.size(); ++i) {
            const SolverBody& body = solver_bodies[bodies_[i]];
            const MassScale& s = scales[bodies_[i]];
            const auto at = Eigen::Index(3 * i);
            if (s.x > 0.0) component(at, double(body.velocity.x) / s.x);
            if (s.y > 0.0) component(at + 1, double(body.velocity.y) / s.y);
            if (s.turn > 0.0) component(at + 2, double(body.angular_velocity) / s.turn);
        }
    };
    if (!applied) {
        visit([&](Eigen::Index k, double velocity) { forced_[k] = velocity; });
        return;
    }
    trial_.setZero();
    visit([&](Eigen::Index k, double velocity) { trial_[k] = forced_[k] - velocity; });
    if ((before_ - trial_).squaredNorm() > most_rotated * most_rotated * forced_.squaredNorm())
        before_ = trial_;
}

/// Writes impulses and velocities.
void DirectProblem::write(std::span<const MassScale> scales,
                          std::span<SolverBody> solver_bodies) const {
    for (const uint32_t i : rows_) all_[i].keep();
    for (size_t i = 0; i < bodies_.size(); ++i) {
        SolverBody& body = solver_bodies[bodies_[i]];
        const MassScale& s = scales[bodies_[i]];
        const auto at = Eigen::Index(3 * i);
        const auto change = [&](Eigen::Index k) { return before_[at + k] + u_[at + k]; };
        const auto moved = [](float from, double by) {
            return bounded(float(double(from) + by), 1e30f);
        };
        body.velocity.x = moved(body.velocity.x, s.x * change(0));
        body.velocity.y = moved(body.velocity.y, s.y * change(1));
        body.angular_velocity = moved(body.angular_velocity, s.turn * change(2));
    }
}

/// Sets the bounds that depend on the impulses of other rows, from the current impulses.
void DirectProblem::bound_friction(size_t i) {
    DirectRow& r = row(i);
    if (r.bearers == 0) return;
    double load = 0.0;
    for (uint32_t k = 0; k < r.bearers; ++k) load += all_[r.bearer + k].impulse;
    r.high = r.friction * std::max(load, 0.0);
    r.low = -r.high;
}

/// How many times as fast as plausible a body is: it has more energy than its whole island had, and
/// is faster than the push speed. The links of an almost straight chain close a gap only by a long
/// way aside, the pushes of a crowd add up, and a search that was not finished may end anywhere.
double DirectProblem::excess(std::span<const MassScale> scales, float push_speed) const {
    const double most = most_growth * forced_.squaredNorm();
    double excess2 = 0.0;
    for (size_t i = 0; i < bodies_.size(); ++i) {
        const MassScale& s = scales[bodies_[i]];
        const double scale = std::max(s.x, s.y);
        const double pushed = scale > 0.0 ? double(push_speed) / scale : 0.0;
        const auto at = Eigen::Index(3 * i);
        const double energy = (forced_.segment<3>(at) + u_.segment<3>(at)).squaredNorm();
        const double plausible = most + pushed * pushed;
        if (plausible > 0.0) excess2 = std::max(excess2, energy / plausible);
    }
    return std::sqrt(excess2);
}

/// The rows keep `share` of their corrections. The search begins without impulses: from there,
/// sweeps without corrections do not add energy.
void DirectProblem::restart(double share) {
    for (size_t i = 0; i < lines_.size(); ++i) {
        DirectRow& r = row(i);
        r.push -= (1.0 - share) * r.correction;
        r.correction *= share;
        r.impulse = lines_[i].best = lines_[i].memory = 0.0;
    }
    for (size_t i = 0; i < lines_.size(); ++i) bound_friction(i);
}

}  // namespace fettle::physics::detail
