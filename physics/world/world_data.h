#pragma once

#include <partition/blocks.h>
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

/// Gap up to which contacts are made before shapes meet, m.
inline constexpr float speculative_margin = 0.02f;
/// Shapes this close count as touching, m.
inline constexpr float touch_distance = 0.005f;
/// Coordinates and speeds beyond these are cut off: far from where a float resolves a millimetre,
/// near enough that no square of them overflows.
inline constexpr float greatest_coordinate = 1e8f;
inline constexpr float greatest_speed = 1e4f;
/// Friction, and lever of rolling resistance (m), of a contact.
inline constexpr float greatest_grip = 1e6f;
/// Turning in one sub-step, rad.
inline constexpr float greatest_turn = 3.0f;

/// What is awake is in no order in memory: so many before its turn each is asked for.
inline constexpr size_t contacts_ahead = 12, bodies_ahead = 6;

inline constexpr int color_count = 64;

/// The border is solid where normal·p <= depth.
struct BorderPlane {
    V2 normal;
    float depth = 0.0f;
};

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
    BodyId body_id(uint32_t slot) const { return {slot, body_generations[slot]}; }
    /// The shape that stands for a slot outside: a part is its owner.
    uint32_t named_shape(uint32_t slot) const {
        return shapes[slot].owner == none ? slot : shapes[slot].owner;
    }
    ShapeId shape_id(uint32_t slot) const {
        const uint32_t named = named_shape(slot);
        return {named, shape_generations[named]};
    }
    /// Collides itself; an outline only in its parts.
    bool is_solid(uint32_t shape) const { return forms[shape].kind != FormKind::outline; }
    Convex convex(uint32_t shape) const {
        const ShapeForm& form = forms[shape];
        return {&pool.vertices[form.begin], &pool.directions[form.begin], &pool.offsets[form.begin],
                int(form.count), form.radius};
    }

    Solid solid(uint32_t shape) const {
        const ShapeForm& form = forms[shape];
        Solid made = {convex(shape), form.kind};
        if (form.kind == FormKind::convex || form.kind == FormKind::ellipse) return made;
        made.limits = &pool.local[form.begin] + form.count;
        made.normals = &pool.normals[form.begin];
        if (form.body != none) made.rotation = {states[form.body].cosine, states[form.body].sine};
        return made;
    }

    // slots.cpp: birth and death
    void make_border();
    void apply_bounds();
    BorderPlane border_plane(uint32_t side) const;
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
    std::span<const V2> outline_of(uint32_t shape) const {
        return {&pool.local[forms[shape].begin], shapes[shape].outline};
    }
    /// Itself, or the parts it consists of.
    template <typename Visit>
    void for_each_solid(uint32_t shape, Visit&& visit) const {
        if (is_solid(shape)) {
            visit(shape);
            return;
        }
        for (uint32_t part = shapes[shape].first_part; part != none;) {
            const uint32_t next = shapes[part].next_part;
            visit(part);
            part = next;
        }
    }

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
    void list_joint(uint32_t joint);
    void forget_impulses(uint32_t joint);
    void wake_joint(uint32_t joint);
    void wake_jointed();
    bool keeps_apart(uint32_t joint) const;
    bool joint_forbids_contact(uint32_t body_a, uint32_t body_b) const;
    void refilter_joint(uint32_t joint);
    enum class Role { idle, asleep, acting };
    Role role_of(const JointRecord& joint) const;
    template <typename Visit>
    void for_each_joint(uint32_t body, Visit&& visit) const {
        for (uint32_t edge = bodies[body].first_joint; edge != none;) {
            const uint32_t next = joints[edge >> 1].edges[edge & 1].next;
            visit(edge >> 1, edge & 1);
            edge = next;
        }
    }

    // ../solver/joint_passes.cpp
    JointEnds joint_ends(const JointRecord& joint) const;
    JointFrame joint_frame(const JointRecord& joint) const;
    template <class Constraint>
    void list_acting_joints(JointPlan& plan);
    template <class Constraint>
    bool prepare_list(const JointStep& step, std::vector<Constraint>& made);
    JointStep prepare_joints(float h);
    size_t acting_joints() const;
    template <bool backwards = false, typename Visit>
    void for_each_joint_of(const StripNodes& nodes, Visit&& visit);
    void warm_start_joints(const StripNodes& nodes);
    void solve_joints(const JointStep& step, const StripNodes& nodes);
    void relax_joints(const JointStep& step, const StripNodes& nodes);
    void find_jointed();
    void strain_joints();
    void store_joints(const JointStep& step);
    void break_joints(const JointStep& step);

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
    void place_shape(uint32_t shape, Rotation q);
    void place_large(uint32_t shape, Rotation q);
    void update_mobility(uint32_t body);
    void mark_moved(uint32_t shape);
    void list_moved(uint32_t shape);
    void set_proxy(uint32_t shape);
    void remove_proxy(uint32_t shape);
    float fat_margin(uint32_t shape) const;
    void wake_for_edit(uint32_t body) {
        wake_body(body);
        if (bodies[body].mobility != Mobility::dynamic) wake_touching(body);
    }

    // pairs.cpp
    void find_pairs();
    void look_at_pair(uint32_t shape, uint32_t other, std::vector<uint64_t>& found) const;
    template <typename Look>
    void look_in_pieces(size_t count, Look&& look);
    void look_around_moved();
    void walk_trees();
    void look_at_border();
    void order_pairs();
    void prefetch_pair(uint64_t pair) const;
    void create_contacts();
    void mark_paired(std::span<const uint32_t> moved);
    // contacts.cpp: pairs and manifolds
    bool filters_agree(uint32_t shape_a, uint32_t shape_b) const;
    bool may_collide(uint32_t shape_a, uint32_t shape_b) const;
    bool callback_agrees(uint32_t shape_a, uint32_t shape_b) const;
    void create_contact(uint32_t shape_a, uint32_t shape_b);
    void destroy_contact(uint32_t contact);
    void destroy_contacts_of_shape(uint32_t shape);  ///< and of its parts
    void destroy_contacts_of_body(uint32_t body);
    void refilter(uint32_t shape);
    void remix(ContactRecord& contact) const;
    void remix_shape(uint32_t shape);
    void narrow_phase();
    template <typename Work>
    size_t collide_awake(std::span<const uint32_t> slots, size_t first, uint32_t others, Work&&);
    size_t collide_and_create();
    void end_pairs();
    void consult_callbacks();
    void tell_persisting();
    V2 middle_of(const ContactRecord& contact) const;
    void update_manifold(ContactRecord& contact);
    void follow_note(ContactRecord& contact, uint32_t slot);
    /// `held`: they were in contact before.
    void collide_unusual(const ContactRecord& contact, float margin, bool held,
                         Manifold& manifold) const;
    float approach_speed(const ContactRecord& contact, V2 point) const;
    float impact_mass(const ContactRecord& contact, V2 point) const;
    // hits.cpp
    std::optional<ContactHitEvent> hit_of(uint32_t contact, const ContactExtra* extra) const;
    void tell_hits();
    // touching.cpp
    void set_touching(uint32_t contact, bool touching);
    void tell_touching(const ContactRecord& contact, bool touching);
    void tell_parted();
    bool of_outline(const ContactRecord& contact) const;
    bool same_pair(const ContactRecord& c, const ContactRecord& d) const;
    bool touch_elsewhere(uint32_t contact) const;
    bool tells_for_pair(uint32_t contact) const;
    Contact view(const ContactRecord& contact) const;
    template <typename Visit>
    void for_each_contact(uint32_t body, Visit&& visit) const {
        any_contact(bodies[body].first_contact, none, [&](uint32_t contact) {
            visit(contact);
            return false;
        });
    }
    /// Whether `visit` is true of a contact in a body's list, from an edge on and before the
    /// contact `end` (none: to the end of the list).
    template <typename Visit>
    bool any_contact(uint32_t edge, uint32_t end, Visit&& visit) const {
        while (edge != none && edge >> 1 != end) {
            const uint32_t next = contact_links[edge >> 1].edges[edge & 1].next;
            if (visit(edge >> 1)) return true;
            edge = next;
        }
        return false;
    }
    /// Those of the shape and of its parts.
    template <typename Visit>
    void for_each_contact_of(uint32_t shape, Visit&& visit) const {
        if (forms[shape].body == none) return;
        const auto is_its = [&](uint32_t s) { return s == shape || shapes[s].owner == shape; };
        for_each_contact(forms[shape].body, [&](uint32_t contact) {
            const ContactRecord& c = contacts[contact];
            if (is_its(c.shape_a) || is_its(c.shape_b)) visit(contact);
        });
    }
    uint32_t other_body(uint32_t contact, uint32_t body) const {
        const ContactRecord& c = contacts[contact];
        return c.body_a == body ? c.body_b : c.body_a;
    }

    // islands.cpp: sleeping and waking
    void wake_body(uint32_t body) {
        if (bodies[body].asleep())
            wake_sleeping(body);
        else
            bodies[body].sleep_time = 0.0f;
    }
    void wake_sleeping(uint32_t body);  ///< with its island
    void wake_touching(uint32_t body);
    void wake_all();
    void put_to_sleep(std::span<const uint32_t> group);
    void compact_awake();
    void put_group_to_sleep(uint32_t body);
    void sleep_resting_islands();
    void add_awake(uint32_t body);
    void remove_awake(uint32_t body);
    void add_awake_contact(uint32_t contact);
    void remove_awake_contact(uint32_t contact);
    void leave_island(uint32_t body);
    void free_island_slot(uint32_t island);
    bool in_motion(uint32_t body) const;

    // step.cpp
    void step(float dt);
    void solve(float dt);
    void apply_forces(float h);
    void gather_bodies(float h);
    uint8_t gather_body(size_t place, float h);
    // finish.cpp
    void finish_bodies(float dt);
    void finish_body(size_t place, float dt, FinishedPiece& piece);
    void finish_shapes(uint32_t body, Rotation q, FinishedPiece& piece);
    void follow_placed();
    // continuous.cpp
    void stop_fast_bodies();
    void stop_or_list(const FastBody& fast, FinishedPiece& piece);
    void stop_body(const FastBody& fast, FinishedPiece& piece);
    bool is_disabled(uint32_t shape, uint32_t other) const;
    float limit_motion(const FastBody& fast) const;
    float sweep_shape(const FastBody& fast, uint32_t shape, uint32_t obstacle, V2 centroid,
                      float core) const;
    // strips.cpp
    void cut_into_strips();
    void order_lists();
    // hubs.cpp
    void find_hubs(size_t begin, size_t end);
    bool is_hub(uint32_t body) const;
    float inverse_mass_at_rim(uint32_t body) const;
    // ../solver/soft_step.cpp
    struct BlockStep;
    struct FirstBlock;
    using WidePass = void (*)(const WideStep&);
    void solve_softly(const JointStep& joint_step, const ContactStiffness& stiffness);
    bool repeats_pushes(const SolverBlock& block);
    void solve_first_block(const BlockStep& step, const JointStep& joint_step);
    void solve_block(const SolverBlock& block, WideBlock& wide, const BlockStep& step);
    const Sections& sections_of(const SolverBlock& block) const {
        return block.cut ? cut_sections : whole_sections;
    }
    ThreadPool* helpers_of(const SolverBlock& block) const { return block.cut ? threads : nullptr; }
    template <typename Work>
    auto section_loop(const SolverBlock& block, Work work);
    void pass(WidePass kernel, uint32_t section, WideBlock& wide, const BlockStep& step);
    void prepare_block(const SolverBlock& block, WideBlock& wide, const BlockStep& step);
    void store_section(uint32_t section, WideBlock& wide, const BlockStep& step);
    auto begin_loop(const SolverBlock& block, const BlockStep& step, bool again);
    auto move_loop(const SolverBlock& block, const BlockStep& step);
    // ../solver
    void solve_sequentially(const JointStep& joint_step);
    void solve_directly(const JointStep& joint_step);
    void keep_pushed_awake(float dt);
    void follow_curved_contacts();
    bool on_locked_axis(const ContactRecord& contact) const;
    void find_acting(float dt);
    void color_contacts();
    void update_blocks();
    void make_blocks(bool several);
    void make_sections();
    size_t section_of(const ActingContact& contact) const;
    void color_nodes(const StripNodes& nodes, std::vector<uint32_t>& left_over);
    template <typename Visit>
    void for_each_acting_of(const StripNodes& nodes, Visit&& visit);
    uint32_t entry_of(const ActingContact& contact, uint32_t color) const;
    // ../solver/serial_contacts.cpp
    void list_serial();
    void prepare_serial(float dt, float ratio, const ContactStiffness& stiffness);
    void give_extras();
    void prepare_extra_of(size_t serial, float ratio);
    void store_serial();
    uint8_t store_constraint(const ContactConstraint& constraint);
    Corner corner_of(const ContactRecord& contact) const;
    void count_places();
    void place_lanes();
    void fill_group(size_t group, WideContact& wide, ContactLanes& from);
    void note_news(size_t group, const ContactLanes& of);
    void tell_of_groups();
    bool passes_corner(const ContactRecord& contact, float dt) const;
    void prepare_contacts(float dt, float h, const ContactStiffness& stiffness);
    void store_contacts();
    void zero_locked();

    template <typename Visit>
    void for_each_asleep(uint32_t island, Visit&& visit) const {
        for (uint32_t body = islands[island].first; body != none;) {
            const uint32_t next = bodies[body].next;
            visit(body);
            body = next;
        }
    }

    // memory.cpp
    void trim();

    // archive.cpp, links.cpp, memberships.cpp, numbers.cpp: saved worlds
    void replace_state(WorldState&& other);
    std::optional<std::string> links_problem() const;
    std::optional<std::string> memberships_problem() const;
    std::optional<std::string> numbers_problem() const;

    // fields.cpp
    void apply_fields(float h, float dt);
    // queries.cpp, shape_queries.cpp
    bool accepted(const QueryFilter& filter, uint32_t shape) const;
    bool shape_contains(uint32_t shape, V2 point) const;
    std::optional<std::string> validate() const;
};

}  // namespace fettle::physics::detail
