#pragma once
// Joints as the tree knows them. The physics library has a joint only while there are bodies to
// tie; in the tree one may hang before its bodies are chosen, outlive them, or be in another world.
// What it is set to is therefore kept here, and a native joint is made of it before the next step.

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <variant>
#include <vector>

#include <fettle/physics/world.h>
#include <fettle/property/bytes.h>

namespace fettle::physics_module {

class Hosting;

/// A value that is found when the joint begins to act, unless one is given.
template <class T>
struct Found {
    std::optional<T> value;
    bool given = false;  // by a user: stays when the joint takes other bodies

    void give(std::optional<T> wanted) {
        value = wanted;
        given = wanted.has_value();
    }
    void look_again() {
        if (!given) value.reset();
    }
};

// What a type adds.

struct MouseSettings {
    using Native = physics::MouseJoint;
    Found<physics::Vec2> anchor;  // the point that is at the target
    physics::Vec2 target = physics::Vec2::Zero();
    float frequency = 5.0f, damping_ratio = 0.7f, max_force = physics::infinity;
};
struct DistanceSettings {
    using Native = physics::DistanceJoint;
    Found<float> length;
    float min_length = 0.0f, max_length = physics::infinity;
    float hertz = physics::infinity, damping_ratio = 0.0f;
};
struct RevoluteSettings {
    using Native = physics::RevoluteJoint;
    Found<float> reference_angle;
    float lower_angle = -physics::infinity, upper_angle = physics::infinity;
    float motor_speed = 0.0f, max_motor_torque = 0.0f;
    float hertz = 0.0f, damping_ratio = 0.0f, target_angle = 0.0f;
};

struct JointRecord {
    bool used = false;
    std::array<property::Handle, 2> bodies;  // null: the world. A mouse has only b
    std::array<physics::Vec2, 2> anchors = {physics::Vec2::Zero(), physics::Vec2::Zero()};
    bool collide = false, enabled = true;
    std::variant<MouseSettings, DistanceSettings, RevoluteSettings> settings;
    std::uint32_t world = 0;  // the nearest above
    physics::JointId native;  // in that world; dangling when a body took it along
};

class Joints {
  public:
    explicit Joints(Hosting& hosting) : hosting_(hosting) {}

    template <class Settings>
    std::uint32_t create(std::uint32_t world) {
        const std::uint32_t row = create(world);
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

    /// Null: the world, or it was deleted.
    property::Handle body(std::uint32_t row, std::size_t side) const;
    void set_body(std::uint32_t row, std::size_t side, property::Handle body);
    /// The point of a body that a mouse pulls.
    physics::Vec2 mouse_anchor(std::uint32_t row) const;
    /// Where the anchor is in the world now.
    physics::Vec2 world_anchor(const JointRecord& record, std::size_t side) const;
    float angle_of(const JointRecord& record, std::size_t side) const;
    /// Made anew before the next step: for what only the making of a joint finds.
    void remake(std::uint32_t row);

    /// Bodies came, went or changed worlds, or a joint was edited: look before the next step.
    void loosen() { loose_ = true; }
    /// Makes and ends native joints as the records want them.
    void tighten();

    void save(property::ByteWriter& to) const;
    /// Reads and checks; what is returned puts it into place.
    std::function<void()> restore(property::ByteReader& from);

  private:
    std::uint32_t create(std::uint32_t world);
    physics::World& world_of(const JointRecord& record) const;
    bool can_act(const JointRecord& record) const;
    physics::BodyId body_id(property::Handle body) const;
    void disconnect(JointRecord& record);
    physics::JointId connect(JointRecord& record, MouseSettings& settings);
    physics::JointId connect(JointRecord& record, DistanceSettings& settings);
    physics::JointId connect(JointRecord& record, RevoluteSettings& settings);
    physics::JointDef description(const JointRecord& record) const;

    Hosting& hosting_;
    std::vector<JointRecord> records_;
    std::vector<std::uint32_t> free_;
    bool loose_ = false;
};

}  // namespace fettle::physics_module
