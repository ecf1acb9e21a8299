#include "runs/scene_run.h"

#include <array>

#include "engines/fettle_engine.h"
#include "measure/simulation.h"
#include "scenes/catalogue.h"

namespace fettle::scene_run {

std::span<const ShortScene> short_scenes() {
    static constexpr std::array<ShortScene, 10> scenes = {{
        {"joint_grid", 40},
        {"large_pyramid", 40},
        {"many_pyramids", 20},
        {"smash", 60},
        {"tumbler", 100},
        {"spinner", 60},
        {"washer", 40},
        {"compounds", 60},
        {"junkyard", 120},
        {"rain", 60},
    }};
    return scenes;
}

std::uint64_t run_scene(const ShortScene& short_scene, const RunOptions& options) {
    bench::Scene scene = short_scene.name == small_crowd.name
                             ? bench::crowd_of(12, 8)
                             : bench::scene_named(short_scene.name).make();
    scene.steps = options.times > 0 ? scene.steps * options.times : short_scene.steps;
    auto engine = bench::make_fettle(scene, options.solver, 4);
    engine->set_threads(options.threads);
    physics::World& world = bench::fettle_world(*engine);
    if (options.simd_width > 0) world.limit_simd_width(options.simd_width);
    bench::Simulation simulation(scene, "fettle", std::move(engine));
    for (int step = 0; step < scene.steps; ++step) {
        simulation.advance(1);
        if (options.after_step) options.after_step(world);
        if (options.in_the_middle && step == scene.steps / 2) options.in_the_middle(world);
    }
    return simulation.hash();
}

}  // namespace fettle::scene_run
