#pragma once

#include <contacts/contact_list.h>
#include <sleep/sleep.h>
#include <state/step_scratch.h>
#include <state/world_state.h>

#include <string_view>

// Edits of a world. Derived data are computed lazily: an edit marks outdated data and lists them.
// They are computed when they are read or before the next step, once for any number of edits.

namespace fettle::physics::detail {

/// Data that an edit may change.
struct Editing {
    ObjectState& objects;
    Columns& columns;
    BroadPhaseState& broad_phase;
    ActiveLists& active;
    const WorldDef& settings;
    ContactList contacts;
    Activity activity;
    Generations& generations;
};

// edits.cpp: marking data, and computing marked data

void mark_geometry(ObjectState& objects, ActiveLists& active, uint32_t shape);
void mark_mass(ObjectState& objects, ActiveLists& active, uint32_t body);
void mark_placement(ObjectState& objects, ActiveLists& active, uint32_t body);
/// Must be called after the mass of the body or its number of joints changed: it is computed anew
/// whether its joints may crowd it.
void mark_joints(ObjectState& objects, ActiveLists& active, uint32_t body);
/// Must be called when an edit moved the shape or changed which shapes it collides with: all its
/// pairs are searched again.
void mark_moved(ObjectState& objects, BroadPhaseState& broad_phase, uint32_t shape);
/// Must be called when an edit changed which shapes the shape collides with, but did not move it.
void mark_refiltered(ObjectState& objects, const Columns& columns, BroadPhaseState& broad_phase,
                     uint32_t shape);
/// Must be called when an edit moved or changed shapes of the body: the manifolds of its contacts
/// are computed again.
void drop_kept_manifolds(ObjectState& objects, uint32_t body);

void refresh(const Editing& editing);
void refresh_shape(const Editing& editing, uint32_t shape);
void refresh_edited_mass(const Editing& editing, uint32_t body);
inline void refresh_mass(const Editing& editing, uint32_t body) {
    // A body that is not listed has no outdated data, nor have its shapes.
    if (editing.objects.bodies[body].listed) refresh_edited_mass(editing, body);
}
void remove_proxy(ObjectState& objects, BroadPhaseState& broad_phase, uint32_t shape);
void refilter(const Editing& editing, const UserFilter& filter, uint32_t shape);

inline void wake_for_edit(const Activity& activity, uint32_t body) {
    wake_body(activity, body);
    if (activity.objects.bodies[body].mobility != Mobility::dynamic) wake_touching(activity, body);
}

/// Moves a body to another pose. Bodies that rested on it wake, derived data are marked as
/// outdated, and its previous pose becomes the new one, so that no pose in between is drawn.
void teleport(const Activity& activity, uint32_t body, const Position& position, float angle);

// traits.cpp

/// The traits of a body, to be edited; `free_default_traits` must be called afterwards.
BodyTraits& traits_of(ObjectState& objects, uint32_t body);
/// Frees the record of a body whose traits all have their default values.
void free_default_traits(ObjectState& objects, uint32_t body);
void set_name(ObjectState& objects, uint32_t body, std::string_view name);

// create_and_destroy.cpp

/// Body 0 belongs to the world: its shapes 0 to 3 are the four half-planes of the bounds.
void make_border(const Editing& editing);
void apply_bounds(const Editing& editing);
/// Reserves the memory that creating a body usually needs. Throws std::bad_alloc if there is none;
/// then nothing has changed.
void make_room_for_body(const Editing& editing);
/// The same for a shape; parts of outlines get theirs later.
void make_room_for_shape(const Editing& editing, const Geometry& geometry);
uint32_t create_body(const Editing& editing, const BodyDef& def);
void destroy_body(const Editing& editing, uint32_t body);
/// True for a disabled body that would move: it stores its velocity until it is enabled.
inline bool keeps_motion(const BodyRecord& body) {
    return body.flags.disabled && body.type != BodyType::static_body &&
           (body.type == BodyType::kinematic_body || body.mass < infinity);
}
/// Computes its mass and mobility at once. A disabled body keeps its velocity.
void set_body_enabled(const Editing& editing, uint32_t body, bool enabled);
uint32_t create_shape(const Editing& editing, const ShapeDef& def, const Geometry& geometry);
uint32_t new_shape(const Editing& editing);
void destroy_shape(const Editing& editing, uint32_t shape);
/// Gives a shape a geometry of any type; `hull`: the hull of a polygon's vertices.
void set_form(const Editing& editing, uint32_t shape, const Geometry& geometry,
              const std::vector<Vec2>& hull);
/// Reserves room for this number of vertices in the pool. If the position changes, the old vertices
/// are lost.
void reserve_vertices(ObjectState& objects, uint32_t shape, uint32_t count);
void attach_shape(const Editing& editing, uint32_t shape, uint32_t body);
void detach_shape(const Editing& editing, uint32_t shape);
void unlink_shape(ObjectState& objects, BroadPhaseState& broad_phase, uint32_t shape);

// parts.cpp: outlines of many pieces

/// Copies the points; the parts are created when they are needed.
void write_outline(ObjectState& objects, ActiveLists& active, uint32_t shape,
                   std::span<const Vec2> points);
void rebuild_parts(const Editing& editing, uint32_t shape);
/// Destroys the parts after `last`; none: all.
void drop_parts(const Editing& editing, uint32_t shape, uint32_t last);
/// Copies the surface of an outline to its parts, except for surfaces that segments have of their
/// own.
void copy_surface_to_parts(ObjectState& objects, uint32_t shape);

// joints.cpp, break_joints.cpp

/// Must be called with each edit of a joint: its bodies wake.
void edit_joint(const Activity& activity, uint32_t joint);
uint32_t create_joint(const Editing& editing, const JointRecord& record);
void destroy_joint(const Editing& editing, uint32_t joint);
/// 0: the world; if both are, the joint is dormant.
void set_joint_bodies(const Editing& editing, uint32_t joint, uint32_t a, uint32_t b);
void set_joint_enabled(const Editing& editing, uint32_t joint, bool enabled);
void set_joint_collide(const Editing& editing, uint32_t joint, bool collide);
void set_joint_broken(const Editing& editing, uint32_t joint, bool broken);
/// Breaks joints whose mean load over a step is too large. The load is an impulse times `rate`.
void break_joints(const Editing& editing, const JointScratch& scratch, float rate);

}  // namespace fettle::physics::detail
