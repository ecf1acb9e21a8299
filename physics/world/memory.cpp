#include <world/archive.h>
#include <world/world_data.h>

#include <algorithm>
#include <type_traits>

// What a world has on the heap. Slots grow by a fifth (geometry/growth.h); what a step makes anew
// starts over when most of what was awake sleeps, so that a world at rest holds what it is and
// little more.

namespace fettle::physics {

namespace detail {
namespace {

template <class T, class Io>
concept ListsScratch = requires(Io& io, T& value) {
    std::remove_const_t<T>::scratch(io, value);
};

/// Sums up what the vectors hold that it is shown.
struct MemorySum {
    size_t used = 0, reserved = 0;

    template <class T>
    void operator()(const std::vector<T>& list) {
        used += list.size() * sizeof(T);
        reserved += list.capacity() * sizeof(T);
        if constexpr (ListsMembers<const T, MemorySum> || ListsScratch<const T, MemorySum>)
            for (const T& element : list) (*this)(element);
    }
    template <class T>
    void operator()(const std::vector<std::vector<T>>& lists) {
        used += lists.size() * sizeof(std::vector<T>);
        reserved += lists.capacity() * sizeof(std::vector<T>);
        for (const std::vector<T>& list : lists) (*this)(list);
    }
    template <class... T>
    void operator()(const std::tuple<T...>& lists) {
        each_of(*this, lists);
    }
    template <class T, std::size_t n>
    void operator()(const std::array<std::vector<T>, n>& lists) {
        each_of(*this, lists);
    }
    template <class T>
    void operator()(const T& value) {
        if constexpr (ListsMembers<const T, MemorySum>)
            T::members(*this, value);
        else if constexpr (ListsScratch<const T, MemorySum>)
            T::scratch(*this, value);
    }
};

/// Empties the vectors that it is shown.
struct MemoryRelease {
    template <class T>
    void operator()(std::vector<T>& list) {
        list = std::vector<T>();
    }
    template <class... T>
    void operator()(std::tuple<T...>& lists) {
        each_of(*this, lists);
    }
    template <class T>
    void operator()(T& value) {
        T::scratch(*this, value);
    }
};

/// Every vector whose elements do not outlive a step.
template <class Io, class World>
void scratch_members(Io& io, World& w) {
    io(w.relocated), io(w.new_pairs), io(w.spare_pairs), io(w.found_pairs), io(w.parts_of_walk);
    io(w.collided), io(w.finished), io(w.fast_bodies), io(w.gathered);
    io(w.solver_bodies), io(w.solver_ends), io(w.solver_forces), io(w.joint_share), io(w.locked);
    io(w.hubs);
    io(w.constraints), io(w.serial_contacts), io(w.extras), io(w.rolling_contacts);
    io(w.wide_blocks), io(w.acting), io(w.acting_pieces), io(w.colors_of_body);
    io(w.lane_contacts), io(w.spare_lanes), io(w.news), io(w.told), io(w.hits);
    io(w.blocks), io(w.color_begin), io(w.first_groups), io(w.out_of_colors), io(w.serial_acting);
    io(w.joint_notes), io(w.serial_notes), io(w.bounced), io(w.joint_plans);
    io(w.joint_constraints), io(w.strains), io(w.parted), io(w.reordering);
}

template <class... Part>
MemoryShare share_of(const char* purpose, const Part&... parts) {
    MemorySum sum;
    (sum(parts), ...);
    return {purpose, sum.used, sum.reserved};
}

}  // namespace

/// Where three quarters of the bodies that a step once solved sleep now, or so many shapes were
/// made or moved by edits.
void WorldData::trim() {
    const size_t once = std::max(solver_bodies.capacity(), moved_shapes.capacity());
    if ((awake_bodies.size() + 1) * 4 > once) return;
    MemoryRelease release;
    scratch_members(release, *this);
    event_members(release, pending);
    Tree::scratch(release, moving_tree);
    Tree::scratch(release, fixed_tree);
    for (std::vector<uint32_t>* list :
         {&moved_shapes, &awake_bodies, &awake_contacts, &edited_bodies, &edited_shapes})
        list->shrink_to_fit();
    for (auto& list : awake_joints) list.shrink_to_fit();
}

}  // namespace detail

using namespace detail;

std::vector<MemoryShare> World::memory() const {
    const WorldData& w = *data_;
    MemorySum events, step;
    for (const Events* each : {&w.events, &w.pending}) event_members(events, *each);
    scratch_members(step, w);
    Tree::scratch(step, w.moving_tree);
    Tree::scratch(step, w.fixed_tree);
    std::vector<MemoryShare> shares = {
        share_of("bodies", w.bodies, w.states, w.previous, w.body_generations, w.islands),
        share_of("shapes", w.shapes, w.forms, w.shape_generations),
        share_of("bounding boxes", w.boxes, w.fat_boxes, w.paired_boxes),
        share_of("vertices", w.pool),
        share_of("trees", w.fixed_tree, w.moving_tree),
        share_of("contacts", w.contacts, w.contact_links),
        share_of("pairs", w.pairs),
        share_of("joints", w.joints, w.joint_lists, w.joint_generations),
        share_of("fields", w.fields),
        share_of("lists", w.moved_shapes, w.awake_bodies, w.awake_contacts, w.awake_joints,
                 w.edited_bodies, w.edited_shapes),
        {"events", events.used, events.reserved},
        {"step", step.used, step.reserved},
    };
    return shares;
}

}  // namespace fettle::physics
