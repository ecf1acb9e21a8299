// Field and the classes that derive from it: Wind, Drag, Buoyancy, Attractor. A field acts in the
// nearest World above it; without a World above it, it can be read and edited, too.

#include <bindings/bindings.h>
#include <fields/field_classes.h>

namespace fettle::physics_module {
namespace {

using physics::FieldDef;

physics::Field field_at(Hosting& hosting, Row row) {
    return hosting.field(row);
}

/// Changes one value of a field: the library gets the complete definition and checks it.
void change(Hosting& hosting, Row row, auto&& make) {
    physics::Field field = field_at(hosting, row);
    FieldDef def = field.definition();
    make(def);
    field.set(def);
}

template <auto Member>
struct MemberOf;
template <class Of, class Held, Held Of::*Member>
struct MemberOf<Member> {
    using Owner = Of;
    using Value = Held;
};

/// A value of one kind of field.
template <auto Member>
Binding force_value(Hosting& hosting) {
    using Owner = typename MemberOf<Member>::Owner;
    using Held = typename MemberOf<Member>::Value;
    return accessor(
        hosting,
        [](Hosting& h, Row row) {
            return to_value(std::get<Owner>(field_at(h, row).definition().force).*Member);
        },
        [](Hosting& h, Row row, const Value& value) {
            change(h, row, [&](FieldDef& def) {
                std::get<Owner>(def.force).*Member = from_value<Held>(value);
            });
        });
}

Value region(Hosting& hosting, Row row) {
    const auto& region = field_at(hosting, row).definition().region;
    return region ? to_value(*region) : Value();
}

void set_region(Hosting& hosting, Row row, const Value& value) {
    std::optional<physics::Aabb> region;
    if (!value.is_nil()) region = from_value<physics::Aabb>(value);
    change(hosting, row, [&](FieldDef& def) { def.region = region; });
}

template <class Force>
property::Lifecycle lifecycle(Hosting& hosting) {
    property::Lifecycle lifecycle;
    lifecycle.context = &hosting;
    lifecycle.create = [](void* context, property::Tree&, Handle self) {
        return static_cast<Hosting*>(context)->create_field(
            self, {.force = Force{}, .user_data = pack(self)});
    };
    lifecycle.place = [](void* context, property::Tree&, Handle self, Row row) {
        return static_cast<Hosting*>(context)->place_field(self, row);
    };
    lifecycle.destroy = [](void* context, property::Tree&, Handle, Row row) {
        static_cast<Hosting*>(context)->destroy_field(row);
    };
    hosting.field_kinds.emplace_back(lifecycle.create, decltype(FieldDef::force)(Force{}).index());
    return lifecycle;
}

void define_field(Hosting& hosting) {
    property::ClassDescriptor field;
    field.name = "Field";
    field.doc =
        "A field of force: it acts on bodies that are awake in the world above it. An edit of it "
        "wakes all bodies.";
    field.creatable = false;
    field.snapshots = property::Snapshots::natively;
    field.lifecycle = lifecycle<physics::WindField>(hosting);
    field.properties = {
        flag("enabled", true, "True if it acts.",
             accessor(
                 hosting, [](Hosting& h, Row row) { return field_at(h, row).definition().enabled; },
                 [](Hosting& h, Row row, const Value& value) {
                     change(h, row, [&](FieldDef& def) { def.enabled = value.boolean(); });
                 })),
        {.name = "region",
         .type = Type::list,
         .unit = "m",
         .range = coordinates,
         .doc = "Region in which it acts, by its lower left and upper right corner: on shapes that "
                "overlap it (Buoyancy), or whose body has its center of mass inside; nil: "
                "everywhere.",
         .binding = accessor(
             hosting, [](Hosting& h, Row row) { return region(h, row); },
             [](Hosting& h, Row row, const Value& value) { set_region(h, row, value); }),
         .nullable = true,
         .element = Type::vec2,
         .single_precision = true},
        {.name = "mask",
         .type = Type::integer,
         .default_value = -1,
         .doc = "Categories of the shapes on which it acts, as bits.",
         .binding = accessor(
             hosting,
             [](Hosting& h, Row row) { return to_value(field_at(h, row).definition().mask); },
             [](Hosting& h, Row row, const Value& value) {
                 change(h, row,
                        [&](FieldDef& def) { def.mask = from_value<std::uint64_t>(value); });
             }),
         .bits = true},
    };
    hosting.classes.abstract.push_back(&hosting.tree.define(std::move(field)));
}

template <class Force>
void define_kind(Hosting& hosting, std::string name, std::string doc,
                 std::vector<Property> properties) {
    property::ClassDescriptor kind;
    kind.name = std::move(name);
    kind.base = "Field";
    kind.doc = std::move(doc);
    kind.lifecycle = lifecycle<Force>(hosting);
    kind.makes_base_rows = true;
    kind.properties = std::move(properties);
    hosting.tree.define(std::move(kind));
}

}  // namespace

void define_fields(Hosting& hosting) {
    using physics::AttractorField;
    using physics::BuoyancyField;
    using physics::DragField;
    using physics::WindField;
    Hosting& h = hosting;
    define_field(h);
    define_kind<WindField>(
        h, "Wind", "Moving air: pushes every edge that faces it, by the square of its speed.",
        {vector("velocity", {5, 0}, "m/s", "Velocity of the air.",
                force_value<&WindField::velocity>(h)),
         amount("density", widen(1.2f, 0).x, "kg/m\xC2\xB2", "Density of the air.",
                force_value<&WindField::density>(h))});
    define_kind<DragField>(
        h, "Drag", "Slows bodies that move relative to a flow, by the area of their shapes.",
        {vector("flow", {0, 0}, "m/s", "Velocity of the flow.", force_value<&DragField::flow>(h)),
         amount("linear", 1, "N s/m\xC2\xB3", "Resistance for each m/s and m\xC2\xB2.",
                force_value<&DragField::linear>(h)),
         amount("quadratic", 0, "N s\xC2\xB2/m\xE2\x81\xB4",
                "Resistance for each (m/s)\xC2\xB2 and m\xC2\xB2.",
                force_value<&DragField::quadratic>(h))});
    define_kind<BuoyancyField>(
        h, "Buoyancy",
        "A liquid below a straight surface: lifts bodies by exactly the weight of the displaced "
        "liquid.",
        {number("level", 0, "m", "Height of the surface, along its normal from the origin.",
                force_value<&BuoyancyField::level>(h)),
         vector("normal", {0, 1}, "", "Direction up from the surface; of any length but 0.",
                force_value<&BuoyancyField::normal>(h)),
         amount("density", 2, "kg/m\xC2\xB2", "Density of the liquid.",
                force_value<&BuoyancyField::density>(h)),
         amount("drag", 2, "1/s", "Share of the displaced mass that resists motion.",
                force_value<&BuoyancyField::drag>(h)),
         vector("flow", {0, 0}, "m/s", "Velocity of the liquid.",
                force_value<&BuoyancyField::flow>(h))});
    Property falloff{.name = "falloff",
                     .type = Type::integer,
                     .default_value = 2,
                     .range = {.min = 0, .max = 3},
                     .doc = "The acceleration is divided by this power of the distance.",
                     .binding = force_value<&AttractorField::falloff>(h)};
    define_kind<AttractorField>(
        h, "Attractor", "Pulls bodies towards a point, as a planet does.",
        {within(coordinates, vector("center", {0, 0}, "m", "Position of the point in the world.",
                                    force_value<&AttractorField::center>(h))),
         number("strength", 10, "m/s\xC2\xB2",
                "Acceleration at a distance of 1 m; a negative one repels.",
                force_value<&AttractorField::strength>(h)),
         falloff,
         amount("core", 0.5, "m",
                "At a smaller distance the force is proportional to the distance.",
                force_value<&AttractorField::core>(h))});
}

}  // namespace fettle::physics_module
