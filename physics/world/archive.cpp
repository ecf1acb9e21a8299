#include <world/archive.h>
#include <world/world_data.h>

#include <algorithm>
#include <string>
#include <utility>

// Saving a world and restoring it in place. What a step makes anew (solver bodies, constraints,
// colors) is left out; everything else is copied as it is, the order of every list included, so
// that a restored world goes on bit for bit.

namespace fettle::physics {

namespace detail {
namespace {

constexpr uint32_t archive_magic = 0x77546546;  // "FeTw"
constexpr uint32_t archive_version = 11;
constexpr size_t world_data_size = 5864;  // without the lists of joints

/// Another layout of what is copied byte by byte is another format.
constexpr uint32_t layout() {
    uint32_t mixed = 0x811c9dc5u;
    const auto add = [&](size_t size) { mixed = (mixed ^ uint32_t(size)) * 0x01000193u; };
    for (const size_t size :
         {sizeof(BodyState), sizeof(Pose), sizeof(BodyRecord), sizeof(ShapeRecord),
          sizeof(ShapeForm), sizeof(ContactRecord), sizeof(ContactLinks), sizeof(Island),
          sizeof(JointRecord), sizeof(WorldDef), sizeof(StepStatistics), sizeof(ContactBeginEvent),
          sizeof(ContactPersistEvent), sizeof(ContactHitEvent)})
        add(size);
    [&]<class... Data>(const std::tuple<std::vector<Data>...>*) {
        (add(sizeof(Data)), ...);
    }(static_cast<const JointLists*>(nullptr));
    return mixed;
}

struct Header {
    uint32_t magic = archive_magic;
    uint32_t version = archive_version;
    uint32_t layout = detail::layout();
};

/// Every member that outlives a step, once. The capacity kept for the step (`solver_bodies` to
/// `fast_bodies`) is not state.
template <class Io, class World>
void world_members(Io& io, World& w) {
    io(w.settings);
    io(w.states), io(w.previous);
    io(w.body_generations), io(w.shape_generations), io(w.joint_generations);
    io(w.bodies), io(w.shapes), io(w.contacts), io(w.contact_links);
    io(w.joints), io(w.joint_lists), io(w.islands);
    io(w.fields), io(w.free_field), io(w.field_count);
    io(w.free_body), io(w.free_shape), io(w.free_contact), io(w.free_joint), io(w.free_island);
    io(w.body_count), io(w.shape_count), io(w.contact_count), io(w.joint_count), io(w.island_count);
    io(w.next_generation);
    io(w.forms), io(w.boxes), io(w.fat_boxes), io(w.paired_boxes), io(w.pool);
    io(w.fixed_tree), io(w.moving_tree), io(w.pairs);
    io(w.moved_shapes), io(w.awake_bodies), io(w.awake_contacts), io(w.awake_joints);
    io(w.edited_bodies), io(w.edited_shapes);
    io(w.strips), io(w.last_substep), io(w.steps), io(w.sleep_candidates);
    event_members(io, w.events), event_members(io, w.pending);
    io(w.statistics);
    // A reminder for who adds a member: it belongs into the list above, unless it is made anew in
    // every step: then it is a scratch member in memory.cpp. Either way the number here changes.
    constexpr size_t of_joints = sizeof(JointLists) + sizeof(JointConstraints);
    static_assert(sizeof(void*) != 8 || sizeof(WorldData) - of_joints == world_data_size);
}

}  // namespace
}  // namespace detail

using namespace detail;

void World::save(std::vector<std::byte>& out) const {
    const Header header;
    size_t needed = out.size();
    ArchiveSize size(needed);
    size(header);
    world_members(size, std::as_const(*data_));
    // And room for the contacts of all that still falls, for who saves into the same memory the
    // next time: what is reserved and not written to costs nothing.
    if (needed > out.capacity()) out.reserve(needed / 2 * 5);
    ArchiveWriter write(out);
    write(header);
    world_members(write, std::as_const(*data_));
}

void World::restore(std::span<const std::byte> bytes) {
    ArchiveReader read(bytes);
    Header header;
    read(header);
    if (header.magic != archive_magic)
        throw std::invalid_argument("these bytes are no saved world");
    if (header.version != archive_version || header.layout != layout())
        throw std::invalid_argument("the world was saved by another version of this library");
    WorldData fresh;
    world_members(read, fresh);
    if (!read.at_end()) throw std::invalid_argument("there is something behind the saved world");
    auto problem = fresh.links_problem();
    if (!problem) problem = fresh.memberships_problem();
    if (problem) throw std::invalid_argument("the saved world is damaged: " + *problem);
    data_->take(std::move(fresh));
}

void World::take(World&& other) {
    data_->take(std::move(*other.data_));
}

/// What was made since stays gone for good: its generation is not given again.
void WorldData::take(WorldData&& other) {
    const uint32_t issued = std::max(next_generation, other.next_generation);
    const int widest = most_lanes;
    ThreadPool* const own_threads = threads;
    other.callbacks = std::move(callbacks);
    *this = std::move(other);
    next_generation = issued;
    most_lanes = widest;
    threads = own_threads;
}

}  // namespace fettle::physics
