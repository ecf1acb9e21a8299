#include <calls/calls.h>

#include <fettle/physics_c/world_settings.h>

#include <memory>

namespace fettle::physics_c {
namespace {

/// The threads of a caller in C.
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

fettle_code fettle_world_gravity(const fettle_world* world, fettle_vec2* gravity) {
    return read<&World::gravity>(__func__, world, gravity);
}

fettle_code fettle_world_set_gravity(fettle_world* world, float x, float y) {
    return edit<&World::set_gravity>(__func__, world, Vec2(x, y));
}

fettle_code fettle_world_substeps(const fettle_world* world, int32_t* substeps) {
    return read<&World::substeps>(__func__, world, substeps);
}

fettle_code fettle_world_last_substeps(const fettle_world* world, int32_t* substeps) {
    return read<&World::last_substeps>(__func__, world, substeps);
}

fettle_code fettle_world_set_substeps(fettle_world* world, int32_t substeps) {
    return edit<&World::set_substeps>(__func__, world, substeps);
}

fettle_code fettle_world_bounds(const fettle_world* world, bool* is_set, fettle_aabb* bounds) {
    return read_optional<&World::bounds>(__func__, world, is_set, bounds);
}

fettle_code fettle_world_set_bounds(fettle_world* world, const fettle_aabb* bounds) {
    return edit<&World::set_bounds>(__func__, world,
                                    bounds ? std::optional(box_of(*bounds)) : std::nullopt);
}

fettle_code fettle_world_bounds_friction(const fettle_world* world, float* bounds_friction) {
    return read<&World::bounds_friction>(__func__, world, bounds_friction);
}

fettle_code fettle_world_set_bounds_friction(fettle_world* world, float bounds_friction) {
    return edit<&World::set_bounds_friction>(__func__, world, bounds_friction);
}

fettle_code fettle_world_bounds_restitution(const fettle_world* world, float* bounds_restitution) {
    return read<&World::bounds_restitution>(__func__, world, bounds_restitution);
}

fettle_code fettle_world_set_bounds_restitution(fettle_world* world, float bounds_restitution) {
    return edit<&World::set_bounds_restitution>(__func__, world, bounds_restitution);
}

fettle_code fettle_world_sleeping(const fettle_world* world, bool* sleeping) {
    return read<&World::sleeping>(__func__, world, sleeping);
}

fettle_code fettle_world_set_sleeping(fettle_world* world, bool sleeping) {
    return edit<&World::set_sleeping>(__func__, world, sleeping);
}

fettle_code fettle_world_continuous(const fettle_world* world, bool* continuous) {
    return read<&World::continuous>(__func__, world, continuous);
}

fettle_code fettle_world_set_continuous(fettle_world* world, bool continuous) {
    return edit<&World::set_continuous>(__func__, world, continuous);
}

fettle_code fettle_world_restitution_threshold(const fettle_world* world,
                                               float* restitution_threshold) {
    return read<&World::restitution_threshold>(__func__, world, restitution_threshold);
}

fettle_code fettle_world_set_restitution_threshold(fettle_world* world,
                                                   float restitution_threshold) {
    return edit<&World::set_restitution_threshold>(__func__, world, restitution_threshold);
}

fettle_code fettle_world_hit_threshold(const fettle_world* world, float* hit_threshold) {
    return read<&World::hit_threshold>(__func__, world, hit_threshold);
}

fettle_code fettle_world_set_hit_threshold(fettle_world* world, float hit_threshold) {
    return edit<&World::set_hit_threshold>(__func__, world, hit_threshold);
}

fettle_code fettle_world_sleep_speed(const fettle_world* world, float* sleep_speed) {
    return read<&World::sleep_speed>(__func__, world, sleep_speed);
}

fettle_code fettle_world_set_sleep_speed(fettle_world* world, float sleep_speed) {
    return edit<&World::set_sleep_speed>(__func__, world, sleep_speed);
}

fettle_code fettle_world_sleep_delay(const fettle_world* world, float* sleep_delay) {
    return read<&World::sleep_delay>(__func__, world, sleep_delay);
}

fettle_code fettle_world_set_sleep_delay(fettle_world* world, float sleep_delay) {
    return edit<&World::set_sleep_delay>(__func__, world, sleep_delay);
}

fettle_code fettle_world_contact_hertz(const fettle_world* world, float* contact_hertz) {
    return read<&World::contact_hertz>(__func__, world, contact_hertz);
}

fettle_code fettle_world_set_contact_hertz(fettle_world* world, float contact_hertz) {
    return edit<&World::set_contact_hertz>(__func__, world, contact_hertz);
}

fettle_code fettle_world_contact_damping(const fettle_world* world, float* contact_damping) {
    return read<&World::contact_damping>(__func__, world, contact_damping);
}

fettle_code fettle_world_set_contact_damping(fettle_world* world, float contact_damping) {
    return edit<&World::set_contact_damping>(__func__, world, contact_damping);
}

fettle_code fettle_world_push_speed(const fettle_world* world, float* push_speed) {
    return read<&World::push_speed>(__func__, world, push_speed);
}

fettle_code fettle_world_set_push_speed(fettle_world* world, float push_speed) {
    return edit<&World::set_push_speed>(__func__, world, push_speed);
}

fettle_code fettle_world_solver(const fettle_world* world, int32_t* solver) {
    return read<&World::solver>(__func__, world, solver);
}

fettle_code fettle_world_set_solver(fettle_world* world, int32_t solver) {
    return edit<&World::set_solver>(__func__, world, Enumerated<Solver::direct>{"solver", solver});
}

fettle_code fettle_world_friction_mix(const fettle_world* world, int32_t* friction_mix) {
    return read<&World::friction_mix>(__func__, world, friction_mix);
}

fettle_code fettle_world_set_friction_mix(fettle_world* world, int32_t friction_mix) {
    return edit<&World::set_friction_mix>(
        __func__, world, Enumerated<MixRule::geometric>{"friction_mix", friction_mix});
}

fettle_code fettle_world_restitution_mix(const fettle_world* world, int32_t* restitution_mix) {
    return read<&World::restitution_mix>(__func__, world, restitution_mix);
}

fettle_code fettle_world_set_restitution_mix(fettle_world* world, int32_t restitution_mix) {
    return edit<&World::set_restitution_mix>(
        __func__, world, Enumerated<MixRule::geometric>{"restitution_mix", restitution_mix});
}

fettle_code fettle_world_persist_events(const fettle_world* world, bool* persist_events) {
    return read<&World::persist_events>(__func__, world, persist_events);
}

fettle_code fettle_world_set_persist_events(fettle_world* world, bool persist_events) {
    return edit<&World::set_persist_events>(__func__, world, persist_events);
}

fettle_code fettle_world_threads(const fettle_world* world, int32_t* threads) {
    return read<&World::threads>(__func__, world, threads);
}

fettle_code fettle_world_set_threads(fettle_world* world, int32_t threads) {
    return edit<&World::set_threads>(__func__, world, threads);
}

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
