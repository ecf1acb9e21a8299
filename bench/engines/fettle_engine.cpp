// A scene in the bare library.

#include <fettle/physics/physics.h>

#include <vector>

#include "engines/engine.h"

namespace fettle::bench {
namespace {

physics::Vec2 vec(Point p) {
    return {p.x, p.y};
}

struct GeometryMaker {
    physics::Body& body;
    const physics::ShapeDef& def;

    void operator()(const CircleShape& circle) const {
        body.add(physics::Circle{circle.radius, vec(circle.center)}, def);
    }
    void operator()(const BoxShape& box) const {
        body.add(
            physics::Box{
                .width = 2 * box.half.x, .height = 2 * box.half.y, .center = vec(box.center)},
            def);
    }
    void operator()(const SegmentShape& segment) const {
        body.add(physics::Segment{.from = vec(segment.from), .to = vec(segment.to)}, def);
    }
    void operator()(const PolygonShape& polygon) const {
        physics::Polygon geometry;
        for (const Point& point : polygon.vertices) geometry.vertices.push_back(vec(point));
        body.add(geometry, def);
    }
};

physics::BodyType type_of(Motion motion) {
    switch (motion) {
        case Motion::fixed:
            return physics::BodyType::static_body;
        case Motion::kinematic:
            return physics::BodyType::kinematic_body;
        case Motion::dynamic:
            break;
    }
    return physics::BodyType::dynamic_body;
}

class FettleEngine : public Engine {
  public:
    explicit FettleEngine(const Scene& scene)
        : world_({.gravity = vec(scene.gravity),
                  .sleeping = scene.sleeping,
                  .continuous = scene.continuous}) {
        bodies_.reserve(scene.bodies.size());
        for (const SceneBody& body : scene.bodies) bodies_.push_back(make(body));
        for (const SceneJoint& joint : scene.joints) tie(scene, joint);
        // Last, since whoever comes to touch a sleeping body wakes it.
        for (std::size_t i = 0; i < bodies_.size(); ++i) {
            if (!scene.bodies[i].awake) bodies_[i].set_awake(false);
        }
    }

    void step() override { world_.step(time_step); }

    BodyMotion motion(std::size_t index) const override {
        const physics::Body& body = bodies_[index];
        const physics::Vec2 position = body.position();
        const physics::Vec2 velocity = body.velocity();
        return {{position.x(), position.y()},
                body.angle(),
                {velocity.x(), velocity.y()},
                body.angular_velocity()};
    }

    void set_velocity(std::size_t body, Point velocity) override {
        bodies_[body].set_velocity(vec(velocity));
    }

    std::size_t contacts() const override { return world_.contacts().size(); }
    std::size_t bodies() const override { return world_.body_count(); }

  private:
    void tie(const Scene& scene, const SceneJoint& joint) {
        physics::RevoluteJoint made =
            world_.create_revolute_joint({.body_a = bodies_[joint.body_a].id(),
                                          .body_b = bodies_[joint.body_b].id(),
                                          .anchor_a = vec(scene.anchor_a(joint)),
                                          .anchor_b = vec(scene.anchor_b(joint))});
        if (joint.motor_torque <= 0) return;
        made.set_motor_speed(joint.motor_speed);
        made.set_max_motor_torque(joint.motor_torque);
    }

    physics::Body make(const SceneBody& description) {
        physics::Body body = world_.create_body({.type = type_of(description.motion),
                                                 .position = vec(description.position),
                                                 .angle = description.angle,
                                                 .velocity = vec(description.velocity),
                                                 .angular_velocity = description.angular_velocity,
                                                 .awake = description.awake,
                                                 .bullet = description.bullet});
        for (const SceneShape& shape : description.shapes) {
            const physics::ShapeDef def{.density = shape.density,
                                        .friction = shape.friction,
                                        .restitution = shape.restitution,
                                        .hit_events = shape.hit_events,
                                        .category = shape.category,
                                        .mask = shape.mask};
            std::visit(GeometryMaker{body, def}, shape.geometry);
        }
        return body;
    }

    physics::World world_;
    std::vector<physics::Body> bodies_;
};

}  // namespace

std::unique_ptr<Engine> make_fettle(const Scene& scene) {
    return std::make_unique<FettleEngine>(scene);
}

}  // namespace fettle::bench
