#include <world/archive.h>
#include <world/seal.h>
#include <world/world_data.h>

#include <algorithm>
#include <string>
#include <utility>

// Saving a world and restoring it in place. What a step makes anew (solver bodies, constraints,
// colors) is left out, and so is what belongs to the world but not to its state (callbacks,
// threads); everything else is copied as it is, the order of every list included, so that a
// restored world goes on bit for bit.

namespace fettle::physics {

namespace detail {
namespace {

constexpr uint32_t archive_magic = 0x77546546;  // "FeTw"
constexpr uint32_t archive_version = 11;
constexpr size_t world_data_size = 5720;  // without `self` and the lists of joints

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

constexpr uint32_t byte_order = 0x01020304;

/// Every member that outlives a step, once. What a step fills anew, and keeps for its capacity
/// only, is listed in memory.cpp instead.
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
    io(w.forms), io(w.boxes), io(w.fat_boxes), io(w.paired_boxes), io(w.pool);
    io(w.fixed_tree), io(w.moving_tree), io(w.pairs);
    io(w.moved_shapes), io(w.awake_bodies), io(w.awake_contacts), io(w.awake_joints);
    io(w.edited_bodies), io(w.edited_shapes);
    io(w.strips), io(w.last_substep), io(w.steps), io(w.sleep_candidates);
    event_members(io, w.events), event_members(io, w.pending);
    io(w.statistics);
    // A reminder for who adds a member: it belongs into the list above; unless it is made anew in
    // every step, then it is a scratch member in memory.cpp; or unless it is none of the state,
    // then `WorldData::take` below keeps it. Each time the number here changes.
    constexpr size_t others = sizeof(WorldSelf) + sizeof(JointLists) + sizeof(JointConstraints);
    static_assert(sizeof(void*) != 8 || sizeof(WorldData) - others == world_data_size);
}

}  // namespace
}  // namespace detail

using namespace detail;

void World::save(std::vector<std::byte>& out) const {
    data_->self.may_copy("World::save");
    const size_t begin = out.size();
    const SavedHeader header = {archive_magic, archive_version, layout(), byte_order, 0, 0};
    size_t needed = begin;
    ArchiveSize size(needed);
    size(header);
    world_members(size, std::as_const(*data_));
    // And room for the contacts of all that still falls, for who saves into the same memory the
    // next time: what is reserved and not written to costs nothing.
    if (needed > out.capacity()) out.reserve(needed / 2 * 5);
    ArchiveWriter write(out);
    write(header);
    world_members(write, std::as_const(*data_));
    seal(std::span(out).subspan(begin));
}

namespace {

/// Refuses everything but what `save` wrote, byte for byte; the members of the world are left.
ArchiveReader unsealed(std::span<const std::byte> bytes) {
    SavedHeader header;
    ArchiveReader read(bytes);
    read(header);
    if (header.magic != archive_magic)
        throw std::invalid_argument("these bytes are no saved world");
    if (header.version != archive_version || header.layout != layout() ||
        header.byte_order != byte_order)
        throw std::invalid_argument("the world was saved by another version of this library");
    if (header.size != bytes.size())
        throw std::invalid_argument("the saved world is damaged: it has " +
                                    std::to_string(bytes.size()) + " bytes and was saved with " +
                                    std::to_string(header.size));
    if (header.checksum != checksum(bytes.subspan(sizeof header)))
        throw std::invalid_argument("the saved world is damaged: its checksum is another");
    return read;
}

}  // namespace

void World::restore(std::span<const std::byte> bytes) {
    WorldData& data = populate(__func__);
    ArchiveReader read = unsealed(bytes);
    WorldData fresh;
    world_members(read, fresh);
    if (!read.at_end()) throw std::invalid_argument("there is something behind the saved world");
    auto problem = fresh.links_problem();
    if (!problem) problem = fresh.memberships_problem();
    if (!problem) problem = fresh.numbers_problem();
    if (problem) throw std::invalid_argument("the saved world is damaged: " + *problem);
    data.take(std::move(fresh));
}

void World::take(World&& other) {
    if (this == &other) return;
    WorldData& data = populate(__func__);
    WorldData& given = other.populate(__func__);
    data.take(std::move(given));
    WorldData empty;
    empty.self.link = &take_link();
    empty.make_border();
    given.take(std::move(empty));
}

/// What was made since stays gone for good: its generation is not given again.
void WorldData::take(WorldData&& other) {
    const int widest = most_lanes;
    ThreadPool* const own_threads = threads;
    *this = std::move(other);
    most_lanes = widest;
    threads = own_threads;
    skip_generations();
}

void WorldData::skip_generations() {
    self.link->skip(body_generations);
    self.link->skip(shape_generations);
    self.link->skip(joint_generations);
    for (const FieldRecord& field : fields) self.link->skip({&field.generation, 1});
}

}  // namespace fettle::physics
