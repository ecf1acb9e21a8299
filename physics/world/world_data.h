#pragma once

#include <edits/edits.h>
#include <state/limits.h>
#include <state/step_scratch.h>
#include <wide/kernels.h>
#include <world/world_self.h>

#include <array>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace fettle::physics::detail {

struct JointStep;
struct SubSteps;

struct WorldData;

/// A world as an argument: it converts to the part of the world that a parameter needs.
struct Parts {
    WorldData& data;
    operator Editing() const;
    operator Activity() const;
    operator ContactList() const;
    template <class Part>
    requires std::is_base_of_v<std::remove_const_t<Part>, WorldData>
    operator Part&() const;
};

/// A world: its state, the scratch data of its step, and its other data. Member functions are
/// grouped by the file that defines them.
struct WorldData : WorldState, StepScratch {
    int most_width = group_size;  ///< limited by tests that compare instruction sets
    bool stepping = false;
    WorldSelf self;                 ///< callbacks, owner, threads: not part of the state
    ThreadPool* threads = nullptr;  ///< of `self`

    // Its parts, by name. A stage of the step takes those that it uses.
    ObjectState& objects() { return *this; }
    Columns& columns() { return *this; }
    BroadPhaseState& broad_phase() { return *this; }
    ActiveLists& active() { return *this; }
    PairScratch& pair_scratch() { return *this; }
    BodyScratch& body_scratch() { return *this; }
    JointScratch& joint_scratch() { return *this; }
    ContactScratch& contact_scratch() { return *this; }
    ScheduleScratch& schedule() { return *this; }

    Events& event_sink() { return stepping ? events : pending; }
    BodyId body_id(uint32_t slot) const { return detail::body_id(*this, slot); }
    ShapeId shape_id(uint32_t slot) const { return detail::shape_id(*this, *this, slot); }
    Solid solid(uint32_t shape) const { return solid_of(*this, *this, shape); }

    // callbacks.cpp: `read_...` is called before a value is read that edits may have left out of
    // date, and before an edit that reads it. It calls the refresh callback of the user first.
    void read_all() {
        self.may_read();
        if (!edited_bodies.empty() || !edited_shapes.empty()) read_edited({});
    }
    void read_shape(uint32_t shape) {
        if (shapes[shape].geometry_dirty) read_edited({Refresh::Of::shape, shape});
    }
    void read_mass(uint32_t body) {
        if (bodies[body].flags.mass_dirty) read_edited({Refresh::Of::body, body});
    }
    void read_edited(const Refresh& wanted);
    void refresh(const Refresh& wanted);

    bool callback_agrees(uint32_t shape_a, uint32_t shape_b) const;
    UserFilter user_filter() const;
    UserDecision user_decision();
    bool callbacks_let_act(uint32_t contact);
    bool may_collide(uint32_t shape_a, uint32_t shape_b) const {
        return detail::may_collide(*this, user_filter(), shape_a, shape_b);
    }
    void call_contact_callbacks();
    /// A step finds the pairs of all shapes again.
    void search_all_pairs();
    /// A copy has no filter, but its state has not the pairs that the filter refused.
    bool lacks_refused_pairs() const { return filtered && !self.filter; }
    /// The contacts of movers that `call_contact_callbacks` has skipped act again. To be called
    /// when a step is over.
    void end_moves();

    // damage.cpp
    /// Makes an edit by `act`, a function of edits.h or sleep.h: it gets the parts of the world
    /// that it needs, then `given`. If memory runs out in the middle of it, the world is damaged.
    template <auto act, class... Given>
    auto change(Given&&... given) {
        try {
            return [&]<size_t... i>(std::index_sequence<i...>) {
                return act(((void)i, Parts{*this})..., std::forward<Given>(given)...);
            }
            (std::make_index_sequence<parameters(act) - sizeof...(Given)>());
        } catch (...) {
            mark_damaged_and_rethrow();
        }
    }
    template <class Result, class... Parameters>
    static constexpr size_t parameters(Result (*)(Parameters...)) {
        return sizeof...(Parameters);
    }
    /// To be called in a handler: the data may be inconsistent, so no object exists any more, and
    /// all functions that use the world throw `Damaged` until another state replaces it. Throws the
    /// exception again.
    [[noreturn]] void mark_damaged_and_rethrow();

    ContactList contact_list() { return {touching(), pairs, *this}; }
    Touching touching() {
        return {*this,           *this,
                event_sink(),    stepping ? &parted : nullptr,
                uint32_t(steps), settings.restitution_threshold,
                solver_forces,   last_substep,
                last_length};
    }
    Editing editing() {
        return {*this,    *this,          *this,      *this,
                settings, contact_list(), activity(), self.link->generations};
    }
    Activity activity() { return {*this, *this, *this, event_sink()}; }

    // contact_data.cpp
    void clear_ended_contacts();
    void mark_ended_contacts();

    // body_functions.cpp
    void call_velocity_functions(float dt, int substeps);
    /// To be called when a step is over.
    void call_position_functions(float dt);

    // step_order.cpp
    void step(float dt);
    void begin_step();
    void apply_mover_weights();
    /// The data of bodies that the solver reads.
    void gather_objects(const SubSteps& sub, float dt);
    JointStep prepare_constraints(const SubSteps& sub, float dt);
    void solve_constraints(const SubSteps& sub, const JointStep& joint_step,
                           const WideKernels& kernels);
    void store_results(const SubSteps& sub, const JointStep& joint_step, float dt);
    void end_step();
    /// False: the solver solves all constraints one after the other.
    bool solves_in_groups() const { return settings.solver == Solver::soft_step; }
    void notify_step_begin(float dt);
    void notify_step_end();
    // memory.cpp
    void trim();

    // archive.cpp
    void replace_state(WorldState&& other);
};

inline Parts::operator Editing() const {
    return data.editing();
}
inline Parts::operator Activity() const {
    return data.activity();
}
inline Parts::operator ContactList() const {
    return data.contact_list();
}
template <class Part>
requires std::is_base_of_v<std::remove_const_t<Part>, WorldData> Parts::operator Part&() const {
    return data;
}

/// hash.cpp: hash of the poses and velocities of all bodies.
uint64_t hash_of(const Columns& columns);

/// callbacks.cpp: mixes the surfaces of all contacts, as if no callback had changed them.
void remix_all(WorldData& data);

}  // namespace fettle::physics::detail
