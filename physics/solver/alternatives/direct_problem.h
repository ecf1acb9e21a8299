#pragma once

#include <solver/joints/direct_row.h>

#include <Eigen/SparseCholesky>
#include <span>
#include <vector>

namespace fettle::physics::detail {

/// The bodies of an island and the rows that act on them: one mixed complementarity problem, see
/// direct_problem.cpp.
class DirectProblem {
  public:
    /// `bodies`: moving solver bodies; `rows`: indices of rows. The two ends of row i are at
    /// `place[rows[i].a]` and `place[rows[i].b]` in the list of bodies, or -1 for an end that does
    /// not move.
    DirectProblem(std::vector<uint32_t> bodies, std::vector<uint32_t> rows,
                  std::span<const DirectRow> all, std::span<const int32_t> place);

    /// Sets the impulses of the rows and the velocities of the bodies. `applied`: the velocities
    /// already contain the current impulses of the rows. `push_speed`: of the world, m/s. False if
    /// the problem was too large or no solution was found: then the result comes from sweeps over
    /// the rows.
    bool solve(std::span<DirectRow> all, std::span<const MassScale> scales,
               std::span<SolverBody> solver_bodies, bool applied, float push_speed);
    std::span<const uint32_t> bodies() const { return bodies_; }
    std::span<const uint32_t> rows() const { return rows_; }

  private:
    enum class State : int8_t { low = -1, free = 0, high = 1 };
    /// A row of this problem, scaled by the masses: its velocities are √M·v.
    struct Line {
        int32_t a = -1, b = -1;  ///< places among the bodies
        uint32_t block = 0;      ///< place of the block of both bodies in the matrix
        double on_a[3], on_b[3];
        double base = 0.0;    ///< velocity without any impulse
        double memory = 0.0;  ///< impulse of the last round
        double best = 0.0;    ///< impulse of the round with the smallest residual
        State state = State::free;
        double velocity = 0.0, ahead = 0.0;  ///< of a line search: at its start, and change
    };

    void analyze();
    void read(std::span<const MassScale> scales, std::span<const SolverBody> solver_bodies,
              bool applied);
    void remove_impulses(std::span<const MassScale> scales,
                         std::span<const SolverBody> solver_bodies, bool applied);
    double excess(std::span<const MassScale> scales, float push_speed) const;
    void restart(double share);
    void write(std::span<const MassScale> scales, std::span<SolverBody> solver_bodies) const;
    bool find_velocities();
    bool solve_exactly();
    bool solve_boxed(int most);
    void guess_states();
    double residual();
    void assemble();
    void add_block(const Line& line, double stiffness);
    bool update_bounds(bool average);
    void bound_friction(size_t i);
    void sweep(int most);
    void begin_from_sweeps();

    DirectRow& row(size_t i) { return all_[rows_[i]]; }
    static double inverse_mass(const Line& line);
    double along(const Line& line, const Eigen::VectorXd& u) const;
    void add(const Line& line, double impulse, Eigen::VectorXd& to) const;
    /// `wanted`: impulse of row i at a velocity. `allowed`: that impulse within its bounds.
    double wanted(size_t i, double velocity);
    double allowed(size_t i, double velocity);
    State next_state(size_t i, double velocity);
    double step_length(const Eigen::VectorXd& direction);
    double work_of_factorization() const;
    int factorizations_left() const;

    std::vector<uint32_t> bodies_, rows_;
    std::vector<Line> lines_;
    std::span<DirectRow> all_;  ///< rows of all problems; only set while one is solved
    Eigen::VectorXd u_, right_, trial_;
    Eigen::VectorXd before_;  ///< from the velocities of the bodies to those without impulses
    Eigen::VectorXd forced_;  ///< √M·v before the impulses of the sub-step
    Eigen::SparseMatrix<double> matrix_;
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower> factor_;
    bool analyzed_ = false;
    bool search_failed_ = false;
    double share_ = 1.0, begin_ = 1.0;  ///< share of rigidity: now, at the start
    double work_left_ = 0.0;            ///< multiplications left in this step
    double work_ = 0.0;                 ///< multiplications of a factorization; 0: not yet computed
    int budget_ = 0;                    ///< factorizations that the problem may still make
    double least_left_ = 0.0;           ///< smallest `residual` of all rounds of this problem
};

}  // namespace fettle::physics::detail
