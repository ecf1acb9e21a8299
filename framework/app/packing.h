#pragma once
// Keyframes of a timeline, packed by a thread of their own so that no frame waits for it: neither
// thread ever holds what the other wants. The game hands a state over and looks, when it comes by
// again, whether it is packed.

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

namespace fettle::app {

/// The state of a keyframe, and later the same in fewer bytes.
class PackedBytes {
  public:
    explicit PackedBytes(std::vector<std::byte> plain)
        : plain_(std::move(plain)), plain_size_(plain_.size()) {}

    // --- By the game's thread
    std::vector<std::byte> payload() const;
    /// Bytes it takes now.
    std::size_t size() const;
    /// Once it is packed, memory for the next: that of what was packed, or more. Nothing before,
    /// and after that.
    std::optional<std::vector<std::byte>> settle();

    // --- By the packing thread
    struct Room {
        std::vector<std::byte> ranks, packed;  // kept from one to the next
        bool made = false;                     // the memory for states
    };
    void pack(Room& room);

  private:
    std::vector<std::byte> plain_;   // the game's again once it is packed
    std::vector<std::byte> packed_;  // the packing thread's until then
    std::vector<std::byte> next_;    // as well: memory for later states, made once
    std::size_t plain_size_ = 0;
    std::atomic<bool> is_packed_{false};
};

class Packer {
  public:
    Packer();
    ~Packer();
    Packer(const Packer&) = delete;
    void pack(const std::shared_ptr<PackedBytes>& what);

  private:
    void work();

    std::mutex mutex_;  // held to hand over, never while packing
    std::condition_variable wake_;
    std::deque<std::weak_ptr<PackedBytes>> waiting_;
    bool ending_ = false;
    std::thread thread_;
};

}  // namespace fettle::app
