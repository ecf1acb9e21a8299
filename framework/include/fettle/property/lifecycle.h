#pragma once
// The functions of a class that the tree calls.

#include <cstdint>

#include <fettle/property/export.h>
#include <fettle/property/painter.h>
#include <fettle/property/transform.h>
#include <fettle/property/value.h>

FETTLE_PROPERTY_BEGIN

namespace fettle::property {

class Tree;

/// A module's number for one of its objects: an array index, or any other 32 bits.
using Row = std::uint32_t;

/// Called by the tree when instances of the class are created, moved and deleted. All optional.
struct Lifecycle {
    void* context = nullptr;  ///< is given to the functions
    /// Creates the row, with defaults, before the instance is visible. May throw Error for lack of
    /// room. Until the instance is complete, with `place`, deleting or moving it or one above
    /// throws Error(bad_structure). `Tree::restore` calls it for instances that were not there,
    /// those above first: others have no row yet, so their properties must not be read; deleting or
    /// moving them, creating an instance below them, or taking a snapshot throws the same.
    Row (*create)(void* context, Tree& tree, Handle self) = nullptr;
    /// The chain of parents above `self` changed (called for parents before children). Returns the
    /// row, possibly another one. Meanwhile, deleting or moving the instance, the former parent of
    /// what is being moved, or one above these throws Error(bad_structure).
    Row (*place)(void* context, Tree& tree, Handle self, Row row) = nullptr;
    /// Ends the row. During this, the instances that are being deleted cannot be deleted again,
    /// moved, renamed or get children, and no snapshot can be restored: that throws
    /// Error(bad_structure). Within `Tree::restore`, no instance at all can be created, deleted,
    /// moved or renamed. `Tree::destroy` throws its exceptions after all instances are deleted; a
    /// restore reports them in `restore_remarks`; at the end of the tree they are ignored. In a
    /// module that is plugged in, they are printed.
    void (*destroy)(void* context, Tree& tree, Handle self, Row row) = nullptr;
    /// Draws the instance. `alpha`: time between the last two steps, 0 to 1.
    void (*draw)(void* context, const Tree& tree, Handle self, Row row, Painter& painter,
                 double alpha) = nullptr;
    /// Draws over all instances, after they are drawn.
    void (*draw_over)(void* context, const Tree& tree, Handle self, Row row, Painter& painter,
                      double alpha) = nullptr;
    /// Where the instance is drawn: the map from its own coordinates to those of the world; for
    /// `alpha`, see `draw`. Pictures and texts below it are drawn in its coordinates.
    Transform (*pose)(void* context, const Tree& tree, Handle self, Row row,
                      double alpha) = nullptr;
    /// Instances below this one are drawn between `begin_below` and `end_below`: once for each
    /// `pass`, 0, 1, 2 ..., until `begin_below` returns false; then `end_below` is not called. Both
    /// are called again if others are drawn in between. A state of the painter that the first one
    /// pushes, the second one pops.
    bool (*begin_below)(void* context, const Tree& tree, Handle self, Row row, Painter& painter,
                        int pass) = nullptr;
    /// Called after the instances below this one are drawn.
    void (*end_below)(void* context, const Tree& tree, Handle self, Row row,
                      Painter& painter) = nullptr;
    /// Whether a function is set.
    bool any() const {
        return create || place || destroy || draw || draw_over || pose || begin_below;
    }
};

}  // namespace fettle::property

FETTLE_PROPERTY_END
