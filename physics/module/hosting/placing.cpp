// Placing: instances are created, moved and deleted, and their objects in the library follow.
//
// A body is in the world of the nearest World above it, a shape on the nearest Body. An instance
// without these is in limbo, a world that is never stepped: it can be read and edited, too.

#include <algorithm>
#include <unordered_set>
#include <utility>

#include <fettle/property/error.h>

#include <hosting/hosting.h>

namespace fettle::physics_module {

void Hosting::require_concrete(Handle self) const {
    const property::Class& of = tree.class_of(self);
    if (std::ranges::find(classes.abstract, &of) != classes.abstract.end())
        throw property::Error(property::ErrorKind::bad_structure,
                              of.name() +
                                  ": it cannot be made: it is what several classes have in "
                                  "common");
}

// --- Worlds

Row Hosting::create_world(Handle self) {
    const EditScope placing(*this);
    std::uint32_t number = first_world;
    while (number < max_worlds && worlds_[number] != nullptr) ++number;
    if (number == max_worlds)
        throw property::Error(
            property::ErrorKind::rejected,
            "there can be at most " + std::to_string(max_worlds - 1) + " worlds at a time");
    worlds_[number] = make_world(number);
    worlds_[number]->self = self;
    set_callbacks(*worlds_[number], {});
    const Row row = make_row(number, 0);
    tree.set_row(tree.create(*classes.statistics, self, "step"), row);
    return row;
}

Row Hosting::place_world(Handle self, Row row) {
    const EditScope placing(*this);
    hosted(row).placed = tree.is_below(self, tree.root());
    return row;
}

void Hosting::destroy_world(Row row) {
    const EditScope placing(*this);
    if (world_number(row) == limbo) return;
    worlds_[world_number(row)].reset();
    std::erase_if(postponed_, [&](const auto& one) { return one.world == world_number(row); });
}

// --- Bodies

Row Hosting::create_body(Handle self) {
    const Placing placing(*this);
    const std::uint32_t number = world_above(self);
    physics::World& world = worlds_[number]->world;
    const physics::Body made = world.create_body({.user_data = pack(self)});
    worlds_[number]->written_poses.note_new(made.index());
    // The undo of a deletion brings back the body that a joint is tied to.
    if (world.joint_count() > 0) joints.set_connect_needed();
    return row_of(number, made);
}

Row Hosting::place_body(Handle self, Row row) {
    const Placing placing(*this);
    const std::uint32_t number = world_above(self);
    if (number == limbo) add_stray(self, outside_);
    return number == world_number(row) ? row : migrate_body(row, number);
}

void Hosting::destroy_body(Row row) {
    if (postpone(world_number(row), [this, row] { destroy_body(row); })) return;
    const Placing placing(*this);
    HostedWorld& in = hosted(row);
    const physics::Body gone = body(row);
    if (gone.is_touching()) in.departed_bodies[gone.id().generation] = unpack(gone.user_data());
    in.body_colors.reset(slot_of(row));
    in.velocities.reset(slot_of(row));
    in.movers.reset(slot_of(row));
    joints.disconnect_all(gone);
    physics::Body(gone).destroy();
}

// --- Shapes

Row Hosting::create_shape(Handle self, const physics::Geometry& geometry) {
    require_concrete(self);
    const Placing placing(*this);
    const Handle owner = body_above(self);
    const Row owner_row = owner ? tree.row(owner) : make_row(limbo, 0);
    HostedWorld& in = hosted(owner_row);
    const physics::ShapeDef def{.hit_events = wanted_.hits, .user_data = pack(self)};
    physics::Shape made = in.world.create_shape(geometry, def);
    if (owner) made.attach(body(owner_row));
    return row_of(world_number(owner_row), made);
}

Row Hosting::place_shape(Handle self, Row row) {
    const Placing placing(*this);
    const Handle owner = body_above(self);
    if (!owner) {
        add_stray(self, stray_shapes_);
        if (world_number(row) != limbo) return migrate_shape(row, limbo, {});
        shape(row).detach();
        return row;
    }
    const Row owner_row = tree.row(owner);
    if (world_number(row) != world_number(owner_row))
        return migrate_shape(row, world_number(owner_row), body(owner_row));
    physics::Shape placed = shape(row);
    if (placed.body() != body(owner_row)) placed.attach(body(owner_row));
    return row;
}

void Hosting::destroy_shape(Row row) {
    if (postpone(world_number(row), [this, row] { destroy_shape(row); })) return;
    const Placing placing(*this);
    store_departure(row);
    hosted(row).looks.reset(slot_of(row));
    shape(row).destroy();
}

/// Stores the instances of a shape and its body that are removed during a touch, for the event of
/// its end.
void Hosting::store_departure(Row row) {
    const physics::Shape going = shape(row);
    if (!going.is_touching()) return;
    HostedWorld& in = hosted(row);
    in.departed_shapes[going.id().generation] = unpack(going.user_data());
    const physics::Body owner = going.body();
    if (owner) in.departed_bodies[owner.id().generation] = unpack(owner.user_data());
}

// --- What is outside

void Hosting::add_stray(Handle self, Strays& strays) const {
    if (!strays.reported && on_problem && tree.is_below(self, tree.root()))
        strays.placed.push_back(self);
}

void Hosting::add_placed_joint(Handle self) {
    add_stray(self, world_above(self) == limbo ? outside_ : stray_joints_);
    add_stray(self, crossed_limits_);
}

void Hosting::add_joint_with_limits(Row row) {
    const Handle self = instance_of(joints.at(row).user_data());
    if (!crossed_limits_.reported && self && !crossed_limits(self).empty())
        add_stray(self, crossed_limits_);
}

namespace {

/// What is wrong with the limits of a joint, as the library says it of a definition.
std::string crossed(const char* lower_name, float lower, const char* upper_name, float upper) {
    if (!(lower > upper)) return {};
    const auto text = [](float value) {
        return property::number_text(double(value), property::Precision::single_precision);
    };
    return std::string("has ") + lower_name + " = " + text(lower) + ": expected at most " +
           upper_name + ", which is " + text(upper) + " and is used for both";
}

template <class Joint>
std::string crossed_limits_of(const Joint& joint) {
    if constexpr (requires { joint.lower_angle(); })
        return crossed("lower_angle", joint.lower_angle(), "upper_angle", joint.upper_angle());
    else if constexpr (requires { joint.lower_translation(); })
        return crossed("lower_translation", joint.lower_translation(), "upper_translation",
                       joint.upper_translation());
    else
        return crossed("min_length", joint.min_length(), "max_length", joint.max_length());
}

}  // namespace

std::string Hosting::crossed_limits(Handle joint) const {
    const Row row = tree.row(joint);
    const auto of = [&]<class Joint>() { return crossed_limits_of(joints.at<Joint>(row)); };
    switch (joints.at(row).type()) {
        case physics::JointType::distance:
            return of.operator()<physics::DistanceJoint>();
        case physics::JointType::revolute:
            return of.operator()<physics::RevoluteJoint>();
        case physics::JointType::rotary_limit:
            return of.operator()<physics::RotaryLimitJoint>();
        case physics::JointType::prismatic:
            return of.operator()<physics::PrismaticJoint>();
        case physics::JointType::pin_slot:
            return of.operator()<physics::PinSlotJoint>();
        case physics::JointType::wheel:
            return of.operator()<physics::WheelJoint>();
        default:
            return {};
    }
}

void Hosting::report_strays() {
    const auto unless = [](bool fine, const char* problem) {
        return std::string(fine ? "" : problem);
    };
    report_first(outside_, [&](Handle each) {
        return unless(world_above(each) != limbo,
                      "is below no World, so it takes part in no step; add it to one: "
                      "world:add(...)");
    });
    report_first(stray_shapes_, [&](Handle each) {
        return unless(bool(body_above(each)),
                      "is on no Body, so nothing touches it; put it into one: Body { Circle {} }");
    });
    report_first(stray_joints_, [&](Handle each) {
        const Row row = tree.row(each);
        for (const Handle body : {joints.body(row, 0), joints.body(row, 1)})
            if (body && world_number(tree.row(body)) != world_number(row))
                return "does nothing: " + tree.path(body) +
                       " is in another World; a joint connects bodies of the World that it is in";
        return unless(
            joints.body(row, 0) != joints.body(row, 1),
            "does nothing: its body_a and body_b are the same, or both nil, which is the world");
    });
    report_first(crossed_limits_, [this](Handle each) { return crossed_limits(each); });
}

void Hosting::report_first(Strays& strays, const std::function<std::string(Handle)>& problem_of) {
    if (strays.placed.empty()) return;
    std::vector<Handle> placed = std::exchange(strays.placed, {});
    std::unordered_set<std::uint64_t> seen;  // a joint is there again for each limit that was set
    std::erase_if(placed, [&](Handle each) {
        return !seen.insert(pack(each)).second || !tree.alive(each) ||
               !tree.is_below(each, tree.root()) || problem_of(each).empty();
    });
    if (placed.empty()) return;
    strays.reported = true;
    const std::string more =
        placed.size() > 1 ? " (with " + std::to_string(placed.size() - 1) + " more)" : "";
    on_problem(tree.path(placed.front()) + more + " " + problem_of(placed.front()));
}

// --- Fields

/// A linear search is fast enough, because worlds have few fields.
physics::Field Hosting::field(Row row) {
    for (const physics::Field& field : world(row).fields())
        if (field.id().index == slot_of(row)) return field;
    return {};
}

Row Hosting::create_field(Handle self, const physics::FieldDef& def) {
    require_concrete(self);
    const Placing placing(*this);
    const std::uint32_t number = world_above(self);
    return make_row(number, worlds_[number]->world.create_field(def).id().index);
}

Row Hosting::place_field(Handle self, Row row) {
    const Placing placing(*this);
    const std::uint32_t number = world_above(self);
    if (number == limbo) add_stray(self, outside_);
    if (number == world_number(row)) return row;
    require_unlocked(row);
    const Row placed = create_field(self, field(row).definition());
    field(row).destroy();
    return placed;
}

void Hosting::destroy_field(Row row) {
    if (postpone(world_number(row), [this, row] { destroy_field(row); })) return;
    const Placing placing(*this);
    field(row).destroy();
}

// --- Deletions while a world calls a function

bool Hosting::postpone(std::uint32_t world, std::function<void()> destroy) {
    if (!worlds_[world]->world.locked()) return false;
    postponed_.push_back({world, std::move(destroy)});
    return true;
}

void Hosting::destroy_postponed() {
    const auto locked = [this](const Postponed& one) { return worlds_[one.world]->world.locked(); };
    const auto first_ready = std::stable_partition(postponed_.begin(), postponed_.end(), locked);
    const std::vector<Postponed> ready(first_ready, postponed_.end());
    postponed_.erase(first_ready, postponed_.end());
    for (const Postponed& one : ready) one.destroy();
}

void Hosting::require_unlocked(Row row) {
    if (world(row).locked())
        throw property::Error(property::ErrorKind::rejected,
                              "a physics world calls a function: what is in it moves to another "
                              "world when its step or query is over");
}

}  // namespace fettle::physics_module
