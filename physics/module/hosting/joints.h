#pragma once
// Joints of the tree. A joint of the physics library needs two bodies; a joint of the tree may
// exist before its bodies are set, live longer than they do, or be in another world. Its settings
// are therefore kept here, and a native joint is created from them before the next step.

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include <fettle/physics/world.h>
#include <fettle/property/bytes.h>

#include <hosting/joint_settings.h>

namespace fettle::physics_module {

class Hosting;

struct JointRecord {
    bool used = false;
    std::array<property::Handle, 2> bodies;  // null: the world. A MouseJoint has only b
    std::array<physics::Vec2, 2> anchors = {physics::Vec2::Zero(), physics::Vec2::Zero()};
    bool collide = false, enabled = true, broken = false;
    float break_force = physics::infinity, break_torque = physics::infinity;
    AnySettings settings;
    property::Handle self;
    std::uint32_t world = 0;  // the nearest world above
    physics::JointId native;  // in that world; dangling after a body moved to another world
};

class Joints {
  public:
    explicit Joints(Hosting& hosting) : hosting_(hosting) {}

    template <class Settings>
    std::uint32_t create(std::uint32_t world, property::Handle self) {
        const std::uint32_t row = create(world, self);
        records_[row].settings = Settings{};
        return row;
    }
    void place(std::uint32_t row, std::uint32_t world);
    void destroy(std::uint32_t row);

    JointRecord& at(std::uint32_t row) { return records_[row]; }
    const JointRecord& at(std::uint32_t row) const { return records_[row]; }
    template <class Settings>
    Settings& settings(std::uint32_t row) {
        return std::get<Settings>(records_[row].settings);
    }
    /// The native joint in the world; invalid while there is none.
    template <class Native = physics::Joint>
    Native native(std::uint32_t row) const {
        return {&world_of(records_[row]), records_[row].native};
    }
    /// The joint that checks settings: the native one or, while there is none, a model, so that the
    /// library always refuses the same settings at once.
    template <class Native = physics::Joint>
    Native acting_or_model(std::uint32_t row) {
        const Native acting = native<Native>(row);
        if (acting) return acting;
        const physics::JointId id = model(records_[row].settings);
        return {models_.get(), id};
    }

    /// Null for the world and for a deleted body.
    property::Handle body(std::uint32_t row, std::size_t side) const;
    void set_body(std::uint32_t row, std::size_t side, property::Handle body);
    /// The point of a body that a MouseJoint pulls.
    physics::Vec2 mouse_anchor(std::uint32_t row) const;
    /// Current position of the anchor in the world.
    physics::Vec2 world_anchor(const JointRecord& record, std::size_t side) const;
    float angle_of(const JointRecord& record, std::size_t side) const;
    /// Marks a joint as broken that the library broke in a step; returns its instance.
    property::Handle broke(physics::JointId native, physics::World& world);
    /// Creates the native joint again before the next step, for values that are measured only at
    /// creation.
    void remake(std::uint32_t row);

    /// Bodies were created, deleted or moved to another world, or a joint was edited: `tighten` is
    /// needed before the next step.
    void loosen() { loose_ = true; }
    /// Creates and destroys native joints, so that they match the records.
    void tighten();

    void save(property::ByteWriter& to) const;
    /// Reads and checks; the returned function restores the joints, and owns the data until then.
    std::function<void()> restore(property::ByteReader& from,
                                  const std::vector<JointRecord>*& read);

  private:
    std::uint32_t create(std::uint32_t world, property::Handle self);
    physics::World& world_of(const JointRecord& record) const;
    physics::JointId model(const AnySettings& type);
    void check(const JointRecord& record);
    bool begin(JointRecord& record);
    bool can_act(const JointRecord& record) const;
    physics::BodyId body_id(property::Handle body) const;
    void disconnect(JointRecord& record);
    void disconnect(std::uint32_t world, physics::JointId native);
    template <class Settings>
    typename Settings::Native make(const JointRecord& record, const Settings& settings) const;
    physics::JointDef description(const JointRecord& record) const;

    Hosting& hosting_;
    std::vector<JointRecord> records_;
    std::vector<std::uint32_t> free_;
    bool loose_ = false;
    // A joint of each type in a world that is never stepped. Created at first use.
    std::unique_ptr<physics::World> models_;
    std::array<physics::JointId, std::variant_size_v<AnySettings>> model_of_type_;
};

}  // namespace fettle::physics_module
