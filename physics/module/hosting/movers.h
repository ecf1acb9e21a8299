#pragma once
// The settings and the state of movers.

#include <cstdint>
#include <vector>

#include <fettle/physics/mover.h>

namespace fettle::physics_module {

// These structs are saved byte by byte, so they have no gaps between their members.

/// Settings of a mover, which games change.
struct MoverSettings {
    float radius = 0.4f, height = 1.8f, crouch_height = 0.9f;  // m
    float max_slope = 0.87f, step_height = 0.3f, snap = 0.25f;
    float push_force = 600.0f;
    float walk = 0.0f, climb = 0.0f;                       // m/s
    float acceleration = 60.0f, air_acceleration = 20.0f;  // m/s²
    std::uint32_t crouch = 0, climbing = 0;
};

/// The state of a mover after its last step.
struct MoverResult {
    std::uint32_t crouched = 0, on_ground = 0, crushed = 0;
    std::uint16_t on_wall = 0, on_ceiling = 0;
    float velocity_x = 0.0f, velocity_y = 0.0f;  // relative to the ground, m/s
    float shown_x = 0.0f, shown_y = 0.0f;        // velocity given to the body
    float place_x = 0.0f, place_y = 0.0f;        // where the body must be after the step
    float normal_x = 0.0f, normal_y = 0.0f;      // of the ground
    float ground_x = 0.0f, ground_y = 0.0f;      // velocity of the ground
    float left_x = 0.0f, left_y = 0.0f;          // in the air: of the ground that it left
    std::uint32_t ground_part = 0;               // segment or piece of `ground`
    physics::ShapeId ground, dropped;
};

/// Events of a mover in the step.
struct MoverEvents {
    std::uint32_t happened = 0;
    float landing_speed = 0.0f;
    float bump_x = 0.0f, bump_y = 0.0f;  // normal of the obstacle that it bumped against
    physics::ShapeId bumped, was_ground;
};

struct MoverRecord {
    std::uint64_t slot = 0;  // of its body; 0: none
    std::uint64_t ledges = 0;
    MoverSettings settings;
    MoverResult result;
    MoverEvents events;
};
static_assert(sizeof(MoverRecord) == 2 * 8 + 34 * 4 + 4 * sizeof(physics::ShapeId));

/// The movers of one world, in the order of their slots.
class Movers {
  public:
    /// The defaults, with slot 0, if the body is not a mover.
    MoverRecord get(std::uint32_t slot) const;
    void set(std::uint32_t slot, MoverRecord record);
    void reset(std::uint32_t slot);
    bool empty() const { return records_.empty(); }
    const std::vector<MoverRecord>& all() const { return records_; }
    void replace(std::vector<MoverRecord> records) { records_ = std::move(records); }

  private:
    std::size_t place_of(std::uint32_t slot) const;

    std::vector<MoverRecord> records_;
};

/// The settings for the library, clamped to its ranges.
physics::MoverDef definition(const MoverRecord& record, const physics::Body& body);

/// True if all numbers are in their ranges and the slots are in order.
bool are_valid(const std::vector<MoverRecord>& records);

/// The shape of a mover: the one that belongs to no instance. Empty if there is none.
physics::Shape capsule_of(const physics::Body& body);
/// An upright capsule on the origin of a body.
physics::Segment capsule(float radius, float height);

}  // namespace fettle::physics_module
