#pragma once

#include <fettle/physics/body.h>

namespace fettle::physics {

/// A light handle to a joint that drags a point of a body softly towards a target. Errors as for
/// `Body`. Every setter wakes the body. Destroying the body destroys the joint.
class MouseJoint {
  public:
    MouseJoint() = default;
    MouseJoint(World* world, JointId id) : world_(world), id_(id) {}

    bool is_valid() const;
    explicit operator bool() const { return is_valid(); }
    JointId id() const { return id_; }
    World& world() const { return *world_; }
    friend bool operator==(const MouseJoint&, const MouseJoint&) = default;
    void destroy();

    JointType type() const { return JointType::mouse; }
    Body body() const;
    void set_body(const Body& body);  ///< keeps the anchor's body coordinates
    Vec2 anchor() const;              ///< body coordinates, m
    void set_anchor(const Vec2& anchor);
    Vec2 target() const;  ///< world, m
    void set_target(const Vec2& target);
    float hertz() const;
    void set_hertz(float hertz);
    float damping_ratio() const;
    void set_damping_ratio(float ratio);
    float max_force() const;  ///< N
    void set_max_force(float force);
    bool enabled() const;
    void set_enabled(bool enabled);
    Vec2 force() const;  ///< N, what it pulled with in the last step

    uint64_t user_data() const;
    void set_user_data(uint64_t value);

  private:
    World* world_ = nullptr;
    JointId id_;
};

}  // namespace fettle::physics
