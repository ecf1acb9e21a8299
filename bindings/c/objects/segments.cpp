#include <fettle/physics_c/shape.h>

#include <calls/calls.h>

// Surfaces of single segments of a chain.

namespace fettle::physics_c {

using namespace physics;

namespace {

fettle_segment_surface in_c(const SegmentSurface& surface) {
    return {surface.friction, surface.restitution, surface.rolling_resistance,
            surface.surface_speed, surface.material};
}

SegmentSurface surface_of(const fettle_segment_surface& given) {
    return {given.friction, given.restitution, given.rolling_resistance, given.surface_speed,
            checked(Material{given.material})};
}

}  // namespace
}  // namespace fettle::physics_c

using namespace fettle::physics_c;
using fettle::physics::SegmentSurface;
using fettle::physics::Shape;

fettle_code fettle_shape_segment_count(const fettle_world* world, fettle_id shape,
                                       uint32_t* segment_count) {
    return read<&Shape::segment_count>(__func__, world, shape, segment_count);
}

fettle_code fettle_shape_segment_surface(const fettle_world* world, fettle_id shape,
                                         uint32_t segment, fettle_segment_surface* surface) {
    return on<Shape>(__func__, world, shape, [&](Shape it) {
        fettle_segment_surface& result = needed("surface", surface);
        result = in_c(it.segment_surface(segment));
    });
}

fettle_code fettle_shape_set_segment_surface(fettle_world* world, fettle_id shape, uint32_t segment,
                                             const fettle_segment_surface* surface) {
    return on<Shape>(__func__, world, shape, [&](Shape it) {
        if (surface == nullptr)
            it.set_segment_surface(segment, {});
        else
            it.set_segment_surface(segment, surface_of(*surface));
    });
}

fettle_code fettle_shape_segment_surface_override(const fettle_world* world, fettle_id shape,
                                                  uint32_t segment, bool* is_set,
                                                  fettle_segment_surface* surface) {
    return on<Shape>(__func__, world, shape, [&](Shape it) {
        bool& set = needed("is_set", is_set);
        fettle_segment_surface& result = needed("surface", surface);
        const auto own = it.segment_surface_override(segment);
        set = own.has_value();
        result = own ? in_c(*own) : fettle_segment_surface{};
    });
}

fettle_code fettle_shape_set_segment_surfaces(fettle_world* world, fettle_id shape,
                                              const fettle_segment_surface* surfaces,
                                              uint32_t count) {
    return on<Shape>(__func__, world, shape, [&](Shape it) {
        std::vector<SegmentSurface> result;
        if (count > 0) {
            const auto* begin = &needed("surfaces", surfaces);
            if (const uint32_t wanted = it.segment_count(); wanted != count)
                throw Failure{FETTLE_INVALID, "surfaces: expected none or " +
                                                  std::to_string(wanted) +
                                                  ", one for each segment of the chain, got " +
                                                  std::to_string(count)};
            for (uint32_t i = 0; i < count; ++i) result.push_back(surface_of(begin[i]));
        }
        it.set_segment_surfaces(result);
    });
}
