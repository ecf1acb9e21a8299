// The order in which instances are drawn.

#include <catch.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include <fettle/property/drawing.h>
#include <fettle/property/painter.h>
#include <fettle/property/snapshot.h>
#include <fettle/property/tree.h>

#include "no_painter.h"

namespace draw_order_test {

using namespace fettle::property;
using fettle::property::testing::NoPainter;

namespace {

/// A tree with a class `Mark`, whose instances write their names when they are drawn, and a class
/// `Curtain`, which writes brackets around what is below it.
struct Stage {
    Tree tree;
    std::string log;
    const Class* mark = nullptr;
    const Class* curtain = nullptr;
    int passes = 1;

    Stage() {
        ClassDescriptor d{.name = "Mark"};
        d.lifecycle.context = this;
        d.lifecycle.draw = [](void* c, const Tree& in, Handle self, Row, Painter&, double) {
            static_cast<Stage*>(c)->log += in.name(self);
        };
        mark = &tree.define(std::move(d));
        ClassDescriptor layer{.name = "Curtain"};
        layer.lifecycle.context = this;
        layer.lifecycle.begin_below = [](void* c, const Tree&, Handle, Row, Painter& painter,
                                         int pass) {
            Stage& s = *static_cast<Stage*>(c);
            if (pass >= s.passes) return false;
            painter.push(Transform::moved({1, 0}));
            s.log += "(";
            return true;
        };
        layer.lifecycle.end_below = [](void* c, const Tree&, Handle, Row, Painter& painter) {
            painter.pop();
            static_cast<Stage*>(c)->log += ")";
        };
        curtain = &tree.define(std::move(layer));
    }
    Handle add(std::string_view name, Handle parent = {}, double z = 0) {
        const Handle made = tree.create(*mark, parent ? parent : tree.root(), name);
        if (z != 0) tree.set(made, "z", Value(z));
        return made;
    }
    std::string drawn() {
        log.clear();
        NoPainter painter;
        tree.draw(tree.root(), painter, 1);
        CHECK(painter.pushed() == 0);
        return log;
    }
};

}  // namespace

TEST_CASE_METHOD(Stage, "a drawer leaves out instances and keeps the layers around the others") {
    struct Chooser : Drawer {
        Tree& tree;
        std::string asked;
        explicit Chooser(Tree& of) : tree(of) {}
        bool draws(const Class&) override { return false; }
        bool begins(Handle instance) override {
            asked += tree.name(instance);
            return tree.name(instance) != "b";
        }
        void draw(Handle, Painter&) override {}
    } chooser(tree);
    const Handle layer = tree.create(*curtain, tree.root(), "layer");
    add("a", layer);
    add("b", layer);
    add("c");
    NoPainter painter;
    tree.draw(tree.root(), painter, 1, &chooser);
    CHECK(log == "(a)c");
    CHECK(chooser.asked == "abc");
}

TEST_CASE_METHOD(Stage, "without z the order of the tree is the order of drawing") {
    const Handle a = add("a");
    add("b", a);
    add("c");
    CHECK(drawn() == "abc");
}

TEST_CASE_METHOD(Stage, "instances and the marks over them can be drawn apart") {
    using Part = DrawingPart::Part;
    ClassDescriptor d{.name = "Ground"};
    d.lifecycle.context = this;
    d.lifecycle.draw_over = [](void* c, const Tree&, Handle, Row, Painter&, double) {
        static_cast<Stage*>(c)->log += "!";
    };
    const Handle ground = tree.create(tree.define(std::move(d)), tree.root(), "ground");
    add("a", ground);
    add("b");
    CHECK(drawn() == "ab!");
    {
        const DrawingPart instances(Part::instances);
        CHECK(drawn() == "ab");
        {
            const DrawingPart marks(Part::marks);
            CHECK(drawn() == "!");
        }
        CHECK(drawn() == "ab");
    }
    CHECK(drawn() == "ab!");
}

TEST_CASE_METHOD(
    Stage, "a larger z is drawn later and the z of a parent is added to that of its children") {
    const Handle a = add("a", {}, 2);
    add("b", a, -1);
    const Handle c = add("c");
    add("d", {}, 1);
    CHECK(drawn() == "cbda");  // 0, 1 (2 - 1), 1, 2: equal ones in the order of the tree
    tree.set(c, "z", Value(5.0));
    CHECK(drawn() == "bdac");
    tree.set(c, "z", Value(0.0));
    CHECK(drawn() == "cbda");
    tree.set(tree.root(), "z", Value(7.0));  // the same for all
    CHECK(drawn() == "cbda");
}

TEST_CASE_METHOD(Stage, "z is a property like every other one") {
    const Handle a = add("a");
    CHECK(tree.get(a, "z") == Value(0.0));
    CHECK_THROWS(tree.set(a, "z", Value(std::numeric_limits<double>::infinity())));
    CHECK_THROWS(tree.set(a, "z", Value(1e10)));
    CHECK_THROWS(tree.set(a, "z", Value("over")));
    tree.set(a, "z", Value(2));
    CHECK(tree.get(a, "z") == Value(2.0));
    CHECK(tree.overridden(a, tree.property(a, "z")));
    tree.reset(a, tree.property(a, "z"));
    CHECK(tree.get(a, "z") == Value(0.0));
    CHECK_FALSE(tree.overridden(a, tree.property(a, "z")));
}

TEST_CASE_METHOD(Stage, "a class may have another default of z") {
    const Class& high = tree.define(
        {.name = "High", .base = "Mark", .properties = {{.name = "z", .default_value = 3.0}}});
    const Handle a = tree.create(high, tree.root(), "a");
    add("b", {}, 1);
    CHECK(tree.get(a, "z") == Value(3.0));
    CHECK(tree.get(a, *tree.object_class().property("z")) == Value(3.0));
    CHECK(drawn() == "ba");
    tree.set(a, "z", Value(0.0));
    CHECK(drawn() == "ab");
    tree.set(a, "z", Value());
    CHECK(drawn() == "ba");
}

TEST_CASE_METHOD(Stage, "snapshots and undo bring z back") {
    const Handle a = add("a", {}, 4);
    const Handle b = add("b", {}, 3);
    const Handle gone = add("gone", {}, 9);
    tree.destroy(gone);
    const Snapshot before = tree.snapshot();
    tree.set(a, "z", Value(1.0));
    tree.set(b, "z", Value(0.0));
    const Handle again = add("again");
    CHECK(tree.get(again, "z") == Value(0.0));  // it has the place of the deleted one
    CHECK(drawn() == "bagaina");
    tree.restore(before);
    CHECK(tree.get(a, "z") == Value(4.0));
    CHECK(tree.get(b, "z") == Value(3.0));
    CHECK(drawn() == "ba");
    const Snapshot from_file = Snapshot::from_bytes(before.to_bytes());
    tree.set(a, "z", Value(1.0));
    tree.restore(from_file);
    CHECK(tree.get(a, "z") == Value(4.0));
}

TEST_CASE_METHOD(Stage, "instances below a layer are drawn between its beginning and its end") {
    const Handle layer = tree.create(*curtain, tree.root(), "layer");
    add("a", layer);
    add("b");
    add("c", layer);
    CHECK(drawn() == "(ac)b");
    tree.set(tree.child(layer, "c"), "z", Value(1.0));
    CHECK(drawn() == "(a)b(c)");
    tree.set(layer, "z", Value(1.0));
    CHECK(drawn() == "b(ac)");
    const Handle inner = tree.create(*curtain, layer, "inner");
    add("d", inner, 5);
    add("e", layer, 6);
    CHECK(drawn() == "b(ac)((d))(e)");
    passes = 2;
    CHECK(drawn() == "b(ac)(ac)((d)(d))((d)(d))(e)(e)");
    passes = 0;
    CHECK(drawn() == "b");
}

TEST_CASE_METHOD(Stage, "layers end when a draw function throws") {
    const Handle layer = tree.create(*curtain, tree.root(), "layer");
    ClassDescriptor d{.name = "Thrower"};
    d.lifecycle.draw = [](void*, const Tree&, Handle, Row, Painter&, double) {
        throw std::runtime_error("no paint");
    };
    tree.create(tree.define(std::move(d)), layer, "thrower");
    NoPainter painter;
    CHECK_THROWS(tree.draw(tree.root(), painter, 1));
    CHECK(painter.pushed() == 0);
}

TEST_CASE_METHOD(Stage, "a drawer draws after the class of the instance") {
    struct Second : Drawer {
        std::string& log;
        const Class& of;
        Second(std::string& l, const Class& c) : log(l), of(c) {}
        bool draws(const Class& asked) override { return &asked == &of; }
        void draw(Handle, Painter&) override { log += "+"; }
    } also(log, *mark);
    add("a", {}, 1);
    add("b");
    NoPainter painter;
    tree.draw(tree.root(), painter, 1, &also);
    CHECK(log == "b+a+");
}

TEST_CASE_METHOD(Stage, "a service may call another property z") {
    static bool down = false;
    static int context = 0;
    const auto key = [] {
        return Property{.name = "z",
                        .type = Type::boolean,
                        .binding = accessor(
                            context, [](int&, Row) { return down; },
                            [](int&, Row, const Value& v) { down = v.boolean(); })};
    };
    CHECK_THROWS(tree.define({.name = "Thing", .properties = {key()}}));
    const Class& keys = tree.define({.name = "Keys", .creatable = false, .properties = {key()}});
    const Handle made = tree.create(keys, tree.root());
    add("a", made, 1);
    add("b");
    tree.set(made, "z", Value(true));
    CHECK(down);
    CHECK(tree.get(made, "z") == Value(true));
    CHECK(drawn() == "ba");
    const Snapshot before = tree.snapshot();
    tree.set(made, "z", Value(false));
    tree.restore(Snapshot::from_bytes(before.to_bytes()));
    CHECK(down);
    CHECK(drawn() == "ba");
}

TEST_CASE("only a stored number can be sparse") {
    Tree tree;
    Property text{.name = "label", .type = Type::text};
    text.sparse = true;
    CHECK_THROWS(tree.define({.name = "Labelled", .properties = {text}}));
}

TEST_CASE("transforms combine and measure") {
    const Transform t = Transform::placed({3, 1}, std::acos(0.0)) * Transform::scaled({2, 4});
    CHECK((t({1, 0}) - Vec2(3, 3)).length() < 1e-12);
    CHECK((t({0, 1}) - Vec2(-1, 1)).length() < 1e-12);
    CHECK(std::abs(t.area() - 8) < 1e-12);
    CHECK(std::abs(t.scale() - std::sqrt(8.0)) < 1e-12);
    CHECK(Transform().is_identity());
    CHECK_FALSE(t.is_identity());
}

}  // namespace draw_order_test
