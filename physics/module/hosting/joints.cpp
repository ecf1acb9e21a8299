#include <hosting/joints.h>

#include <hosting/hosting.h>

namespace fettle::physics_module {

Row Joints::create(Handle self, physics::JointType type) {
    hosting_.require_concrete(self);
    const Hosting::Placing placing(hosting_);
    const std::uint32_t number = hosting_.world_above(self);
    physics::World& world = hosting_.world_at(number)->world;
    set_connect_needed();
    return row_of(number, world.create_joint(type, pack(self)));
}

Row Joints::place(Handle self, Row row) {
    const std::uint32_t number = hosting_.world_above(self);
    hosting_.add_placed_joint(self);
    if (number == world_number(row)) return row;
    hosting_.require_unlocked(row);
    const Hosting::Placing placing(hosting_);
    const Row placed = row_of(number, hosting_.world_at(number)->world.create_joint(at(row)));
    put_ties(placed, ties(row));
    destroy(row);
    set_connect_needed();
    return placed;
}

void Joints::destroy(Row row) {
    hosting_.hosted(row).ties.reset(slot_of(row));
    if (hosting_.postpone(world_number(row), [this, row] { destroy(row); })) return;
    const Hosting::Placing placing(hosting_);
    at(row).destroy();
}

std::pair<physics::World*, physics::JointId> Joints::object_of(Row row) const {
    const auto [in, slot] = hosting_.at(row);
    return {&in.world, {slot, physics::HostAccess::joint_generation(in.world, slot)}};
}

Ties Joints::ties(Row row) const {
    return hosting_.hosted(row).ties.get(slot_of(row));
}

void Joints::put_ties(Row row, const Ties& ties) {
    hosting_.hosted(row).ties.set(slot_of(row), ties);
}

Handle Joints::body(Row row, std::size_t side) const {
    const Handle body = ties(row).bodies[side];
    return hosting_.tree.alive(body) ? body : Handle{};
}

void Joints::set_body(Row row, std::size_t side, Handle body) {
    Ties changed = ties(row);
    changed.bodies[side] = body;
    if (changed.source == Source::measured) changed.source = Source::none;
    at(row).disconnect();
    put_ties(row, changed);
    set_connect_needed();
}

void Joints::set_source(Row row, Source source) {
    Ties changed = ties(row);
    changed.source = source;
    if (source == Source::none) {
        at(row).disconnect();
        set_connect_needed();
    }
    put_ties(row, changed);
}

void Joints::disconnect_all(const physics::Body& body) {
    for (physics::Joint& joint : body.joints()) joint.disconnect();
}

physics::Vec2 Joints::world_anchor(Row row, std::size_t side) const {
    const physics::Joint joint = at(row);
    const physics::Vec2 anchor = side == 0 ? joint.anchor_a() : joint.anchor_b();
    const physics::Body tied = library_body(body(row, side));
    return tied ? tied.world_point(anchor) : anchor;
}

float Joints::angle_of(Row row, std::size_t side) const {
    const physics::Body tied = library_body(body(row, side));
    return tied ? tied.angle() : 0.0f;
}

physics::Body Joints::library_body(Handle body) const {
    return body ? hosting_.body(hosting_.tree.row(body)) : physics::Body();
}

bool Joints::can_act(std::uint32_t world, const Ties& ties) const {
    if (ties.bodies[0] == ties.bodies[1]) return false;
    for (const Handle body : ties.bodies) {
        if (!body) continue;  // the world
        if (!hosting_.tree.alive(body)) return false;
        if (world_number(hosting_.tree.row(body)) != world) return false;
    }
    return true;
}

/// Connects a dormant joint of `in`, the world with that number or a copy of it, if it can act.
/// Returns true if its value was measured.
bool Joints::connect_in(std::uint32_t number, physics::World& in, physics::Joint& joint) const {
    if (!joint.dormant()) return false;
    const Row row = make_row(number, joint.id().index);
    const Ties wanted = ties(row);
    if (!can_act(number, wanted)) return false;
    const auto tied = [&](Handle body) {
        return body ? in.body(library_body(body).id()) : physics::Body();
    };
    joint.connect(tied(wanted.bodies[0]), tied(wanted.bodies[1]));
    const Measure measure = measures[static_cast<std::size_t>(joint.type())];
    if (wanted.source != Source::none || measure == nullptr) return false;
    measure(hosting_, row, in);
    return true;
}

void Joints::connect() {
    if (!connect_needed_) return;
    connect_needed_ = false;
    for (std::uint32_t number = first_world; number < max_worlds; ++number) {
        HostedWorld* const in = hosting_.world_at(number);
        if (in == nullptr) continue;
        for (physics::Joint& joint : in->world.joints())
            if (connect_in(number, in->world, joint))
                set_source(make_row(number, joint.id().index), Source::measured);
    }
}

void Joints::connect_copy(std::uint32_t number, physics::World& copy) const {
    if (!connect_needed_) return;
    for (physics::Joint& joint : copy.joints()) connect_in(number, copy, joint);
}

}  // namespace fettle::physics_module
