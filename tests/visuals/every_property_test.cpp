// Every property of every class of this part: any value is accepted or refused. An accepted value
// can be drawn and is kept by snapshots.

#include <catch.h>

#include <limits>

#include "levels.h"

namespace every_property_test {

using namespace fettle::visuals::test;

namespace {

const char* const classes[] = {"Sprite", "Text", "Line", "Layer", "Emitter", "Tilemap"};

std::vector<Value> values_for(const Property& property) {
    constexpr double inf = std::numeric_limits<double>::infinity();
    std::vector<Value> all{Value(),
                           Value(true),
                           Value(0),
                           Value(7),
                           Value(std::numeric_limits<std::int64_t>::max()),
                           Value(-1.5),
                           Value(1e300),
                           Value(1e-300),
                           Value(std::nan("")),
                           Value(inf),
                           Value(-inf),
                           Value(""),
                           Value("hero.tga"),
                           Value(std::string(3000, 'x')),
                           Value(Vec2(1e9, -1e9)),
                           Value(Vec2(std::nan(""), inf)),
                           Value(Color{0.5f, 2, -1, 0.5f}),
                           Value(Color{0.1f, 0.2f, 0.3f, 0.4f}),
                           Value(List{}),
                           Value(List{Vec2(0, 0), Vec2(1e9, 1e9), Vec2(-1e9, 3)}),
                           Value(List{Vec2(0, 0), Value("no point")})};
    for (const double end : {property.range.min, property.range.max}) {
        all.emplace_back(end);
        all.emplace_back(Vec2(end, end));
    }
    for (const std::string& name : property.enumerators) all.emplace_back(name);
    return all;
}

struct Room : Land {
    Room() {
        for (const char* of : classes) {
            const Handle made = make(of);
            if (tree.find(made, "map")) {
                tree.set(made, "map", Value("level.tmj"));
                step(1);
            }
            if (tree.find(made, "image")) tree.set(made, "image", Value("hero.tga"));
            if (tree.find(made, "text")) tree.set(made, "text", Value("two\nlines"));
            if (tree.find(made, "points"))
                tree.set(made, "points", Value(List{Vec2(0, 0), Vec2(1, 1)}));
            if (std::string(of) == "Layer") make("Sprite", {{"image", "hero.tga"}}, made);
        }
    }
    std::vector<std::pair<const Property*, Value>> state(Handle of) {
        std::vector<std::pair<const Property*, Value>> all;
        for (const Property* property : tree.properties(of))
            if (!property->read_only && !property->transient)
                all.emplace_back(property, tree.get(of, *property));
        return all;
    }
    std::vector<Handle> things() {
        std::vector<Handle> all;
        tree.each_below(tree.root(), [&](Handle each) {
            if (each != tree.root()) all.push_back(each);
        });
        return all;
    }
};

}  // namespace

TEST_CASE_METHOD(Room, "any value is refused or can be drawn and is kept by snapshots") {
    std::size_t taken = 0;
    for (const Handle thing : things())
        for (const Property* property : tree.properties(thing)) {
            if (property->read_only || property->binding.kind == BindingKind::node ||
                property->binding.kind == BindingKind::ad_hoc)
                continue;
            for (const Value& value : values_for(*property)) {
                INFO(tree.path(thing, *property) << " = " << tree.text(value));
                try {
                    tree.set(thing, *property, value);
                    ++taken;
                } catch (const Error&) {
                    continue;
                }
                const auto before = state(thing);
                CHECK_NOTHROW(draw());
                const Snapshot snapshot = Snapshot::from_bytes(tree.snapshot().to_bytes());
                tree.reset(thing, *property);
                CHECK_NOTHROW(step(1));
                tree.restore(snapshot);
                CHECK(state(thing) == before);
                CHECK(tree.get(thing, *property) ==
                      tree.coerce(thing, *property, tree.get(thing, *property)));
            }
            tree.reset(thing, *property);
            if (property->name == "map" || property->name == "made_from" ||
                property->name == "made" || property->name == "followed")
                continue;
            if (property->name == "image") tree.set(thing, *property, Value("hero.tga"));
        }
    CHECK(taken > 200);
}

TEST_CASE_METHOD(Room, "every property can be explained") {
    for (const char* of : classes)
        for (const Property* property : tree.class_named(of).properties()) {
            INFO(of << "." << property->name);
            CHECK(property->doc.size() > 5);
            CHECK(property->doc.back() == '.');
        }
}

TEST_CASE_METHOD(Room, "deleting instances while they are drawn does no harm") {
    for (const Handle thing : things()) {
        if (!tree.alive(thing)) continue;
        CHECK_NOTHROW(draw());
        tree.destroy(thing);
        CHECK_NOTHROW(step(1));
    }
    CHECK(draw().empty());
    make("Sprite", {{"image", "hero.tga"}});
    CHECK(draw().size() == 1);
}

}  // namespace every_property_test
