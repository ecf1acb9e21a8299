#pragma once
// Joints as the tree knows them. The physics library has a joint only while there are bodies to
// tie; in the tree one may hang before its bodies are chosen, outlive them, or be in another world.
// What it is set to is therefore kept here, and a native joint is made of it before the next step.

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include <fettle/physics/world.h>
#include <fettle/property/bytes.h>

#include "joint_settings.h"

namespace fettle::physics_module {

class Hosting;

struct JointRecord {
    bool used = false;
    std::array<property::Handle, 2> bodies;  // null: the world. A mouse has only b
    std::array<physics::Vec2, 2> anchors = {physics::Vec2::Zero(), physics::Vec2::Zero()};
    bool collide = false, enabled = true, broken = false;
    float break_force = physics::infinity, break_torque = physics::infinity;
    AnySettings settings;
    property::Handle self;
    std::uint32_t world = 0;  // the nearest above
    physics::JointId native;  // in that world; dangling when a body took it along
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
    /// The joint that acts in the world; invalid while none does.
    template <class Native = physics::Joint>
    Native native(std::uint32_t row) const {
        return {&world_of(records_[row]), records_[row].native};
    }
    /// What settings are told to: the joint that acts or, while none does, a model, so that the
    /// library refuses the same at the same moment.
    template <class Native = physics::Joint>
    Native acting_or_model(std::uint32_t row) {
        const Native acting = native<Native>(row);
        if (acting) return acting;
        const physics::JointId id = model(records_[row].settings);
        return {models_.get(), id};
    }

    /// Null: the world, or it was deleted.
    property::Handle body(std::uint32_t row, std::size_t side) const;
    void set_body(std::uint32_t row, std::size_t side, property::Handle body);
    /// The point of a body that a mouse pulls.
    physics::Vec2 mouse_anchor(std::uint32_t row) const;
    /// Where the anchor is in the world now.
    physics::Vec2 world_anchor(const JointRecord& record, std::size_t side) const;
    float angle_of(const JointRecord& record, std::size_t side) const;
    /// What the library broke in a step is broken here too; the instance it stands for.
    property::Handle broke(physics::JointId native, physics::World& world);
    /// Made anew before the next step: for what only the making of a joint finds.
    void remake(std::uint32_t row);

    /// Bodies came, went or changed worlds, or a joint was edited: look before the next step.
    void loosen() { loose_ = true; }
    /// Makes and ends native joints as the records want them.
    void tighten();

    void save(property::ByteWriter& to) const;
    /// Reads and checks; what is returned puts it into place, and owns what is `read` until then.
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
    // A joint of each type in a world that is never stepped. Made when first asked for.
    std::unique_ptr<physics::World> models_;
    std::array<physics::JointId, std::variant_size_v<AnySettings>> model_of_type_;
};

}  // namespace fettle::physics_module
