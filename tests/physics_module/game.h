#pragma once
// A game without scripts: a tree with physics, stepped as the loop does it.

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fettle/physics_module/physics_module.h>
#include <fettle/property/path.h>

namespace fettle::physics_module::testing {

using property::Handle;
using property::List;
using property::Tree;
using property::Value;
using property::Vec2;

class Game {
  public:
    Game() { physics.attach(tree); }

    Handle make(std::string_view of_class, Handle parent, std::string_view name = {}) {
        return tree.create(tree.class_named(of_class), parent, name);
    }
    Handle make(std::string_view of_class, Handle parent,
                std::initializer_list<std::pair<const char*, Value>> values) {
        const Handle made = make(of_class, parent);
        for (const auto& [property, value] : values) tree.set(made, property, value);
        return made;
    }
    /// Makes a body with one shape of that class.
    Handle body(std::string_view shape, const Vec2& position, std::string_view type = "dynamic") {
        const Handle made = make("Body", world(), {{"type", type}, {"position", position}});
        make(shape, made);
        return made;
    }
    /// Its upper side is at y = 0.
    Handle floor() {
        const Handle made = make("Body", world(), {{"type", "static"}, {"position", Vec2(0, -1)}});
        make("Box", made, {{"width", 40}, {"height", 2}});
        return made;
    }

    Handle world() const { return tree.child(tree.root(), "world"); }
    Handle shape_of(Handle body) const { return tree.first_child(body); }
    Value get(Handle of, std::string_view property) const { return tree.get(of, property); }
    double number(Handle of, std::string_view property) const { return get(of, property).number(); }
    Vec2 vec(Handle of, std::string_view property) const { return get(of, property).vec2(); }
    double y(Handle of) const { return vec(of, "position").y; }
    double x(Handle of) const { return vec(of, "position").x; }
    bool awake(Handle of) const { return get(of, "awake").boolean(); }
    void set(Handle of, std::string_view property, const Value& value) {
        tree.set(of, property, value);
    }

    /// As the loop does: barrier, step, report, barrier.
    void step(int count = 1) {
        for (int i = 0; i < count; ++i) {
            tree.set_step(tree.step() + 1);
            tree.stepped();
            tree.barrier();
            physics.step(1.0 / 60);
            physics.report(tree);
            tree.barrier();
        }
    }
    /// Steps until `body` sleeps; false if it does not within four seconds.
    bool falls_asleep(Handle body) {
        for (int i = 0; i < 240 && awake(body); ++i) step();
        return !awake(body);
    }

    PhysicsModule physics;  // outlives the tree
    Tree tree;
};

}  // namespace fettle::physics_module::testing
