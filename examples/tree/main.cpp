// The property tree with physics in it, in a loop of your own: no window, no Lua, no console.
// Every value has a path, can be watched, edited, undone and saved.

#include <cstdio>
#include <string>

#include <fettle/physics_module/physics_module.h>
#include <fettle/property/path.h>
#include <fettle/property/storage/scene.h>

using namespace fettle;
using property::Handle;
using property::Value;
using property::Vec2;

int main() {
    physics_module::PhysicsModule physics;  // outlives the tree that uses its memory
    property::Tree tree;
    physics.attach(tree);

    // Instances are created by class; properties are set by path.
    const Handle world = property::resolve(tree, "world").instance;
    const Handle floor = tree.create(tree.class_named("Body"), world, "floor");
    tree.create(tree.class_named("Box"), floor, "box");
    property::set(tree, "world.floor.type", "static");
    property::set(tree, "world.floor.box.width", 40);
    const Handle ball = tree.create(tree.class_named("Body"), world, "ball");
    tree.create(tree.class_named("Circle"), ball, "circle");
    property::set(tree, "world.ball.position", Vec2(0, 8));
    property::set(tree, "world.ball.circle.restitution", 0.7);

    // Changes and events are delivered at barriers.
    tree.watch(ball, "awake", [&](const property::Change& change) {
        std::printf("step %llu: the ball %s\n", static_cast<unsigned long long>(change.cause.step),
                    change.new_value.boolean() ? "woke" : "fell asleep");
    });
    int bounces = 0;
    tree.on(ball, *tree.class_of(ball).event("contact_begin"),
            [&](const property::Occurrence&) { ++bounces; });
    // A formula computes a property.
    tree.set_formula(floor, "label", {.function = [ball](const property::Tree& t) {
                         return Value("below a ball of " + t.text(t.get(ball, "mass")) + " kg");
                     }});

    for (std::uint64_t step = 1; step <= 600; ++step) {  // the host's own loop
        tree.set_step(step);
        {
            const property::Tree::CauseScope cause(tree, property::Writer::simulation);
            physics.step(1.0 / 60);
            physics.report(tree);
        }
        tree.barrier();
    }
    std::printf("%d bounces, at rest at %s\n", bounces,
                tree.text(property::get(tree, "world.ball.position")).c_str());

    // The body of an instance can be used directly, without the tree.
    physics.body(ball).apply_impulse({0, 2});
    property::set(tree, "world.ball.mass", 5);  // an edit: the formula is computed again
    std::printf("%s\n", property::get(tree, "world.floor.label").text().c_str());
    try {
        property::set(tree, "world.ball.positon", 3);
    } catch (const property::Error& error) {
        std::printf("%s\n", error.what());
    }
    std::printf("%s", property::scene_text(tree, ball).c_str());
    return bounces > 3 ? 0 : 1;
}
