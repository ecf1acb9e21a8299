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

fettle_field_def told_of(const FieldDef& def) {
    fettle_field_def told{};
    told.size = sizeof told;
    told.type = int32_t(def.force.index());
    told.has_region = def.region.has_value();
    if (def.region) told.region = converted(*def.region);
    told.enabled = def.enabled;
    told.mask = def.mask;
    told.user_data = def.user_data;
    if (const auto* wind = std::get_if<WindField>(&def.force)) {
        told.velocity = converted(wind->velocity);
        told.density = wind->density;
    } else if (const auto* drag = std::get_if<DragField>(&def.force)) {
        told.flow = converted(drag->flow);
        told.linear = drag->linear;
        told.quadratic = drag->quadratic;
    } else if (const auto* liquid = std::get_if<BuoyancyField>(&def.force)) {
        told.level = liquid->level;
        told.normal = converted(liquid->normal);
        told.density = liquid->density;
        told.drag = liquid->drag;
        told.flow = converted(liquid->flow);
    } else if (const auto* attractor = std::get_if<AttractorField>(&def.force)) {
        told.center = converted(attractor->center);
        told.strength = attractor->strength;
        told.falloff = attractor->falloff;
        told.core = attractor->core;
    }
    return told;
}

FieldType field_type(int32_t type) {
    return enumerator("type", type, FieldType::attractor);
}

}  // namespace

FieldDef definition_of(const fettle_field_def* def) {
    const fettle_field_def& given = needed("def", def);
    check_size(given.size, sizeof given);
    FieldDef taken;
    switch (field_type(given.type)) {
        case FieldType::wind:
            taken.force = WindField{vector_of(given.velocity), given.density};
            break;
        case FieldType::drag:
            taken.force = DragField{vector_of(given.flow), given.linear, given.quadratic};
            break;
        case FieldType::buoyancy:
            taken.force = BuoyancyField{given.level, vector_of(given.normal), given.density,
                                        given.drag, vector_of(given.flow)};
            break;
        case FieldType::attractor:
            taken.force = AttractorField{position_of(given.center), given.strength, given.falloff,
                                         given.core};
            break;
    }
    if (flag(given.has_region)) taken.region = box_of(given.region);
    taken.mask = given.mask;
    taken.enabled = flag(given.enabled);
    taken.user_data = given.user_data;
    return taken;
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
        result = told_of(defaults);
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
        fettle_field_def& told = needed("def", def);
        check_size(told.size, sizeof told);
        told = told_of(it.definition());
    });
}

fettle_code fettle_field_set(fettle_world* world, fettle_id field, const fettle_field_def* def) {
    return on<Field>(__func__, world, field, [&](Field it) { it.set(definition_of(def)); });
}
