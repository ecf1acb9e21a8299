// Equal inputs give equal bits: in every run, with every instruction set, and after saving and
// restoring. For compilers and optimization levels, see `scene_hashes`, which ./check --full
// builds.

#include <fettle/physics/instruction_set.h>

#include <cstddef>
#include <string>
#include <vector>

#include "catch.h"
#include "runs/scene_run.h"
#include "thorough.h"

namespace determinism_test {

using namespace fettle::scene_run;
using fettle::physics::Solver;
using fettle::physics::World;

namespace {

void save_disturb_and_restore(World& world) {
    std::vector<std::byte> saved;
    world.save(saved);
    const auto before = world.hash();
    world.set_gravity({5, 5});
    for (int i = 0; i < 3; ++i) world.step(1.0f / 60);
    CHECK(world.hash() != before);
    world.restore(saved);
    CHECK(world.hash() == before);
}

/// Runs the scene again, with narrow instructions and with a restore in the middle: in a thorough
/// run apart from each other, and also in the same way and with every instruction set of this
/// machine. A quick run ends in the middle of the scene, but for bodies that have not landed by
/// then.
void check_scene(ShortScene scene, const RunOptions& plain = {}) {
    if (!thorough() && scene.name != "junkyard") scene.steps /= 2;
    INFO(scene.name << ", solver " << static_cast<int>(plain.solver));
    const std::uint64_t expected = run_scene(scene, plain);
    if (thorough()) CHECK(run_scene(scene, plain) == expected);
    for (const int width : {4, 8}) {
        if (!thorough() || width >= fettle::physics::simd_width()) continue;
        RunOptions narrow = plain;
        narrow.simd_width = width;
        INFO("instructions of " << width << " numbers");
        CHECK(run_scene(scene, narrow) == expected);
    }
    RunOptions restored = plain;
    restored.in_the_middle = save_disturb_and_restore;
    if (!thorough()) restored.simd_width = 4;
    INFO("restored in the middle" << (thorough() ? "" : ", instructions of 4 numbers"));
    CHECK(run_scene(scene, restored) == expected);
}

const ShortScene& scene_of(std::string_view name) {
    for (const ShortScene& scene : short_scenes())
        if (scene.name == name) return scene;
    FAIL("no such scene");
    return short_scenes()[0];
}

}  // namespace

TEST_CASE("a grid of joints ends in the same state in every kind of run") {
    check_scene(scene_of("joint_grid"));
}
TEST_CASE("a large pyramid ends in the same state in every kind of run") {
    check_scene(scene_of("large_pyramid"));
}
TEST_CASE("many pyramids end in the same state in every kind of run") {
    check_scene(scene_of("many_pyramids"));
}
TEST_CASE("a smashed wall ends in the same state in every kind of run") {
    check_scene(scene_of("smash"));
}
TEST_CASE("a tumbler ends in the same state in every kind of run") {
    check_scene(scene_of("tumbler"));
}
TEST_CASE("a spinner ends in the same state in every kind of run") {
    check_scene(scene_of("spinner"));
}
TEST_CASE("a washer ends in the same state in every kind of run") {
    check_scene(scene_of("washer"));
}
TEST_CASE("falling compounds end in the same state in every kind of run") {
    check_scene(scene_of("compounds"));
}
TEST_CASE("a junkyard ends in the same state in every kind of run") {
    check_scene(scene_of("junkyard"));
}
TEST_CASE("raining ragdolls end in the same state in every kind of run") {
    check_scene(scene_of("rain"));
}
TEST_CASE("a crowd ends in the same state with every solver in every kind of run") {
    for (const Solver solver : {Solver::soft_step, Solver::sequential, Solver::direct})
        check_scene(small_crowd, {.solver = solver});
}

}  // namespace determinism_test
