// The visuals may end before the tree.

#include <catch.h>

#include <memory>

#include "gallery.h"

namespace lifetime_test {

using namespace fettle::visuals::test;

TEST_CASE("the instances of the visuals are deleted with them") {
    Sheet sheet;
    Tree tree;
    auto visuals = std::make_unique<fettle::visuals::Visuals>(nullptr);
    visuals->attach(tree);
    const Handle layer = tree.create(tree.class_named("Layer"), tree.root(), "layer");
    const Handle line = tree.create(tree.class_named("Line"), layer, "line");
    const Handle detached = tree.create(tree.class_named("Sprite"));
    const Handle map = tree.create(tree.class_named("Tilemap"), tree.root(), "map");
    const Handle emitter = tree.create(tree.class_named("Emitter"), tree.root(), "emitter");
    CHECK_THROWS_AS(visuals->attach(tree), std::logic_error);
    visuals.reset();
    CHECK_FALSE(tree.alive(layer));
    CHECK_FALSE(tree.alive(line));
    CHECK_FALSE(tree.alive(detached));
    CHECK_FALSE(tree.alive(map));
    CHECK_FALSE(tree.alive(emitter));
    tree.restore(tree.snapshot());
    tree.barrier();
    CHECK_THROWS_AS(tree.create(tree.class_named("Text"), tree.root(), "text"), Error);
    tree.draw(tree.root(), sheet, 1);
    CHECK(sheet.all.empty());
}

TEST_CASE("a tree may end before the visuals") {
    fettle::visuals::Visuals visuals(nullptr);
    {
        Tree tree;
        visuals.attach(tree);
        tree.create(tree.class_named("Text"), tree.root(), "text");
    }
    CHECK_NOTHROW(visuals.step(0.1));
}

}  // namespace lifetime_test
