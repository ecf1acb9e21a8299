#include <hosting/movers.h>

#include <algorithm>
#include <iterator>
#include <limits>

#include <hosting/hosting.h>

namespace fettle::physics_module {

physics::MoverDef definition(const MoverRecord& record, const physics::Body& body) {
    physics::MoverDef def;
    def.radius = std::clamp(record.settings.radius, 0.01f, 500.0f);
    const float wanted =
        record.result.crouched != 0 ? record.settings.crouch_height : record.settings.height;
    def.height = std::clamp(wanted, 2.0f * def.radius, 1000.0f);
    def.up = body.world_vector({0.0f, 1.0f});
    def.max_slope = std::clamp(record.settings.max_slope, 0.0f, 1.5f);
    def.step_height = std::clamp(record.settings.step_height, 0.0f, 1000.0f);
    def.snap = std::clamp(record.settings.snap, 0.0f, 1000.0f);
    def.push_force = std::clamp(record.settings.push_force, 0.0f, 1e9f);
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

void Movers::reset(std::uint32_t slot) {
    const std::size_t at = place_of(slot);
    if (at < records_.size() && records_[at].slot == slot)
        records_.erase(records_.begin() + static_cast<std::ptrdiff_t>(at));
}

namespace {

bool is_within(float value, float least, float most) {
    return value >= least && value <= most;
}

/// False if a deserialized setting is out of the range of its property.
bool are_valid(const MoverSettings& s) {
    constexpr float largest = std::numeric_limits<float>::max();
    return is_within(s.radius, 0.01f, 500.0f) && is_within(s.height, 0.02f, 1000.0f) &&
           is_within(s.crouch_height, 0.02f, 1000.0f) && is_within(s.max_slope, 0.0f, 1.5f) &&
           is_within(s.step_height, 0.0f, 1000.0f) && is_within(s.snap, 0.0f, 1000.0f) &&
           is_within(s.push_force, 0.0f, 1e9f) && is_within(s.walk, -largest, largest) &&
           is_within(s.climb, -largest, largest) && is_within(s.acceleration, 0.0f, largest) &&
           is_within(s.air_acceleration, 0.0f, largest);
}

/// False if a deserialized number is not finite or larger than any step makes it.
bool is_valid(const MoverResult& result, const MoverEvents& events) {
    const float numbers[] = {result.velocity_x, result.velocity_y, result.shown_x,
                             result.shown_y,    result.place_x,    result.place_y,
                             result.normal_x,   result.normal_y,   result.ground_x,
                             result.ground_y,   result.left_x,     result.left_y,
                             events.bump_x,     events.bump_y,     events.landing_speed};
    return std::all_of(std::begin(numbers), std::end(numbers),
                       [](float x) { return is_within(x, -1e9f, 1e9f); });
}

}  // namespace

bool are_valid(const std::vector<MoverRecord>& records) {
    std::uint64_t last = 0;
    for (const MoverRecord& record : records) {
        if (record.slot <= last || record.slot >= max_slots) return false;
        if (!are_valid(record.settings) || !is_valid(record.result, record.events)) return false;
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
    made.add(capsule(record.settings.radius, record.settings.height), {.hit_events = wanted_.hits});
    in.movers.set(made.index(), record);
    return row;
}

}  // namespace fettle::physics_module
