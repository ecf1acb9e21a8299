#pragma once
// The data of the module: the hosted worlds. A row of the tree consists of the number of a world
// and the slot of a body, a shape, a joint or a field in it. So a property is read directly from an
// array of the physics library.

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include <fettle/physics/host_access.h>
#include <fettle/physics/world.h>
#include <fettle/property/error.h>
#include <fettle/property/snapshot.h>
#include <fettle/property/tree.h>

#include <hosting/joints.h>
#include <hosting/looks.h>
#include <hosting/movers.h>
#include <hosting/written_poses.h>

namespace fettle::physics_module {

using property::Handle;
using property::Row;

inline constexpr unsigned slot_bits = 24;
inline constexpr std::uint32_t max_slots = 1u << slot_bits;
inline constexpr std::uint32_t max_worlds = 1u << (32 - slot_bits);
/// Number of the world for all objects whose instance has no World above it. It is never stepped.
inline constexpr std::uint32_t limbo = 0;
inline constexpr std::uint32_t first_world = limbo + 1;

constexpr std::uint32_t world_number(Row row) {
    return row >> slot_bits;
}
constexpr std::uint32_t slot_of(Row row) {
    return row & (max_slots - 1);
}
constexpr Row make_row(std::uint32_t world, std::uint32_t slot) {
    return world << slot_bits | slot;
}

/// Returns the row of a new object. If the slot is too large for a row, destroys the object, which
/// no instance refers to yet, and throws.
Row row_of(std::uint32_t world, auto made) {
    if (made.id().index < max_slots) return make_row(world, made.id().index);
    made.destroy();
    throw property::Error(
        property::ErrorKind::rejected,
        "a world holds at most " + std::to_string(max_slots) + " bodies and as many shapes");
}

// The user data of the physics library are 64 bits: enough for a handle.
constexpr std::uint64_t pack(Handle handle) {
    return std::uint64_t{handle.generation} << 32 | handle.index;
}
constexpr Handle unpack(std::uint64_t data) {
    return {static_cast<std::uint32_t>(data), static_cast<std::uint32_t>(data >> 32)};
}

struct HostedWorld {
    explicit HostedWorld(const property::NotedSteps& steps) : written_poses(steps) {}
    physics::World world;
    Handle self;              // null for limbo
    bool placed = false;      // true if it is below the root, so that it is stepped
    bool unreported = false;  // true if it made a step whose events were not reported yet
    SlotValues<Look> looks;   // by shape slot
    SlotValues<std::optional<property::Color>> body_colors;  // by body slot
    SlotValues<Ties> ties;                                   // by joint slot
    // Only in limbo: velocities that were set, by body slot. Shapes that are added later move the
    // center of mass, but the body gets this velocity when it enters a world.
    SlotValues<std::optional<physics::Vec2>> velocities;
    Movers movers;
    WrittenPoses written_poses;
    // Instances of objects that were destroyed while they touched others, by generation. The event
    // of the end of the touch contains them.
    std::unordered_map<std::uint32_t, Handle> departed_bodies, departed_shapes;
};

/// Defaults of a class of shapes.
struct ShapeKind {
    Hosting* hosting = nullptr;
    physics::Geometry geometry;
};

/// Two events with the same name: one of bodies and one of shapes.
struct PairEvent {
    const property::Event* of_body = nullptr;
    const property::Event* of_shape = nullptr;
    bool has_handlers() const { return of_body->listeners != 0 || of_shape->listeners != 0; }
};

/// The events that the classes declare.
struct DeclaredEvents {
    PairEvent contact_begin, contact_persist, contact_end, contact_hit, sensor_begin, sensor_end;
    PairEvent before_solve;
    const property::Event *mix_surfaces = nullptr, *filter_pair = nullptr;  // of worlds
    const property::Event *woke = nullptr, *slept = nullptr;                // of bodies
    const property::Event *broke = nullptr, *loaded = nullptr;              // of joints
};

struct HostedClasses {
    const property::Class *world = nullptr, *body = nullptr, *shape = nullptr;
    const property::Class* statistics = nullptr;
    std::vector<const property::Class*> abstract;  // their objects have no kind
};

class Hosting {
  public:
    /// `part`: the module as a part of snapshots.
    Hosting(property::Tree& tree, property::SnapshotPart& part);

    // --- From rows to objects
    struct Place {
        HostedWorld& in;
        std::uint32_t slot;
    };
    // Most games have one world. The comparison lets the processor load the data of that world
    // before the row has been loaded.
    Place at(Row row) {
        const std::uint32_t slot = row - make_row(first_world, 0);
        if (slot < max_slots) [[likely]]
            return {*worlds_[first_world], slot};
        return {*worlds_[world_number(row)], slot_of(row)};
    }
    HostedWorld& hosted(Row row) { return at(row).in; }
    physics::World& world(Row row) { return hosted(row).world; }
    const physics::BodyState& state(Row row) {
        const auto [in, slot] = at(row);
        return physics::HostAccess::state(in.world, slot);
    }
    physics::Body body(Row row) {
        const auto [in, slot] = at(row);
        return in.world.body({slot, physics::HostAccess::body_generation(in.world, slot)});
    }
    physics::Shape shape(Row row) {
        const auto [in, slot] = at(row);
        return in.world.shape({slot, physics::HostAccess::shape_generation(in.world, slot)});
    }
    physics::Field field(Row row);
    /// Velocity of the center of mass.
    physics::Vec2 velocity(Row row) {
        const auto [in, slot] = at(row);
        if (world_number(row) == limbo)
            if (const auto written = in.velocities.get(slot))
                physics::HostAccess::set_velocity(in.world, slot, *written);
        return physics::HostAccess::velocity(in.world, slot);
    }
    /// False when the body does not move by itself.
    bool set_velocity(Row row, const physics::Vec2& velocity) {
        const auto [in, slot] = at(row);
        const bool moves = physics::HostAccess::set_velocity(in.world, slot, velocity);
        if (world_number(row) == limbo) in.velocities.set(slot, velocity);
        return moves;
    }
    HostedWorld* world_at(std::uint32_t number) { return worlds_[number].get(); }
    const HostedWorld* world_at(std::uint32_t number) const { return worlds_[number].get(); }

    /// The instance in an object's user data; null if it was deleted.
    Handle instance_of(std::uint64_t user_data) const {
        const Handle instance = unpack(user_data);
        return tree.alive(instance) ? instance : Handle{};
    }

    // --- Up the tree
    /// Number of the nearest world above an instance; limbo when there is none.
    std::uint32_t world_above(Handle instance) const;
    /// The nearest body above; null when there is none.
    Handle body_above(Handle instance) const;

    // --- Creating, moving, deleting (placing.cpp, migration.cpp)
    /// Throws Error(bad_structure) for an instance of an abstract class, Shape for example.
    void require_concrete(Handle self) const;
    Row create_world(Handle self);
    Row place_world(Handle self, Row row);
    void destroy_world(Row row);
    Row create_body(Handle self);
    Row create_mover(Handle self);  // movers.cpp
    Row place_body(Handle self, Row row);
    void destroy_body(Row row);
    Row create_shape(Handle self, const physics::Geometry& geometry);
    Row place_shape(Handle self, Row row);
    void destroy_shape(Row row);
    Row create_field(Handle self, const physics::FieldDef& def);
    Row place_field(Handle self, Row row);
    void destroy_field(Row row);
    /// False if the world can be changed now. While it calls a function, no object of it is
    /// destroyed: then `destroy_postponed` calls `destroy` later.
    bool postpone(std::uint32_t world, std::function<void()> destroy);
    void destroy_postponed();  ///< calls those that are possible now
    /// Reports instances that were placed below the root since the last call and have no effect
    /// there, once for each kind: bodies, fields and joints below no world, shapes on no body,
    /// joints that connect nothing. Also joints whose lower limit is above the upper one since they
    /// were placed or a limit was set.
    void report_strays();
    /// Adds the memory of the contacts of all worlds to the weight of the tree.
    void weigh_contacts(std::int64_t contacts);
    /// Adds a joint to those that `report_strays` checks.
    void add_placed_joint(Handle self);
    /// The same for a joint whose limits were set, if they cross.
    void add_joint_with_limits(Row row);
    std::function<void(const std::string&)> on_problem;
    /// Throws Error(rejected) while the world of `row` calls a function.
    void require_unlocked(Row row);

    // --- Events (room events)
    void update_callbacks();
    void report(HostedWorld& hosted);

    // --- Snapshots (room saving; `refresh`: hosting.cpp)
    void save(property::ByteWriter& to) const;
    std::function<void()> restore(property::ByteReader& from);
    void refresh(std::uint64_t what);
    /// While an object of this class exists, reads are parts of an edit: a replay repeats them with
    /// the edit, so they are not reported to the timeline.
    class EditScope {
      public:
        explicit EditScope(Hosting& hosting) : depth_(hosting.edit_depth_) { ++depth_; }
        ~EditScope() { --depth_; }
        EditScope(const EditScope&) = delete;

      private:
        int& depth_;
    };

    /// As `EditScope`, for creating and destroying objects in the worlds, which only the module may
    /// do.
    class Placing {
      public:
        explicit Placing(Hosting& hosting) : edit_(hosting), acting_(hosting.owner_) {}

      private:
        EditScope edit_;
        physics::Owner::Acting acting_;
    };

    /// Throws in a function that a step or a query calls.
    void require_idle() const;

    // --- Looks (looks.cpp)
    property::Color fill_of(Row shape);
    property::Color border_of(Row shape);

    /// For each class, the function that creates its rows, and the kind of its objects. The kind is
    /// the index of the alternative in the library's variant.
    using Kinds =
        std::vector<std::pair<Row (*)(void* context, property::Tree&, Handle), std::size_t>>;
    Kinds field_kinds, joint_kinds;

    property::Tree& tree;
    const std::weak_ptr<const property::Tree*> tree_life;
    /// False in a shared object: its tree has no lifetime, and lives longer than the module.
    const bool tree_may_end = !tree_life.expired();
    Joints joints;
    std::array<ShapeKind, 8> kinds;

    /// Length of the last step, s; functions that make steps of a copy use it.
    double last_dt = 1.0 / 60;

    HostedClasses classes;
    std::array<property::Value, 3> type_names;  // by physics::BodyType

    DeclaredEvents declared;
    /// Stores the events of the class of bodies, or of shapes.
    void register_pair_events(const property::Class& defined,
                              const property::Event* PairEvent::*of);

  private:
    std::unique_ptr<HostedWorld> make_world(std::uint32_t number);
    Row migrate_body(Row row, std::uint32_t to);
    /// Creates the shape at `from` in another world, as part of `owner` (none: detached).
    Row migrate_shape(Row from, std::uint32_t to, const physics::Body& owner);
    physics::Shape copy_shape(const physics::Shape& shape, std::uint32_t to);
    Row replace_shape(Row from, std::uint32_t to, const physics::Shape& fresh);
    void store_departure(Row shape);

    struct PairSide {
        Handle body, shape;
    };
    PairSide pair_side(HostedWorld& hosted, physics::BodyId body, physics::ShapeId shape) const;
    template <class AddRest>
    void emit_pair(const PairEvent& event, const PairSide& self, const PairSide& other,
                   const AddRest& add_rest);

    property::SnapshotPart& part_;
    physics::Owner owner_{
        "this world belongs to a property tree, which makes and ends what is in it: create or "
        "destroy the instance instead"};
    std::array<std::unique_ptr<HostedWorld>, max_worlds> worlds_;
    int edit_depth_ = 0;  // number of living `EditScope`
    std::int64_t weight_of_contacts_ = 0;
    struct Postponed {
        std::uint32_t world;
        std::function<void()> destroy;
    };
    std::vector<Postponed> postponed_;
    struct Strays {
        std::vector<Handle> placed{};
        bool reported = false;
    };
    Strays outside_, stray_shapes_, stray_joints_, crossed_limits_;
    void add_stray(Handle self, Strays& strays) const;
    std::string crossed_limits(Handle joint) const;
    /// `problem_of`: what is wrong with an instance; empty: nothing.
    void report_first(Strays& strays, const std::function<std::string(Handle)>& problem_of);
    /// Which events and callbacks have handlers.
    struct Wanted {
        bool hits = false, persisting = false, before_solve = false, mixing = false, filter = false;
        bool operator==(const Wanted&) const = default;
    };
    void set_callbacks(HostedWorld& hosted, const Wanted& before);
    void call_before_solve(HostedWorld& hosted, physics::ContactEdit& contact);
    void call_mixing(HostedWorld& hosted, physics::ContactEdit& contact);
    bool call_filter(HostedWorld& hosted, const physics::Shape& a, const physics::Shape& b);
    Wanted wanted_;
};

}  // namespace fettle::physics_module
