// Redo of instances that a person has made and that the game has changed since.

#include "catch.h"
#include "fixture.h"

namespace redo_test {

using namespace fettle::property;
using namespace fettle::property::testing;

namespace {
struct Fixture {
    Tree tree;
    BallModule module{tree};
    Handle world = tree.create(tree.object_class(), tree.root(), "world");

    template <class F>
    void console(F f) {
        const Tree::CauseScope scope(tree, Writer::console);
        f();
    }
};
}  // namespace

TEST_CASE_METHOD(Fixture, "redo of a creation gives back what undo took away at one moment") {
    Handle lamp, bulb;
    console([&] {
        tree.begin_edit("a lamp");
        bulb = tree.create(*module.type);
        tree.set(bulb, "mass", 2);
        lamp = tree.create(*module.type);
        tree.set(lamp, "mass", 3);
        tree.set_or_add(lamp, "hue", 1);
        tree.move(bulb, lamp, "bulb");
        tree.move(lamp, world, "lamp");
        tree.end_edit();
    });
    const auto state = [&] {
        return tree.text(tree.get(lamp, "mass")) + " " + tree.text(tree.get(lamp, "hue")) + " " +
               tree.text(tree.get(bulb, "mass")) + " " + tree.text(tree.get(bulb, "velocity")) +
               " " + tree.path(bulb);
    };
    // The game goes on.
    tree.set(lamp, "mass", 30);
    tree.set(lamp, "hue", 10);
    tree.set(bulb, "velocity", Vec2(1, 2));
    const std::string played = state();
    console([&] { tree.set(bulb, "mass", 7); });
    const std::string edited = state();
    tree.set(lamp, "hue", 11);
    for (int round = 0; round < 3; ++round) {
        CAPTURE(round);
        tree.undo();
        const std::string taken = state();
        tree.undo();
        CHECK_FALSE(tree.alive(lamp));
        tree.redo();
        CHECK(state() == taken);
        tree.redo();
        CHECK(tree.get(bulb, "mass").number() == 7);
        tree.set(lamp, "mass", 40 + round);
        tree.set(bulb, "velocity", Vec2(round, 3));
    }
    // The game gives back a default, takes an added property away and moves a part.
    tree.undo();
    tree.reset(bulb, tree.property(bulb, "mass"));
    tree.remove_ad_hoc(lamp, "hue");
    tree.move(bulb, world, "bulb");
    tree.undo();
    tree.redo();
    CHECK_FALSE(tree.overridden(bulb, tree.property(bulb, "mass")));
    CHECK_FALSE(tree.find(lamp, "hue"));
    CHECK(tree.path(bulb) == "world.bulb");
}

}  // namespace redo_test
