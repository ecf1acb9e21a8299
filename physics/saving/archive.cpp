#include <saving/archive.h>
#include <saving/checksum.h>
#include <saving/saved_world.h>
#include <world/world_data.h>

#include <optional>
#include <string>
#include <utility>

// Saving a world and restoring it in place. The saved data are the members that `WorldState` lists.
// Scratch data of a step, and data that belong to the world but not to its state (callbacks,
// threads), do not change. The order of every list is saved, so that a restored world continues bit
// for bit.

namespace fettle::physics {

namespace detail {
namespace {

constexpr uint32_t archive_magic = 0x77546546;  // "FeTw"
constexpr uint32_t archive_version = 26;
constexpr uint32_t coordinate_size = sizeof(WorldCoordinate);

/// The format of the members of a world; also distinguishes formats for which `archive_version`
/// was forgotten.
uint32_t format_of_members() {
    static const uint32_t hash = [] {
        ArchiveFormat format;
        format(WorldState());
        return format.hash();
    }();
    return hash;
}

}  // namespace
}  // namespace detail

using namespace detail;

void World::save(std::vector<std::byte>& out) const {
    data_->self.may_copy("World::save");
    const size_t begin = out.size();
    const SavedHeader header = {
        archive_magic, archive_version, format_of_members(), coordinate_size, 0, 0};
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
    write_checksum(std::span(out).subspan(begin));
}

namespace {

/// Checks the header, and returns a reader at the beginning of the world's members. Refuses bytes
/// that `save` did not write.
ArchiveReader unsealed(std::span<const std::byte> bytes) {
    SavedHeader header = {};
    if (bytes.size() < sizeof header)
        throw std::invalid_argument("the data are not a saved world: they have only " +
                                    std::to_string(bytes.size()) + " bytes");
    ArchiveReader read(bytes);
    read(header);
    if (header.magic != archive_magic)
        throw std::invalid_argument("the data are not a saved world");
    if (header.version != archive_version)
        throw std::invalid_argument(
            "the world was saved by another version of this library, in format " +
            std::to_string(header.version) + ": expected format " +
            std::to_string(archive_version));
    if (header.coordinate + coordinate_size == sizeof(float) + sizeof(double))
        throw std::invalid_argument(other_precision("the world was saved"));
    if (header.coordinate != coordinate_size || header.records != format_of_members())
        throw std::invalid_argument(
            "the world was saved by another version of this library, whose records have other "
            "fields");
    if (header.size != bytes.size())
        throw std::invalid_argument("the saved world is damaged: it has " +
                                    std::to_string(bytes.size()) + " bytes and was saved with " +
                                    std::to_string(header.size));
    if (header.checksum != checksum(bytes.subspan(sizeof header)))
        throw std::invalid_argument("the saved world is damaged: its checksum differs");
    return read;
}

}  // namespace

void World::restore(std::span<const std::byte> bytes) {
    data_->self.may_replace("World", __func__);
    WorldData& data = *data_;
    ArchiveReader read = unsealed(bytes);
    WorldData fresh;
    std::optional<std::string> problem;
    try {
        read(static_cast<WorldState&>(fresh));
    } catch (const std::invalid_argument& unreadable) {
        problem = unreadable.what();
    }
    if (!problem && !read.at_end()) problem = "there are bytes after its end";
    if (!problem) problem = links_problem(fresh);
    if (!problem) problem = memberships_problem(fresh);
    if (!problem) problem = numbers_problem(fresh);
    if (problem) throw std::invalid_argument("the saved world is damaged: " + *problem);
    data.replace_state(std::move(fresh));
}

void World::take(World&& other) {
    if (this == &other) return;
    data_->self.may_replace("World", __func__);
    WorldData& data = *data_;
    WorldData& given = other.populate(__func__);
    // If memory runs out here, neither world has changed.
    WorldData empty;
    empty.self.link = &acquire_link();
    detail::make_border(empty.editing());
    WorldState taken(std::move(static_cast<WorldState&>(given)));
    given.replace_state(std::move(empty));
    data.replace_state(std::move(taken));
}

/// Keeps scratch data, callbacks and threads. The generations of the new state are never used
/// again.
void WorldData::replace_state(WorldState&& other) {
    part<WorldState>(*this) = std::move(other);
    self.clear_damage();
    for (const auto* list : {&body_generations, &shape_generations, &joint_generations})
        self.link->skip(*list);
    for (const FieldRecord& field : fields) self.link->skip({&field.generation, 1});
}

}  // namespace fettle::physics
