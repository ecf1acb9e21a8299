// A scene in Box2D 2.4: 8 velocity and 3 position iterations, as its manual recommends.

#include <box2d/box2d.h>

#include <stdexcept>
#include <vector>

#include "engines/engine.h"

namespace fettle::bench {
namespace {

b2Vec2 vec(Point p) {
    return {p.x, p.y};
}

/// Makes one fixture of `shape` on `body`.
struct FixtureMaker {
    b2Body& body;
    const SceneShape& shape;

    void make(const b2Shape& geometry) const {
        b2FixtureDef def;
        def.shape = &geometry;
        def.density = shape.density;
        def.friction = shape.friction;
        def.restitution = shape.restitution;
        def.filter.categoryBits = shape.category;
        def.filter.maskBits = shape.mask;
        body.CreateFixture(&def);
    }
    void operator()(const CircleShape& circle) const {
        b2CircleShape geometry;
        geometry.m_radius = circle.radius;
        geometry.m_p = vec(circle.center);
        make(geometry);
    }
    void operator()(const BoxShape& box) const {
        b2PolygonShape geometry;
        geometry.SetAsBox(box.half.x, box.half.y, vec(box.center), 0);
        make(geometry);
    }
    void operator()(const SegmentShape& segment) const {
        b2EdgeShape geometry;
        geometry.SetTwoSided(vec(segment.from), vec(segment.to));
        make(geometry);
    }
    void operator()(const PolygonShape& polygon) const {
        std::vector<b2Vec2> points;
        for (const Point& point : polygon.vertices) points.push_back(vec(point));
        b2PolygonShape geometry;
        geometry.Set(points.data(), static_cast<int32>(points.size()));
        make(geometry);
    }
    void operator()(const EllipseShape&) const {
        throw std::invalid_argument("Box2D has no ellipses");
    }
    /// Box2D's chains are solid on the right side of their points, so ours are reversed. An open
    /// chain needs one more point at each end.
    void operator()(const ChainShape& chain) const {
        std::vector<b2Vec2> points;
        for (auto point = chain.points.rbegin(); point != chain.points.rend(); ++point)
            points.push_back(vec(*point));
        const auto count = static_cast<int32>(points.size());
        b2ChainShape geometry;
        if (chain.closed) {
            geometry.CreateLoop(points.data(), count);
        } else {
            const b2Vec2 before = 2 * points[0] - points[1];
            const b2Vec2 after = 2 * points.back() - points[points.size() - 2];
            geometry.CreateChain(points.data(), count, before, after);
        }
        make(geometry);
    }
};

class Box2dEngine : public Engine {
  public:
    explicit Box2dEngine(const Scene& scene) : world_(vec(scene.gravity)) {
        world_.SetAllowSleeping(scene.sleeping);
        world_.SetContinuousPhysics(scene.continuous);
        bodies_.reserve(scene.bodies.size());
        for (const SceneBody& body : scene.bodies) bodies_.push_back(make(body));
        for (const SceneJoint& joint : scene.joints) add_joint(joint);
    }

    void step() override { world_.Step(time_step, 8, 3); }

    BodyMotion motion(std::size_t index) const override {
        const b2Body& body = *bodies_[index];
        const b2Vec2 position = body.GetPosition();
        const b2Vec2 velocity = body.GetLinearVelocity();
        return {{position.x, position.y},
                body.GetAngle(),
                {velocity.x, velocity.y},
                body.GetAngularVelocity()};
    }

    void set_velocity(std::size_t body, Point velocity) override {
        bodies_[body]->SetLinearVelocity(vec(velocity));
    }

    std::size_t contacts() const override {
        std::size_t touching = 0;
        for (const b2Contact* c = world_.GetContactList(); c; c = c->GetNext())
            touching += c->IsTouching() ? 1 : 0;
        return touching;
    }

    std::size_t bodies() const override { return static_cast<std::size_t>(world_.GetBodyCount()); }

  private:
    void add_joint(const SceneJoint& joint) {
        b2RevoluteJointDef def;
        def.Initialize(bodies_[joint.body_a], bodies_[joint.body_b], vec(joint.anchor));
        def.enableMotor = joint.motor_torque > 0;
        def.motorSpeed = joint.motor_speed;
        def.maxMotorTorque = joint.motor_torque;
        world_.CreateJoint(&def);
    }

    b2Body* make(const SceneBody& description) {
        b2BodyDef def;
        def.type = description.motion == Motion::fixed       ? b2_staticBody
                   : description.motion == Motion::kinematic ? b2_kinematicBody
                                                             : b2_dynamicBody;
        def.position = vec(description.position);
        def.angle = description.angle;
        def.linearVelocity = vec(description.velocity);
        def.angularVelocity = description.angular_velocity;
        def.awake = description.awake;
        def.bullet = description.bullet;
        b2Body* body = world_.CreateBody(&def);
        for (const SceneShape& shape : description.shapes)
            std::visit(FixtureMaker{*body, shape}, shape.geometry);
        return body;
    }

    b2World world_;
    std::vector<b2Body*> bodies_;
};

}  // namespace

std::unique_ptr<Engine> make_box2d(const Scene& scene) {
    return std::make_unique<Box2dEngine>(scene);
}

}  // namespace fettle::bench
