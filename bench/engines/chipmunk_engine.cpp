// A scene in Chipmunk 7 with 10 iterations, its default. Chipmunk multiplies the friction and the
// restitution of two surfaces. Each shape gets the square root of its values, so the product is the
// geometric mean that the other engines use for friction. Its allowed overlap is made for lengths
// in pixels; Box2D's half a centimeter is used instead.

#include <chipmunk/chipmunk.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <vector>

#include "engines/engine.h"

namespace fettle::bench {
namespace {

cpVect vec(Point p) {
    return cpv(p.x, p.y);
}
Point point(cpVect v) {
    return {static_cast<float>(v.x), static_cast<float>(v.y)};
}

/// Makes one shape on `body`; on a dynamic body with its mass.
struct ShapeMaker {
    cpBody& body;

    cpShape* operator()(const CircleShape& circle) const {
        return cpCircleShapeNew(&body, circle.radius, vec(circle.center));
    }
    cpShape* operator()(const BoxShape& box) const {
        return cpBoxShapeNew2(&body,
                              cpBBNew(box.center.x - box.half.x, box.center.y - box.half.y,
                                      box.center.x + box.half.x, box.center.y + box.half.y),
                              box.rounding);
    }
    cpShape* operator()(const SegmentShape& segment) const {
        return cpSegmentShapeNew(&body, vec(segment.from), vec(segment.to), segment.radius);
    }
    cpShape* operator()(const PolygonShape& polygon) const {
        std::vector<cpVect> points;
        for (const Point& p : polygon.vertices) points.push_back(vec(p));
        return cpPolyShapeNew(&body, static_cast<int>(points.size()), points.data(),
                              cpTransformIdentity, polygon.rounding);
    }
    cpShape* operator()(const EllipseShape&) const {
        throw std::invalid_argument("Chipmunk has no ellipses");
    }
    cpShape* operator()(const ChainShape&) const {
        throw std::logic_error("a chain is made segment by segment");
    }
};

/// A chain in Chipmunk: segments with known neighbors.
std::vector<cpShape*> make_chain(cpBody& body, const ChainShape& chain) {
    const std::size_t n = chain.points.size(), segments = chain.closed ? n : n - 1;
    std::vector<cpShape*> made;
    for (std::size_t i = 0; i < segments; ++i) {
        const auto at = [&](std::size_t k) { return vec(chain.points[k % n]); };
        cpShape* segment = cpSegmentShapeNew(&body, at(i), at(i + 1), 0);
        const bool first = !chain.closed && i == 0, end = !chain.closed && i + 1 == segments;
        cpSegmentShapeSetNeighbors(segment, first ? at(i) : at(i + n - 1),
                                   end ? at(i + 1) : at(i + 2));
        made.push_back(segment);
    }
    return made;
}

/// The first space prints a greeting to standard output, which is only for tables and JSON lines.
/// So it is redirected to the error stream.
cpSpace* new_space() {
    std::fflush(stdout);
    const int output = dup(STDOUT_FILENO);
    dup2(STDERR_FILENO, STDOUT_FILENO);
    cpSpace* space = cpSpaceNew();
    std::fflush(stdout);
    dup2(output, STDOUT_FILENO);
    close(output);
    return space;
}

void count_arbiter(cpBody*, cpArbiter* arbiter, void* count) {
    *static_cast<std::size_t*>(count) += cpArbiterGetCount(arbiter) > 0 ? 1 : 0;
}

class ChipmunkEngine : public Engine {
  public:
    explicit ChipmunkEngine(const Scene& scene) : space_(new_space()) {
        cpSpaceSetGravity(space_, vec(scene.gravity));
        cpSpaceSetIterations(space_, 10);
        cpSpaceSetCollisionSlop(space_, 0.005);
        if (scene.sleeping) cpSpaceSetSleepTimeThreshold(space_, 0.5);
        bodies_.reserve(scene.bodies.size());
        for (const SceneBody& body : scene.bodies) bodies_.push_back(make(body));
        for (const SceneJoint& joint : scene.joints) add_joint(joint);
        for (std::size_t i = 0; i < bodies_.size(); ++i) {
            if (scene.sleeping && !scene.bodies[i].awake) cpBodySleep(bodies_[i]);
        }
    }

    ~ChipmunkEngine() override {
        for (cpConstraint* joint : joints_) {
            cpSpaceRemoveConstraint(space_, joint);
            cpConstraintFree(joint);
        }
        for (cpShape* shape : shapes_) {
            cpSpaceRemoveShape(space_, shape);
            cpShapeFree(shape);
        }
        for (cpBody* body : bodies_) {
            cpSpaceRemoveBody(space_, body);
            cpBodyFree(body);
        }
        cpSpaceFree(space_);
    }

    void step() override { cpSpaceStep(space_, time_step); }

    BodyMotion motion(std::size_t index) const override {
        const cpBody* body = bodies_[index];
        return {point(cpBodyGetPosition(body)), static_cast<float>(cpBodyGetAngle(body)),
                point(cpBodyGetVelocity(body)), static_cast<float>(cpBodyGetAngularVelocity(body))};
    }

    void set_velocity(std::size_t body, Point velocity) override {
        cpBodySetVelocity(bodies_[body], vec(velocity));
    }

    std::size_t contacts() const override {
        std::size_t seen = 0;  // each contact is counted from both bodies
        for (cpBody* body : bodies_) cpBodyEachArbiter(body, count_arbiter, &seen);
        return seen / 2;
    }

    std::size_t bodies() const override { return bodies_.size(); }

  private:
    void add_joint(const SceneJoint& joint) {
        cpBody* a = bodies_[joint.body_a];
        cpBody* b = bodies_[joint.body_b];
        add_constraint(cpPivotJointNew(a, b, vec(joint.anchor)));
        if (joint.motor_torque <= 0) return;
        cpConstraint* motor = cpSimpleMotorNew(a, b, -joint.motor_speed);
        cpConstraintSetMaxForce(motor, joint.motor_torque);
        add_constraint(motor);
    }

    void add_constraint(cpConstraint* joint) {
        cpConstraintSetCollideBodies(joint, cpFalse);
        cpSpaceAddConstraint(space_, joint);
        joints_.push_back(joint);
    }

    cpBody* make(const SceneBody& description) {
        cpBody* body = description.motion == Motion::fixed       ? cpBodyNewStatic()
                       : description.motion == Motion::kinematic ? cpBodyNewKinematic()
                                                                 : cpBodyNew(0, 0);
        cpSpaceAddBody(space_, body);
        for (const SceneShape& shape : description.shapes) add(*body, shape, description.motion);
        cpBodySetPosition(body, vec(description.position));
        cpBodySetAngle(body, description.angle);
        if (description.motion != Motion::fixed) {
            cpBodySetVelocity(body, vec(description.velocity));
            cpBodySetAngularVelocity(body, description.angular_velocity);
        } else {
            cpSpaceReindexShapesForBody(space_, body);
        }
        return body;
    }

    void add(cpBody& body, const SceneShape& description, Motion motion) {
        std::vector<cpShape*> made;
        if (const auto* chain = std::get_if<ChainShape>(&description.geometry))
            made = make_chain(body, *chain);
        else
            made = {std::visit(ShapeMaker{body}, description.geometry)};
        for (cpShape* shape : made) finish(shape, description, motion);
    }

    void finish(cpShape* shape, const SceneShape& description, Motion motion) {
        if (motion == Motion::dynamic) cpShapeSetDensity(shape, description.density);
        cpShapeSetFriction(shape, std::sqrt(description.friction));
        cpShapeSetElasticity(shape, std::sqrt(description.restitution));
        cpShapeSetFilter(shape,
                         cpShapeFilterNew(CP_NO_GROUP, description.category, description.mask));
        cpSpaceAddShape(space_, shape);
        shapes_.push_back(shape);
    }

    cpSpace* space_;
    std::vector<cpBody*> bodies_;
    std::vector<cpShape*> shapes_;
    std::vector<cpConstraint*> joints_;
};

}  // namespace

std::unique_ptr<Engine> make_chipmunk(const Scene& scene) {
    return std::make_unique<ChipmunkEngine>(scene);
}

}  // namespace fettle::bench
