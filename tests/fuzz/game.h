#pragma once
// The tree of a small game, which the fuzzers use.

#include <fettle/physics_module/physics_module.h>
#include <fettle/property/tree.h>

#include "text.h"

namespace fettle::fuzz {

struct Game {
    // The module outlives the tree, which calls it for every deleted instance.
    physics_module::PhysicsModule module;
    property::Tree tree;
    property::Handle world;

    Game() {
        module.attach(tree);
        world = tree.child(tree.root(), "world");
        const property::Handle ball = tree.create(tree.class_named("Body"), world, "ball");
        tree.create(tree.class_named("Circle"), ball, "circle");
        tree.create(tree.class_named("Polygon"), ball, "hull");
        const property::Handle odd = tree.create(tree.object_class(), world, "my box");
        tree.set_or_add(odd, "lives", 3);
        tree.set_or_add(odd, "scores", property::List{1, 2.5, "three"});
    }
};

}  // namespace fettle::fuzz
