#pragma once
// Snapshots: the whole state of a tree and its modules, for restoring it in place or saving it in a
// file. docs/design/time.md describes how they are made.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fettle/property/bytes.h>
#include <fettle/property/export.h>

FETTLE_PROPERTY_BEGIN

namespace fettle::property {

/// Data that bytes cannot represent (functions). Snapshots share them while the process lives.
using Memory = std::shared_ptr<const void>;

/// An object whose state belongs to the state of the tree: a module, a clock, a script runtime.
/// Registered with `Tree::add_part`.
class SnapshotPart {
  public:
    virtual ~SnapshotPart() = default;
    /// Name of its bytes, "physics"; unique in a tree.
    virtual std::string_view part_name() const = 0;
    /// Writes all data that influence later steps. Must not change anything.
    virtual Memory save(ByteWriter& to) const = 0;
    /// Reads and checks all data; throws Error(damaged) and then has changed nothing. The returned
    /// function restores the state; it is called after the tree has its instances again, and must
    /// not throw. It is dropped, not called, if the part is removed in between (by a lifecycle
    /// function that destroys it). `memory` is what `save` returned; null if the bytes come from a
    /// file.
    virtual std::function<void()> restore(ByteReader& from, const Memory& memory) = 0;
    /// Descriptions of the data that the last restore lost, one line each, for `restore_remarks`.
    /// Called when the tree is complete again.
    virtual std::vector<std::string> remarks() const { return {}; }

    /// The changes since the last call in the data that `save` returns as memory; null: none. A
    /// timeline keeps them for every step and passes them to `redo` when it repeats the step.
    virtual Memory changes() { return {}; }
    /// Makes changes again that `changes` returned.
    virtual void redo(const Memory& /*changes*/) {}
    /// Bytes of a result of `save` or `changes`, estimated, for limits on memory.
    virtual std::size_t size_of(const Memory& /*memory*/) const { return 0; }
    /// Repeats an update of data that a read caused, as reported to `Tree::refreshing`, if the data
    /// still exist. A timeline calls it when it repeats a step, because it does not repeat reads.
    virtual void refresh(std::uint64_t /*what*/) {}
};

/// The state of a tree at a moment. Cheap to copy: copies share it.
class Snapshot {
  public:
    /// The data that parts keep in memory, by the names of the parts.
    using Memories = std::vector<std::pair<std::string, Memory>>;

    Snapshot() = default;
    /// `held`: bytes that the memories use, estimated.
    Snapshot(std::vector<std::byte> payload, Memories memories, std::size_t held = 0);
    bool empty() const { return data_ == nullptr; }  ///< whether it has no state
    /// The step of the snapshot. Throws Error(damaged), as `to_bytes` does, if it is empty.
    std::uint64_t step() const;
    /// The state itself, without the checksum of a file.
    std::span<const std::byte> payload() const;
    const Memories& memories() const;                               ///< what its parts keep
    std::size_t held() const { return empty() ? 0 : data_->held; }  ///< bytes of them, estimated
    /// Moves the state out of the snapshot; a copy if it is shared.
    std::vector<std::byte> release_payload() &&;

    /// The bytes of a file: complete, with a version and a checksum of every byte. Functions are
    /// not included: formulas are restored from their text; handlers and timers that scripts began
    /// later than at their start are not restored.
    std::vector<std::byte> to_bytes() const;
    /// Throws Error(damaged) for bytes that are incomplete, changed, of another version or no
    /// snapshot.
    static Snapshot from_bytes(std::span<const std::byte> bytes);

  private:
    struct Data {
        std::vector<std::byte> payload;
        Memories memories;
        std::size_t held;
    };
    std::shared_ptr<Data> data_;
};

}  // namespace fettle::property

FETTLE_PROPERTY_END
