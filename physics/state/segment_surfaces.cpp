#include <state/segment_surfaces.h>

#include <algorithm>

// Surfaces of single segments of a chain. Few chains have any, so they are in one sorted list and
// not in the records of shapes: other shapes take no memory for them. The parts of the
// chain have copies, as of the surface of the shape, so a contact reads the surface of its part.

namespace fettle::physics::detail {
namespace {

/// Place of the first record from this segment of this shape on.
size_t place_of(const ObjectState& objects, uint32_t shape, uint32_t segment) {
    const auto& all = objects.segment_surfaces;
    const auto found = std::lower_bound(
        all.begin(), all.end(), segment, [shape](const SegmentRecord& record, uint32_t wanted) {
            return record.shape != shape ? record.shape < shape : record.segment < wanted;
        });
    return size_t(found - all.begin());
}

}  // namespace

std::span<const SegmentRecord> segment_surfaces_of(const ObjectState& objects, uint32_t shape) {
    const auto& all = objects.segment_surfaces;
    if (all.empty()) return {};
    const size_t begin = place_of(objects, shape, 0), end = place_of(objects, shape, none);
    return {all.data() + begin, end - begin};
}

const SegmentSurface* own_surface(const ObjectState& objects, uint32_t shape, uint32_t segment) {
    const auto& all = objects.segment_surfaces;
    const size_t place = place_of(objects, shape, segment);
    const bool found =
        place < all.size() && all[place].shape == shape && all[place].segment == segment;
    return found ? &all[place].surface : nullptr;
}

void set_own_surface(ObjectState& objects, uint32_t shape, uint32_t segment,
                     const std::optional<SegmentSurface>& surface) {
    auto& all = objects.segment_surfaces;
    const auto place = all.begin() + std::ptrdiff_t(place_of(objects, shape, segment));
    const bool found = place != all.end() && place->shape == shape && place->segment == segment;
    if (!surface || *surface == surface_of_shape) {
        if (found) all.erase(place);
    } else if (found) {
        place->surface = *surface;
    } else {
        all.insert(place, {shape, segment, *surface});
    }
}

void remove_segment_surfaces(ObjectState& objects, uint32_t shape) {
    auto& all = objects.segment_surfaces;
    if (all.empty()) return;
    all.erase(all.begin() + std::ptrdiff_t(place_of(objects, shape, 0)),
              all.begin() + std::ptrdiff_t(place_of(objects, shape, none)));
}

ShapeDef with_own(const ShapeDef& of_shape, const SegmentSurface& own) {
    ShapeDef surface = of_shape;
    const auto override_with = [](auto& value, auto given, auto means_that_of_shape) {
        if (given != means_that_of_shape) value = given;
    };
    override_with(surface.friction, own.friction, surface_of_shape.friction);
    override_with(surface.restitution, own.restitution, surface_of_shape.restitution);
    override_with(surface.rolling_resistance, own.rolling_resistance,
                  surface_of_shape.rolling_resistance);
    override_with(surface.surface_speed, own.surface_speed, surface_of_shape.surface_speed);
    override_with(surface.material, own.material, surface_of_shape.material);
    return surface;
}

}  // namespace fettle::physics::detail
