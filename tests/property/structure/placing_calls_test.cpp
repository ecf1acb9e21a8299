// Functions of a module that change the tree while they are called: `create`, `place`, `draw`; and
// ways back, which a host may call at any time.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <fettle/property/painter.h>
#include <fettle/property/question.h>

#include "catch.h"
#include "fixture.h"
#include "no_painter.h"

namespace placing_calls_test {

using namespace fettle::property;
using fettle::property::testing::message_of;
using fettle::property::testing::NoPainter;

namespace {

/// A class `Guest` whose rows begin at 100. Its functions call what a test sets, once.
class Guests {
  public:
    explicit Guests(Tree& of) : tree(of) {
        ClassDescriptor d{.name = "Guest"};
        d.lifecycle.context = this;
        d.lifecycle.create = [](void* c, Tree&, Handle self) {
            Guests& g = *static_cast<Guests*>(c);
            g.run(g.in_create, self);
            return ++g.last;
        };
        d.lifecycle.place = [](void* c, Tree&, Handle self, Row row) {
            Guests& g = *static_cast<Guests*>(c);
            g.rows_hold &= row > 100;
            g.run(g.in_place, self);
            return row;
        };
        d.lifecycle.destroy = [](void* c, Tree&, Handle self, Row row) {
            Guests& g = *static_cast<Guests*>(c);
            g.rows_hold &= row > 100;
            g.run(g.in_destroy, self);
        };
        d.lifecycle.draw = [](void* c, const Tree& in, Handle self, Row row, Painter&, double) {
            Guests& g = *static_cast<Guests*>(c);
            g.rows_hold &= in.row(self) == row;
            g.drawn += in.name(self) + " ";
            if (g.drawn.size() > 100) throw std::runtime_error("it goes on for ever");
            g.run(g.in_draw, self);
        };
        d.lifecycle.draw_over = [](void* c, const Tree& in, Handle self, Row row, Painter&,
                                   double) {
            Guests& g = *static_cast<Guests*>(c);
            g.rows_hold &= in.row(self) == row;
            g.over += in.name(self) + " ";
        };
        is = &tree.define(std::move(d));
    }
    Handle make(Handle parent, std::string_view name) { return tree.create(*is, parent, name); }

    Tree& tree;
    const Class* is = nullptr;
    Row last = 100;
    bool rows_hold = true;
    std::string drawn, over;
    std::function<void(Handle)> in_create, in_place, in_destroy, in_draw;

  private:
    static void run(std::function<void(Handle)>& once, Handle self) {
        if (const auto act = std::exchange(once, {})) act(self);
    }
};

}  // namespace

TEST_CASE("an instance above one that is being made cannot be moved") {
    Tree tree;
    Guests guests(tree);
    const Handle group = tree.create(tree.object_class(), tree.root(), "group");
    const Handle top = guests.make(tree.root(), "top");
    const auto back = tree.placement_restorer(top);
    tree.move(top, group);
    std::vector<std::string> messages;
    const auto try_all = [&](Handle self) {
        messages = {message_of([&] { tree.move(top, {}); }),
                    message_of([&] { tree.move(self, group); }),
                    message_of([&] { tree.replace(top, tree.create(tree.object_class())); })};
        back();
    };
    const std::string refused = "group.top.below is being made: its module cannot ";
    const std::vector<std::string> expected = {refused + "move it meanwhile",
                                               refused + "move it meanwhile",
                                               refused + "replace it meanwhile"};
    guests.in_create = try_all;
    const Handle below = guests.make(top, "below");
    CHECK(messages == expected);
    CHECK(tree.path(below) == "group.top.below");
    CHECK(guests.rows_hold);

    const Snapshot whole = tree.snapshot();
    tree.destroy(below);
    messages.clear();
    guests.in_create = try_all;
    tree.restore(whole);
    CHECK(messages == expected);
    CHECK(tree.path(below) == "group.top.below");
    CHECK(guests.rows_hold);

    tree.destroy(below);
    messages.clear();
    guests.in_place = try_all;
    guests.make(top, "below");
    CHECK(messages == expected);
    CHECK(guests.rows_hold);

    // The way back can be used when it is possible again.
    back();
    CHECK(tree.path(top) == "top");
}

TEST_CASE(
    "an instance that a module is placing and its former parent can be neither deleted nor moved") {
    Tree tree;
    Guests guests(tree);
    const Handle from = tree.create(tree.object_class(), tree.root(), "from");
    const Handle to = tree.create(tree.object_class(), tree.root(), "to");
    const Handle top = guests.make(from, "top");
    const Handle below = guests.make(top, "below");
    std::vector<std::string> messages;
    guests.in_place = [&](Handle self) {
        const auto back = tree.placement_restorer(self);
        for (const Handle each : {self, to, from}) {
            messages.push_back(message_of([&] { tree.destroy(each); }));
            if (each == self) messages.push_back(message_of([&] { tree.move(self, {}); }));
        }
        messages.push_back(message_of([&] { tree.move(from, top); }));
        back();
    };
    tree.move(top, to);
    CHECK(messages ==
          std::vector<std::string>{
              "to.top is being moved: its module cannot delete it meanwhile",
              "to.top is being moved: its module cannot move it meanwhile",
              "to.top is being moved: its module cannot delete it meanwhile",
              "from is left by an instance that is being moved: its module cannot delete it "
              "meanwhile",
              "from is left by an instance that is being moved: its module cannot move it "
              "meanwhile"});
    CHECK(tree.path(below) == "to.top.below");
    CHECK(guests.rows_hold);
    CHECK_NOTHROW(tree.destroy(from));
    // An instance that is not placed yet may be deleted.
    guests.in_place = [&](Handle) { tree.destroy(below); };
    CHECK_NOTHROW(tree.move(top, tree.root()));
    CHECK_FALSE(tree.alive(below));
    tree.check(tree.snapshot());
}

TEST_CASE("an instance that takes the place of another stays although a module interferes") {
    Tree tree;
    Guests guests(tree);
    const Handle old = guests.make(tree.root(), "old");
    const Handle by = tree.create(tree.object_class(), {}, "by");
    std::string message;
    guests.in_destroy = [&](Handle) {
        message = message_of([&] { tree.destroy(by); });
        throw std::runtime_error("the disk is full");
    };
    CHECK_THAT(message_of([&] { tree.replace(old, by); }), contains("the disk is full"));
    CHECK_THAT(message, contains("is being moved: its module cannot delete it meanwhile"));
    CHECK_FALSE(tree.alive(old));
    CHECK(tree.path(by) == "old");
    tree.check(tree.snapshot());
}

TEST_CASE("a way back does nothing after the end of the tree") {
    auto tree = std::make_unique<Tree>();
    const Handle a = tree->create(tree->object_class(), tree->root(), "a");
    const auto back = tree->placement_restorer(a);
    tree.reset();
    CHECK_NOTHROW(back());
}

TEST_CASE("a way back moves nothing where a move is refused") {
    Tree tree;
    const Handle a = tree.create(tree.object_class(), tree.root(), "a");
    const Handle group = tree.create(tree.object_class(), tree.root(), "group");
    const auto back = tree.placement_restorer(a);
    tree.move(a, group);
    tree.set_formula(tree.root(), "f", {.function = [&](const Tree&) {
                         back();
                         return Value(1.0);
                     }});
    CHECK(tree.get(tree.root(), "f") == Value(1.0));
    CHECK(tree.path(a) == "group.a");
    {
        const Inquiry inquiry(tree, "a question", "must not");
        back();
        CHECK(tree.path(a) == "group.a");
    }
    back();
    CHECK(tree.path(a) == "a");
    // Below itself it cannot go.
    const Handle inside = tree.create(tree.object_class(), group, "inside");
    const auto into = tree.placement_restorer(inside);
    tree.move(inside, tree.root());
    tree.move(group, inside);
    into();
    CHECK(tree.path(group) == "inside.group");
    tree.check(tree.snapshot());
}

TEST_CASE("a way back to a name that is taken gives a numbered one") {
    Tree tree;
    const Handle group = tree.create(tree.object_class(), tree.root(), "group");
    const Handle a = tree.create(tree.object_class(), group, "a");
    const auto back = tree.placement_restorer(a);
    tree.move(a, tree.root());
    const Handle other = tree.create(tree.object_class(), group, "a");
    back();
    CHECK(tree.parent(a) == group);
    CHECK(tree.path(other) == "group.a");
    CHECK(tree.name(a) != "a");
    CHECK(tree.child(group, tree.name(a)) == a);
}

TEST_CASE("a draw function may move and delete instances") {
    Tree tree;
    Guests guests(tree);
    NoPainter painter;
    const Handle group = tree.create(tree.object_class(), tree.root(), "group");
    const auto draw = [&] {
        guests.drawn = guests.over = "";
        REQUIRE_NOTHROW(tree.draw(tree.root(), painter, 1));
        CHECK(guests.rows_hold);
    };
    const Handle a = guests.make(group, "a");
    const Handle b = guests.make(group, "b");
    guests.make(a, "c");
    guests.in_draw = [&](Handle self) { tree.move(self, {}); };
    draw();
    CHECK(guests.drawn == "a c b ");
    tree.move(a, group);
    guests.in_draw = [&](Handle self) {
        tree.destroy(self);
        guests.make(group, "d");
    };
    draw();  // b is the first child now
    CHECK(guests.drawn == "b a c ");
    CHECK(guests.over == "a c ");
    CHECK_FALSE(tree.alive(b));
    guests.in_draw = [&](Handle self) { tree.destroy(self); };
    draw();
    CHECK(guests.drawn == "a d ");
    CHECK(guests.over == "d ");
}

TEST_CASE("no move gives a child of the root the name game") {
    Tree tree;
    const Handle a = tree.create(tree.object_class(), {}, "game");
    tree.move(a, tree.root());
    CHECK(tree.name(a) == "game_1");
    CHECK(resolve(tree, tree.path(a)).instance == a);
    const Handle b = tree.create(tree.object_class(), {}, "game");
    PlainNames names;
    tree.move(b, tree.root(), {}, &names);
    CHECK(tree.name(b) == "game_2");
    const Handle inner = tree.create(tree.object_class(), a, "game");
    CHECK(tree.path(inner) == "game_1.game");
    CHECK_THROWS_AS(tree.replace(tree.root(), tree.create(tree.object_class())), Error);
}

}  // namespace placing_calls_test
