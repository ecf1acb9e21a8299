#include <saving/archive.h>
#include <saving/saved_world.h>
#include <saving/seal.h>
#include <world/world_data.h>

#include <algorithm>
#include <string>
#include <type_traits>
#include <utility>

// Saving a world and restoring it in place. The saved data are the members that `WorldState` lists.
// Scratch data of a step, and data that belong to the world but not to its state (callbacks,
// threads), do not change. The order of every list is saved, so that a restored world continues bit
// for bit.

namespace fettle::physics {

namespace detail {
namespace {

constexpr uint32_t archive_magic = 0x77546546;  // "FeTw"
constexpr uint32_t swapped_magic = 0x46655477;  // "wTeF"
constexpr uint32_t archive_version = 20;

/// Hash of the layout of the types that are copied byte by byte. A different layout is a different
/// format.
constexpr uint32_t layout() {
    uint32_t mixed = 0x811c9dc5u;
    const auto add = [&](size_t size) { mixed = (mixed ^ uint32_t(size)) * 0x01000193u; };
    for (const size_t size :
         {sizeof(BodyState), sizeof(Pose), sizeof(BodyRecord), sizeof(BodyTraits),
          sizeof(IgnoredPair), sizeof(SegmentRecord), sizeof(ShapeRecord), sizeof(ShapeForm),
          sizeof(ContactRecord), sizeof(ContactLinks), sizeof(ManifoldPose), sizeof(Island),
          sizeof(JointRecord), sizeof(WorldDef), sizeof(StepStatistics), sizeof(ContactBeginEvent),
          sizeof(ContactPersistEvent), sizeof(ContactHitEvent)})
        add(size);
    return mixed;
}

/// The order of the bytes of such a word is the byte order of the machine. Their first digits are
/// the precision of positions, on which the layout depends too.
constexpr uint32_t single_precision = 0x01020304, double_precision = 0x11121314;
constexpr uint32_t byte_order =
    std::is_same_v<WorldCoordinate, double> ? double_precision : single_precision;
constexpr uint32_t of_other_precision = single_precision ^ double_precision ^ byte_order;

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
    const WorldState& state = *data_;
    size(state);
    // Reserves room for later saves into the same memory, when there may be more contacts. Reserved
    // memory costs nothing until it is written.
    if (needed > out.capacity()) out.reserve(needed / 2 * 5);
    ArchiveWriter write(out);
    write(header);
    write(state);
    seal(std::span(out).subspan(begin));
}

namespace {

/// Checks the header, and returns a reader at the beginning of the world's members. Refuses bytes
/// that `save` did not write.
ArchiveReader unsealed(std::span<const std::byte> bytes) {
    SavedHeader header;
    ArchiveReader read(bytes);
    read(header);
    if (header.magic == swapped_magic)
        throw std::invalid_argument("the world was saved on a machine with the other byte order");
    if (header.magic != archive_magic)
        throw std::invalid_argument("the data are not a saved world");
    if (header.version == archive_version && header.byte_order == of_other_precision)
        throw std::invalid_argument(
            byte_order == single_precision
                ? "the world was saved with positions in double precision, and this library has "
                  "single precision (FETTLE_PHYSICS_DOUBLE)"
                : "the world was saved with positions in single precision, and this library has "
                  "double precision (FETTLE_PHYSICS_DOUBLE)");
    if (header.version != archive_version)
        throw std::invalid_argument(
            "the world was saved by another version of this library, in format " +
            std::to_string(header.version) + ": expected format " +
            std::to_string(archive_version));
    if (header.byte_order != byte_order || header.layout != layout())
        throw std::invalid_argument(
            "the world was saved by a build of this library for another machine or compiler, "
            "which lays its records out in another way");
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
    read(static_cast<WorldState&>(fresh));
    if (!read.at_end()) throw std::invalid_argument("there is something behind the saved world");
    auto problem = links_problem(fresh);
    if (!problem) problem = memberships_problem(fresh);
    if (!problem) problem = numbers_problem(fresh);
    if (problem) throw std::invalid_argument("the saved world is damaged: " + *problem);
    data.replace_state(std::move(fresh));
}

void World::take(World&& other) {
    if (this == &other) return;
    WorldData& data = populate(__func__);
    WorldData& given = other.populate(__func__);
    data.replace_state(std::move(given));
    WorldData empty;
    empty.self.link = &take_link();
    detail::make_border(empty.editing());
    given.replace_state(std::move(empty));
}

/// Keeps scratch data, callbacks and threads. The generations of the new state are never given
/// again.
void WorldData::replace_state(WorldState&& other) {
    part<WorldState>(*this) = std::move(other);
    for (const auto* list : {&body_generations, &shape_generations, &joint_generations})
        self.link->skip(*list);
    for (const FieldRecord& field : fields) self.link->skip({&field.generation, 1});
}

}  // namespace fettle::physics
