#include <hosting/movers.h>

#include <algorithm>
#include <iterator>
#include <limits>

#include <hosting/hosting.h>

namespace fettle::physics_module {

physics::MoverDef definition(const MoverRecord& record, const physics::Body& body) {
    physics::MoverDef def;
    def.radius = std::clamp(record.radius, 0.01f, 500.0f);
    const float wanted = record.crouched != 0 ? record.crouch_height : record.height;
    def.height = std::clamp(wanted, 2.0f * def.radius, 1000.0f);
    def.up = body.world_vector({0.0f, 1.0f});
    def.max_slope = std::clamp(record.max_slope, 0.0f, 1.5f);
    def.step_height = std::clamp(record.step_height, 0.0f, 1000.0f);
    def.snap = std::clamp(record.snap, 0.0f, 1000.0f);
    def.push_force = std::clamp(record.push_force, 0.0f, 1e9f);
    def.mass = std::clamp(body.mass(), 0.0f, 1e6f);
    def.ledges = record.ledges;
    def.body = body.id();
    if (const physics::Shape shape = capsule_of(body)) {
        def.category = shape.category();
        def.mask = shape.mask();
        def.group = shape.group();
    }
    return def;
}

std::size_t Movers::place_of(std::uint32_t slot) const {
    const auto at = std::lower_bound(
        records_.begin(), records_.end(), slot,
        [](const MoverRecord& record, std::uint32_t wanted) { return record.slot < wanted; });
    return static_cast<std::size_t>(at - records_.begin());
}

MoverRecord Movers::get(std::uint32_t slot) const {
    const std::size_t at = place_of(slot);
    return at < records_.size() && records_[at].slot == slot ? records_[at] : MoverRecord{};
}

void Movers::set(std::uint32_t slot, MoverRecord record) {
    record.slot = slot;
    const std::size_t at = place_of(slot);
    if (at < records_.size() && records_[at].slot == slot)
        records_[at] = record;
    else
        records_.insert(records_.begin() + static_cast<std::ptrdiff_t>(at), record);
}

void Movers::forget(std::uint32_t slot) {
    const std::size_t at = place_of(slot);
    if (at < records_.size() && records_[at].slot == slot)
        records_.erase(records_.begin() + static_cast<std::ptrdiff_t>(at));
}

namespace {

bool is_within(float value, float least, float most) {
    return value >= least && value <= most;
}

/// True if writes could have made the settings, and steps the state.
bool is_sound(const MoverRecord& r) {
    constexpr float largest = std::numeric_limits<float>::max();
    const float state[] = {r.velocity_x, r.velocity_y, r.shown_x,      r.shown_y,  r.place_x,
                           r.place_y,    r.normal_x,   r.normal_y,     r.ground_x, r.ground_y,
                           r.bump_x,     r.bump_y,     r.landing_speed};
    return is_within(r.radius, 0.01f, 500.0f) && is_within(r.height, 0.02f, 1000.0f) &&
           is_within(r.crouch_height, 0.02f, 1000.0f) && is_within(r.max_slope, 0.0f, 1.5f) &&
           is_within(r.step_height, 0.0f, 1000.0f) && is_within(r.snap, 0.0f, 1000.0f) &&
           is_within(r.push_force, 0.0f, 1e9f) && is_within(r.walk, -largest, largest) &&
           is_within(r.climb, -largest, largest) && is_within(r.acceleration, 0.0f, largest) &&
           is_within(r.air_acceleration, 0.0f, largest) &&
           std::all_of(std::begin(state), std::end(state),
                       [](float x) { return is_within(x, -1e9f, 1e9f); });
}

}  // namespace

bool are_sound(const std::vector<MoverRecord>& records) {
    std::uint64_t last = 0;
    for (const MoverRecord& record : records) {
        if (record.slot <= last || record.slot >= max_slots || !is_sound(record)) return false;
        last = record.slot;
    }
    return true;
}

physics::Shape capsule_of(const physics::Body& body) {
    for (const physics::Shape& shape : body.shapes())
        if (shape.user_data() == 0 && shape.type() == physics::ShapeType::segment) return shape;
    return {};
}

physics::Segment capsule(float radius, float height) {
    return {.from = {0.0f, radius},
            .to = {0.0f, std::max(height - radius, radius)},
            .rounding = radius};
}

Row Hosting::create_mover(Handle self) {
    const Placing placing(*this);
    const std::uint32_t number = world_above(self);
    HostedWorld& in = *worlds_[number];
    physics::Body made = in.world.create_body(
        {.type = physics::BodyType::kinematic_body, .mass = 80.0f, .user_data = pack(self)});
    const Row row = row_of(number, made);
    const MoverRecord record;
    made.add(capsule(record.radius, record.height), {.hit_events = wanted_.hits});
    in.movers.set(made.index(), record);
    return row;
}

}  // namespace fettle::physics_module
