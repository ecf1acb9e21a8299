#include <handles/live.h>
#include <state/segment_surfaces.h>

#include <stdexcept>
#include <string>

// Methods of shapes: surfaces by segment of a chain.

namespace fettle::physics {

using namespace detail;

namespace {

/// Number of segments. If the chain was edited, its segments are made first, which moves records.
uint32_t count_segments(WorldData& data, uint32_t shape) {
    data.read_shape(shape);
    uint32_t count = 0;
    data.for_each_solid(shape, [&](uint32_t) { ++count; });
    return count;
}

void check_segment(WorldData& data, uint32_t shape, uint32_t segment) {
    const uint32_t count = count_segments(data, shape);
    if (segment < count) return;
    throw std::invalid_argument("segment = " + std::to_string(segment) +
                                ": expected a number below " + std::to_string(count) +
                                ", the number of segments of the chain");
}

WorldData& of_chain(WorldData& data, uint32_t shape, const char* what) {
    if (data.shapes[shape].type != ShapeType::chain)
        refuse_wrong_type(what, data.shapes[shape].type);
    return data;
}

}  // namespace

uint32_t Shape::segment_count() const {
    WorldData& data = of_chain(live(), id_.index, __func__);
    return count_segments(data, id_.index);
}

std::optional<SegmentSurface> Shape::segment_surface_override(uint32_t segment) const {
    WorldData& data = of_chain(live(), id_.index, __func__);
    check_segment(data, id_.index, segment);
    const SegmentSurface* own = own_surface(data, id_.index, segment);
    return own != nullptr ? std::optional(*own) : std::nullopt;
}

SegmentSurface Shape::segment_surface(uint32_t segment) const {
    WorldData& data = of_chain(live(), id_.index, __func__);
    check_segment(data, id_.index, segment);
    const SegmentSurface* own = own_surface(data, id_.index, segment);
    const ShapeDef surface =
        with_own(data.shapes[id_.index].surface, own != nullptr ? *own : surface_of_shape);
    return {surface.friction, surface.restitution, surface.rolling_resistance,
            surface.surface_speed, surface.material};
}

std::vector<SegmentSurface> Shape::segment_surface_overrides() const {
    WorldData& data = of_chain(live(), id_.index, __func__);
    std::vector<SegmentSurface> all;
    const uint32_t count = count_segments(data, id_.index);
    for (const SegmentRecord& record : segment_surfaces_of(data, id_.index)) {
        if (record.segment >= count) break;
        if (all.empty()) all.assign(count, surface_of_shape);
        all[record.segment] = record.surface;
    }
    return all;
}

void Shape::set_segment_surface(uint32_t segment, const std::optional<SegmentSurface>& surface) {
    FETTLE_EDIT_SHAPE
    of_chain(data, id_.index, __func__);
    if (surface) check(*surface);
    check_segment(data, id_.index, segment);
    data.change<set_own_surface>(id_.index, segment, surface);
    surface_changed(data, id_.index);
}

void Shape::set_segment_surfaces(std::span<const SegmentSurface> surfaces) {
    FETTLE_EDIT_SHAPE
    of_chain(data, id_.index, __func__);
    for (const SegmentSurface& surface : surfaces) check(surface);
    const uint32_t count = count_segments(data, id_.index);
    if (!surfaces.empty() && surfaces.size() != count)
        throw std::invalid_argument("surfaces: expected none or " + std::to_string(count) +
                                    ", one for each segment of the chain, got " +
                                    std::to_string(surfaces.size()));
    remove_segment_surfaces(data, id_.index);
    for (uint32_t i = 0; i < surfaces.size(); ++i)
        data.change<set_own_surface>(id_.index, i, surfaces[i]);
    surface_changed(data, id_.index);
}

}  // namespace fettle::physics
