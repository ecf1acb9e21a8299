#pragma once

#include <solver/joints/direct_row.h>
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
    /// An impulse of 1 at a contact, and the impulses with which the joints react.
    struct Reaction {
        Jacobian contact;
        struct Part {
            uint32_t component = 0;
            Eigen::VectorXd velocities;  ///< J·M⁻¹·Jcᵀ
            Eigen::VectorXd impulses;    ///< -λ
        };
        std::vector<Part> parts;  ///< of the components of the two bodies

        /// By how much the joints reduce the velocity at this contact that an impulse at another
        /// one between the same bodies causes.
        double reduction(const Reaction& other) const;
    };

    /// Finds what the acting joints connect. `h`: length of a sub-step.
    JointResponse(const SolverInput& input, float h);
    bool acts_on(uint32_t a, uint32_t b) const {
        return first_joints_[a] != none || first_joints_[b] != none;
    }
    Reaction reaction_to(const Jacobian& contact);
    /// The part of the velocity at a contact that its joints do not allow and will take away: that
    /// of a joint made between bodies which move apart, for example. No impact has to stop it.
    double forbidden(const Reaction& reaction, std::span<const SolverBody> bodies) const;
    /// True if a kinematic body that moves acts on the bodies, at the contact or by a joint.
    bool are_driven(const Reaction& reaction) const;
    /// True if the bodies hardly yield at this contact, since joints hold them there: near the pin
    /// of a lever. `mobility`: the velocity that an impulse of 1 causes, 1/kg.
    bool are_held(const Reaction& reaction, double mobility) const;
    /// Applies the impulses of the joints; calls `changed(body)` for every body that they move.
    void apply(const Reaction& reaction, double impulse, std::span<SolverBody> bodies,
               auto&& changed) {
        for (const Reaction::Part& part : reaction.parts) {
            Component& component = components_[part.component];
            for (size_t i = 0; i < component.rows.size(); ++i)
                push(component.rows[i], -impulse * part.impulses[Eigen::Index(i)], bodies);
            for (const uint32_t body : component.bodies) changed(body);
        }
    }
    /// Adds the impulses of all reactions to the sums of velocities and to the strains of joints.
    void report() const;

  private:
    static constexpr uint32_t none = ~0u;
    /// A joint of a component, and its rows.
    struct Member {
        uint32_t array, index;
        size_t first_row, row_end;
    };
    /// Bodies that joints connect. It is made when an impact hits it.
    struct Component {
        std::vector<uint32_t> bodies;
        std::vector<DirectRow> rows;  ///< joint by joint; `impulse`: of all reactions
        std::vector<Member> members;
        bool driven = false;  ///< by a kinematic body that moves and is joined to it
        std::unique_ptr<Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>> factor;
    };
    /// A joint in the list of its component.
    struct Place {
        uint32_t array, index, next;
    };

    bool is_driven(uint32_t body) const;
    void list_joints();
    uint32_t component_of(uint32_t body);
    void read(uint32_t first_joint, Component& component);
    void factorize(Component& component) const;
    void add_to_sums(const Component& component, const Member& member) const;
    void add_to_strain(const Component& component, Strain& strain) const;
    double between(const Jacobian& one, const Jacobian& other) const;
    void push(DirectRow& row, double impulse, std::span<SolverBody> bodies) const;

    const SolverInput& input_;
    float h_;
    std::vector<MassScale> scales_;
    std::vector<Place> joints_;
    std::vector<uint32_t> first_joints_;  ///< of its component, by solver body; or `none`
    std::vector<uint32_t> component_of_;  ///< by first joint; `none` until it is hit
    std::vector<Component> components_;
};

}  // namespace fettle::physics::detail
