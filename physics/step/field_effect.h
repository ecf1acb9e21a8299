#pragma once

#include <geometry/vector.h>

#include <array>

namespace fettle::physics::detail {

/// Velocity and angular velocity, or force and torque.
using Twist = std::array<double, 3>;

/// Effect of the fields on one body in a step: forces, and resistances, which are proportional to
/// the velocity at the end of the step (implicit Euler). So no resistance is too great for the
/// step: it never removes more velocity than there is, of the translation and of the rotation
/// together.
class FieldEffect {
  public:
    void at(Vec2 arm, Vec2 force);
    /// A resistance (N s/m) at a point of the body that moves with this velocity relative to what
    /// surrounds it.
    void resist(Vec2 arm, double resistance, Vec2 velocity);
    /// The same only along the unit vector `n`. `speed`: along `n`.
    void resist_along(Vec2 n, Vec2 arm, double resistance, float speed);
    /// A resistance (N m s) against the rotation alone.
    void resist_turn(double resistance, float spin);

    /// The change of velocity in the step. `change`: by all other forces. `inverse`: of the masses
    /// along the axes and of the moment of inertia; 0: locked.
    Twist change(Twist change, const Twist& inverse, double dt) const;

  private:
    Twist force_ = {}, resistance_ = {};
    std::array<Twist, 3> by_velocity_ = {};  ///< how the resistance grows with the velocity
};

}  // namespace fettle::physics::detail
