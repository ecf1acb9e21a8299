#include <fettle/physics_module/physics_module.h>

#include <algorithm>
#include <exception>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include <fettle/property/ended_class.h>
#include <fettle/property/error.h>
#include <fettle/property/spelling.h>

#include <bodies/body_class.h>
#include <fields/field_classes.h>
#include <hosting/hosting.h>
#include <joints/joint_classes.h>
#include <movers/mover_class.h>
#include <shapes/shape_classes.h>
#include <worlds/world_class.h>

namespace fettle::physics_module {
namespace {

constexpr std::string_view world_name = "world";

const property::Class& require_class(const Hosting& hosting, Handle instance,
                                     const property::Class& wanted) {
    const property::Class& is = hosting.tree.class_of(instance);
    if (!is.is_a(wanted))
        throw property::Error(property::ErrorKind::wrong_type,
                              hosting.tree.path(instance) + ": expected " +
                                  property::with_article(wanted.name()) + ", got " +
                                  property::with_article(is.name()));
    return is;
}

void define_all(Hosting& hosting) {
    define_step_statistics(hosting);
    define_world(hosting);
    define_body(hosting);
    define_shapes(hosting);
    define_mover(hosting);
    define_joints(hosting);
    define_fields(hosting);
}

/// The classes of `define_all`; a test compares the two. A class cannot be removed, so `attach`
/// checks that none of them exists before it defines the first.
constexpr const char* class_names[] = {"StepStatistics", "World",
                                       "Body",           "Shape",
                                       "Circle",         "Box",
                                       "Segment",        "Capsule",
                                       "Polygon",        "Ellipse",
                                       "Concave",        "Chain",
                                       "Joint",          "PairJoint",
                                       "MouseJoint",     "DistanceJoint",
                                       "RevoluteJoint",  "PrismaticJoint",
                                       "PinSlotJoint",   "GrooveJoint",
                                       "WheelJoint",     "WeldJoint",
                                       "MotorJoint",     "PulleyJoint",
                                       "GearJoint",      "RatchetJoint",
                                       "FilterJoint",    "RotaryLimitJoint",
                                       "Field",          "Wind",
                                       "Drag",           "Buoyancy",
                                       "Attractor",      "Mover"};

/// Throws if a name that `attach` needs is already used in the tree.
void require_free_names(const property::Tree& tree) {
    const auto refuse = [](const std::string& what) {
        throw property::Error(property::ErrorKind::bad_name, "physics cannot be attached: " + what);
    };
    const auto taken = [&](const char* name) { return tree.find_class(name) != nullptr; };
    if (std::ranges::all_of(class_names, taken))
        refuse(
            "the tree has its classes already; a tree takes physics once only, also when the "
            "first has ended: make another tree");
    for (const char* name : class_names)
        if (taken(name)) refuse("the tree has a class \"" + std::string(name) + "\" already");
    const Handle root = tree.root();
    if (tree.child(root, world_name) || tree.find(root, world_name) != nullptr ||
        tree.class_of(root).method(world_name) != nullptr)
        refuse("the root has a \"" + std::string(world_name) + "\" already");
}

}  // namespace

PhysicsModule::PhysicsModule() = default;

PhysicsModule::~PhysicsModule() {
    if (!hosting_ || hosting_->tree_life.expired()) return;
    hosting_->require_idle();
    property::Tree& tree = hosting_->tree;
    tree.remove_part(*this);
    for (const char* name : class_names) property::end_class(tree, tree.class_named(name));
}

void PhysicsModule::attach(property::Tree& tree) {
    if (hosting_) throw std::logic_error("physics is attached to a tree already");
    require_free_names(tree);
    tree.add_part(*this);
    try {
        hosting_ = std::make_unique<Hosting>(tree, *this);
        define_all(*hosting_);
    } catch (...) {
        tree.remove_part(*this);
        hosting_.reset();
        throw;
    }
    tree.create(*hosting_->classes.world, tree.root(), world_name);
}

/// Throws if the module is used before it was attached, or after the end of its tree.
Hosting& PhysicsModule::hosting() const {
    if (!hosting_) throw std::logic_error("physics is attached to no tree: call attach first");
    if (hosting_->tree_may_end && hosting_->tree_life.expired())
        throw std::logic_error("the tree that physics was attached to was destroyed");
    return *hosting_;
}

void PhysicsModule::on_problem(std::function<void(const std::string&)> listener) {
    hosting().on_problem = std::move(listener);
}

void PhysicsModule::step(double dt) {
    if (!(dt >= 0) || dt > std::numeric_limits<float>::max())
        throw std::invalid_argument("PhysicsModule::step: dt = " + property::number_text(dt) +
                                    ": expected a time from 0 to 3.4e38 s");
    const Hosting::EditScope step(hosting());
    if (dt > 0) hosting().last_dt = dt;
    hosting().update_callbacks();
    hosting().joints.connect();
    hosting().report_strays();
    std::exception_ptr thrown;
    std::int64_t contacts = 0;
    for (std::uint32_t n = first_world; n < max_worlds; ++n) {
        HostedWorld* hosted = hosting().world_at(n);
        if (hosted == nullptr || !hosted->placed) continue;
        if (hosted->unreported) {  // no `report` was called: old events are dropped
            hosted->departed_bodies.clear();
            hosted->departed_shapes.clear();
        }
        const bool makes_step = !hosted->world.locked();  // false: this is called inside of a step
        // If a user function throws, other worlds are stepped all the same and this world's events
        // are kept: its step is complete.
        try {
            move_movers(*hosted, static_cast<float>(dt));
            hosted->world.step(static_cast<float>(dt));
        } catch (...) {
            if (!thrown) thrown = std::current_exception();
        }
        if (hosting().world_at(n) != hosted) continue;
        if (makes_step) hosted->unreported = true;
        contacts += hosted->world.statistics().contacts;
    }
    hosting().weigh_contacts(contacts);
    if (thrown) std::rethrow_exception(thrown);
}

void PhysicsModule::report(property::Tree& tree) {
    if (&tree != &hosting().tree)
        throw std::invalid_argument(
            "PhysicsModule::report: expected the tree that physics is attached to, got another");
    tree.stepped();
    for (std::uint32_t n = first_world; n < max_worlds; ++n) {
        HostedWorld* hosted = hosting().world_at(n);
        if (hosted == nullptr || !hosted->unreported) continue;
        hosted->unreported = false;
        hosting().report(*hosted);
        if (hosting().world_at(n) == hosted) report_movers(hosting(), *hosted);
    }
}

property::Memory PhysicsModule::save(property::ByteWriter& to) const {
    hosting().save(to);
    return {};
}

std::function<void()> PhysicsModule::restore(property::ByteReader& from, const property::Memory&) {
    return hosting().restore(from);
}

void PhysicsModule::refresh(std::uint64_t what) {
    hosting().refresh(what);
}

std::uint64_t PhysicsModule::hash() const {
    std::uint64_t combined = 0;
    for (std::uint32_t n = first_world; n < max_worlds; ++n) {
        const HostedWorld* hosted = hosting().world_at(n);
        if (hosted == nullptr || !hosted->placed) continue;
        // The hash of a single world is not changed: 0 · anything is 0.
        combined = combined * 0x9e3779b97f4a7c15u ^ hosted->world.hash();
    }
    return combined;
}

physics::World& PhysicsModule::world(Handle instance) {
    if (hosting().tree.class_of(instance).is_a(*hosting().classes.world))
        return hosting().world(hosting().tree.row(instance));
    return hosting().world_at(hosting().world_above(instance))->world;
}

physics::Body PhysicsModule::body(Handle instance) {
    require_class(hosting(), instance, *hosting().classes.body);
    return hosting().body(hosting().tree.row(instance));
}

physics::Shape PhysicsModule::shape(Handle instance) {
    require_class(hosting(), instance, *hosting().classes.shape);
    return hosting().shape(hosting().tree.row(instance));
}

Handle PhysicsModule::handle(const physics::Body& body) const {
    return body ? hosting().instance_of(body.user_data()) : Handle{};
}

Handle PhysicsModule::handle(const physics::Shape& shape) const {
    return shape ? hosting().instance_of(shape.user_data()) : Handle{};
}

}  // namespace fettle::physics_module
