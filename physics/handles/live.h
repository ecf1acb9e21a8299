#pragma once

#include <checks/arguments.h>
#include <world/world_data.h>

namespace fettle::physics::detail {

// Common code of the handles of bodies and shapes.

/// The data of the world in which the object lives; `kind`: name of its type for errors.
template <class Id>
WorldData& live(WorldLink* link, Id id, const char* kind) {
    if (link == nullptr || link->data == nullptr || !link->data->is_valid(id)) [[unlikely]]
        refuse_dangling(kind, link, id.index, id.generation);
    return *link->data;
}

/// To be called after an edit of the surface of a shape or of its segments.
void surface_changed(WorldData& data, uint32_t shape);

/// Returns true if the body may have a velocity. Then it is awake afterwards, unless it is
/// disabled; the bodies that touch it wake if necessary.
bool wake_if_movable(WorldData& data, uint32_t body);

/// Throws: the body that carries the bounds of a world cannot be edited.
[[noreturn]] void refuse_border_body(const char* function);

inline void may_edit_body(const WorldData& data, BodyId id, const char* function) {
    data.self.may_edit("Body", function);
    if (id.index == 0) [[unlikely]]
        refuse_border_body(function);
}

}  // namespace fettle::physics::detail

// The first line of every method of `Body` that requires a live body: declares `data` and its
// records.
#define FETTLE_LIVE_BODY                                          \
    WorldData& data = detail::live(link_, id_, "body");           \
    [[maybe_unused]] BodyRecord& record = data.bodies[id_.index]; \
    [[maybe_unused]] BodyState& state = data.states[id_.index];
// The same for methods that edit it.
#define FETTLE_EDIT_BODY \
    FETTLE_LIVE_BODY     \
    may_edit_body(data, id_, __func__);

// Defines a read-only property.
#define FETTLE_BODY_READ(Value, name, value) \
    Value Body::name() const {               \
        FETTLE_LIVE_BODY                     \
        return value;                        \
    }
// Defines a property that follows from the shapes and may be out of date.
#define FETTLE_BODY_DERIVED(Value, name, value) \
    Value Body::name() const {                  \
        FETTLE_LIVE_BODY                        \
        data.read_mass(id_.index);              \
        return value;                           \
    }
// Defines a number that a step reads: it is checked, and writing it wakes the body.
#define FETTLE_BODY_NUMBER(name, cell, check)  \
    FETTLE_BODY_READ(float, name, record.cell) \
    void Body::set_##name(float value) {       \
        FETTLE_EDIT_BODY                       \
        record.cell = check(#name, value);     \
        data.change<wake_body>(id_.index);     \
    }

// The first line of every method of `Shape` that requires a live shape: declares `data` and its
// records.
#define FETTLE_LIVE_SHAPE                                          \
    WorldData& data = detail::live(link_, id_, "shape");           \
    [[maybe_unused]] ShapeRecord& record = data.shapes[id_.index]; \
    [[maybe_unused]] ShapeForm& form = data.forms[id_.index];
// The same for values that may be out of date. A refresh may make parts of outlines, which moves
// all records, so it comes before the references.
#define FETTLE_REFRESHED_SHAPE(refresh)                            \
    WorldData& data = detail::live(link_, id_, "shape");           \
    data.refresh;                                                  \
    [[maybe_unused]] ShapeRecord& record = data.shapes[id_.index]; \
    [[maybe_unused]] ShapeForm& form = data.forms[id_.index];
// The first line of methods that edit it.
#define FETTLE_EDIT_SHAPE \
    FETTLE_LIVE_SHAPE     \
    data.self.may_edit("Shape", __func__);

// Defines a read-only property.
#define FETTLE_SHAPE_READ(Value, name, value) \
    Value Shape::name() const {               \
        FETTLE_LIVE_SHAPE                     \
        return value;                         \
    }
