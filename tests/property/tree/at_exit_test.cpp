#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <memory>

#include <fettle/property/path.h>
#include <fettle/property/tree.h>

#include "catch.h"

namespace at_exit_test {

using namespace fettle::property;

namespace {

/// A global variable with a tree that is used and destroyed after the static objects of functions.
struct Host {
    std::unique_ptr<Tree> tree;

    ~Host() {
        if (tree == nullptr) return;
        bool right = bool(Symbol::find("place_of_host"));
        const Handle place = tree->child(tree->root(), "place_of_host");
        right &= bool(place) && tree->path(place) == "place_of_host";
        tree->create(tree->class_named("Object"), place, "child_of_host");
        right &= tree->path(tree->child(place, "child_of_host")) == "place_of_host.child_of_host";
        tree.reset();
        _exit(right ? 7 : 8);
    }
};
Host host;

}  // namespace

TEST_CASE("a tree that is a global variable can be used until it is destroyed") {
    const pid_t child = fork();
    if (child == 0) {
        host.tree = std::make_unique<Tree>();
        host.tree->create(host.tree->class_named("Object"), host.tree->root(), "place_of_host");
        std::exit(1);
    }
    int status = 0;
    REQUIRE(waitpid(child, &status, 0) == child);
    REQUIRE(WIFEXITED(status));
    CHECK(WEXITSTATUS(status) == 7);
}

}  // namespace at_exit_test
