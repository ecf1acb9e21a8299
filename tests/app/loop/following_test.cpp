// The view follows an instance, keeps to limits, is turned, and shakes.

#include <catch.h>

#include <cmath>

#include <fettle/app/services.h>
#include <fettle/property/error.h>
#include <fettle/property/snapshot.h>

namespace following_test {

using namespace fettle;
using property::Handle;
using property::List;
using property::Value;
using property::Vec2;

namespace {

struct Game {
    property::Tree tree;
    app::Services services{tree};
    app::View& view = services.view;
    Handle self = tree.child(tree.root(), "view");
    Handle target = tree.create(tree.object_class(), tree.root(), "target");

    Game() {
        tree.set_or_add(target, "position", Value(Vec2(8, 4)));
        tree.set(self, "follow", Value(target));
    }
    void place(const Vec2& at) { tree.set(target, "position", Value(at)); }
    Vec2 after(int steps) {
        for (int i = 0; i < steps; ++i) {
            view.note_step_begins();
            view.advance(tree, 1.0 / 60);
            view.note_step_ended();
        }
        return view.center;
    }
};

bool near(const Vec2& a, const Vec2& b, double tolerance = 1e-9) {
    return (a - b).length() < tolerance;
}

}  // namespace

TEST_CASE_METHOD(Game, "the view is where the instance is") {
    CHECK(near(after(1), {8, 4}));
    const Handle above = tree.create(tree.object_class(), tree.root(), "above");
    tree.set_or_add(above, "position", Value(Vec2(100, 0)));
    tree.set_or_add(above, "angle", Value(std::acos(0.0)));
    tree.move(target, above);
    CHECK(near(after(1), {96, 8}));
    tree.destroy(target);
    CHECK(near(after(1), {96, 8}));
    tree.set(self, "follow", Value(Handle{}));
    tree.set(self, "center", Value(Vec2(1, 2)));
    CHECK(near(after(5), {1, 2}));
}

TEST_CASE_METHOD(Game, "with damping the view follows with a delay") {
    tree.set(self, "follow_damping", Value(0.5));
    CHECK(near(after(30), Vec2(8, 4) * (1 - std::exp(-1.0)), 1e-6));
    CHECK(near(after(600), {8, 4}, 1e-3));
}

TEST_CASE_METHOD(Game, "the view does not move while the instance stays in the dead zone") {
    tree.set(self, "dead_zone", Value(Vec2(2, 100)));
    CHECK(near(after(1), {7, 0}));
    place({6.5, 3});
    CHECK(near(after(1), {7, 0}));
    place({5, 0});
    CHECK(near(after(1), {6, 0}));
}

TEST_CASE_METHOD(Game, "the view stays within its limits") {
    tree.set(self, "limits", Value(List{Vec2(-30, -12), Vec2(20, 12)}));
    after(1);
    CHECK(view.upper().x <= 20 + 1e-9);
    CHECK(near(view.center, {4, 2}));  // 32 x 20 m are seen
    tree.set(self, "limits", Value(List{Vec2(0, 0), Vec2(10, 10)}));
    CHECK(near(after(1), {5, 5}));
    CHECK_THROWS_AS(tree.set(self, "limits", Value(List{Vec2(1, 0), Vec2(0, 1)})), property::Error);
    CHECK_THROWS_AS(tree.set(self, "limits", Value(List{Vec2(1, 0)})), property::Error);
    CHECK_THROWS_AS(tree.set(self, "limits", Value(List{Value(1.0), Value(2.0)})), property::Error);
    tree.set(self, "limits", Value(List{}));
    CHECK(near(after(1), {8, 4}));
}

TEST_CASE_METHOD(Game, "a picture shows the view between two steps") {
    tree.set(self, "follow_damping", Value(1e-9));
    after(1);
    place({10, 4});
    after(1);
    CHECK(near(view.drawn(tree, 0.5).center, {9, 4}));
    CHECK(near(view.drawn(tree, 1).center, {10, 4}));
    tree.set(self, "center", Value(Vec2(0, 0)));  // by the game, after the step
    CHECK(near(view.drawn(tree, 0.5).center, {0, 0}));
}

TEST_CASE_METHOD(Game, "what the view follows without a delay is in the middle of every picture") {
    after(1);
    place({10, 4});
    CHECK(near(view.drawn(tree, 0.5).center, {10, 4}));
    tree.set(self, "limits", Value(List{Vec2(-30, -12), Vec2(20, 12)}));
    CHECK(near(view.drawn(tree, 0.5).center, {4, 2}));
    tree.set(self, "center", Value(Vec2(1, 1)));
    CHECK(near(view.drawn(tree, 0.5).center, {1, 1}));
}

TEST_CASE_METHOD(Game, "a turn and a zoom of the view are drawn between two steps") {
    tree.set(self, "follow", Value(Handle{}));
    view.note_step_begins();
    tree.set(self, "angle", Value(0.4));
    tree.set(self, "height", Value(30.0));
    view.note_step_ended();
    CHECK(view.drawn(tree, 0.5).angle == Approx(0.2));
    CHECK(view.drawn(tree, 0.5).height == Approx(25));
    CHECK(view.drawn(tree, 1).height == Approx(30));
}

TEST_CASE_METHOD(Game, "a cut of the view to another place is not drawn on its way") {
    tree.set(self, "follow", Value(Handle{}));
    view.note_step_begins();
    tree.set(self, "center", Value(Vec2(100, 0)));
    view.note_step_ended();
    CHECK(near(view.drawn(tree, 0.5).center, {100, 0}));
}

TEST_CASE_METHOD(Game, "a shake moves the picture only and ends") {
    after(1);
    tree.call(self, "shake", {Value(0.5), Value(0.5)});
    double most = 0;
    for (int i = 0; i < 29; ++i) {
        CHECK(near(after(1), {8, 4}));
        const double moved = (view.drawn(tree, 1).center - view.center).length();
        CHECK(moved < 0.75);
        most = std::max(most, moved);
    }
    CHECK(most > 0.1);
    tree.call(self, "shake", {Value(0.001), Value(9.0)});  // weaker than what is left
    CHECK(tree.get(self, "shake_left").number() < 0.5);
    after(2);
    CHECK(near(view.drawn(tree, 1).center, view.center));
    CHECK_THROWS_AS(tree.call(self, "shake", {Value(-1.0)}), property::Error);
}

TEST_CASE_METHOD(Game, "snapshots contain the instance that the view follows") {
    tree.set(self, "limits", Value(List{Vec2(-50, -50), Vec2(50, 50)}));
    const property::Snapshot before = tree.snapshot();
    tree.set(self, "follow", Value(Handle{}));
    tree.set(self, "limits", Value(List{}));
    tree.restore(property::Snapshot::from_bytes(before.to_bytes()));
    CHECK(view.follow == target);
    CHECK(view.limits.size() == 2);
}

TEST_CASE_METHOD(Game, "a turned view converts points and has the corners of what is visible") {
    tree.set(self, "follow", Value(Handle{}));
    tree.set(self, "angle", Value(std::acos(0.0)));
    const Vec2 right = view.to_screen({0, 1});  // what is up in the world is to the right
    CHECK(near(right, 0.5 * view.screen + Vec2(view.zoom(), 0), 1e-6));
    CHECK(near(view.to_world(view.to_screen({3, -2})), {3, -2}, 1e-6));
    CHECK(view.upper().x == Approx(0.5 * view.height));
    CHECK(view.upper().y == Approx(0.5 * view.width()));
}

TEST_CASE_METHOD(Game, "a design size keeps its proportions") {
    tree.set(self, "follow", Value(Handle{}));
    view.screen = {1280, 800};
    tree.set(self, "height", Value(10.0));
    CHECK(view.width() == Approx(16));
    tree.set(self, "design", Value(Vec2(320, 180)));
    tree.set(self, "fit", Value("letterbox"));
    CHECK(view.zoom() == Approx(72));  // 1280 x 720 pixels
    CHECK(view.width() == Approx(10 * 16.0 / 9));
    CHECK(near(view.to_window(view.upper()), {1280, 40}, 1e-6));
    CHECK(near(view.to_screen(view.upper()), {1280, 0}, 1e-6));
    CHECK(near(view.to_world({0, 720}), view.lower(), 1e-9));
    view.screen = {1000, 800};
    tree.set(self, "fit", Value("pixel"));
    CHECK(view.zoom() == Approx(54));  // three pixels for each of the design
    view.screen = {100, 100};
    CHECK(view.zoom() == Approx(18));  // never less than one
    tree.set(self, "zoom", Value(36.0));
    CHECK(view.height == Approx(5));
    CHECK_THROWS_AS(tree.set(self, "fit", Value("stretch")), property::Error);
    CHECK_THROWS_AS(tree.set(self, "design", Value(Vec2(0, 100))), property::Error);
}

}  // namespace following_test
