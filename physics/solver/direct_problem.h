#pragma once

#include <solver/direct_row.h>

#include <Eigen/SparseCholesky>
#include <span>
#include <vector>

namespace fettle::physics::detail {

/// The bodies of an island and the rows that act on them: one mixed complementarity problem, see
/// direct_problem.cpp.
class DirectProblem {
  public:
    /// `bodies` are solver bodies that move, `rows` indices of rows. The two ends of row i are at
    /// `place[rows[i].a]` and `place[rows[i].b]` among the bodies, or -1 where nothing moves.
    DirectProblem(std::vector<uint32_t> bodies, std::vector<uint32_t> rows,
                  std::span<const DirectRow> all, std::span<const int32_t> place);

    /// Sets the impulses of the rows and the velocities of the bodies. `applied`: the impulses the
    /// rows have now are in the velocities already. False when the problem was too large or no
    /// solution was found: then sweeps over the rows have come as near as they do.
    bool solve(std::span<DirectRow> all, std::span<const MassScale> scales,
               std::span<SolverBody> solver_bodies, bool applied);

  private:
    enum class State : int8_t { low = -1, free = 0, high = 1 };
    /// A row of this problem, scaled by the masses: velocities are those of √M·v.
    struct Line {
        int32_t a = -1, b = -1;  ///< places among the bodies
        uint32_t block = 0;      ///< where the block of both is in the matrix
        double on_a[3], on_b[3];
        double base = 0.0;    ///< velocity before all impulses
        double memory = 0.0;  ///< impulse of the last round
        double best = 0.0;    ///< of the round that left least, else of the pass before
        State state = State::free;
        double velocity = 0.0, ahead = 0.0;  ///< of a line search: where it begins, along its way
    };

    void analyze();
    void take(std::span<const MassScale> scales, std::span<const SolverBody> solver_bodies,
              bool applied);
    void give(std::span<const MassScale> scales, std::span<SolverBody> solver_bodies) const;
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
    /// Impulse that row i wants at a velocity, and what its bounds leave of it.
    double wanted(size_t i, double velocity);
    double allowed(size_t i, double velocity);
    State next_state(size_t i, double velocity);
    double step_length(const Eigen::VectorXd& direction);
    double work_of_factorization() const;
    int affordable() const;

    std::vector<uint32_t> bodies_, rows_;
    std::vector<Line> lines_;
    std::span<DirectRow> all_;  ///< rows of all problems, while one is solved
    Eigen::VectorXd u_, before_, right_, trial_;
    Eigen::SparseMatrix<double> matrix_;
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower> factor_;
    bool analyzed_ = false;
    bool hopeless_ = false;
    double share_ = 1.0, begin_ = 1.0;  ///< of the rigidity of rows: now, and to begin with
    double work_left_ = 0.0;            ///< multiplications that it may still cost in this step
    double work_ = 0.0;                 ///< multiplications of a factorization; 0: not known yet
    int budget_ = 0;                    ///< factorizations that may still be made
    double least_left_ = 0.0;           ///< of all rounds of this problem: `residual`
};

}  // namespace fettle::physics::detail
