#pragma once
// Where a body is in a picture: between its poses of the last two steps.

#include <cmath>

#include <fettle/physics/world.h>
#include <fettle/property/class.h>

#include <bindings/conversion.h>
#include <hosting/hosting.h>

namespace fettle::physics_module {

/// Converts from a body's coordinates to the world, interpolated between the last two steps.
class Frame {
  public:
    Frame() = default;
    Frame(const HostedWorld& in, std::uint32_t body, double alpha) {
        if (const auto written = in.written_poses.drawn(in.world, body, alpha)) {
            position_ = written->position;
            turn_to(written->angle);
            return;
        }
        const physics::Pose& from = physics::HostAccess::previous(in.world, body);
        const physics::BodyState& to = physics::HostAccess::state(in.world, body);
        position_ = widen(from.position) + alpha * (widen(to.position) - widen(from.position));
        const double start = from.angle, turn = static_cast<double>(to.angle) - start;
        turn_to(start + alpha * turn);
    }
    property::Vec2 point(const physics::Vec2& local) const {
        const double x = local.x, y = local.y;
        return {position_.x + cosine_ * x - sine_ * y, position_.y + sine_ * x + cosine_ * y};
    }
    double angle() const { return angle_; }
    const property::Vec2& position() const { return position_; }

  private:
    void turn_to(double angle) {
        angle_ = angle;
        cosine_ = std::cos(angle);
        sine_ = std::sin(angle);
    }

    property::Vec2 position_{0, 0};
    double angle_ = 0, cosine_ = 1, sine_ = 0;
};

/// As in property::Lifecycle; the context is the Hosting.
property::Transform drawn_pose(void* context, const property::Tree& tree, property::Handle self,
                               property::Row row, double alpha);

}  // namespace fettle::physics_module
