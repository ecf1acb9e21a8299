// Values that are written and read: a number that a float can hold is not changed, a meaningless
// one is refused with path and reason, and a refused write changes nothing.

#include <cmath>
#include <limits>

#include "catch.h"
#include "game.h"

namespace values_test {

using namespace fettle::physics_module::testing;
using namespace fettle;
using property::Property;
using property::Type;

namespace {

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// One instance of every class.
struct Zoo : Game {
    std::vector<Handle> all;

    Zoo() {
        const Handle crate = make("Body", world());
        all = {world(), crate, tree.child(world(), "step")};
        for (const char* shape : {"Circle", "Box", "Segment", "Capsule", "Polygon"})
            all.push_back(make(shape, crate));
        all.push_back(make("MouseJoint", world()));
    }

    template <class Visit>
    void each_property(Visit visit) {
        for (const Handle handle : all)
            for (const Property* property : tree.class_of(handle).properties())
                if (property->owner != &tree.object_class()) visit(handle, *property);
    }
    /// A value of the property's type that contains `x`.
    static Value filled(Type type, double x) {
        if (type == Type::vec2) return Vec2(x, 1);
        if (type == Type::list) return List{Vec2(0, 0), Vec2(1, x), Vec2(2, 5)};
        return x;
    }
};

}  // namespace

TEST_CASE_METHOD(Zoo, "no property accepts NaN") {
    each_property([&](Handle handle, const Property& property) {
        INFO(tree.path(handle, property));
        const Value before = get(handle, property.name);
        CHECK_THROWS_AS(tree.set(handle, property, filled(property.type, nan)), property::Error);
        CHECK(get(handle, property.name) == before);
    });
}

TEST_CASE_METHOD(Zoo, "only properties for which infinity has a meaning accept it") {
    each_property([&](Handle handle, const Property& property) {
        if (property.type != Type::number && property.type != Type::vec2) return;
        if (property.read_only) return;
        INFO(tree.path(handle, property));
        for (const double x : {inf, -inf}) {
            if (property.infinity && x > 0) {
                CHECK_NOTHROW(tree.set(handle, property, x));
                CHECK(number(handle, property.name) == inf);
            } else {
                const Value before = get(handle, property.name);
                CHECK_THROWS_AS(tree.set(handle, property, filled(property.type, x)),
                                property::Error);
                CHECK(get(handle, property.name) == before);
            }
        }
    });
    CHECK(number(all[1], "mass") == inf);
}

TEST_CASE_METHOD(Zoo, "numbers that no float can hold are refused and others are exact") {
    each_property([&](Handle handle, const Property& property) {
        if (property.type != Type::number || property.read_only) return;
        INFO(tree.path(handle, property));
        try {
            tree.set(handle, property, -2);
            CHECK(number(handle, property.name) == -2);
            CHECK(property.range.min <= -2);
        } catch (const property::Error& error) {
            CHECK_THAT(error.what(), contains(property.name) && contains("-2"));
            CHECK(property.range.min > -2);
        }
        CHECK_THROWS_AS(tree.set(handle, property, std::int64_t{9007199254740993}),
                        property::Error);
        CHECK_THROWS_AS(tree.set(handle, property, 1e300), property::Error);
        CHECK_THROWS_AS(tree.set(handle, property, "heavy"), property::Error);
    });
}

TEST_CASE_METHOD(Zoo, "bits of categories can be any integer") {
    const Handle circle = all[3];
    for (const std::int64_t bits :
         {std::int64_t{-2}, std::int64_t{9007199254740993},
          std::numeric_limits<std::int64_t>::min(), std::numeric_limits<std::int64_t>::max()}) {
        set(circle, "category", bits);
        set(circle, "mask", bits);
        CHECK(get(circle, "category").integer() == bits);
        CHECK(get(circle, "mask").integer() == bits);
    }
    set(circle, "group", -2);
    CHECK(get(circle, "group").integer() == -2);
    CHECK_THROWS_AS(set(circle, "group", std::int64_t{1} << 40), property::Error);
}

TEST_CASE_METHOD(Zoo, "a float property prints what was written") {
    set(all[1], "gravity_scale", 0.1);
    const Property& scale = tree.property(all[1], "gravity_scale");
    CHECK(tree.text(get(all[1], "gravity_scale"), scale.precision()) == "0.1");
    CHECK(number(all[1], "gravity_scale") == static_cast<double>(0.1f));
}

TEST_CASE_METHOD(Zoo, "properties have the defaults of their descriptors before anyone writes") {
    const Handle alone = make("Body", world());
    for (const Handle handle : {world(), alone, all[3], all[4], all[5], all[6], all[7], all[8]}) {
        for (const Property* property : tree.class_of(handle).properties()) {
            if (property->owner == &tree.object_class() || property->read_only) continue;
            INFO(tree.path(handle, *property));
            CHECK(get(handle, property->name) == property->default_value);
            CHECK_FALSE(tree.overridden(handle, *property));
        }
    }
}

TEST_CASE_METHOD(Zoo, "every property of physics is described") {
    each_property([&](Handle handle, const Property& property) {
        INFO(tree.path(handle, property));
        CHECK(property.doc.size() > 8);
        CHECK(property.doc.back() == '.');
        CHECK_NOTHROW(get(handle, property.name));
        if (property.type == Type::number || property.type == Type::vec2)
            CHECK(property.single_precision);
    });
    for (const property::Class* of : tree.classes()) {
        INFO(of->name());
        CHECK(of->doc().size() > 6);
    }
}

TEST_CASE_METHOD(Zoo, "names and defaults on which games depend are unchanged") {
    const auto value = [&](Handle handle, const char* name) { return get(handle, name); };
    CHECK(value(world(), "gravity") == Vec2(0, -10));
    CHECK(value(world(), "bounds").is_nil());
    CHECK(value(all[1], "type") == "dynamic");
    CHECK(value(all[1], "linear_damping") == 0.0);
    CHECK(value(all[3], "density") == 1.0);
    CHECK(value(all[3], "friction") == static_cast<double>(0.6f));
    CHECK(value(all[3], "restitution") == 0.0);
    const char* of_body[] = {"type",     "position",        "angle",          "velocity",
                             "mass",     "inertia",         "center",         "force",
                             "torque",   "gravity_scale",   "linear_damping", "angular_damping",
                             "awake",    "can_sleep",       "bullet",         "locked_x",
                             "locked_y", "locked_rotation", "contacts",       "angular_velocity"};
    for (const char* name : of_body) CHECK_NOTHROW(value(all[1], name));
    const char* of_shape[] = {"density",       "friction", "restitution",   "rolling_resistance",
                              "surface_speed", "sensor",   "category",      "mask",
                              "group",         "color",    "border",        "visible",
                              "area",          "aabb",     "world_vertices"};
    for (std::size_t i = 3; i < 8; ++i)
        for (const char* name : of_shape) CHECK_NOTHROW(value(all[i], name));
}

TEST_CASE_METHOD(Zoo,
                 "an edit refused by the library reports path and reason and changes nothing") {
    const Handle crate = all[1];
    CHECK_THROWS_WITH(set(crate, "mass", 0), contains("world.body_1.mass"));
    CHECK_THROWS_WITH(set(crate, "mass", -1), contains("kg"));
    CHECK_THROWS_WITH(set(crate, "position", Vec2(1e30, 0)), contains("world.body_1.position"));
    CHECK(vec(crate, "position") == Vec2(0, 0));
    CHECK_THROWS_WITH(set(all[3], "radius", 0), contains("circle_1.radius"));
    CHECK_THROWS_WITH(set(all[3], "restitution", 1.5), contains("from 0 to 1"));
    CHECK_THROWS_WITH(set(world(), "bounds", List{Vec2(0, 0)}), contains("two corners"));
    CHECK_THROWS_WITH(set(world(), "bounds", List{Vec2(0, 0), Vec2(0, 5)}), contains("line"));
    CHECK_THROWS_WITH(set(world(), "substeps", 0), contains("from 1 to 64"));
    CHECK_THROWS_WITH(set(all[3], "area", 3), contains("read-only"));
    CHECK_THROWS_WITH(set(crate, "contacts", List{}), contains("read-only"));
}

}  // namespace values_test
