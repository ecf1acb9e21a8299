#pragma once
// Joints of the tree. A joint can exist before its bodies are set, after they were deleted, or
// while they are in another world. Meanwhile its joint in the library is dormant and holds its
// settings. Before a step, dormant joints are connected if both bodies are in their world.

#include <array>
#include <cstdint>
#include <utility>

#include <fettle/physics/world.h>
#include <fettle/property/lifecycle.h>
#include <fettle/property/value.h>

namespace fettle::physics_module {

class Hosting;
using property::Handle;
using property::Row;

/// Source of the length, angle or point of a joint: given by a user, or measured when the joint
/// begins to act. A given value stays when the joint gets other bodies.
enum class Source : std::uint32_t { none, measured, given };

/// The data of a joint that the module stores and the library does not.
struct Ties {
    std::array<Handle, 2> bodies;  // null: the world. A MouseJoint uses only the second one
    Source source = Source::none;
};
static_assert(sizeof(Ties) == 2 * sizeof(Handle) + sizeof(Source));  // snapshots contain its bytes

class Joints {
  public:
    explicit Joints(Hosting& hosting) : hosting_(hosting) {}

    Row create(Handle self, physics::JointType type);
    Row place(Handle self, Row row);
    void destroy(Row row);

    template <class Native = physics::Joint>
    Native at(Row row) const {
        const auto [world, id] = object_of(row);
        return {world, id};
    }
    Ties ties(Row row) const;
    /// Null for the world and for a deleted body.
    Handle body(Row row, std::size_t side) const;
    void set_body(Row row, std::size_t side, Handle body);
    /// Sets the source of the measured value. After `none`, the joint is connected again before the
    /// next step, and measures again.
    void set_source(Row row, Source source);
    /// Disconnects the joints of a body that is about to be destroyed.
    void disconnect_all(const physics::Body& body);

    // These use the bodies that are set in the tree, also while the joint is dormant.
    /// Current position of the anchor in the world.
    physics::Vec2 world_anchor(Row row, std::size_t side) const;
    float angle_of(Row row, std::size_t side) const;

    /// For each type of joint, the function that measures its value and sets it in a world: that of
    /// the row, or a copy of it. Null if the type measures none.
    using Measure = void (*)(Hosting& hosting, Row row, physics::World& in);
    std::array<Measure, static_cast<std::size_t>(physics::JointType::rotary_limit) + 1> measures{};

    /// To be called when bodies were moved to another world or a joint was edited: `connect` is
    /// needed before the next step.
    void set_connect_needed(bool needed = true) { connect_needed_ = needed; }
    bool connect_needed() const { return connect_needed_; }
    /// Connects the dormant joints whose bodies are both in their world.
    void connect();
    /// Does the same in a copy of the world with that number, which itself is not touched.
    void connect_copy(std::uint32_t number, physics::World& copy) const;

  private:
    std::pair<physics::World*, physics::JointId> object_of(Row row) const;
    void put_ties(Row row, const Ties& ties);
    bool can_act(std::uint32_t world, const Ties& ties) const;
    bool connect_in(std::uint32_t number, physics::World& in, physics::Joint& joint) const;
    physics::Body library_body(Handle body) const;

    Hosting& hosting_;
    bool connect_needed_ = false;
};

}  // namespace fettle::physics_module
