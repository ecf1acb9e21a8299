#include <fettle/physics_c/field.h>

#include <calls/members.h>

namespace fettle::physics_c {

using namespace physics;

template <class InC, class Each>
void each_member(InC& c, WindField& wind, const Each& each) {
    each(c.velocity, wind.velocity);
    each(c.density, wind.density);
}

template <class InC, class Each>
void each_member(InC& c, DragField& drag, const Each& each) {
    each(c.flow, drag.flow);
    each(c.linear, drag.linear);
    each(c.quadratic, drag.quadratic);
}

template <class InC, class Each>
void each_member(InC& c, BuoyancyField& liquid, const Each& each) {
    each(c.level, liquid.level);
    each(c.normal, liquid.normal);
    each(c.density, liquid.density);
    each(c.drag, liquid.drag);
    each(c.flow, liquid.flow);
}

template <class InC, class Each>
void each_member(InC& c, AttractorField& attractor, const Each& each) {
    each(c.center, attractor.center);
    each(c.strength, attractor.strength);
    each(c.falloff, attractor.falloff);
    each(c.core, attractor.core);
}

/// `def.force` must already have the type of the field; its members are copied.
template <class InC, class Each>
void each_member(InC& c, FieldDef& def, const Each& each) {
    std::visit([&](auto& force) { each_member(c, force, each); }, def.force);
    each(c.has_region, c.region, def.region);
    each(c.mask, def.mask);
    each(c.enabled, def.enabled);
    each(c.user_data, def.user_data);
}

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

FieldType field_type(int32_t type) {
    return enumerator("type", type, FieldType::attractor);
}

fettle_field_def definition_in_c(const FieldDef& def) {
    fettle_field_def result = in_c<fettle_field_def>(def);
    result.type = int32_t(def.force.index());
    return result;
}

}  // namespace

FieldDef definition_of(const fettle_field_def* def) {
    const fettle_field_def& given = needed("def", def);
    check_size(given.size, sizeof given);
    FieldDef result;
    result.force = default_force(field_type(given.type));
    each_member(given, result, FromC());
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
        result = definition_in_c(defaults);
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
        result = definition_in_c(it.definition());
    });
}

fettle_code fettle_field_set(fettle_world* world, fettle_id field, const fettle_field_def* def) {
    return on<Field>(__func__, world, field, [&](Field it) { it.set(definition_of(def)); });
}
