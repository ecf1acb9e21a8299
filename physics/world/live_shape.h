#pragma once

#include <checks/arguments.h>
#include <world/world_data.h>

namespace fettle::physics::detail {

inline WorldData& live(WorldLink* link, ShapeId id) {
    if (link == nullptr || link->data == nullptr || !link->data->is_valid(id)) [[unlikely]]
        dangling("shape", link, id.index, id.generation);
    return *link->data;
}

}  // namespace fettle::physics::detail

// The first line of every method of `Shape` that needs a live one: `data`, and its records.
#define FETTLE_LIVE_SHAPE                                          \
    WorldData& data = detail::live(link_, id_);                    \
    [[maybe_unused]] ShapeRecord& record = data.shapes[id_.index]; \
    [[maybe_unused]] ShapeForm& form = data.forms[id_.index];
// The same for one that edits it.
#define FETTLE_EDIT_SHAPE \
    FETTLE_LIVE_SHAPE     \
    data.self.may_edit("Shape", __func__);

// A property that is read and no more than that.
#define FETTLE_SHAPE_READ(Value, name, value) \
    Value Shape::name() const {               \
        FETTLE_LIVE_SHAPE                     \
        return value;                         \
    }
