// Mover: a body that walks, climbs and rides through a world.

#include <bindings/bindings.h>
#include <drawing/drawing.h>
#include <drawing/drawn_pose.h>
#include <movers/mover_class.h>

namespace fettle::physics_module {
namespace {

using property::Method;
using property::Result;

MoverRecord record_of(Hosting& hosting, Row row) {
    return hosting.hosted(row).movers.get(slot_of(row));
}

/// A number of the record.
template <float MoverSettings::*Member, bool of_capsule = false>
Binding setting_of(Hosting& hosting) {
    return accessor(
        hosting, [](Hosting& h, Row row) { return to_value(record_of(h, row).settings.*Member); },
        [](Hosting& h, Row row, const Value& value) {
            const Hosting::EditScope doing(h);
            MoverRecord record = record_of(h, row);
            record.settings.*Member = from_value<float>(value);
            h.hosted(row).movers.set(slot_of(row), record);
            if constexpr (of_capsule) adapt_capsule(h.hosted(row), slot_of(row));
        });
}

template <std::uint32_t MoverSettings::*Member, bool of_capsule = false>
Binding switch_of(Hosting& hosting) {
    return accessor(
        hosting,
        [](Hosting& h, Row row) { return to_value(record_of(h, row).settings.*Member != 0); },
        [](Hosting& h, Row row, const Value& value) {
            const Hosting::EditScope doing(h);
            MoverRecord record = record_of(h, row);
            record.settings.*Member = value.boolean();
            h.hosted(row).movers.set(slot_of(row), record);
            if constexpr (of_capsule) adapt_capsule(h.hosted(row), slot_of(row));
        });
}

/// A property of the capsule; its value is `otherwise` if a damaged save has no capsule.
template <auto Get, auto Set, std::uint64_t otherwise>
Binding of_capsule(Hosting& hosting) {
    return accessor(
        hosting,
        [](Hosting& h, Row row) {
            const physics::Shape shape = capsule_of(h.body(row));
            return to_value(shape ? (shape.*Get)() : otherwise);
        },
        [](Hosting& h, Row row, const Value& value) {
            physics::Shape shape = capsule_of(h.body(row));
            if (shape) (shape.*Set)(from_value<std::uint64_t>(value));
        });
}

std::uint32_t capsule_slot(Hosting& hosting, Row row) {
    return capsule_of(hosting.body(row)).index();
}

Binding capsule_visible(Hosting& hosting) {
    return accessor(
        hosting,
        [](Hosting& h, Row row) { return h.hosted(row).looks.get(capsule_slot(h, row)).visible; },
        [](Hosting& h, Row row, const Value& value) {
            const std::uint32_t slot = capsule_slot(h, row);
            Look look = h.hosted(row).looks.get(slot);
            look.visible = value.boolean();
            h.hosted(row).looks.set(slot, look);
        });
}

/// A value that a step computes.
template <class Get>
Property reading(Hosting& hosting, Property described, Get) {
    described.binding =
        accessor(hosting, [](Hosting& h, Row row) { return Get{}(h, row, record_of(h, row)); });
    described.read_only = described.transient = described.simulated = true;
    return described;
}

std::vector<Property> form(Hosting& h) {
    return {
        within({.min = 0.01, .max = 500},
               number("radius", widen(0.4f, 0).x, "m", "Radius of its capsule: half its width.",
                      setting_of<&MoverSettings::radius, true>(h))),
        within({.min = 0.02, .max = 1000},
               number("height", widen(1.8f, 0).x, "m",
                      "Height while it stands; at least twice the radius is used. Its position is "
                      "at its feet.",
                      setting_of<&MoverSettings::height, true>(h))),
        within({.min = 0.02, .max = 1000},
               number("crouch_height", widen(0.9f, 0).x, "m", "Height while it crouches.",
                      setting_of<&MoverSettings::crouch_height, true>(h))),
        flag("crouch", false,
             "True if it is to crouch. After false it stands up as soon as there is room; "
             "`crouched` says whether it is still low.",
             switch_of<&MoverSettings::crouch, true>(h)),
    };
}

std::vector<Property> control(Hosting& h) {
    return {
        number(
            "walk", 0, "m/s",
            "Target speed along the ground, to its right; negative to its left. In the air it is "
            "relative to the ground that it left.",
            setting_of<&MoverSettings::walk>(h)),
        number("climb", 0, "m/s", "Speed upwards while it climbs.",
               setting_of<&MoverSettings::climb>(h)),
        simulated(flag("climbing", false,
                       "True if it is on a ladder: gravity does not act, and it moves by walk and "
                       "climb.",
                       switch_of<&MoverSettings::climbing>(h))),
        amount("acceleration", 60, "m/s\xC2\xB2", "Acceleration to the speed `walk` on the ground.",
               setting_of<&MoverSettings::acceleration>(h)),
        amount("air_acceleration", 20, "m/s\xC2\xB2",
               "Acceleration to the speed `walk` in the air.",
               setting_of<&MoverSettings::air_acceleration>(h)),
    };
}

std::vector<Property> limits(Hosting& h) {
    return {
        within({.min = 0, .max = 1.5},
               number("max_slope", widen(0.87f, 0).x, "rad",
                      "Steepest ground on which it stands; steeper ground is a wall.",
                      setting_of<&MoverSettings::max_slope>(h))),
        within({.min = 0, .max = 1000},
               number("step_height", widen(0.3f, 0).x, "m", "Height of the steps that it climbs.",
                      setting_of<&MoverSettings::step_height>(h))),
        within(
            {.min = 0, .max = 1000},
            number("snap", 0.25, "m",
                   "While it walks, it stays on ground that falls away by at most this in a step.",
                   setting_of<&MoverSettings::snap>(h))),
        within({.min = 0, .max = 1e9}, number("push_force", 600, "N",
                                              "Greatest force with which it pushes bodies; the "
                                              "body on which it stands gets the opposite.",
                                              setting_of<&MoverSettings::push_force>(h))),
        {.name = "ledges",
         .type = Type::integer,
         .default_value = 0,
         .doc = "Categories of ledges, as bits: shapes on which it stands and through which it "
                "passes from below. Chains are like this without a category.",
         .binding = accessor(
             h, [](Hosting& g, Row row) { return to_value(record_of(g, row).ledges); },
             [](Hosting& g, Row row, const Value& value) {
                 MoverRecord record = record_of(g, row);
                 record.ledges = from_value<std::uint64_t>(value);
                 g.hosted(row).movers.set(slot_of(row), record);
             }),
         .bits = true},
        {.name = "category",
         .type = Type::integer,
         .default_value = 1,
         .doc = "Its categories, as bits: see `Shape.category`.",
         .binding = of_capsule<&physics::Shape::category, &physics::Shape::set_category, 1>(h),
         .bits = true},
        {.name = "mask",
         .type = Type::integer,
         .default_value = -1,
         .doc = "Categories of the shapes with which it collides, as bits; -1 is all.",
         .binding =
             of_capsule<&physics::Shape::mask, &physics::Shape::set_mask, ~std::uint64_t{0}>(h),
         .bits = true},
        flag("visible", true,
             "True if its capsule is drawn; set it to false if a sprite is drawn in its place.",
             capsule_visible(h)),
    };
}

Value body_below(Hosting& hosting, Row row, const MoverRecord& record) {
    HostedWorld& in = hosting.hosted(row);
    if (record.result.on_ground == 0 || !in.world.is_valid(record.result.ground))
        return Value(Handle{});
    const physics::Body body = in.world.shape(record.result.ground).body();
    const Handle owner = body ? hosting.instance_of(body.user_data()) : Handle{};
    return owner ? owner : in.self;
}

std::vector<Property> state(Hosting& h) {
    return {
        reading(
            h,
            {.name = "on_ground", .type = Type::boolean, .doc = "True if it stands on the ground."},
            [](Hosting&, Row, const MoverRecord& r) { return Value(r.result.on_ground != 0); }),
        reading(h,
                {.name = "ground",
                 .type = Type::reference,
                 .doc = "The body on which it stands, or the world for its bounds; nil in the air.",
                 .nullable = true},
                [](Hosting& g, Row row, const MoverRecord& r) { return body_below(g, row, r); }),
        reading(h,
                {.name = "ground_normal",
                 .type = Type::vec2,
                 .doc = "Direction away from the ground; zero in the air.",
                 .single_precision = true},
                [](Hosting&, Row, const MoverRecord& r) -> Value {
                    return widen(r.result.normal_x, r.result.normal_y);
                }),
        reading(h,
                {.name = "ground_velocity",
                 .type = Type::vec2,
                 .unit = "m/s",
                 .doc = "Velocity of the ground below its feet.",
                 .single_precision = true},
                [](Hosting&, Row, const MoverRecord& r) -> Value {
                    return widen(r.result.ground_x, r.result.ground_y);
                }),
        reading(h, {.name = "on_wall", .type = Type::boolean, .doc = "True if a wall stopped it."},
                [](Hosting&, Row, const MoverRecord& r) { return Value(r.result.on_wall != 0); }),
        reading(
            h,
            {.name = "on_ceiling", .type = Type::boolean, .doc = "True if a ceiling stopped it."},
            [](Hosting&, Row, const MoverRecord& r) { return Value(r.result.on_ceiling != 0); }),
        reading(h,
                {.name = "crouched",
                 .type = Type::boolean,
                 .doc = "True if it has the height for crouching."},
                [](Hosting&, Row, const MoverRecord& r) { return Value(r.result.crouched != 0); }),
    };
}

Result jump(void* context, property::Tree&, Handle, Row row, std::span<const Value> a) {
    Hosting& h = *static_cast<Hosting*>(context);
    physics::Body body = h.body(row);
    MoverRecord record = record_of(h, row);
    const physics::Vec2 up = body.world_vector({0.0f, 1.0f});
    physics::Vec2 velocity = body.velocity();
    velocity += (float_argument(a[0]) - velocity.dot(up)) * up;
    if (record.result.on_ground != 0)
        velocity += physics::Vec2(record.result.ground_x, record.result.ground_y).dot(up) * up;
    record.settings.climbing = 0;
    h.hosted(row).movers.set(slot_of(row), record);
    h.set_velocity(row, velocity);
    return Value();
}

Result drop(void* context, property::Tree&, Handle, Row row, std::span<const Value>) {
    Hosting& h = *static_cast<Hosting*>(context);
    const Hosting::EditScope doing(h);
    HostedWorld& in = h.hosted(row);
    MoverRecord record = record_of(h, row);
    physics::Mover mover(definition(record, h.body(row)), h.body(row).position());
    physics::MoverState state = mover.state();
    state.ground = record.result.ground;
    state.on_ground = record.result.on_ground != 0;
    mover.set_state(state);
    if (!mover.drop(in.world)) return Value(false);
    record.result.dropped = mover.state().dropped;
    in.movers.set(slot_of(row), record);
    return Value(true);
}

std::vector<property::Event> events() {
    return {
        {.name = "landed",
         .fields = {{.name = "ground",
                     .type = Type::reference,
                     .doc = "The body on which it landed."},
                    {"speed", Type::number, "m/s", "Speed of its fall."}},
         .doc = "It came onto the ground."},
        {.name = "left_ground",
         .fields = {{.name = "ground",
                     .type = Type::reference,
                     .doc = "The body on which it stood; nil if that was deleted.",
                     .nullable = true}},
         .doc = "It jumped or fell off the ground."},
        {.name = "bumped",
         .fields = {{"other", Type::reference, "", "The body that stopped it."},
                    {.name = "other_shape",
                     .type = Type::reference,
                     .doc = "The shape that stopped it; nil for the bounds and another mover.",
                     .reference_class = "Shape",
                     .nullable = true},
                    {"normal", Type::vec2, "", "Direction away from it."}},
         .doc = "A wall or a ceiling stopped it."},
        {.name = "crushed",
         .doc = "Obstacles press it from several sides, and it overlaps one of them."},
    };
}

}  // namespace

void define_mover(Hosting& hosting) {
    property::ClassDescriptor mover;
    mover.snapshots = property::Snapshots::natively;
    mover.name = "Mover";
    mover.base = "Body";
    mover.weight = 2000;
    mover.doc =
        "A character: a body with the shape of an upright capsule, which walks up slopes and "
        "steps, "
        "rides on platforms, passes through ledges from below and pushes crates. Its position is "
        "at its feet. It moves by itself while its type is \"kinematic\"; with \"dynamic\" it is "
        "a body like others.";
    for (const auto& group : {form(hosting), control(hosting), limits(hosting), state(hosting)})
        mover.properties.insert(mover.properties.end(), group.begin(), group.end());
    mover.methods = {
        Method{.name = "jump",
               .parameters = {{.name = "speed", .unit = "m/s", .doc = "Speed upwards."}},
               .required = 1,
               .doc = "Gives it this speed upwards, also in the air, and ends climbing.",
               .context = &hosting,
               .call = jump},
        Method{.name = "drop",
               .returns = {{.name = "dropped",
                            .type = Type::boolean,
                            .doc = "False if it stands on no ledge and on no chain."}},
               .doc = "Lets it fall through the ledge on which it stands.",
               .context = &hosting,
               .call = drop},
    };
    mover.events = events();
    mover.makes_base_rows = true;
    mover.lifecycle =
        lifecycle_of<&Hosting::create_mover, &Hosting::place_body, &Hosting::destroy_body>(hosting);
    mover.lifecycle.pose = drawn_pose;
    mover.lifecycle.draw = draw_mover;
    hosting.tree.define(std::move(mover));
}

}  // namespace fettle::physics_module
