#include <partition/hubs.h>

#include <algorithm>

namespace fettle::physics::detail {

void Hubs::begin(uint32_t strips) {
    hubs_.clear();
    strips_ = strips;
}

void Hubs::add(uint32_t body, float inverse_mass_at_rim, std::vector<SolverBody>& bodies) {
    hubs_.push_back({body, uint32_t(bodies.size()), inverse_mass_at_rim, {}});
    SolverBody copy = bodies[body];
    copy.inverse_mass *= parts();
    copy.inverse_inertia *= parts();
    bodies.insert(bodies.end(), strips_ * (copies + 1), copy);
}

/// Number of the hub, from 1 on; 0: the body is not a hub.
uint8_t Hubs::hub_of(SolverEnd end) const {
    if (!end.is_hub()) return 0;
    const auto hub = std::find_if(hubs_.begin(), hubs_.end(),
                                  [&](const Hub& h) { return h.body == end.index(); });
    return uint8_t(hub - hubs_.begin() + 1);
}

void Hubs::choose_node(ActingContact& c, std::span<const SolverBody> bodies) const {
    c.node = 1;
    const uint8_t hub_a = hub_of(c.end_a), hub_b = hub_of(c.end_b);
    if ((hub_a == 0) == (hub_b == 0) || !c.both_move() || c.serially || c.takes_impacts()) return;
    const uint8_t hub = std::max(hub_a, hub_b);
    const SolverEnd other = hub_a != 0 ? c.end_b : c.end_a;
    if (!outweighs(hubs_[hub - 1].inverse_mass_at_rim, bodies[other.index()].inverse_mass)) return;
    c.hub = hub;
    c.node = other.strip();
}

void Hubs::choose_copy(ActingContact& c) {
    Hub& hub = hubs_[c.hub - 1];
    const uint32_t leaf = leaf_of(c.node);
    const uint32_t copy = first_of(hub, leaf) + 1 + hub.used[leaf]++ % copies;
    (c.a() == hub.body ? c.end_a : c.end_b) = SolverEnd(copy, c.node, true);
}

void Hubs::use_hub_itself(ActingContact& c) const {
    const Hub& hub = hubs_[c.hub - 1];
    (c.a() >= hub.first_copy ? c.end_a : c.end_b) = SolverEnd::of_hub(hub.body);
    c.node = 1;
}

void Hubs::write_copies(const StripNodes& nodes, std::span<SolverBody> bodies) const {
    for (const Hub& hub : hubs_) {
        const SolverBody& from = bodies[hub.body];
        const uint32_t begin = first_of(hub, leaf_of(nodes.begin));
        const uint32_t end = first_of(hub, leaf_of(nodes.end));
        for (SolverBody& copy : bodies.subspan(begin, end - begin)) {
            copy.velocity = from.velocity;
            copy.angular_velocity = from.angular_velocity;
            copy.shift = from.shift;
            copy.turn = from.turn;
        }
    }
}

void Hubs::average_copies(std::span<SolverBody> bodies) const {
    for (const Hub& hub : hubs_) {
        Vec2 velocity;
        float angular_velocity = 0.0f;
        for (uint32_t leaf = 0; leaf < strips_; ++leaf) {
            const auto all = bodies.subspan(first_of(hub, leaf), copies + 1);
            for (const SolverBody& copy : all.subspan(1)) {
                velocity = velocity + (copy.velocity - all[0].velocity);
                angular_velocity += copy.angular_velocity - all[0].angular_velocity;
            }
        }
        SolverBody& body = bodies[hub.body];
        body.velocity = body.velocity + (1.0f / parts()) * velocity;
        body.angular_velocity += 1.0f / parts() * angular_velocity;
    }
}

}  // namespace fettle::physics::detail
