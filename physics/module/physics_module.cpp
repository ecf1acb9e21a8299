#include <fettle/physics_module/physics_module.h>

#include <stdexcept>

#include <fettle/property/error.h>

#include "classes.h"
#include "hosting.h"

namespace fettle::physics_module {
namespace {

const property::Class& require_class(const Hosting& hosting, Handle instance,
                                     const property::Class& wanted) {
    const property::Class& is = hosting.tree.class_of(instance);
    if (!is.is_a(wanted))
        throw property::Error(
            property::ErrorKind::wrong_type,
            hosting.tree.path(instance) + ": expected a " + wanted.name() + ", got a " + is.name());
    return is;
}

}  // namespace

PhysicsModule::PhysicsModule() = default;
PhysicsModule::~PhysicsModule() = default;

void PhysicsModule::attach(property::Tree& tree) {
    if (hosting_) throw std::logic_error("physics is attached to a tree already");
    hosting_ = std::make_unique<Hosting>(tree, *this);
    tree.add_part(*this);
    define_step_statistics(*hosting_);
    define_world(*hosting_);
    define_body(*hosting_);
    define_shapes(*hosting_);
    define_joints(*hosting_);
    define_fields(*hosting_);
    tree.create(*hosting_->world_class, tree.root(), "world");
}

/// Whoever steps a module before it was attached hears of it.
Hosting& PhysicsModule::hosting() const {
    if (!hosting_) throw std::logic_error("physics is attached to no tree: call attach first");
    return *hosting_;
}

void PhysicsModule::step(double dt) {
    const Hosting::Doing step(hosting());
    hosting().follow_listeners();
    hosting().joints.tighten();
    for (std::uint32_t n = first_world; n < most_worlds; ++n) {
        HostedWorld* hosted = hosting().world_at(n);
        if (hosted == nullptr || !hosted->placed) continue;
        if (hosted->unreported) {  // nobody asked: nothing is kept for who may never do
            hosted->departed_bodies.clear();
            hosted->departed_shapes.clear();
        }
        hosted->world.step(static_cast<float>(dt));
        hosted->unreported = true;
    }
}

void PhysicsModule::report(property::Tree& tree) {
    tree.stepped();
    for (std::uint32_t n = first_world; n < most_worlds; ++n) {
        HostedWorld* hosted = hosting().world_at(n);
        if (hosted == nullptr || !hosted->unreported) continue;
        hosted->unreported = false;
        hosting().report(*hosted);
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
    for (std::uint32_t n = first_world; n < most_worlds; ++n) {
        const HostedWorld* hosted = hosting().world_at(n);
        if (hosted == nullptr || !hosted->placed) continue;
        // One world alone has its own hash: 0 · anything is 0.
        combined = combined * 0x9e3779b97f4a7c15u ^ hosted->world.hash();
    }
    return combined;
}

physics::World& PhysicsModule::world(Handle instance) {
    if (hosting().tree.class_of(instance).is_a(*hosting().world_class))
        return hosting().world(hosting().tree.row(instance));
    return hosting().world_at(hosting().world_above(instance))->world;
}

physics::Body PhysicsModule::body(Handle instance) {
    require_class(hosting(), instance, *hosting().body_class);
    return hosting().body(hosting().tree.row(instance));
}

physics::Shape PhysicsModule::shape(Handle instance) {
    require_class(hosting(), instance, *hosting().shape_class);
    return hosting().shape(hosting().tree.row(instance));
}

Handle PhysicsModule::handle(const physics::Body& body) const {
    return body ? unpack(body.user_data()) : Handle{};
}

Handle PhysicsModule::handle(const physics::Shape& shape) const {
    return shape ? unpack(shape.user_data()) : Handle{};
}

}  // namespace fettle::physics_module
