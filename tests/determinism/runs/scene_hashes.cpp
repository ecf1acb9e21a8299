// Prints the hash of every short scene, and of a small scene with each solver. The output must be
// the same for every compiler, optimization level and machine.

#include <cinttypes>
#include <cstdio>
#include <utility>

#include "runs/scene_run.h"

int main() {
    using namespace fettle::scene_run;
    using fettle::physics::Solver;
    for (const ShortScene& scene : short_scenes())
        std::printf("%s %016" PRIx64 "\n", scene.name.data(), run_scene(scene));
    for (const auto& [name, solver] :
         {std::pair{"sequential", Solver::sequential}, std::pair{"direct", Solver::direct}}) {
        const RunOptions options = {.solver = solver};
        std::printf("%s %016" PRIx64 "\n", name, run_scene(small_crowd, options));
    }
}
