// The end of the services and of a loop, before and after the end of their tree.

#include <catch.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "game.h"

namespace services_test {

using namespace fettle;
using namespace fettle::app;

TEST_CASE("services that end before their tree leave none of their instances in it") {
    property::Tree tree;
    tree.create(tree.object_class(), tree.root(), "mine");
    std::optional<Services> services(std::in_place, tree);
    const property::Handle view = tree.child(tree.root(), "view");
    const property::Handle child = tree.create(tree.object_class(), view, "child");
    std::string deleted_paths;
    tree.watch_deleted(tree.object_class(), [&](const property::Existence& gone) {
        deleted_paths += gone.path + " ";
        if (gone.path != "view") return;
        CHECK(gone.last_values.size() > 5);
        CHECK(gone.cause.where == "the end of app::Services");
    });
    tree.barrier();
    tree.begin_edit("an edit that stays open");
    services.reset();
    tree.end_edit();
    CHECK_FALSE(tree.alive(view));
    CHECK_FALSE(tree.alive(child));
    CHECK(tree.size() == 2);
    CHECK(tree.parts().empty());
    tree.barrier();
    for (const char* path :
         {"time ", "time.timings ", "view ", "view.show ", "audio ", "audio.buses ",
          "audio.buses.music ", "input ", "input.keys ", "input.mouse ", "input.gamepad_1 "})
        CHECK_THAT(deleted_paths, contains(path));
    // No undo and no restore can create them again.
    tree.undo();
    CHECK(tree.size() == 2);
    tree.restore(tree.snapshot());
}

TEST_CASE("no instances of the classes of ended services can be made") {
    property::Tree tree;
    std::optional<Services> services(std::in_place, tree);
    tree.define({.name = "Louder", .base = "Audio"});
    // Neither those outside of the game nor those of derived classes are left.
    const property::Handle loose = tree.create(tree.class_named("Audio"));
    const property::Handle louder = tree.create(tree.class_named("Louder"), tree.root());
    const property::Snapshot before = tree.snapshot();
    services.reset();
    CHECK_FALSE(tree.alive(loose));
    CHECK_FALSE(tree.alive(louder));
    for (const char* name : {"Time", "Timings", "View", "Show", "Audio", "Louder", "Input", "Keys",
                             "Mouse", "Gamepad"}) {
        INFO(name);
        CHECK_THROWS_WITH(tree.create(tree.class_named(name), tree.root()),
                          contains(std::string(name) + ": it can have no instances any more"));
    }
    tree.define({.name = "Loudest", .base = "Louder"});
    CHECK_THROWS_WITH(tree.create(tree.class_named("Loudest")), contains("Loudest"));
    CHECK(tree.size() == 1);
    CHECK_THROWS(tree.restore(before));
    CHECK(tree.size() == 1);
    CHECK_THROWS_WITH(Services(tree), contains("the services cannot be added"));
}

TEST_CASE("services may end after their tree") {
    auto tree = std::make_unique<property::Tree>();
    const Services services(*tree);
    tree.reset();
    CHECK(services.clock.step == 0);
}

TEST_CASE("services that cannot be added to a tree leave nothing in it") {
    // Each name that the services take is taken once before them.
    std::vector<std::string> classes, children;
    {
        property::Tree tree;
        const std::size_t before = tree.classes().size();
        const Services services(tree);
        for (std::size_t i = before; i < tree.classes().size(); ++i)
            classes.push_back(tree.classes()[i]->name());
        for (const property::Handle child : tree.children(tree.root()))
            children.push_back(tree.name(child));
    }
    REQUIRE(classes.size() == 21);
    REQUIRE(children.size() == 4);
    const auto refused = [](property::Tree& tree) {
        const std::size_t size = tree.size(), count = tree.classes().size();
        CHECK_THROWS_WITH(Services(tree), contains("the services cannot be added"));
        CHECK(tree.size() == size);
        CHECK(tree.classes().size() == count);
        CHECK(tree.parts().empty());
    };
    for (const std::string& name : classes) {
        INFO(name);
        property::Tree tree;
        tree.define({.name = name});
        refused(tree);
    }
    for (const std::string& name : children) {
        INFO(name);
        property::Tree tree;
        tree.create(tree.object_class(), tree.root(), name);
        refused(tree);
    }
}

TEST_CASE("a jump in time that a destroyed loop requested is not made") {
    property::Tree tree;
    Services services(tree);
    script::Runtime runtime(tree, {});
    auto loop = std::make_unique<Loop>(tree, runtime, services);
    for (int i = 0; i < 5; ++i) loop->turn();
    services.clock.timeline.go_to(2);
    loop.reset();
    CHECK_NOTHROW(tree.barrier());
    CHECK(services.clock.step == 5);
}

}  // namespace services_test
