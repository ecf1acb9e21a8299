#pragma once
// Keyframes of a timeline, packed by a thread of their own so that no frame waits for it.

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <memory>
#include <mutex>
#include <span>
#include <thread>
#include <utility>
#include <vector>

#include <fettle/property/snapshot.h>

namespace fettle::app {

/// The state of a keyframe, and later the same in fewer bytes. Shared between the game's thread and
/// the packing one.
class PackedBytes {
  public:
    explicit PackedBytes(property::Snapshot taken) : taken_(std::move(taken)) {}
    std::vector<std::byte> payload() const;
    /// Bytes it takes now.
    std::size_t size() const;
    /// By the packing thread.
    void pack();
    /// By the game's thread, now and then: what was packed is let go of.
    void settle();

  private:
    mutable std::mutex mutex_;
    property::Snapshot taken_;  // empty when packed
    std::vector<std::byte> packed_;
    std::size_t plain_size_ = 0;
};

class Packer {
  public:
    Packer();
    ~Packer();
    Packer(const Packer&) = delete;
    void pack(std::shared_ptr<PackedBytes> what);
    /// Until everything handed over is packed.
    void finish();

  private:
    void work();

    std::mutex mutex_;
    std::condition_variable wake_, idle_;
    std::deque<std::weak_ptr<PackedBytes>> waiting_;
    // Ended by the game's thread: snapshots hold functions of its scripts.
    std::vector<std::shared_ptr<PackedBytes>> finished_;
    bool ending_ = false;
    bool busy_ = false;
    std::thread thread_;
};

}  // namespace fettle::app
