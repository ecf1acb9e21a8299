#include <calls/convert.h>

#include <cstdio>

namespace fettle::physics_c {

using namespace physics;

namespace {

constexpr const char* kinds[] = {nullptr, "body", "shape", "joint", "field"};

std::string name_of_kind(uint32_t kind) {
    if (kind == 0) return "nothing";
    return kind < std::size(kinds) ? std::string("a ") + kinds[kind] : "no object";
}

const char* name_of(JointType type) {
    constexpr const char* names[] = {"mouse",    "distance", "revolute", "prismatic",   "wheel",
                                     "weld",     "motor",    "pulley",   "gear",        "groove",
                                     "pin slot", "ratchet",  "filter",   "rotary limit"};
    return names[size_t(type)];
}

std::string text(fettle_id id) {
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "0x%016llx", static_cast<unsigned long long>(id));
    return buffer;
}

}  // namespace

fettle_id packed(uint32_t index, uint32_t generation, uint32_t kind) {
    if (generation == 0) return 0;
    if (index >> slot_bits != 0)
        throw Failure{FETTLE_FAILED, "the world has more objects than ids in C can name"};
    return uint64_t(generation) << 32 | kind << slot_bits | index;
}

uint32_t unpacked(fettle_id id, uint32_t kind) {
    const uint32_t given = uint32_t(id) >> slot_bits;
    if (id == 0)
        throw Failure{FETTLE_STALE,
                      "expected the id of " + name_of_kind(kind) + ", got 0, which names none"};
    if (given != kind)
        throw Failure{FETTLE_INVALID, "expected the id of " + name_of_kind(kind) + ", got " +
                                          text(id) + ", which names " + name_of_kind(given)};
    return uint32_t(id) & ((1u << slot_bits) - 1);
}

void refuse_if_damaged(World& world) {
    try {
        (void)Body(&world, {0, 1}).world();
    } catch (const std::invalid_argument&) {
        // An undamaged world reports that it has no such body; a damaged one throws something else.
    }
}

void refuse_stale(fettle_id id, uint32_t kind) {
    const std::string object = std::string(kinds[kind]) + " " + std::to_string(unpacked(id, kind));
    throw Failure{FETTLE_STALE, "expected the id of " + name_of_kind(kind) + ", got that of " +
                                    object + " (" + text(id) +
                                    "), which was destroyed, or is of another world"};
}

void refuse_joint(JointType wanted, JointType is) {
    throw Failure{FETTLE_INVALID, std::string("expected a ") + name_of(wanted) + " joint, got a " +
                                      name_of(is) + " joint"};
}

Body body_or_world(const char* name, const fettle_world* world, fettle_id id) {
    return id == 0 ? Body() : body_named([=] { return name; }, world, id);
}

fettle_body_state converted(const BodyState& state) {
    return {converted(state.position), state.angle,  state.angular_velocity,
            converted(state.velocity), state.cosine, state.sine};
}

fettle_contact converted(const Contact& contact) {
    fettle_contact result{};
    result.body_a = converted(contact.body_a);
    result.body_b = converted(contact.body_b);
    result.shape_a = converted(contact.shape_a);
    result.shape_b = converted(contact.shape_b);
    result.normal = converted(contact.normal);
    result.friction = contact.friction;
    result.restitution = contact.restitution;
    result.normal_force = contact.normal_force;
    result.point_count = contact.point_count;
    result.part_a = contact.part_a;
    result.part_b = contact.part_b;
    result.material_a = contact.material_a;
    result.material_b = contact.material_b;
    for (size_t i = 0; i < contact.points.size(); ++i) {
        const ContactPoint& point = contact.points[i];
        result.points[i] = {converted(point.point), point.separation, point.normal_impulse,
                            point.tangent_impulse, point.feature};
    }
    return result;
}

fettle_ray_hit converted(const RayHit& hit) {
    return {converted(hit.shape), converted(hit.point), converted(hit.normal), hit.fraction};
}

fettle_point_hit converted(const PointHit& hit) {
    return {converted(hit.shape), converted(hit.point), converted(hit.normal), hit.distance};
}

fettle_memory_share converted(const MemoryShare& share) {
    return {share.purpose, share.used, share.reserved};
}

}  // namespace fettle::physics_c

uint32_t fettle_slot(fettle_id id) {
    return uint32_t(id) & ((1u << fettle::physics_c::slot_bits) - 1);
}
