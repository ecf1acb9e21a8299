#include <fettle/physics_c/field.h>

#include <calls/calls.h>

namespace fettle::physics_c {

using namespace physics;

namespace {

enum class FieldType : int32_t { wind, drag, buoyancy, attractor };

decltype(FieldDef::force) default_force(FieldType type) {
    switch (type) {
        case FieldType::wind:
            return WindField{};
        case FieldType::drag:
            return DragField{};
        case FieldType::buoyancy:
            return BuoyancyField{};
        default:
            return AttractorField{};
    }
}

fettle_field_def in_c(const FieldDef& def) {
    fettle_field_def result{};
    result.size = sizeof result;
    result.type = int32_t(def.force.index());
    result.has_region = def.region.has_value();
    if (def.region) result.region = converted(*def.region);
    result.enabled = def.enabled;
    result.mask = def.mask;
    result.user_data = def.user_data;
    if (const auto* wind = std::get_if<WindField>(&def.force)) {
        result.velocity = converted(wind->velocity);
        result.density = wind->density;
    } else if (const auto* drag = std::get_if<DragField>(&def.force)) {
        result.flow = converted(drag->flow);
        result.linear = drag->linear;
        result.quadratic = drag->quadratic;
    } else if (const auto* liquid = std::get_if<BuoyancyField>(&def.force)) {
        result.level = liquid->level;
        result.normal = converted(liquid->normal);
        result.density = liquid->density;
        result.drag = liquid->drag;
        result.flow = converted(liquid->flow);
    } else if (const auto* attractor = std::get_if<AttractorField>(&def.force)) {
        result.center = converted(attractor->center);
        result.strength = attractor->strength;
        result.falloff = attractor->falloff;
        result.core = attractor->core;
    }
    return result;
}

FieldType field_type(int32_t type) {
    return enumerator("type", type, FieldType::attractor);
}

}  // namespace

FieldDef definition_of(const fettle_field_def* def) {
    const fettle_field_def& given = needed("def", def);
    check_size(given.size, sizeof given);
    FieldDef result;
    switch (field_type(given.type)) {
        case FieldType::wind:
            result.force = WindField{vector_of(given.velocity), given.density};
            break;
        case FieldType::drag:
            result.force = DragField{vector_of(given.flow), given.linear, given.quadratic};
            break;
        case FieldType::buoyancy:
            result.force = BuoyancyField{given.level, vector_of(given.normal), given.density,
                                         given.drag, vector_of(given.flow)};
            break;
        case FieldType::attractor:
            result.force = AttractorField{position_of(given.center), given.strength, given.falloff,
                                          given.core};
            break;
    }
    if (flag(given.has_region)) result.region = box_of(given.region);
    result.mask = given.mask;
    result.enabled = flag(given.enabled);
    result.user_data = given.user_data;
    return result;
}

}  // namespace fettle::physics_c

using namespace fettle::physics_c;
using fettle::physics::Field;

fettle_code fettle_field_def_init(fettle_field_def* def, size_t size, int32_t type) {
    return guarded(__func__, [&] {
        fettle_field_def& result = needed("def", def);
        check_size(size, sizeof result);
        fettle::physics::FieldDef defaults;
        defaults.force = default_force(field_type(type));
        result = in_c(defaults);
    });
}

bool fettle_field_is_valid(const fettle_world* world, fettle_id field) {
    return lives<fettle::physics::FieldId>(world, field);
}

fettle_code fettle_field_destroy(fettle_world* world, fettle_id field) {
    return edit<&Field::destroy>(__func__, world, field);
}

fettle_code fettle_field_definition(const fettle_world* world, fettle_id field,
                                    fettle_field_def* def) {
    return on<Field>(__func__, world, field, [&](Field it) {
        fettle_field_def& result = needed("def", def);
        check_size(result.size, sizeof result);
        result = in_c(it.definition());
    });
}

fettle_code fettle_field_set(fettle_world* world, fettle_id field, const fettle_field_def* def) {
    return on<Field>(__func__, world, field, [&](Field it) { it.set(definition_of(def)); });
}
