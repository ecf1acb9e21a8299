#pragma once
// Joints as the tree knows them. The physics library has a joint only while there is a body to
// pull; in the tree one may hang before its body is chosen, outlive it, or be in another world.
// What it is set to is therefore kept here, and a native joint is made of it before the next step.

#include <cstdint>
#include <optional>
#include <vector>

#include <fettle/physics/world.h>
#include <fettle/property/value.h>

namespace fettle::physics_module {

class Hosting;

struct MouseJointRecord {
    bool used = false;
    property::Handle body;
    physics::Vec2 target = physics::Vec2::Zero();
    std::optional<physics::Vec2> anchor;  // none: the point that will be at the target when it acts
    bool anchor_given = false;            // by a user, so that another body keeps it
    float frequency = 5.0f;
    float damping_ratio = 0.7f;
    float max_force = physics::infinity;
    bool enabled = true;
    std::uint32_t world = 0;  // the nearest above
    physics::JointId native;  // in that world; dangling when the body took it along
};

class Joints {
  public:
    explicit Joints(Hosting& hosting) : hosting_(hosting) {}

    std::uint32_t create(std::uint32_t world);
    void place(std::uint32_t row, std::uint32_t world);
    void destroy(std::uint32_t row);

    MouseJointRecord& at(std::uint32_t row) { return records_[row]; }
    const MouseJointRecord& at(std::uint32_t row) const { return records_[row]; }
    /// The joint that acts in the world; invalid while none does.
    physics::MouseJoint native(std::uint32_t row) const;

    /// Null when it was deleted.
    property::Handle body(std::uint32_t row) const;
    void set_body(std::uint32_t row, property::Handle body);
    physics::Vec2 anchor(std::uint32_t row) const;
    /// None: the point of the body that is at the target when the joint acts next.
    void set_anchor(std::uint32_t row, std::optional<physics::Vec2> anchor);

    /// Bodies came, went or changed worlds, or a joint was edited: look before the next step.
    void loosen() { loose_ = true; }
    /// Makes and ends native joints as the records want them.
    void tighten();

  private:
    void disconnect(MouseJointRecord& record);
    void connect(MouseJointRecord& record);

    Hosting& hosting_;
    std::vector<MouseJointRecord> records_;
    std::vector<std::uint32_t> free_;
    bool loose_ = false;
};

}  // namespace fettle::physics_module
