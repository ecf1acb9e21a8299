#pragma once

#include <fettle/physics/physics.h>
#include <fettle_physics.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <calls/failure.h>

// The objects behind the pointers of a caller in C.

namespace fettle::physics_c {

/// A value with its name: "dt = nan".
std::string name_and_value(const char* name, float value);

/// The arrays to which `fettle_world_events` returned pointers.
struct ReturnedEvents {
    std::vector<fettle_contact_event> contact_begin, contact_persist, contact_hit;
    std::vector<fettle_contact_end_event> contact_end;
    std::vector<fettle_sensor_event> sensor_begin, sensor_end;
    std::vector<fettle_joint_break_event> joint_broke;
    std::vector<fettle_joint_load_event> joint_loaded;
    std::vector<fettle_id> slept, woke;
};

}  // namespace fettle::physics_c

struct fettle_owner {
    bool is_destroyed() const { return !owner.has_value(); }

    std::string advice;
    std::optional<fettle::physics::Owner> owner;  ///< none: destroyed
    std::optional<fettle::physics::Owner::Acting> acting;
    int depth = 0;   ///< nested calls of begin
    int worlds = 0;  ///< number of worlds with this owner
};

struct fettle_world {
    bool is_destroyed() const { return world == nullptr; }

    std::unique_ptr<fettle::physics::World> world;              ///< null: destroyed
    std::unique_ptr<fettle::physics::TaskScheduler> scheduler;  ///< of the world
    fettle_owner* owner = nullptr;
    int visiting = 0;  ///< calls of visitors that have not returned
    fettle::physics_c::ReturnedEvents events;
    std::vector<std::byte> saved;
    std::string fault;
    std::string name;  ///< of the body whose name was read last
};

namespace fettle::physics_c {

/// Makes a world in C of a world of the library.
fettle_world* adopt(std::unique_ptr<physics::World> world);
/// Destroys the world, and keeps the memory for stale pointers.
void retire(fettle_world* world) noexcept;

/// The world; throws Failure if it is null or destroyed.
physics::World& live(const fettle_world* world);
/// Also throws Failure inside a visitor.
physics::World& editable(fettle_world* world);

/// While it lives, the world must not be edited.
class Visiting {
  public:
    explicit Visiting(fettle_world& world) : world_(world) { ++world_.visiting; }
    ~Visiting() { --world_.visiting; }
    Visiting(const Visiting&) = delete;
    Visiting& operator=(const Visiting&) = delete;

  private:
    fettle_world& world_;
};

}  // namespace fettle::physics_c
