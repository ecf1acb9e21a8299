#include "wild/plans/fettle_world.h"

#include <fettle/physics/host_access.h>
#include <algorithm>

#include "wild/plans/setters.h"

namespace fettle::bench::wild {

FettleWorld::FettleWorld(const WorldPlan& plan)
    : plan_(plan),
      world_(plan.def),
      ids_of_bodies_(plan.bodies.size()),
      ids_of_shapes_(plan.bodies.size()),
      ids_of_joints_(plan.joints.size()) {
    for (const FieldDef& field : plan.fields) world_.create_field(field);
}

FettleWorld::FettleWorld(const FettleWorld& other)
    : RunningWorld(),
      plan_(other.plan_),
      world_(other.world_.clone()),
      ids_of_bodies_(other.ids_of_bodies_),
      ids_of_shapes_(other.ids_of_shapes_),
      ids_of_joints_(other.ids_of_joints_),
      time_(other.time_) {}

FettleWorld::FettleWorld(const FettleWorld& other, std::span<const std::byte> bytes)
    : plan_(other.plan_),
      ids_of_bodies_(other.ids_of_bodies_),
      ids_of_shapes_(other.ids_of_shapes_),
      ids_of_joints_(other.ids_of_joints_),
      time_(other.time_) {
    world_.restore(bytes);
}

std::unique_ptr<FettleWorld> FettleWorld::restored() const {
    std::vector<std::byte> bytes;
    world_.save(bytes);
    return std::unique_ptr<FettleWorld>(new FettleWorld(*this, bytes));
}

void FettleWorld::make_body(std::size_t index) {
    const BodyPlan& plan = plan_.bodies[index];
    Body made = world_.create_body(plan.def);
    for (const ShapePlan& shape : plan.shapes)
        ids_of_shapes_[index].push_back(made.add(shape.geometry, shape.def).id());
    ids_of_bodies_[index] = made.id();
}

void FettleWorld::make_joint(std::size_t index) {
    const JointPlan& plan = plan_.joints[index];
    const auto end = [&](int of) { return of == the_world ? Body() : body(of); };
    if ((plan.a != the_world && !end(plan.a)) || (plan.b != the_world && !end(plan.b))) return;
    Joint made = world_.create_joint(plan.type);
    made.connect(end(plan.a), end(plan.b));
    made.set_anchor_a(plan.anchor_a);
    made.set_anchor_b(plan.anchor_b);
    made.set_collide(plan.collide);
    for (const Setting& setting : plan.settings)
        setter_named(setting.setter, Target::joint, plan.type)
            .call({.world = world_, .joint = made.id()}, setting.value);
    ids_of_joints_[index] = made.id();
}

void FettleWorld::edit(const Edit& edit) {
    const auto object = std::size_t(edit.object);
    SetterTarget target{.world = world_};
    JointType joint{};
    switch (edit.target) {
        case Target::world:
            break;
        case Target::body:
            target.body = body(edit.object);
            if (!target.body) return;
            break;
        case Target::shape:
            if (std::size_t(edit.shape) >= ids_of_shapes_[object].size()) return;
            target.shape = world_.shape(ids_of_shapes_[object][std::size_t(edit.shape)]);
            if (!target.shape) return;
            break;
        case Target::joint:
            target.joint = ids_of_joints_[object];
            if (!world_.is_valid(target.joint)) return;
            joint = plan_.joints[object].type;
            break;
    }
    if (edit.geometry)
        target.shape.set_geometry(*edit.geometry);
    else
        setter_named(edit.setting.setter, edit.target, joint).call(target, edit.setting.value);
}

void FettleWorld::prepare(int step) {
    const auto read = [&] {
        if (reads_) world_.refresh();
    };
    for (std::size_t i = 0; i < plan_.bodies.size(); ++i) {
        if (plan_.bodies[i].born != step) continue;
        make_body(i);
        if (i % 3 == 0) read();
    }
    for (std::size_t i = 0; i < plan_.joints.size(); ++i)
        if (plan_.joints[i].born == step) make_joint(i);
    for (const Edit& each : plan_.edits) {
        if (each.step != step) continue;
        edit(each);
        read();
    }
    for (std::size_t i = 0; i < plan_.bodies.size(); ++i) {
        const Swing& swing = plan_.bodies[i].swing;
        if (swing.hertz > 0 && world_.is_valid(ids_of_bodies_[i]))
            body(int(i)).set_velocity(swing.velocity(time_));
    }
    time_ += plan_.length_of(step);
    read();
}

void FettleWorld::read(std::vector<BodyNow>& bodies) const {
    bodies.assign(plan_.bodies.size(), {});
    std::vector<int> index_of(HostAccess::body_slots(world_), the_world);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        if (!world_.is_valid(ids_of_bodies_[i])) continue;
        const Body body = world_.body(ids_of_bodies_[i]);
        index_of[body.index()] = int(i);
        bodies[i] = {.exists = true,
                     .awake = body.awake(),
                     .slot = body.index(),
                     .type = body.type(),
                     .position = body.position(),
                     .angle = body.angle(),
                     .velocity = body.velocity(),
                     .angular_velocity = body.angular_velocity(),
                     .center = body.world_center(),
                     .mass = body.mass(),
                     .inertia = body.inertia(),
                     .gravity_scale = body.gravity_scale()};
    }
    const auto touch = [&](BodyId id, BodyId other_id, float overlap, float force, Vec2 normal) {
        if (index_of[id.index] == the_world) return;
        BodyNow& body = bodies[std::size_t(index_of[id.index])];
        const int other = index_of[other_id.index];
        body.touched.push_back(other);
        if (other == the_world || bodies[std::size_t(other)].type != BodyType::dynamic_body)
            body.held_by.push_back(normal);
        body.deepest = std::max(body.deepest, overlap);
        body.load += force;
    };
    for (const Contact& contact : world_.contacts()) {
        float overlap = 0;
        for (int k = 0; k < contact.point_count; ++k)
            overlap = std::max(overlap, -contact.points[std::size_t(k)].separation);
        touch(contact.body_a, contact.body_b, overlap, contact.normal_force, -contact.normal);
        touch(contact.body_b, contact.body_a, overlap, contact.normal_force, contact.normal);
    }
}

std::unique_ptr<RunningWorld> run_in_fettle(const WorldPlan& plan) {
    return std::make_unique<FettleWorld>(plan);
}

}  // namespace fettle::bench::wild
