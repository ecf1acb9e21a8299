// What the console costs in large games. The times are told, not checked; what is drawn must not
// grow with the game.

#include <cstdio>
#include <ctime>
#include <string>

#include "catch.h"
#include "rig.h"

namespace cost_test {

using namespace fettle;
using console::test::RasterSurface;
using property::Handle;
using property::Value;

namespace {

double cpu_milliseconds() {
    timespec now{};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

/// A world with many bodies and a console.
struct LargeGame {
    explicit LargeGame(int bodies) : runtime((console::test::make_game(tree), tree), {}) {
        const Handle world = tree.child(tree.root(), "world");
        for (int i = 3; i < bodies; ++i) tree.create(tree.class_named("Body"), world);
        tree.barrier();
        lua = std::make_unique<console::Console>(tree, runtime, console::Options{});
    }
    /// The mean of some frames after the first ones, which lay out and read the tree.
    void tell(const std::string& what) {
        constexpr int frames = 60;
        for (int i = 0; i < 10; ++i) frame();
        const double begin = cpu_milliseconds();
        double longest = 0;
        for (int i = 0; i < frames; ++i) {
            const double before = cpu_milliseconds();
            frame();
            longest = std::max(longest, cpu_milliseconds() - before);
        }
        std::printf("console: %zu instances, %s: %.3f ms of CPU time a frame, the longest %.3f\n",
                    tree.size(), what.c_str(), (cpu_milliseconds() - begin) / frames, longest);
    }
    void frame() {
        surface.clear();
        lua->between_frames();
        lua->after_step();
        lua->draw(surface, 1.0 / 60);
        triangles = surface.triangle_count();
    }
    property::Tree tree;
    script::Runtime runtime;
    RasterSurface surface{1280, 800};
    std::unique_ptr<console::Console> lua;
    std::size_t triangles = 0;
};

/// Triangles of the open console with one selected instance and ten plots.
std::size_t cost_of(int bodies) {
    LargeGame game(bodies);
    game.tell("closed");
    CHECK(game.triangles == 0);
    game.lua->open();
    game.tell("open");
    game.lua->select(game.tree.child(game.tree.child(game.tree.root(), "world"), "ball"));
    game.tell("one selected");
    std::string command = "plot world.ball.mass";
    for (int i = 1; i < 10; ++i) command += ", world.ball.mass + " + std::to_string(i);
    game.lua->state().run(command);
    game.tell("ten plots");
    const std::size_t triangles = game.triangles;
    auto& inspector = game.lua->state().inspector;
    std::vector<Handle> all = game.tree.children(game.tree.child(game.tree.root(), "world"));
    inspector.select(all);
    game.tell("all selected");
    CHECK(inspector.selection().size() == static_cast<std::size_t>(bodies));
    return triangles;
}

}  // namespace

TEST_CASE("what the console draws does not grow with the game") {
    const std::size_t small = cost_of(10'000), large = cost_of(100'000);
    CHECK(small > 100);
    CHECK(large < small + small / 10);
}

}  // namespace cost_test
