#include <partition/joint_share.h>

#include <algorithm>

namespace fettle::physics::detail {

void JointShare::unite() {
    std::sort(bodies_.begin(), bodies_.end());
    bodies_.erase(std::unique(bodies_.begin(), bodies_.end()), bodies_.end());
    velocities_.resize(bodies_.size());
    nodes_.clear();
    for (const uint64_t body : bodies_) nodes_.count(uint32_t(body >> 32));
    nodes_.sum_up();
}

void JointShare::save_velocities(const StripNodes& nodes, std::span<const SolverBody> bodies) {
    for (size_t i = nodes_.begin(nodes); i < nodes_.end(nodes); ++i) {
        const SolverBody& b = bodies[uint32_t(bodies_[i])];
        velocities_[i] = {b.velocity, b.angular_velocity};
    }
}

void JointShare::add_change(const StripNodes& nodes, std::span<const SolverBody> bodies,
                            std::span<SolverForce> forces) const {
    for (size_t i = nodes_.begin(nodes); i < nodes_.end(nodes); ++i) {
        const SolverBody& b = bodies[uint32_t(bodies_[i])];
        SolverForce& f = forces[uint32_t(bodies_[i])];
        f.before = f.before + (b.velocity - velocities_[i].linear);
        f.turn_before += b.angular_velocity - velocities_[i].angular;
    }
}

}  // namespace fettle::physics::detail
