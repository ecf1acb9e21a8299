#include <hosting/joints.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <hosting/hosting.h>

namespace fettle::physics_module {
namespace {

/// Bodies that are far apart may give a measured value that is higher than a setter accepts.
float bounded(float x, float most) {
    return std::isnan(x) ? 0.0f : std::clamp(x, -most, most);
}
float within_reach(float found) {
    return bounded(found, std::numeric_limits<float>::max());
}
physics::Vec2 within_reach(const physics::Vec2& found) {
    constexpr float most = 1e8f;  // of coordinates
    return {bounded(found.x(), most), bounded(found.y(), most)};
}

/// Sets all settings of a native joint, in the order of `each`.
template <class Settings>
void adjust(typename Settings::Native joint, const Settings& settings) {
    Settings::each([&](auto field, auto set, auto... ask) {
        const auto& value = settings.*field;
        if constexpr (sizeof...(ask) == 0)
            (joint.*set)(value);
        else if (value.value)
            (joint.*set)(*value.value);
    });
}

/// Reads values that are neither set nor measured from the joint.
template <class Settings>
void find_missing(typename Settings::Native joint, Settings& settings) {
    Settings::each([&](auto field, auto set, auto... ask) {
        if constexpr (sizeof...(ask) != 0) {
            auto& value = (settings.*field).value;
            if (value) return;
            value = within_reach((..., (joint.*ask)()));
            (joint.*set)(*value);
        }
    });
}

}  // namespace

std::uint32_t Joints::create(std::uint32_t world, property::Handle self) {
    std::uint32_t row = 0;
    if (free_.empty()) {
        row = static_cast<std::uint32_t>(records_.size());
        records_.emplace_back();
    } else {
        row = free_.back();
        free_.pop_back();
    }
    records_[row] = {};
    records_[row].used = true;
    records_[row].world = world;
    records_[row].self = self;
    loosen();
    return row;
}

void Joints::place(std::uint32_t row, std::uint32_t world) {
    JointRecord& record = records_[row];
    if (record.world == world) return;
    hosting_.require_unlocked(make_row(record.world, 0));
    disconnect(record);
    record.world = world;
    loosen();
}

void Joints::destroy(std::uint32_t row) {
    const auto [world, native] = std::pair(records_[row].world, records_[row].native);
    if (!hosting_.postpone(world, [this, world, native] { disconnect(world, native); }))
        disconnect(world, native);
    records_[row] = {};
    free_.push_back(row);
}

physics::World& Joints::world_of(const JointRecord& record) const {
    return hosting_.world_at(record.world)->world;
}

property::Handle Joints::body(std::uint32_t row, std::size_t side) const {
    const property::Handle body = records_[row].bodies[side];
    return hosting_.tree.alive(body) ? body : property::Handle{};
}

void Joints::set_body(std::uint32_t row, std::size_t side, property::Handle body) {
    JointRecord& record = records_[row];
    record.bodies[side] = body;
    const auto look_again = [](auto& settings) {
        std::remove_cvref_t<decltype(settings)>::each([&](auto field, auto, auto... ask) {
            if constexpr (sizeof...(ask) != 0) (settings.*field).look_again();
        });
    };
    std::visit(look_again, record.settings);
    remake(row);
}

void Joints::remake(std::uint32_t row) {
    disconnect(records_[row]);
    loosen();
}

physics::Vec2 Joints::mouse_anchor(std::uint32_t row) const {
    const JointRecord& record = records_[row];
    const auto& mouse = std::get<MouseSettings>(record.settings);
    if (mouse.anchor.value) return *mouse.anchor.value;
    if (!hosting_.tree.alive(record.bodies[1])) return physics::Vec2::Zero();
    return hosting_.body(hosting_.tree.row(record.bodies[1])).local_point(mouse.target);
}

physics::Vec2 Joints::world_anchor(const JointRecord& record, std::size_t side) const {
    const physics::Vec2& anchor = record.anchors[side];
    if (!hosting_.tree.alive(record.bodies[side])) return anchor;
    return hosting_.body(hosting_.tree.row(record.bodies[side])).world_point(anchor);
}

float Joints::angle_of(const JointRecord& record, std::size_t side) const {
    if (!hosting_.tree.alive(record.bodies[side])) return 0.0f;
    return hosting_.body(hosting_.tree.row(record.bodies[side])).angle();
}

void Joints::disconnect(JointRecord& record) {
    disconnect(record.world, record.native);
    record.native = {};
}

void Joints::disconnect(std::uint32_t number, physics::JointId native) {
    const Hosting::Placing placing(hosting_);
    physics::World& world = hosting_.world_at(number)->world;
    if (world.is_valid(native)) world.joint(native).destroy();
}

physics::BodyId Joints::body_id(property::Handle body) const {
    return body ? hosting_.body(hosting_.tree.row(body)).id() : physics::BodyId{};
}

physics::JointDef Joints::description(const JointRecord& record) const {
    physics::JointDef def;
    def.body_a = body_id(record.bodies[0]);
    def.body_b = body_id(record.bodies[1]);
    def.anchor_a = record.anchors[0];
    def.anchor_b = record.anchors[1];
    def.collide = record.collide;
    def.enabled = record.enabled;
    return def;
}

template <class Settings>
typename Settings::Native Joints::make(const JointRecord& record, const Settings& settings) const {
    if constexpr (std::is_same_v<Settings, MouseSettings>) {
        physics::MouseJointDef def;
        def.body = body_id(record.bodies[1]);
        def.target = settings.target;
        def.anchor = settings.anchor.value;
        def.enabled = record.enabled;
        return world_of(record).create_mouse_joint(def);
    } else {
        return (world_of(record).*Settings::make)(description(record));
    }
}

bool Joints::can_act(const JointRecord& record) const {
    if (record.world == limbo || record.bodies[0] == record.bodies[1]) return false;
    for (const property::Handle body : record.bodies) {
        if (!body) continue;  // the world
        if (!hosting_.tree.alive(body)) return false;
        if (world_number(hosting_.tree.row(body)) != record.world) return false;
    }
    return true;
}

property::Handle Joints::broke(physics::JointId native, physics::World& world) {
    if (!world.is_valid(native)) return {};
    const property::Handle self = unpack(world.joint(native).user_data());
    if (!hosting_.tree.alive(self)) return {};
    records_[hosting_.tree.row(self)].broken = world.joint(native).broken();
    return self;
}

/// False if the library refuses the settings. They are checked when they are written, so this is
/// not expected; but a step must not throw.
bool Joints::begin(JointRecord& record) try {
    const Hosting::Placing placing(hosting_);
    std::visit(
        [&](auto& settings) {
            const auto made = make(record, settings);
            record.native = made.id();
            adjust(made, settings);
            find_missing(made, settings);
        },
        record.settings);
    physics::Joint made = world_of(record).joint(record.native);
    made.set_user_data(pack(record.self));
    made.set_break_force(record.break_force);
    made.set_break_torque(record.break_torque);
    made.set_broken(record.broken);
    return true;
} catch (const std::invalid_argument&) {
    disconnect(record);
    return false;
}

void Joints::tighten() {
    if (!loose_) return;
    loose_ = false;
    for (JointRecord& record : records_) {
        if (!record.used) continue;
        const bool wanted = can_act(record);
        const bool acts = world_of(record).is_valid(record.native);
        if (wanted && !acts) begin(record);
        if (!wanted && acts) disconnect(record);
    }
}

// --- Models

physics::JointId Joints::model(const AnySettings& type) {
    physics::JointId& known = model_of_type_[type.index()];
    if (known) return known;
    if (models_ == nullptr) models_ = std::make_unique<physics::World>();
    physics::Body body = models_->create_body({});
    known = std::visit(
        [&](const auto& settings) -> physics::JointId {
            using Settings = std::remove_cvref_t<decltype(settings)>;
            if constexpr (std::is_same_v<Settings, MouseSettings>)
                return models_->create_mouse_joint({.body = body.id()}).id();
            else
                return ((*models_).*Settings::make)({.body_b = body.id()}).id();
        },
        type);
    return known;
}

/// Throws std::invalid_argument if the library would refuse the settings.
void Joints::check(const JointRecord& record) {
    const physics::JointId id = model(record.settings);
    std::visit(
        [&](const auto& settings) {
            using Settings = std::remove_cvref_t<decltype(settings)>;
            adjust(typename Settings::Native{models_.get(), id}, settings);
        },
        record.settings);
    physics::Joint any = models_->joint(id);
    any.set_anchor_a(record.anchors[0]);
    any.set_anchor_b(record.anchors[1]);
    any.set_break_force(record.break_force);
    any.set_break_torque(record.break_torque);
}

}  // namespace fettle::physics_module
