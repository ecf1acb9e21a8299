#include <calls/calls.h>

#include <fettle/physics_c/world_settings.h>

#include <memory>

namespace fettle::physics_c {
namespace {

/// A task scheduler that calls the functions of a caller in C.
class HostTasks : public physics::TaskScheduler {
  public:
    HostTasks(fettle_start_tasks starts, fettle_finish_tasks finishes, void* user)
        : start_(starts), finish_(finishes), user_(user) {}

    void start(uint32_t count, Task task, void* context) override {
        start_(user_, count, task, context);
    }
    void finish() override { finish_(user_); }

  private:
    fettle_start_tasks start_;
    fettle_finish_tasks finish_;
    void* user_;
};

}  // namespace
}  // namespace fettle::physics_c

using namespace fettle::physics;
using namespace fettle::physics_c;

// As the macros in calls/properties.h, for settings of the world. `Type`: the setting's type in C.
// NOLINTBEGIN(bugprone-macro-parentheses)
#define FETTLE_WORLD_READING(setting, Type)                                        \
    fettle_code fettle_world_##setting(const fettle_world* world, Type* setting) { \
        return read<&World::setting>(__func__, world, setting);                    \
    }
#define FETTLE_WORLD_PROPERTY(setting, Type)                                    \
    FETTLE_WORLD_READING(setting, Type)                                         \
    fettle_code fettle_world_set_##setting(fettle_world* world, Type setting) { \
        return edit<&World::set_##setting>(__func__, world, setting);           \
    }
// NOLINTEND(bugprone-macro-parentheses)

FETTLE_WORLD_READING(gravity, fettle_vec2)

fettle_code fettle_world_set_gravity(fettle_world* world, float x, float y) {
    return edit<&World::set_gravity>(__func__, world, Vec2(x, y));
}

FETTLE_WORLD_PROPERTY(substeps, int32_t)
FETTLE_WORLD_READING(last_substeps, int32_t)

fettle_code fettle_world_bounds(const fettle_world* world, bool* is_set, fettle_aabb* bounds) {
    return read_optional<&World::bounds>(__func__, world, is_set, bounds);
}

fettle_code fettle_world_set_bounds(fettle_world* world, const fettle_aabb* bounds) {
    return edit<&World::set_bounds>(__func__, world,
                                    bounds ? std::optional(box_of(*bounds)) : std::nullopt);
}

FETTLE_WORLD_PROPERTY(bounds_friction, float)
FETTLE_WORLD_PROPERTY(bounds_restitution, float)
FETTLE_WORLD_PROPERTY(sleeping, bool)
FETTLE_WORLD_PROPERTY(continuous, bool)
FETTLE_WORLD_PROPERTY(restitution_threshold, float)
FETTLE_WORLD_PROPERTY(hit_threshold, float)
FETTLE_WORLD_PROPERTY(sleep_speed, float)
FETTLE_WORLD_PROPERTY(sleep_delay, float)
FETTLE_WORLD_PROPERTY(contact_hertz, float)
FETTLE_WORLD_PROPERTY(contact_damping, float)
FETTLE_WORLD_PROPERTY(push_speed, float)
FETTLE_WORLD_PROPERTY(max_speed, float)
FETTLE_WORLD_READING(solver, int32_t)

fettle_code fettle_world_set_solver(fettle_world* world, int32_t solver) {
    return edit<&World::set_solver>(__func__, world, Enumerated<Solver::direct>{"solver", solver});
}

FETTLE_WORLD_READING(friction_mix, int32_t)

fettle_code fettle_world_set_friction_mix(fettle_world* world, int32_t friction_mix) {
    return edit<&World::set_friction_mix>(
        __func__, world, Enumerated<MixRule::geometric>{"friction_mix", friction_mix});
}

FETTLE_WORLD_READING(restitution_mix, int32_t)

fettle_code fettle_world_set_restitution_mix(fettle_world* world, int32_t restitution_mix) {
    return edit<&World::set_restitution_mix>(
        __func__, world, Enumerated<MixRule::geometric>{"restitution_mix", restitution_mix});
}

FETTLE_WORLD_PROPERTY(persist_events, bool)
FETTLE_WORLD_PROPERTY(threads, int32_t)

fettle_code fettle_world_set_scheduler(fettle_world* world, fettle_start_tasks start,
                                       fettle_finish_tasks finish, void* user, int32_t threads) {
    return guarded(__func__, [&] {
        World& to = editable(world);
        if ((start == nullptr) != (finish == nullptr))
            throw Failure{FETTLE_INVALID, "start and finish: expected two functions or none"};
        std::unique_ptr<TaskScheduler> host;
        if (start != nullptr) host = std::make_unique<HostTasks>(start, finish, user);
        to.set_scheduler(host.get(), threads);
        world->scheduler = std::move(host);
    });
}

fettle_code fettle_world_limit_simd_width(fettle_world* world, int32_t most) {
    return edit<&World::limit_simd_width>(__func__, world, most);
}
