#pragma once

#include <state/world_state.h>

#include <optional>
#include <span>

// Surfaces of single segments of a chain.

namespace fettle::physics::detail {

/// The surfaces of a chain, in the order of the segments.
std::span<const SegmentRecord> segment_surfaces_of(const ObjectState& objects, uint32_t shape);
/// The own surface of a segment; null: it has none.
const SegmentSurface* own_surface(const ObjectState& objects, uint32_t shape, uint32_t segment);
/// nullopt: the segment gets the surface of the shape. `copy_surface_to_parts` must be called
/// after.
void set_own_surface(ObjectState& objects, uint32_t shape, uint32_t segment,
                     const std::optional<SegmentSurface>& surface);
void remove_segment_surfaces(ObjectState& objects, uint32_t shape);
/// The surface of the shape with what the segment has of its own.
ShapeDef with_own(const ShapeDef& of_shape, const SegmentSurface& own);

}  // namespace fettle::physics::detail
