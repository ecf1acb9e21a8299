#pragma once

#include <solver/direct_row.h>
#include <solver/solvers.h>

#include <Eigen/SparseCholesky>
#include <memory>
#include <span>
#include <vector>

// The response of joints to an impact. An impulse at a contact changes the velocities of all bodies
// that joints connect with its two bodies: by the impulses λ of the joints that keep J·Δv = 0 in
// the rows J which hold a point, a distance or an angle. So J·M⁻¹·Jᵀ·λ = -J·M⁻¹·Jcᵀ for an impulse
// of 1 with the Jacobian Jc of the contact. Limits, springs and motors with a limited force take no
// part.

namespace fettle::physics::detail {

class JointResponse {
  public:
    /// An impulse of 1 at a contact, and the impulses with which the joints answer.
    struct Answer {
        Jacobian contact;
        struct Part {
            uint32_t component = 0;
            Eigen::VectorXd velocities;  ///< J·M⁻¹·Jcᵀ
            Eigen::VectorXd impulses;    ///< -λ
        };
        std::vector<Part> parts;  ///< of the components of the two bodies

        /// The velocity at this contact which joints take away from an impulse at another one
        /// between the same bodies.
        double less(const Answer& other) const;
    };

    /// Reads the rows of all acting joints. `h`: length of a sub-step.
    void read(const SolverInput& input, float h);
    bool acts_on(uint32_t a, uint32_t b) const {
        return !component_of_.empty() && (component_of_[a] != none || component_of_[b] != none);
    }
    Answer answer(const Jacobian& contact);
    /// Applies the impulses of the joints; calls `changed(body)` for every body that they move.
    void apply(const Answer& answer, double impulse, std::span<SolverBody> bodies,
               auto&& changed) const {
        for (const Answer::Part& part : answer.parts) {
            const Component& component = components_[part.component];
            for (size_t i = 0; i < component.rows.size(); ++i)
                push(rows_[component.rows[i]].jacobian, -impulse * part.impulses[Eigen::Index(i)],
                     bodies);
            for (const uint32_t body : component.bodies) changed(body);
        }
    }

  private:
    static constexpr uint32_t none = ~0u;
    struct Component {
        std::vector<uint32_t> bodies, rows;
        std::unique_ptr<Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>> factor;
    };

    void find_components();
    void factorize(Component& component) const;
    double between(const Jacobian& one, const Jacobian& other) const;
    void push(const Jacobian& row, double impulse, std::span<SolverBody> bodies) const;

    std::vector<MassScale> scales_;
    std::vector<DirectRow> rows_;
    std::vector<uint32_t> component_of_;  ///< by solver body; `none` without joints
    std::vector<Component> components_;
};

}  // namespace fettle::physics::detail
