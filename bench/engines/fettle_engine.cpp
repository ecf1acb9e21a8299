// A scene in the bare library.

#include "engines/fettle_engine.h"

#include <vector>

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
        body.add(physics::Box{.width = 2 * (box.half.x + box.rounding),
                              .height = 2 * (box.half.y + box.rounding),
                              .center = vec(box.center),
                              .rounding = box.rounding},
                 def);
    }
    void operator()(const SegmentShape& segment) const {
        body.add(
            physics::Segment{
                .from = vec(segment.from), .to = vec(segment.to), .rounding = segment.radius},
            def);
    }
    void operator()(const PolygonShape& polygon) const {
        physics::Polygon geometry{.rounding = polygon.rounding};
        for (const Point& point : polygon.vertices) geometry.vertices.push_back(vec(point));
        body.add(geometry, def);
    }
    void operator()(const EllipseShape& ellipse) const {
        body.add(physics::Ellipse{.radius_x = ellipse.radii.x, .radius_y = ellipse.radii.y}, def);
    }
    void operator()(const ChainShape& chain) const {
        physics::Chain geometry{.closed = chain.closed};
        for (const Point& point : chain.points) geometry.points.push_back(vec(point));
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
    FettleEngine(const Scene& scene, physics::Solver solver, int substeps)
        : world_({.gravity = vec(scene.gravity),
                  .substeps = substeps,
                  .sleeping = scene.sleeping,
                  .continuous = scene.continuous,
                  .solver = solver}) {
        bodies_.reserve(scene.bodies.size());
        for (const SceneBody& body : scene.bodies) bodies_.push_back(make(body));
        for (const SceneJoint& joint : scene.joints) add_joint(bodies_, scene.bodies, joint);
        groups_.resize(scene.groups.size());
        // Last, because a new contact wakes a sleeping body.
        for (std::size_t i = 0; i < bodies_.size(); ++i) {
            if (!scene.bodies[i].awake) bodies_[i].set_awake(false);
        }
    }

    void step() override { world_.step(time_step); }

    void set_threads(int threads) override { world_.set_threads(threads); }

    BodyMotion motion(std::size_t index) const override { return motion_of(bodies_[index]); }

    void mix_groups(std::uint64_t& hash) const override {
        for (const Group& group : groups_)
            for (const physics::Body& body : group.bodies) mix(hash, motion_of(body));
    }

    void set_velocity(std::size_t body, Point velocity) override {
        bodies_[body].set_velocity(vec(velocity));
    }

    /// Removes existing bodies from last to first, shapes before their bodies, as the tree does.
    /// The order determines the next free slots, and so the order of the contacts.
    void replace_group(std::size_t group, const SceneGroup& description) override {
        Group& of = groups_[group];
        for (auto joint = of.joints.rbegin(); joint != of.joints.rend(); ++joint) joint->destroy();
        for (auto body = of.bodies.rbegin(); body != of.bodies.rend(); ++body) {
            std::vector<physics::Shape> shapes = body->shapes();
            for (auto shape = shapes.rbegin(); shape != shapes.rend(); ++shape) shape->destroy();
            body->destroy();
        }
        of = {};
        for (const SceneBody& body : description.bodies) of.bodies.push_back(make(body));
        for (const SceneJoint& joint : description.joints)
            of.joints.push_back(add_joint(of.bodies, description.bodies, joint));
    }

    std::size_t contacts() const override { return world_.contacts().size(); }
    std::size_t bodies() const override { return world_.body_count(); }
    physics::World& world() { return world_; }

  private:
    static BodyMotion motion_of(const physics::Body& body) {
        const auto position = physics::Vec2(body.position());
        const physics::Vec2 velocity = body.velocity();
        return {{position.x, position.y},
                body.angle(),
                {velocity.x, velocity.y},
                body.angular_velocity()};
    }

    physics::Joint add_joint(const std::vector<physics::Body>& bodies,
                             const std::vector<SceneBody>& described, const SceneJoint& joint) {
        physics::RevoluteJoint made = world_.create_revolute_joint(
            {.body_a = bodies[joint.body_a].id(),
             .body_b = bodies[joint.body_b].id(),
             .anchor_a = vec(local_anchor(described, joint.body_a, joint.anchor)),
             .anchor_b = vec(local_anchor(described, joint.body_b, joint.anchor))});
        if (joint.motor_torque > 0) {
            made.set_motor_speed(joint.motor_speed);
            made.set_max_motor_torque(joint.motor_torque);
        }
        if (joint.hertz > 0) {
            made.set_hertz(joint.hertz);
            made.set_damping_ratio(joint.damping_ratio);
        }
        if (joint.reference != 0) made.set_reference_angle(joint.reference);
        made.set_lower_angle(joint.lower);
        made.set_upper_angle(joint.upper);
        return made;
    }

    physics::Body make(const SceneBody& description) {
        physics::Body body = world_.create_body({.type = type_of(description.motion),
                                                 .position = vec(description.position),
                                                 .angle = description.angle,
                                                 .velocity = vec(description.velocity),
                                                 .angular_velocity = description.angular_velocity,
                                                 .linear_damping = description.linear_damping,
                                                 .awake = description.awake,
                                                 .can_sleep = description.can_sleep,
                                                 .bullet = description.bullet});
        for (const SceneShape& shape : description.shapes) {
            const physics::ShapeDef def{.density = shape.density,
                                        .friction = shape.friction,
                                        .restitution = shape.restitution,
                                        .hit_events = shape.hit_events,
                                        .category = shape.category,
                                        .mask = shape.mask,
                                        .group = shape.group};
            std::visit(GeometryMaker{body, def}, shape.geometry);
        }
        return body;
    }

    physics::World world_;
    std::vector<physics::Body> bodies_;
    struct Group {
        std::vector<physics::Body> bodies;
        std::vector<physics::Joint> joints;
    };
    std::vector<Group> groups_;
};

}  // namespace

std::unique_ptr<Engine> make_fettle(const Scene& scene) {
    return make_fettle(scene, physics::Solver::soft_step, 4);
}

std::unique_ptr<Engine> make_fettle(const Scene& scene, physics::Solver solver, int substeps) {
    return std::make_unique<FettleEngine>(scene, solver, substeps);
}

physics::World& fettle_world(Engine& engine) {
    return dynamic_cast<FettleEngine&>(engine).world();
}

}  // namespace fettle::bench
