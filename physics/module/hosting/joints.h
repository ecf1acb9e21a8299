#pragma once
// Joints of the tree. A joint of the tree may exist before its bodies are set, live longer than
// they do, or be in another world: its joint in the library is dormant then, and has its settings.
// Before a step, joints whose bodies are there are connected.

#include <array>
#include <cstdint>
#include <utility>

#include <fettle/physics/world.h>
#include <fettle/property/value.h>

namespace fettle::physics_module {

class Hosting;
using property::Handle;
using property::Row;

/// Where a value comes from that a joint measures when it begins to act, unless it is given: a
/// length, an angle or a point. What was given stays when the joint gets other bodies.
enum class Source : std::uint32_t { none, measured, given };

/// What the library does not know of a joint.
struct Ties {
    std::array<Handle, 2> bodies;  // null: the world. A MouseJoint has only b
    Source source = Source::none;
};

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
    /// Of the value that it measures. `none`: the joint is connected again before the next step,
    /// and measures again.
    void set_source(Row row, Source source);
    /// Disconnects the joints of a body that is about to be destroyed.
    void disconnect_all(const physics::Body& body);

    // Of the bodies that the tree names, whether the joint acts or not.
    /// Current position of the anchor in the world.
    physics::Vec2 world_anchor(Row row, std::size_t side) const;
    float angle_of(Row row, std::size_t side) const;

    /// By type of joint: measures and sets the value; null: there is none.
    using Measure = void (*)(Hosting& hosting, Row row);
    std::array<Measure, static_cast<std::size_t>(physics::JointType::ratchet) + 1> measures{};

    /// Bodies were moved to another world, or a joint was edited: `tighten` is needed before the
    /// next step.
    void loosen(bool loose = true) { loose_ = loose; }
    bool loose() const { return loose_; }
    /// Connects the joints whose bodies are in their world.
    void tighten();

  private:
    std::pair<physics::World*, physics::JointId> object_of(Row row) const;
    void put_ties(Row row, const Ties& ties);
    bool can_act(std::uint32_t world, const Ties& ties) const;
    physics::Body library_body(Handle body) const;

    Hosting& hosting_;
    bool loose_ = false;
};

}  // namespace fettle::physics_module
