#pragma once

#include <contacts/contact_list.h>
#include <contacts/filter.h>
#include <sleep/sleep.h>
#include <state/limits.h>
#include <state/place_shape.h>
#include <state/step_scratch.h>
#include <state/world_state.h>
#include <wide/kernels.h>
#include <world/world_self.h>

#include <array>
#include <span>
#include <string>
#include <tuple>
#include <vector>

namespace fettle::physics::detail {

/// A world: its state, what its step makes anew, and what it is besides. The member functions are
/// grouped by the file that defines them.
struct WorldData : WorldState, StepScratch {
    int most_lanes = lanes;  ///< tests compare instruction sets
    bool stepping = false;
    WorldSelf self;                 ///< of the world, not of its state
    ThreadPool* threads = nullptr;  ///< of `self`

    Events& event_sink() { return stepping ? events : pending; }
    /// One sequence for all slots: an identity never comes back.
    uint32_t new_generation() { return self.link->new_generation(); }
    void skip_generations();
    BodyId body_id(uint32_t slot) const { return detail::body_id(*this, slot); }
    ShapeId shape_id(uint32_t slot) const { return detail::shape_id(*this, *this, slot); }
    Solid solid(uint32_t shape) const { return solid_of(*this, *this, shape); }

    // slots.cpp: birth and death
    void make_border();
    void apply_bounds();
    uint32_t create_body(const BodyDef& def);
    void destroy_body(uint32_t body);
    uint32_t create_shape(const ShapeDef& def, const Geometry& geometry);
    void set_form(uint32_t shape, const Geometry& geometry, const std::vector<Vec2>& hull);
    uint32_t new_shape();
    void reserve_vertices(uint32_t shape, uint32_t count);
    void destroy_shape(uint32_t shape);
    void attach_shape(uint32_t shape, uint32_t body);
    void detach_shape(uint32_t shape);

    // parts.cpp: outlines of many pieces
    void write_outline(uint32_t shape, std::span<const Vec2> points);
    void rebuild_parts(uint32_t shape);
    void drop_parts(uint32_t shape, uint32_t last);
    void share_surface(uint32_t shape);
    void link_shape(uint32_t shape, uint32_t body);
    void unlink_shape(uint32_t shape);

    // joints.cpp: what links two bodies
    template <class Data>
    uint32_t create_joint(const JointRecord& record, const Data& data) {
        auto& list = std::get<std::vector<Data>>(joint_lists);
        list.push_back(data);
        const uint32_t slot = add_joint(record, joint_type<Data>, uint32_t(list.size() - 1));
        list.back().joint = slot;
        return slot;
    }
    uint32_t add_joint(const JointRecord& record, JointType type, uint32_t place);
    void destroy_joint(uint32_t joint);
    void link_joint(uint32_t joint, uint32_t side);
    void unlink_joint(uint32_t joint, uint32_t side);
    void set_joint_body(uint32_t joint, uint32_t side, uint32_t body);
    void set_joint_enabled(uint32_t joint, bool enabled);
    void set_joint_collide(uint32_t joint, bool collide);
    void set_joint_broken(uint32_t joint, bool broken);
    void break_joints(const JointStep& step);
    void refilter_joint(uint32_t joint);
    // edits.cpp: what an edit leaves to do, and doing it when somebody looks. `read_...` is for who
    // looks, before an edit too if it does; `refresh...` for what is part of an edit or a step.
    void read_all() {
        if (!edited_bodies.empty() || !edited_shapes.empty()) read_edited({});
    }
    void read_shape(uint32_t shape) {
        if (shapes[shape].geometry_dirty) read_edited({Refresh::Of::shape, shape});
    }
    void read_mass(uint32_t body) {
        if (bodies[body].mass_dirty) read_edited({Refresh::Of::body, body});
    }
    void read_edited(const Refresh& wanted);
    void refresh(const Refresh& wanted);
    void mark_geometry(uint32_t shape);
    void mark_mass(uint32_t body);
    void mark_placement(uint32_t body);
    void list_body(uint32_t body);
    void refresh();
    void refresh_shape(uint32_t shape);
    void refresh_mass(uint32_t body) {
        if (bodies[body].listed) refresh_edited_mass(body);  // else no edit of it or of its shapes
    }
    void refresh_edited_mass(uint32_t body);
    void refresh_placement(uint32_t body);
    void update_mobility(uint32_t body);
    void mark_moved(uint32_t shape);
    void list_moved(uint32_t shape);
    void set_proxy(uint32_t shape);
    void remove_proxy(uint32_t shape);
    void wake_for_edit(uint32_t body) {
        wake_body(activity(), body);
        if (bodies[body].mobility != Mobility::dynamic) wake_touching(activity(), body);
    }

    // callbacks.cpp
    bool callback_agrees(uint32_t shape_a, uint32_t shape_b) const;
    UserFilter user_filter() const;
    bool may_collide(uint32_t shape_a, uint32_t shape_b) const {
        return detail::may_collide(*this, user_filter(), shape_a, shape_b);
    }
    void consult_callbacks();
    void refilter(uint32_t shape);
    ContactList contact_list() { return {touching(), pairs, *this}; }
    Touching touching() {
        return {*this, *this, event_sink(), stepping ? &parted : nullptr, uint32_t(steps)};
    }
    Activity activity() { return {*this, *this, *this, event_sink()}; }

    // step.cpp
    void step(float dt);
    void begin_step();
    void end_step();
    // memory.cpp
    void trim();

    // archive.cpp, links.cpp, memberships.cpp, numbers.cpp: saved worlds
    void replace_state(WorldState&& other);
    std::optional<std::string> links_problem() const;
    std::optional<std::string> memberships_problem() const;
    std::optional<std::string> numbers_problem() const;

    // queries.cpp, shape_queries.cpp
    bool accepted(const QueryFilter& filter, uint32_t shape) const;
    bool shape_contains(uint32_t shape, V2 point) const;
    std::optional<std::string> validate() const;
};

}  // namespace fettle::physics::detail
