#include "engines/hosted_engine.h"

#include <fettle/property/path.h>

#include <cmath>
#include <stdexcept>
#include <string>

namespace fettle::bench {
namespace {

using property::Handle;
using property::Tree;
using property::Value;

Value value(Point p) {
    return property::Vec2(static_cast<double>(p.x), static_cast<double>(p.y));
}

property::List values(const std::vector<Point>& points) {
    property::List all;
    for (const Point& point : points) all.push_back(value(point));
    return all;
}

/// Makes one shape below `body` and sets its geometry.
struct ShapeMaker {
    Tree& tree;
    Handle body;

    Handle make(std::string_view kind) const { return tree.create(tree.class_named(kind), body); }
    Handle operator()(const CircleShape& circle) const {
        const Handle made = make("Circle");
        tree.set(made, "radius", circle.radius);
        tree.set(made, "center", value(circle.center));
        return made;
    }
    Handle operator()(const BoxShape& box) const {
        const Handle made = make("Box");
        tree.set(made, "width", 2 * (box.half.x + box.rounding));
        tree.set(made, "height", 2 * (box.half.y + box.rounding));
        tree.set(made, "rounding", box.rounding);
        tree.set(made, "center", value(box.center));
        return made;
    }
    Handle operator()(const SegmentShape& segment) const {
        const Handle made = make(segment.radius > 0 ? "Capsule" : "Segment");
        if (segment.radius > 0) tree.set(made, "radius", segment.radius);
        tree.set(made, "from", value(segment.from));
        tree.set(made, "to", value(segment.to));
        return made;
    }
    Handle operator()(const PolygonShape& polygon) const {
        const Handle made = make("Polygon");
        tree.set(made, "vertices", values(polygon.vertices));
        tree.set(made, "rounding", polygon.rounding);
        return made;
    }
    Handle operator()(const EllipseShape& ellipse) const {
        const Handle made = make("Ellipse");
        tree.set(made, "radius_x", ellipse.radii.x);
        tree.set(made, "radius_y", ellipse.radii.y);
        return made;
    }
    Handle operator()(const ChainShape& chain) const {
        const Handle made = make("Chain");
        tree.set(made, "points", values(chain.points));
        tree.set(made, "closed", chain.closed);
        return made;
    }
};

const char* type_name(Motion motion) {
    switch (motion) {
        case Motion::fixed:
            return "static";
        case Motion::kinematic:
            return "kinematic";
        case Motion::dynamic:
            break;
    }
    return "dynamic";
}

}  // namespace

HeadlessGame::HeadlessGame()
    : services(with_physics()), runtime(tree, {}), loop(tree, runtime, services) {
    loop.add({.name = std::string(physics.name()),
              .step = [this](double dt) { physics.step(dt); },
              .report = [this] { physics.report(tree); },
              .hash = [this] { return physics.hash(); }});
    tree.on_handler_error([](const property::HandlerError& error) {
        throw std::runtime_error(error.path + ": " + error.message);
    });
    runtime.on_error(
        [](const script::ScriptError& error) { throw std::runtime_error(error.message); });
}

Tree& HeadlessGame::with_physics() {
    physics.attach(tree);
    return tree;
}

HostedEngine::HostedEngine(const Scene& scene, bool keeps_past)
    : world_(game_.tree.child(game_.tree.root(), "world")) {
    Tree& tree = game_.tree;
    if (!keeps_past) property::set(tree, "time.rewind_limit", 0.0);
    tree.set(world_, "gravity", value(scene.gravity));
    tree.set(world_, "sleeping", scene.sleeping);
    tree.set(world_, "continuous", scene.continuous);
    const property::Class& body = tree.class_named("Body");
    position_ = body.property("position");
    angle_ = body.property("angle");
    velocity_ = body.property("velocity");
    angular_velocity_ = body.property("angular_velocity");
    bodies_.reserve(scene.bodies.size());
    for (const SceneBody& description : scene.bodies) bodies_.push_back(make(description));
    for (const SceneJoint& joint : scene.joints) add_joint(bodies_, scene.bodies, joint);
    groups_.resize(scene.groups.size());
    tree.barrier();
    // Last, because a new contact wakes a sleeping body.
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        if (!scene.bodies[i].awake) tree.set(bodies_[i], "awake", false);
    }
}

Handle HostedEngine::make(const SceneBody& description) {
    Tree& tree = game_.tree;
    const Handle body = tree.create(tree.class_named("Body"), world_);
    tree.set(body, "type", type_name(description.motion));
    tree.set(body, *position_, value(description.position));
    tree.set(body, *angle_, description.angle);
    tree.set(body, *velocity_, value(description.velocity));
    tree.set(body, *angular_velocity_, description.angular_velocity);
    tree.set(body, "bullet", description.bullet);
    tree.set(body, "can_sleep", description.can_sleep);
    tree.set(body, "linear_damping", description.linear_damping);
    for (const SceneShape& shape : description.shapes) {
        const Handle made = std::visit(ShapeMaker{tree, body}, shape.geometry);
        tree.set(made, "density", shape.density);
        tree.set(made, "friction", shape.friction);
        tree.set(made, "restitution", shape.restitution);
        tree.set(made, "category", std::int64_t{shape.category});
        tree.set(made, "mask", std::int64_t{shape.mask});
        tree.set(made, "group", shape.group);
        // The tree enables impact events when a handler is registered. Here there is none, so they
        // are enabled directly.
        if (shape.hit_events) game_.physics.shape(made).set_hit_events(true);
    }
    return body;
}

void HostedEngine::add_joint(const std::vector<Handle>& bodies,
                             const std::vector<SceneBody>& described, const SceneJoint& joint) {
    Tree& tree = game_.tree;
    const Handle made = tree.create(tree.class_named("RevoluteJoint"), world_);
    tree.set(made, "body_a", bodies[joint.body_a]);
    tree.set(made, "body_b", bodies[joint.body_b]);
    tree.set(made, "anchor_a", value(local_anchor(described, joint.body_a, joint.anchor)));
    tree.set(made, "anchor_b", value(local_anchor(described, joint.body_b, joint.anchor)));
    if (joint.motor_torque > 0) {
        tree.set(made, "motor_speed", joint.motor_speed);
        tree.set(made, "max_motor_torque", joint.motor_torque);
    }
    if (joint.hertz > 0) {
        tree.set(made, "hertz", joint.hertz);
        tree.set(made, "damping_ratio", joint.damping_ratio);
    }
    if (joint.reference != 0) tree.set(made, "reference_angle", joint.reference);
    if (joint.lower == -unlimited && joint.upper == unlimited) return;
    tree.set(made, "lower_angle", joint.lower);
    tree.set(made, "upper_angle", joint.upper);
}

/// A group is a node with its bodies and joints below it; it is deleted as a whole.
void HostedEngine::replace_group(std::size_t group, const SceneGroup& description) {
    Tree& tree = game_.tree;
    Group& of = groups_[group];
    if (of.node) tree.destroy(of.node);
    const Handle world = world_;
    world_ = of.node = tree.create(tree.object_class(), world);
    of.bodies.clear();
    for (const SceneBody& body : description.bodies) of.bodies.push_back(make(body));
    for (const SceneJoint& joint : description.joints)
        add_joint(of.bodies, description.bodies, joint);
    world_ = world;
    tree.barrier();
}

void HostedEngine::step() {
    game_.loop.turn();
}

BodyMotion HostedEngine::motion(std::size_t index) const {
    return motion_of(bodies_[index]);
}

void HostedEngine::mix_groups(std::uint64_t& hash) const {
    for (const Group& group : groups_)
        for (const Handle body : group.bodies) mix(hash, motion_of(body));
}

BodyMotion HostedEngine::motion_of(Handle body) const {
    const Tree& tree = game_.tree;
    const auto point = [](const Value& v) {
        return Point{static_cast<float>(v.vec2().x), static_cast<float>(v.vec2().y)};
    };
    return {point(tree.get(body, *position_)), static_cast<float>(tree.get(body, *angle_).number()),
            point(tree.get(body, *velocity_)),
            static_cast<float>(tree.get(body, *angular_velocity_).number())};
}

void HostedEngine::set_velocity(std::size_t body, Point velocity) {
    game_.tree.set(bodies_[body], *velocity_, value(velocity));
}

void HostedEngine::set_threads(int threads) {
    property::set(game_.tree, game_.tree.path(world_) + ".threads", threads);
}

void HostedEngine::edit_velocity(std::size_t body, Point velocity) {
    Tree& tree = game_.tree;
    const Tree::CauseScope cause(tree, property::Writer::console);
    const std::string path = tree.path(bodies_[body]) + ".velocity";
    property::set(tree, path, value(velocity));
    if (property::get(tree, path) != value(velocity))
        throw std::runtime_error(path + " does not have the value that was set");
}

std::size_t HostedEngine::contacts() const {
    return game_.physics.world(world_).contacts().size();
}

std::size_t HostedEngine::bodies() const {
    return game_.physics.world(world_).body_count();
}

void HostedEngine::watch_positions(double share) {
    const auto count =
        static_cast<std::size_t>(std::lround(share * static_cast<double>(bodies_.size())));
    for (std::size_t i = 0; i < count; ++i) {
        // Spread evenly, so that watched bodies are not all neighbors in memory.
        const Handle body = bodies_[i * bodies_.size() / count];
        game_.tree.watch(body, *position_, [this](const property::Change&) { ++changes_seen_; });
    }
}

std::unique_ptr<Engine> make_hosted(const Scene& scene) {
    return std::make_unique<HostedEngine>(scene);
}

}  // namespace fettle::bench
