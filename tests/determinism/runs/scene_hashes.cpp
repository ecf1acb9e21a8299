// Prints the hash of every short scene, of a small scene with each solver, and of all these hashes
// together. The output must be the same for every compiler, optimization level and machine, every
// width of vectors and every number of threads.
//
//   scene_hashes [WIDTH [THREADS]]    WIDTH: of vectors, at most; 0: the widest of the machine

#include <cinttypes>
#include <cstdio>
#include <cstdlib>
#include <utility>

#include "runs/scene_run.h"

namespace {

/// Prints hashes and sums them up.
class Listing {
  public:
    void add(const char* name, std::uint64_t hash) {
        std::printf("%s %016" PRIx64 "\n", name, hash);
        all_ = (all_ ^ hash) * 0x9e3779b97f4a7c15u;
        all_ ^= all_ >> 32;
    }
    std::uint64_t all() const { return all_; }

  private:
    std::uint64_t all_ = 0;
};

}  // namespace

int main(int count, char** arguments) {
    using namespace fettle::scene_run;
    using fettle::physics::Solver;
    RunOptions options;
    if (count > 1) options.simd_width = std::atoi(arguments[1]);
    if (count > 2) options.threads = std::atoi(arguments[2]);
    Listing listing;
    for (const ShortScene& scene : short_scenes())
        listing.add(scene.name.data(), run_scene(scene, options));
    for (const auto& [name, solver] :
         {std::pair{"sequential", Solver::sequential}, std::pair{"direct", Solver::direct}}) {
        options.solver = solver;
        listing.add(name, run_scene(small_crowd, options));
    }
    listing.add("all", listing.all());
}
