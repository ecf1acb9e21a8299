// Redo of instances that a person has made and that the game has changed since.

#include <array>
#include <random>
#include <string>
#include <vector>

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
    Handle ball = tree.create(*module.type, world, "ball");

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

TEST_CASE_METHOD(Fixture, "each redo of a random session gives back what its undo took away") {
    const unsigned seed = GENERATE(range(1u, 40u));
    CAPTURE(seed);
    std::mt19937 random(seed);
    const auto up_to = [&](int most) { return static_cast<int>(random() % unsigned(most + 1)); };
    const auto below = [&](Handle top) {
        std::vector<Handle> all;
        tree.each_below(top, [&](Handle each) { all.push_back(each); });
        return all;
    };
    const auto any = [&] {
        const std::vector<Handle> all = below(world);
        return all[static_cast<std::size_t>(up_to(static_cast<int>(all.size()) - 1))];
    };
    const auto write = [&](Handle to) {
        if (&tree.class_of(to) != module.type) return;
        const char* const name = std::array{"mass", "velocity", "charge", "radius"}[random() % 4];
        if (std::string_view(name) == "velocity")
            tree.set(to, name, Vec2(up_to(9), up_to(9)));
        else if (up_to(5) == 0)
            tree.reset(to, *tree.find(to, name));
        else
            tree.set(to, name, 1 + up_to(8));
    };
    const auto text_of = [&](Handle top) {
        std::string all;
        for (const Handle each : below(top)) {
            all += tree.path(each);
            for (const Property* property : tree.properties(each))
                if (!property->read_only)
                    all += " " + property->name + "=" + tree.text(tree.get(each, *property)) +
                           (tree.overridden(each, *property) ? "!" : "");
            all += "\n";
        }
        return all;
    };
    struct Done {
        Handle made;  // null: another edit
        std::string taken{};
    };
    std::vector<Done> done, undone;
    int names = 0;
    for (int i = 0; i < 200; ++i) {
        const int kind = up_to(9);
        if (kind < 3) {
            write(any());  // the game
        } else if (kind < 5) {
            Handle made;
            console([&] {
                tree.begin_edit("make");
                const Handle part = tree.create(*module.type);
                write(part);
                made = tree.create(*module.type);
                tree.move(part, made, "part");
                write(made);
                tree.move(made, any(), "made_" + std::to_string(++names));
                write(part);
                tree.end_edit();
            });
            done.push_back({made});
            undone.clear();
        } else if (kind == 5) {
            console([&] {
                tree.begin_edit("write");
                tree.set(ball, "charge", 0.5 + 0.001 * i);
                write(any());
                tree.end_edit();
            });
            done.push_back({});
            undone.clear();
        } else if (kind < 8 && !done.empty()) {
            Done last = done.back();
            done.pop_back();
            if (last.made) last.taken = text_of(last.made);
            REQUIRE(tree.undo().done);
            CHECK((!last.made || !tree.alive(last.made)));
            undone.push_back(last);
        } else if (!undone.empty()) {
            const Done next = undone.back();
            undone.pop_back();
            REQUIRE(tree.redo().done);
            if (next.made) CHECK(text_of(next.made) == next.taken);
            done.push_back(next);
        }
    }
}

}  // namespace redo_test
