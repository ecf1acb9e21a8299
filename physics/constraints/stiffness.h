#pragma once

#include <constraints/contact_constraint.h>

// The stiffness of a contact increases with its load, and bodies of a few centimeters have contacts
// that do not yield.
//
// One stiffness for all contacts is not enough. With 45 Hz at four sub-steps of 1/240 s a house of
// cards stands, and a tower of posts and beams comes to rest, but a load of 300 : 1 sinks in by
// 6 %. With 60 Hz that sinks in by half, but the cards, which carry almost no load and touch in
// many places, never come to rest, and a tower of twelve floors sways and bounces for more than 40
// s: so near to the rate of the sub-steps, the passes take hardly any energy out of it. The load of
// a contact in the last step distinguishes the cases. Between the two, the stiffness must rise
// slowly, because it follows the load by a step: where it rises fast, a contact is pressed together
// while it is soft and pushes back while it is stiff, which adds energy to every bounce.

// A soft contact yields by the same distance for bodies of any size, since its stiffness follows
// from the sub-step: a stack of ten boxes sinks in by 13 mm. That is one percent of a meter and
// more than a box of 1 cm. Contacts of small bodies do not yield, and push out more slowly: with
// the full bias, a stack of ten rigid contacts sways.

namespace fettle::physics::detail {

class ContactStiffness {
  public:
    /// The stiffness is at most this part of the sub-step rate.
    static constexpr float greatest_share = 0.25f;

    /// `hertz` is the stiffness of a loaded contact, at most a quarter of the sub-step rate: from a
    /// third on, heavy loads are thrown off. `weight`: acceleration by gravity, m/s².
    ContactStiffness(float hertz, float damping_ratio, float h, float weight)
        : loaded_hertz_(min(hertz, greatest_share / h)) {
        for (int fixed = 0; fixed < 2; ++fixed) {
            // No body pushes the fixed body of such a contact from behind, so the contact can be
            // twice as stiff.
            const float times = fixed == 1 ? 2.0f : 1.0f;
            idle_[fixed] = make_softness(times * idle_share * loaded_hertz_, damping_ratio, h);
            loaded_[fixed] = make_softness(times * loaded_hertz_, damping_ratio, h);
        }
        share_ = 1.0f / ((greatest_load - least_load) * weight * h);
    }

    /// `impulse`: impulse of the last sub-step, N s; `inverse_mass`: that of the lighter body;
    /// `gyration`: square of the radius of gyration of the smaller body, m².
    Softness of(bool fixed, float impulse, float inverse_mass, float gyration) const {
        const float t = clamp(impulse * inverse_mass * share_ - least_share, 0.0f, 1.0f);
        const Softness &u = idle_[fixed], &v = loaded_[fixed];
        const float rate = u.bias_rate + t * (v.bias_rate - u.bias_rate);
        const float mass_scale = u.mass_scale + t * (v.mass_scale - u.mass_scale);
        const float impulse_scale = u.impulse_scale + t * (v.impulse_scale - u.impulse_scale);
        const float size = min(large_gyration * gyration, 1.0f), yields = size * size;
        return {(least_rate + (1.0f - least_rate) * yields) * rate,
                mass_scale + (1.0f - yields) * impulse_scale, yields * impulse_scale};
    }

    const Softness& idle(bool fixed) const { return idle_[fixed]; }
    const Softness& loaded(bool fixed) const { return loaded_[fixed]; }
    /// Frequency of a loaded contact of two moving bodies.
    float loaded_hertz() const { return loaded_hertz_; }
    /// The stiffness depends on load · share - least_share, limited to 0 … 1.
    float share() const { return share_; }

  private:
    static constexpr float idle_share = 0.75f;
    /// Loads between which the stiffness increases, in weights of the lighter body.
    static constexpr float least_load = 20.0f, greatest_load = 100.0f;

  public:
    /// The inverse of the square of the radius of gyration of a box of 10 cm, from which on
    /// contacts yield in full.
    static constexpr float large_gyration = 600.0f;
    /// The bias of the smallest bodies, as a part of the full bias.
    static constexpr float least_rate = 0.25f;
    static constexpr float least_share = least_load / (greatest_load - least_load);

  private:
    float loaded_hertz_;
    Softness idle_[2], loaded_[2];  ///< index 0: two moving bodies; 1: a moving and a fixed one
    float share_ = 0.0f;
};

}  // namespace fettle::physics::detail
