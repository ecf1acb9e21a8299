#include "scene_world.h"

#include <scenes/scene_check.h>

#include <cstddef>

namespace scene_test {

namespace {

using Things = std::vector<Thing>;

Property native(Things& things, std::string name, Type type, Native kind, std::size_t offset,
                Value standard) {
    Property property;
    property.name = std::move(name);
    property.type = type;
    property.default_value = std::move(standard);
    property.binding.kind = BindingKind::column;
    property.binding.native = kind;
    property.binding.context = &things;
    property.binding.stride = sizeof(Thing);
    // `base` is a plain function that cannot hold the offset, so each member has a function of its
    // own.
    switch (offset) {
#define FETTLE_TEST_BASE(member)                                                     \
    case offsetof(Thing, member):                                                    \
        property.binding.base = [](void* all) {                                      \
            return reinterpret_cast<std::byte*>(static_cast<Things*>(all)->data()) + \
                   offsetof(Thing, member);                                          \
        };                                                                           \
        break;
        FETTLE_TEST_BASE(number)
        FETTLE_TEST_BASE(small)
        FETTLE_TEST_BASE(integer)
        FETTLE_TEST_BASE(narrow)
        FETTLE_TEST_BASE(flag)
        FETTLE_TEST_BASE(position)
        FETTLE_TEST_BASE(offset)
        FETTLE_TEST_BASE(tint)
        FETTLE_TEST_BASE(kind)
        FETTLE_TEST_BASE(density)
#undef FETTLE_TEST_BASE
        default:
            throw std::logic_error("no such member");
    }
    return property;
}

}  // namespace

void SceneWorld::define_thing() {
    ClassDescriptor thing;
    thing.name = "Thing";
    thing.lifecycle.context = &things;
    thing.lifecycle.create = [](void* all, Tree&, Handle) {
        auto& rows = *static_cast<Things*>(all);
        rows.emplace_back();
        return static_cast<Row>(rows.size() - 1);
    };
    Property number =
        native(things, "number", Type::number, Native::f64, offsetof(Thing, number), 0.0);
    number.infinity = true;
    Property small = native(things, "small", Type::number, Native::f32, offsetof(Thing, small),
                            static_cast<double>(0.6f));
    small.infinity = true;
    Property density =
        native(things, "density", Type::number, Native::f64, offsetof(Thing, density), 1.0);
    density.unit = "kg/m²";
    density.range = {0, 1000};
    Property kind =
        native(things, "kind", Type::text, Native::enumeration, offsetof(Thing, kind), "dynamic");
    kind.enumerators = {"static", "kinematic", "dynamic"};
    Property position = native(things, "position", Type::vec2, Native::vec2d,
                               offsetof(Thing, position), Vec2(0, 0));
    position.infinity = true;

    Property mass;
    mass.name = "mass";
    mass.unit = "kg";
    mass.range = {0, infinity};
    mass.infinity = true;
    mass.default_value = 1.0;
    mass.binding = accessor(
        things,
        [](Things& all, Row row) { return all[row].mass_given ? all[row].mass : all[row].density; },
        [](Things& all, Row row, const Value& value) {
            if (value.number() == 13)
                throw std::invalid_argument("thirteen kilograms bring bad luck");
            all[row].mass = value.number();
            all[row].mass_given = true;
        });
    mass.binding.reset = [](void* all, Row row) {
        (*static_cast<Things*>(all))[row].mass_given = false;
    };
    mass.binding.overridden = [](void* all, Row row) {
        return (*static_cast<Things*>(all))[row].mass_given;
    };
    Property gain;
    gain.name = "gain";
    gain.single_precision = true;
    gain.default_value = static_cast<double>(0.1f);
    gain.binding = accessor(
        things, [](Things& all, Row row) { return all[row].gain; },
        [](Things& all, Row row, const Value& value) {
            all[row].gain = static_cast<float>(value.number());
        });
    Property weight;
    weight.name = "weight";
    weight.unit = "N";
    weight.read_only = true;
    weight.derives_from = {"mass"};
    weight.binding = accessor(things, [](Things& all, Row row) { return all[row].density * 10; });

    thing.properties = {
        number,
        small,
        native(things, "integer", Type::integer, Native::i64, offsetof(Thing, integer), 0),
        native(things, "narrow", Type::integer, Native::i32, offsetof(Thing, narrow), 7),
        native(things, "flag", Type::boolean, Native::boolean, offsetof(Thing, flag), false),
        position,
        native(things, "offset", Type::vec2, Native::vec2f, offsetof(Thing, offset), Vec2(0, 0)),
        native(things, "tint", Type::color, Native::color, offsetof(Thing, tint), Color{}),
        kind,
        density,
        mass,
        gain,
        weight};
    Method poke;
    poke.name = "poke";
    poke.call = [](void*, Tree&, Handle, Row, std::span<const Value>) { return Result(Value(1)); };
    thing.methods = {poke};
    tree.define(std::move(thing));
}

void SceneWorld::define_stored() {
    ClassDescriptor note;
    note.name = "Note";
    Property text{.name = "text", .type = Type::text, .default_value = ""};
    Property target{.name = "target", .type = Type::reference, .default_value = Handle{}};
    Property thing{.name = "thing", .type = Type::reference, .default_value = Handle{}};
    thing.reference_class = "Thing";
    Property points{.name = "points", .type = Type::list, .default_value = List{}};
    points.element = Type::vec2;
    Property targets{.name = "targets", .type = Type::list, .default_value = List{}};
    targets.element = Type::reference;
    Property anything{.name = "anything", .type = Type::list, .default_value = List{}};
    anything.infinity = true;
    Property limit{.name = "limit", .type = Type::number, .default_value = 5.0};
    limit.nullable = true;
    Property level{.name = "level", .type = Type::integer, .default_value = 3};
    level.range = {0, 9};
    level.clamp = true;
    Property passing{.name = "passing", .type = Type::number, .default_value = 0.0};
    passing.transient = true;
    note.properties = {text, target, thing, points, targets, anything, limit, level, passing};
    tree.define(std::move(note));

    ClassDescriptor service;
    service.name = "Service";
    service.creatable = false;
    tree.define(std::move(service));

    // The constructor creates a child of a class of which a file cannot create instances.
    ClassDescriptor host;
    host.name = "Host";
    host.lifecycle.create = [](void*, Tree& in, Handle self) {
        in.create(in.class_named("Service"), self, "service");
        return Row{0};
    };
    tree.define(std::move(host));
}

SceneWorld::SceneWorld() {
    define_thing();
    define_stored();
    world = tree.create(tree.object_class(), tree.root(), "world");
}

Handle SceneWorld::load(std::string_view text, std::string_view name) {
    std::string refused;
    try {
        check_scene(tree, Document(std::string(text), "level.json"), world, name);
    } catch (const Error& e) {
        refused = e.what();
    }
    warnings.clear();
    const Handle loaded = load_scene_text(tree, text, "level.json", world, name, &warnings);
    if (!refused.empty()) throw std::logic_error("it loads, but the check says: " + refused);
    return loaded;
}

std::string SceneWorld::refusal(std::string_view text) {
    try {
        load(text);
    } catch (const Error& e) {
        return e.what();
    }
    return "";
}

std::string SceneWorld::everything() const {
    std::string all;
    tree.each_below(tree.root(), [&](Handle handle) {
        all += tree.path(handle) + " " + tree.class_of(handle).name() + "\n";
        for (const Property* property : tree.properties(handle)) {
            all += "  " + property->name + " = " + tree.text(tree.get(handle, *property)) + "\n";
        }
    });
    return all;
}

}  // namespace scene_test
