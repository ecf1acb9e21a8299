#include <fettle_physics.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>

#include "catch.h"

namespace {

/// A global variable with worlds in C that is destroyed after the static objects of the library.
struct AtExitHost {
    fettle_world *ended = nullptr, *world = nullptr;

    ~AtExitHost() {
        if (world == nullptr) return;
        bool right = fettle_world_step(ended, 0.1f) == FETTLE_STALE;
        right &= fettle_world_step(world, 0.1f) == FETTLE_DONE;
        right &= fettle_world_destroy(world) == FETTLE_DONE;
        right &= fettle_world_destroy(world) == FETTLE_STALE;
        _exit(right ? 7 : 8);
    }
};
AtExitHost host_at_exit;

}  // namespace

TEST_CASE("a world in C can be used and destroyed when the program ends") {
    const pid_t child = fork();
    if (child == 0) {
        AtExitHost& host = host_at_exit;
        if (fettle_world_create(nullptr, &host.ended) != FETTLE_DONE) _exit(1);
        if (fettle_world_create(nullptr, &host.world) != FETTLE_DONE) _exit(1);
        if (fettle_world_destroy(host.ended) != FETTLE_DONE) _exit(1);
        std::exit(2);
    }
    int status = 0;
    REQUIRE(waitpid(child, &status, 0) == child);
    REQUIRE(WIFEXITED(status));
    CHECK(WEXITSTATUS(status) == 7);
}
