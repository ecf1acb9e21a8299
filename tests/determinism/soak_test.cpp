// Long runs of scenes: no number becomes infinite, no body leaves its container, and the memory
// does not grow. With FETTLE_SOAK=10, each scene runs ten times as long as in the benchmark;
// without it the runs are short.

#include <fettle/physics/host_access.h>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <string>
#include <vector>

#include "catch.h"
#include "runs/scene_run.h"

namespace soak_test {

using namespace fettle::scene_run;
using namespace fettle::physics;

namespace {

/// The region in which a scene keeps its bodies, m; an open side is infinite. `lost`: the number of
/// bodies that may leave it.
struct Pen {
    std::string_view scene;
    Aabb box;
    int lost = 0;
};

Pen pen_of(std::string_view scene) {
    static const Pen pens[] = {
        {"large_pyramid", {{-infinity, -2}, {infinity, infinity}}},
        {"many_pyramids", {{-infinity, -2}, {infinity, infinity}}},
        {"tumbler", {{-16, -6}, {16, 26}}},
        // The tip of the rotor, whose torque is unlimited, touches the ring, so bodies between them
        // are pressed through the ring.
        {"spinner", {{-42, -10}, {42, 74}}, 12},
        {"washer", {{-20, -10}, {20, 30}}},
        {"compounds", {{-800, -82}, {800, infinity}}},
    };
    for (const Pen& pen : pens)
        if (pen.scene == scene) return pen;
    return {scene, {{-infinity, -infinity}, {infinity, infinity}}};
}

class Watch {
  public:
    explicit Watch(std::string_view scene) : pen_(pen_of(scene)) {}

    void look(const World& world) {
        if (++steps_ % 20 != 0) return;
        int outside = 0;
        for (uint32_t slot = 1; slot < HostAccess::body_slots(world); ++slot) {
            if (HostAccess::body_generation(world, slot) == 0) continue;
            const BodyState& s = HostAccess::state(world, slot);
            finite = finite && s.position.is_finite() && s.velocity.is_finite() &&
                     std::isfinite(s.angle) && std::isfinite(s.angular_velocity);
            const Aabb& box = pen_.box;
            outside += !(s.position.x > box.min.x && s.position.y > box.min.y &&
                         s.position.x < box.max.x && s.position.y < box.max.y);
        }
        inside = inside && outside <= pen_.lost;
        if (steps_ % 100 != 0) return;
        saved_.clear();
        world.save(saved_);
        sizes.push_back(saved_.size());
    }

    bool finite = true, inside = true;
    std::vector<std::size_t> sizes;  // of the world, in bytes, at intervals

  private:
    Pen pen_;
    int steps_ = 0;
    std::vector<std::byte> saved_;
};

}  // namespace

TEST_CASE("long runs have no infinite numbers or escaped bodies or growing memory", "[soak]") {
    const char* wanted = std::getenv("FETTLE_SOAK");
    const int times = wanted != nullptr ? std::atoi(wanted) : 0;
    for (const ShortScene& scene : short_scenes()) {
        INFO(scene.name);
        Watch watch(scene.name);
        RunOptions options;
        options.times = times;
        options.after_step = [&watch](World& world) { watch.look(world); };
        run_scene(scene, options);
        CHECK(watch.finite);
        CHECK(watch.inside);
        if (watch.sizes.size() < 4) continue;
        const auto half = watch.sizes.begin() + std::ptrdiff_t(watch.sizes.size() / 2);
        const std::size_t before = *std::max_element(watch.sizes.begin(), half);
        const std::size_t after = *std::max_element(half, watch.sizes.end());
        CHECK(after <= before + before / 4);
    }
}

}  // namespace soak_test
