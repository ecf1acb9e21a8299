// A plan in Box2D 2.4, with 8 velocity and 3 position iterations, as its manual recommends. Round
// ends of capsules and rounded corners become polygons of eight vertices, as do ellipses. Plans
// that need fields, rolling resistance of round shapes, belts, edits, or joints that it lacks are
// refused.

#include <box2d/box2d.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "wild/plans/running_world.h"

namespace fettle::bench::wild {
namespace {

b2Vec2 vec(const Vec2& v) {
    return {v.x, v.y};
}
Vec2 vec(const b2Vec2& v) {
    return {v.x, v.y};
}

bool has_shape(const ShapePlan& shape) {
    if (shape.def.surface_speed != 0) return false;
    if (const auto* polygon = std::get_if<Polygon>(&shape.geometry))
        return polygon->vertices.size() <= b2_maxPolygonVertices;
    return shape.def.rolling_resistance == 0 || !std::holds_alternative<Circle>(shape.geometry);
}

bool has_joint(const JointPlan& joint) {
    for (const Setting& setting : joint.settings)
        if (setting.setter == "set_hertz" && joint.type != JointType::wheel) return false;
    if (joint.type == JointType::distance && joint.number("set_max_length", 0) > 0) return false;
    return joint.type == JointType::distance || joint.type == JointType::revolute ||
           joint.type == JointType::weld || joint.type == JointType::prismatic ||
           joint.type == JointType::wheel;
}

bool has_all(const WorldPlan& plan) {
    if (!plan.fields.empty() || !plan.edits.empty()) return false;
    for (const BodyPlan& body : plan.bodies)
        if (body.born > 0 || !std::ranges::all_of(body.shapes, has_shape)) return false;
    return std::ranges::all_of(
        plan.joints, [](const auto& joint) { return joint.born == 0 && has_joint(joint); });
}

/// A capsule with three edges at each end.
std::vector<Vec2> stadium(const Segment& segment) {
    const Vec2 way = segment.to - segment.from;
    const float along = way.length() < 1e-4f ? 0 : std::atan2(way.y, way.x);
    std::vector<Vec2> points;
    for (int i = 0; i < 8; ++i) {
        const float turn = along - b2_pi / 2 + b2_pi / 3 * float(i < 4 ? i : i - 1);
        points.push_back((i < 4 ? segment.to : segment.from) +
                         segment.rounding * Vec2(std::cos(turn), std::sin(turn)));
    }
    return points;
}

struct FixtureMaker {
    b2Body& body;
    const ShapeDef& surface;

    void make(const b2Shape& geometry) const {
        b2FixtureDef def;
        def.shape = &geometry;
        def.density = surface.density;
        def.friction = surface.friction;
        def.restitution = surface.restitution;
        def.isSensor = surface.sensor;
        def.filter.categoryBits = std::uint16_t(surface.category);
        def.filter.maskBits = std::uint16_t(surface.mask);
        def.filter.groupIndex = std::int16_t(surface.group);
        body.CreateFixture(&def);
    }
    void make(const std::vector<Vec2>& vertices) const {
        std::vector<b2Vec2> points;
        for (const Vec2& vertex : vertices) points.push_back(vec(vertex));
        b2PolygonShape geometry;
        geometry.Set(points.data(), int32(points.size()));
        make(geometry);
    }
    void operator()(const Circle& circle) const {
        b2CircleShape geometry;
        geometry.m_radius = circle.radius;
        geometry.m_p = vec(circle.center);
        make(geometry);
    }
    void operator()(const Box& box) const {
        b2PolygonShape geometry;
        geometry.SetAsBox(box.width / 2, box.height / 2, vec(box.center), box.angle);
        make(geometry);
    }
    void operator()(const Segment& segment) const {
        if (segment.rounding > 0) return make(stadium(segment));
        b2EdgeShape geometry;
        geometry.SetTwoSided(vec(segment.from), vec(segment.to));
        make(geometry);
    }
    void operator()(const Polygon& polygon) const { make(polygon.vertices); }
    void operator()(const Ellipse& ellipse) const {
        std::vector<Vec2> points;
        for (int i = 0; i < 8; ++i) {
            const float turn = b2_pi / 4 * float(i);
            points.push_back(
                placed({ellipse.radius_x * std::cos(turn), ellipse.radius_y * std::sin(turn)},
                       ellipse.center, ellipse.angle));
        }
        make(points);
    }
    void operator()(const Concave& concave) const {
        World scratch;
        for (std::vector<Vec2> piece : scratch.create_shape(concave).pieces()) {
            // A piece with more vertices than Box2D allows is a fan of smaller ones.
            while (piece.size() > b2_maxPolygonVertices) {
                make({piece[0], piece[1], piece[2]});
                piece.erase(piece.begin() + 1);
            }
            make(piece);
        }
    }
    /// Box2D's chains are solid on the right side of their points, so these are reversed.
    void operator()(const Chain& chain) const {
        std::vector<b2Vec2> points;
        for (auto point = chain.points.rbegin(); point != chain.points.rend(); ++point)
            points.push_back(vec(*point));
        b2ChainShape geometry;
        if (chain.closed) {
            geometry.CreateLoop(points.data(), int32(points.size()));
        } else {
            const b2Vec2 before = 2 * points[0] - points[1];
            const b2Vec2 after = 2 * points.back() - points[points.size() - 2];
            geometry.CreateChain(points.data(), int32(points.size()), before, after);
        }
        make(geometry);
    }
};

class Box2dWorld : public RunningWorld {
  public:
    explicit Box2dWorld(const WorldPlan& plan) : plan_(plan), world_(vec(plan.def.gravity)) {
        world_.SetAllowSleeping(plan.def.sleeping);
        world_.SetContinuousPhysics(plan.def.continuous);
        ground_ = world_.CreateBody(&ground_def_);
        if (plan.def.bounds) enclose(*plan.def.bounds);
        for (const BodyPlan& body : plan.bodies) bodies_.push_back(make(body));
        for (const JointPlan& joint : plan.joints) add_joint(joint);
    }

    void prepare(int step) override {
        for (std::size_t i = 0; i < bodies_.size(); ++i)
            if (plan_.bodies[i].swing.hertz > 0)
                bodies_[i]->SetLinearVelocity(vec(plan_.bodies[i].swing.velocity(time_)));
        time_ += plan_.length_of(step);
    }
    void advance(float dt) override { world_.Step(dt, 8, 3); }

    void read(std::vector<BodyNow>& bodies) const override {
        bodies.assign(bodies_.size(), {});
        std::map<const b2Body*, int> index_of;
        for (std::size_t i = 0; i < bodies_.size(); ++i) {
            const b2Body& body = *bodies_[i];
            index_of[&body] = int(i);
            const float inertia =
                body.GetInertia() - body.GetMass() * body.GetLocalCenter().LengthSquared();
            bodies[i] = {.exists = true,
                         .awake = body.IsAwake(),
                         .type = plan_.bodies[i].def.type,
                         .position = vec(body.GetPosition()),
                         .angle = body.GetAngle(),
                         .velocity = vec(body.GetLinearVelocity()),
                         .angular_velocity = body.GetAngularVelocity(),
                         .center = vec(body.GetWorldCenter()),
                         .mass = body.GetMass(),
                         .inertia = inertia,
                         .gravity_scale = body.GetGravityScale()};
        }
        for (const b2Contact* c = world_.GetContactList(); c; c = c->GetNext()) {
            const b2Fixture &a = *c->GetFixtureA(), &b = *c->GetFixtureB();
            if (!c->IsTouching() || a.IsSensor() || b.IsSensor()) continue;
            b2WorldManifold manifold;
            c->GetWorldManifold(&manifold);
            const auto find = [&](const b2Fixture& fixture) {
                const auto found = index_of.find(fixture.GetBody());
                return found == index_of.end() ? the_world : found->second;
            };
            const int first = find(a), second = find(b);
            for (const auto& [of, other] : {std::pair(first, second), std::pair(second, first)}) {
                if (of == the_world) continue;
                BodyNow& body = bodies[std::size_t(of)];
                body.touched.push_back(other);
                const float sign = of == first ? -1.0f : 1.0f;
                if (other == the_world || bodies[std::size_t(other)].type != BodyType::dynamic_body)
                    body.held_by.push_back(sign * vec(manifold.normal));
                for (int k = 0; k < c->GetManifold()->pointCount; ++k)
                    body.deepest = std::max(body.deepest, -manifold.separations[k]);
            }
        }
    }

  private:
    void enclose(const Aabb& box) {
        ShapeDef surface;
        surface.friction = plan_.def.bounds_friction;
        surface.restitution = plan_.def.bounds_restitution;
        FixtureMaker{*ground_, surface}(
            Chain{{box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}}, true});
    }

    b2Body* make(const BodyPlan& plan) {
        b2BodyDef def;
        def.type = plan.def.type == BodyType::static_body      ? b2_staticBody
                   : plan.def.type == BodyType::kinematic_body ? b2_kinematicBody
                                                               : b2_dynamicBody;
        def.position = vec(plan.def.position);
        def.angle = plan.def.angle;
        def.linearVelocity = vec(plan.def.velocity);
        def.angularVelocity = plan.def.angular_velocity;
        def.linearDamping = plan.def.linear_damping;
        def.angularDamping = plan.def.angular_damping;
        def.gravityScale = plan.def.gravity_scale;
        def.fixedRotation = plan.def.locked_rotation;
        def.bullet = plan.def.bullet;
        b2Body* body = world_.CreateBody(&def);
        for (const ShapePlan& shape : plan.shapes)
            std::visit(FixtureMaker{*body, shape.def}, shape.geometry);
        return body;
    }

    /// Sets the members that all definitions of joints have.
    template <class Def>
    Def between(const JointPlan& plan) const {
        Def def;
        def.bodyA = plan.a == the_world ? ground_ : bodies_[std::size_t(plan.a)];
        def.bodyB = plan.b == the_world ? ground_ : bodies_[std::size_t(plan.b)];
        def.localAnchorA = vec(plan.anchor_a);
        def.localAnchorB = vec(plan.anchor_b);
        def.collideConnected = plan.collide;
        return def;
    }
    template <class Def>
    static void limit(Def& def, const JointPlan& plan) {
        def.lowerTranslation = plan.number("set_lower_translation", -b2_maxFloat);
        def.upperTranslation = plan.number("set_upper_translation", b2_maxFloat);
        def.enableLimit = def.upperTranslation < b2_maxFloat;
        def.motorSpeed = plan.number("set_motor_speed", 0);
    }

    void add_joint(const JointPlan& plan) {
        if (plan.type == JointType::revolute) {
            auto def = between<b2RevoluteJointDef>(plan);
            def.referenceAngle = plan.number("set_reference_angle", 0);
            def.lowerAngle = plan.number("set_lower_angle", -b2_maxFloat);
            def.upperAngle = plan.number("set_upper_angle", b2_maxFloat);
            def.enableLimit = def.upperAngle < b2_maxFloat;
            def.motorSpeed = plan.number("set_motor_speed", 0);
            def.maxMotorTorque = plan.number("set_max_motor_torque", 0);
            def.enableMotor = def.maxMotorTorque > 0;
            world_.CreateJoint(&def);
        } else if (plan.type == JointType::distance) {
            auto def = between<b2DistanceJointDef>(plan);
            def.length = def.minLength = def.maxLength = plan.number("set_length", 1);
            world_.CreateJoint(&def);
        } else if (plan.type == JointType::weld) {
            auto def = between<b2WeldJointDef>(plan);
            def.referenceAngle = plan.number("set_reference_angle", 0);
            if (const float hertz = plan.number("set_angular_hertz", infinity);
                std::isfinite(hertz))
                b2AngularStiffness(def.stiffness, def.damping, hertz, 0.7f, def.bodyA, def.bodyB);
            world_.CreateJoint(&def);
        } else if (plan.type == JointType::prismatic) {
            auto def = between<b2PrismaticJointDef>(plan);
            def.localAxisA = vec(plan.vector("set_axis", {1, 0}).normalized());
            def.referenceAngle = plan.number("set_reference_angle", 0);
            limit(def, plan);
            def.maxMotorForce = plan.number("set_max_motor_force", 0);
            def.enableMotor = def.maxMotorForce > 0;
            world_.CreateJoint(&def);
        } else {
            auto def = between<b2WheelJointDef>(plan);
            def.localAxisA = vec(plan.vector("set_axis", {0, 1}).normalized());
            limit(def, plan);
            def.maxMotorTorque = plan.number("set_max_motor_torque", 0);
            def.enableMotor = def.maxMotorTorque > 0;
            b2LinearStiffness(def.stiffness, def.damping, plan.number("set_hertz", 4),
                              plan.number("set_damping_ratio", 0.7f), def.bodyA, def.bodyB);
            world_.CreateJoint(&def);
        }
    }

    const WorldPlan& plan_;
    b2World world_;
    b2BodyDef ground_def_;
    b2Body* ground_ = nullptr;
    std::vector<b2Body*> bodies_;
    double time_ = 0;
};

}  // namespace

std::unique_ptr<RunningWorld> run_in_box2d(const WorldPlan& plan) {
    return has_all(plan) ? std::make_unique<Box2dWorld>(plan) : nullptr;
}

}  // namespace fettle::bench::wild
