#pragma once
// Snapshots: everything a tree and its modules are, to be restored in place or kept in a file.
// docs/design/time.md tells how they are made.

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

/// What bytes cannot hold (functions), shared beside them while the process lives.
using Memory = std::shared_ptr<const void>;

/// Somebody with state of their own that belongs to the tree's: a module, a clock, a script
/// runtime. Registered with `Tree::add_part`.
class SnapshotPart {
  public:
    virtual ~SnapshotPart() = default;
    /// Names its bytes, "physics"; one of a kind in a tree.
    virtual std::string_view part_name() const = 0;
    /// Writes everything that influences what comes later. Must not change anything.
    virtual Memory save(ByteWriter& to) const = 0;
    /// Reads all of it and checks it; nothing has changed when it throws Error(damaged). What is
    /// returned puts it into place; it is called after the tree has its instances again, and must
    /// not throw. `memory` is what `save` returned; null when the bytes come from a file.
    virtual std::function<void()> restore(ByteReader& from, const Memory& memory) = 0;

    /// What has changed since the last call, of that which `save` returns as memory; null: nothing.
    /// A timeline keeps it for every step and gives it to `redo` when it goes that way again.
    virtual Memory changes() { return {}; }
    virtual void redo(const Memory& /*changes*/) {}
    /// Bytes that is, of what `save` or `changes` returned, about: whoever keeps many has a limit.
    virtual std::size_t size_of(const Memory& /*memory*/) const { return 0; }
    /// Brings up to date what a reader once asked for, as told by `Tree::refreshing`, if it is
    /// still there. A timeline asks for it when it goes that way again, since readers are not.
    virtual void refresh(std::uint64_t /*what*/) {}
};

/// The state of a tree at a moment. Cheap to copy: copies share it.
class Snapshot {
  public:
    using Memories = std::vector<std::pair<std::string, Memory>>;

    Snapshot() = default;
    /// `held`: bytes that the memories take, about.
    Snapshot(std::vector<std::byte> payload, Memories memories, std::size_t held = 0);
    bool empty() const { return data_ == nullptr; }
    /// The step it was taken at. Throws Error(damaged), as `to_bytes` does, for an empty one.
    std::uint64_t step() const;
    /// The state itself, without what protects a file.
    std::span<const std::byte> payload() const;
    const Memories& memories() const;
    std::size_t held() const { return empty() ? 0 : data_->held; }
    /// The state itself, out of a snapshot that ends here; a copy of it while others share it.
    std::vector<std::byte> take_payload() &&;

    /// For a file: self-contained, with a version and a checksum of every byte. Functions are not
    /// in it: formulas come back by their text, timers and tweens do not.
    std::vector<std::byte> to_bytes() const;
    /// Throws Error(damaged) for what is cut off, changed, another version's or no snapshot at all.
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
