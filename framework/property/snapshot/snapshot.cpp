// Snapshots of a tree: one block for the tree and one for each of its parts.

#include <fettle/property/snapshot.h>

#include <algorithm>
#include <array>
#include <exception>
#include <utility>

#include <fettle/property/error.h>
#include <fettle/property/question.h>
#include <fettle/property/restoring.h>

#include <tree/state.h>

#include "prepared_parts.h"
#include "transition.h"
#include "tree_image.h"

namespace fettle::property {
namespace {

constexpr std::array<char, 8> magic = {'F', 'e', 't', 't', 'l', 'e', 's', '1'};
constexpr std::uint64_t version = 4;
constexpr std::uint64_t oldest_version = 3;  // the version without makers of rows (see TreeImage)

/// Header of a file. The state follows, and then a checksum of all bytes before it
/// (docs/design/time.md).
struct FileHeader {
    std::array<char, 8> magic = property::magic;
    std::uint64_t version = property::version;
    std::uint64_t size = 0;  // size of the state in bytes
};
using FileChecksum = std::uint64_t;

[[noreturn]] void refuse(const std::string& why) {
    throw Error(ErrorKind::damaged, "the snapshot cannot be read: " + why);
}

const Memory* find(const Snapshot::Memories& memories, std::string_view name) {
    for (const auto& [of, memory] : memories)
        if (of == name) return &memory;
    return nullptr;
}

constexpr std::string_view tree_block = "tree";

}  // namespace

Snapshot::Snapshot(std::vector<std::byte> payload, Memories memories, std::size_t held)
    : data_(std::make_shared<Data>(Data{std::move(payload), std::move(memories), held})) {}

std::span<const std::byte> Snapshot::payload() const {
    if (data_ == nullptr) return {};
    return data_->payload;
}

const Snapshot::Memories& Snapshot::memories() const {
    static const Memories none;
    return data_ == nullptr ? none : data_->memories;
}

std::vector<std::byte> Snapshot::release_payload() && {
    if (data_ == nullptr) return {};
    const std::shared_ptr<Data> data = std::exchange(data_, nullptr);
    if (data.use_count() > 1) return data->payload;
    return std::move(data->payload);
}

std::uint64_t Snapshot::step() const {
    return ByteReader(payload()).get<std::uint64_t>();
}

std::vector<std::byte> Snapshot::to_bytes() const {
    if (data_ == nullptr) throw Error(ErrorKind::damaged, "the snapshot is empty");
    const FileHeader header{.size = data_->payload.size()};
    std::vector<std::byte> out;
    out.reserve(sizeof header + data_->payload.size() + sizeof(FileChecksum));
    ByteWriter to(out);
    to.put(header);
    to.raw(data_->payload.data(), data_->payload.size());
    to.put(FileChecksum{checksum(out)});
    return out;
}

Snapshot Snapshot::from_bytes(std::span<const std::byte> bytes) {
    FileHeader header;
    if (bytes.size() < sizeof header) refuse("it ends too early");
    std::memcpy(&header, bytes.data(), sizeof header);
    if (header.magic != magic) refuse("it is not a snapshot");
    if (header.version < oldest_version || header.version > version)
        refuse("it is of format " + std::to_string(header.version) + ", and this Fettle reads " +
               std::to_string(oldest_version) + " to " + std::to_string(version));
    const std::size_t rest = bytes.size() - sizeof header;
    if (rest < sizeof(FileChecksum) || rest - sizeof(FileChecksum) < header.size)
        refuse("it ends too early");
    if (rest - sizeof(FileChecksum) > header.size) refuse("there are bytes after its end");
    const auto checked = bytes.first(bytes.size() - sizeof(FileChecksum));
    FileChecksum written = 0;
    std::memcpy(&written, checked.data() + checked.size(), sizeof written);
    if (checksum(checked) != written) refuse("it is damaged: its checksum differs");
    const auto payload = checked.subspan(sizeof header);
    return {std::vector<std::byte>(payload.begin(), payload.end()), {}};
}

// --- Of a tree

void Tree::add_part(SnapshotPart& part) {
    state_->lifetime.require_going_on("get a part");
    state_->require_changeable("add a part of snapshots");
    for (const SnapshotPart* other : state_->snapshots.parts)
        if (other->part_name() == part.part_name() || part.part_name() == tree_block)
            throw Error(ErrorKind::bad_name, "a part of snapshots is called \"" +
                                                 std::string(part.part_name()) + "\" already");
    state_->snapshots.parts.push_back(&part);
    state_->snapshots.numbers.push_back(++state_->snapshots.last_number);
}

void Tree::remove_part(SnapshotPart& part) {
    SnapshotState& s = state_->snapshots;
    const auto found = std::find(s.parts.begin(), s.parts.end(), &part);
    if (found == s.parts.end()) return;
    s.numbers.erase(s.numbers.begin() + (found - s.parts.begin()));
    s.parts.erase(found);
    for (PreparedParts* prepared : s.prepared) prepared->forget(&part);
}

const std::vector<SnapshotPart*>& Tree::parts() const {
    return state_->snapshots.parts;
}

void Tree::refreshing(SnapshotPart& part, std::uint64_t what) {
    state_->changes.notify([&](Observer& o) { o.refreshing(part, what); });
}

Snapshot Tree::snapshot() const {
    return snapshot({});
}

Snapshot Tree::snapshot(std::vector<std::byte> room) const {
    state_->underway.require_all_rows("take a snapshot");
    const Inquiry inquiry(state_->tree, "a snapshot",
                          "is being taken: the functions that it calls cannot");
    std::vector<std::byte> payload = std::move(room);
    payload.clear();
    payload.reserve(state_->snapshots.size + state_->snapshots.size / 8);
    Snapshot::Memories memories;
    std::size_t held = 0;
    ByteWriter to(payload);
    to.put(state_->changes.author.step);
    to.put(std::uint64_t{state_->snapshots.parts.size() + 1});
    const auto block = [&](std::string_view name, const auto& save) {
        to.put(name);
        const std::size_t begin = to.begin_block();
        memories.emplace_back(name, save());
        to.end_block(begin);
    };
    block(tree_block, [&] {
        std::shared_ptr<const TreeMemory> memory = TreeImage::save(*state_, to);
        held += memory->bytes();
        return memory;
    });
    // By index, because a part may be destroyed by the `save` of another.
    const std::vector<SnapshotPart*>& parts = state_->snapshots.parts;
    const std::size_t announced = parts.size();
    for (std::size_t i = 0; i < parts.size(); ++i) {
        block(parts[i]->part_name(), [&] { return parts[i]->save(to); });
        if (parts.size() != announced)
            throw Error(ErrorKind::bad_structure,
                        "a part of snapshots was removed while a snapshot was being taken");
        held += parts[i]->size_of(memories.back().second);
    }
    state_->snapshots.size = payload.size();
    return {std::move(payload), std::move(memories), held};
}

void Tree::restore(const Snapshot& snapshot) {
    restore(snapshot, {});
}

namespace {

/// A complete snapshot after reading and checking.
struct Prepared {
    explicit Prepared(SnapshotState& snapshots) : parts(snapshots) {}

    std::unique_ptr<TreeImage> image;
    PreparedParts parts;
};

/// The tree block of the snapshot, while the blocks of the parts are read.
struct Reading {
    const Tree* tree = nullptr;
    const TreeImage* image = nullptr;
};
thread_local Reading reading;

class ReadingScope {
  public:
    explicit ReadingScope(const Reading& now) : before_(std::exchange(reading, now)) {}
    ~ReadingScope() { reading = before_; }
    ReadingScope(const ReadingScope&) = delete;

  private:
    Reading before_;
};

void prepare(Prepared& prepared, Tree::State& state, const Snapshot& snapshot) {
    ByteReader from(snapshot.payload());
    from.get<std::uint64_t>();
    std::vector<std::string> found;
    const Memory* const of_tree = find(snapshot.memories(), tree_block);
    const auto* const memory =
        of_tree == nullptr ? nullptr : static_cast<const TreeMemory*>(of_tree->get());
    const bool own = memory != nullptr && memory->is_of(state);
    // In another tree, data that bytes cannot hold is left out, as in a file.
    const auto memory_of = [&](std::string_view name) {
        const Memory* const held = own ? find(snapshot.memories(), name) : nullptr;
        return held == nullptr ? Memory() : *held;
    };
    for (std::size_t n = from.count(16); n > 0; --n) {
        const std::string name(from.text());
        ByteReader block = from.block("snapshot of \"" + name + "\"");
        found.push_back(name);
        if (name == tree_block) {
            prepared.image = std::make_unique<TreeImage>(state, block, memory_of(name));
        } else {
            const auto found_part =
                std::find_if(state.snapshots.parts.begin(), state.snapshots.parts.end(),
                             [&](const SnapshotPart* p) { return p->part_name() == name; });
            if (found_part == state.snapshots.parts.end())
                throw Error(ErrorKind::unknown_name,
                            "the snapshot holds \"" + name + "\", which this game does not have");
            from.require(prepared.image != nullptr, "the tree does not come first");
            const ReadingScope scope({&state.tree, prepared.image.get()});
            SnapshotPart* const part = *found_part;
            // A part that replaced another one since must not get the memory of that one.
            const std::uint64_t number = state.snapshots.number_of(*part);
            const bool has_part = own && std::find(memory->parts.begin(), memory->parts.end(),
                                                   number) != memory->parts.end();
            prepared.parts.add(part, part->restore(block, has_part ? memory_of(name) : Memory()));
        }
        block.finish();
    }
    from.finish();
    from.require(prepared.image != nullptr, "it holds no tree");
    for (const SnapshotPart* part : state.snapshots.parts)
        if (std::find(found.begin(), found.end(), part->part_name()) == found.end())
            throw Error(ErrorKind::unknown_name, "the snapshot holds nothing of \"" +
                                                     std::string(part->part_name()) +
                                                     "\": it is of another game");
}

}  // namespace

void Tree::check(const Snapshot& snapshot) const {
    if (snapshot.empty()) throw Error(ErrorKind::damaged, "the snapshot is empty");
    Prepared prepared(state_->snapshots);
    prepare(prepared, *state_, snapshot);
}

void each_restored(const Tree& tree, const std::function<void(Handle, const Class&, Row)>& visit) {
    if (reading.tree == &tree) reading.image->each(visit);
}

void Tree::restore(const Snapshot& snapshot, const std::function<void()>& go_on) {
    State& s = *state_;
    s.require_changeable("restore a snapshot");
    if (s.changes.queue.delivering || s.changes.replaying)
        throw Error(ErrorKind::bad_structure,
                    "a snapshot cannot be restored in a handler: wait for the next barrier");
    s.underway.require_no_deletion("restore a snapshot");
    if (s.underway.restoring || s.lifetime.pinned != nullptr)
        throw Error(ErrorKind::bad_structure,
                    "a snapshot cannot be restored by " +
                        (s.underway.restoring ? "what another is restored by"
                                              : std::string(s.lifetime.pinned)) +
                        ": wait for the next barrier");
    struct Restoring {
        Underway& underway;
        explicit Restoring(Underway& u) : underway(u) { underway.restoring = true; }
        ~Restoring() {
            underway.restoring = false;
            underway.unmade.clear();
        }
    } restoring(s.underway);
    const Pin pin(s.lifetime, "what restores a snapshot");
    s.changes.report_plain_writes();  // report earlier writes before the state changes
    if (snapshot.empty()) throw Error(ErrorKind::damaged, "the snapshot is empty");
    Prepared prepared(s.snapshots);
    prepare(prepared, s, snapshot);
    Transition transition(s);
    std::exception_ptr problem;
    {
        struct Silence {
            Tree::State& state;
            explicit Silence(Tree::State& s) : state(s) {
                state.changes.shadows.clear();
                state.changes.replaying = true;
            }
            ~Silence() {
                state.changes.report_plain_writes();  // clears the list; observers are off
                state.changes.replaying = false;
            }
        } silence(s);
        prepared.image->end_rows();
        prepared.image->put_nodes();
        prepared.parts.put_all(problem);
        prepared.image->put_values();
        for (const SnapshotPart* part : s.snapshots.parts)
            std::ranges::move(part->remarks(), std::back_inserter(s.snapshots.remarks));
        if (go_on && !problem) try {
                go_on();
            } catch (...) {
                problem = std::current_exception();  // the tree is valid wherever `go_on` stopped
            }
        s.history.free_unclaimed();
    }
    transition.finish();
    if (problem) std::rethrow_exception(problem);
}

}  // namespace fettle::property
