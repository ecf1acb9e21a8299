#pragma once
// Compresses keyframes of a timeline in a separate thread. Neither thread waits for the other: the
// game hands over a state, and later checks whether it is packed.

#include <algorithm>
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

/// The state of a keyframe, which the packing thread compresses.
class PackedBytes {
  public:
    /// Memory for a state. The first `touched` bytes have been written before, so their pages
    /// exist.
    struct Buffer {
        std::vector<std::byte> bytes;
        std::size_t touched = 0;
    };
    /// `prepare`: size in bytes of the memory to make for later states; 0: none.
    explicit PackedBytes(Buffer plain, std::size_t prepare = 0)
        : plain_(std::move(plain.bytes)),
          touched_(std::max(plain.touched, plain_.size())),
          plain_size_(plain_.size()),
          prepare_(prepare) {}

    // --- Called by the game's thread
    std::vector<std::byte> payload() const;
    /// Size of the state in bytes.
    std::size_t plain_size() const { return plain_size_; }
    /// Memory in use, in bytes.
    std::size_t memory() const;
    /// Once the state is packed, returns memory for the next state: the unpacked buffer or a larger
    /// one. Returns nothing before that, and nothing on later calls.
    std::optional<Buffer> spare_buffer();

    // --- Called by the packing thread
    void pack();

  private:
    std::vector<std::byte> plain_;   // not changed until packed; then owned by the game
    std::size_t touched_ = 0;        // bytes of its memory that were written
    std::vector<std::byte> packed_;  // owned by the packing thread until packed
    std::vector<std::byte> next_;    // memory for later states; owned likewise
    std::size_t plain_size_ = 0;
    std::size_t prepare_ = 0;
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

    std::mutex mutex_;  // locked only to pass a state on, not during packing
    std::condition_variable wake_;
    std::deque<std::weak_ptr<PackedBytes>> waiting_;
    bool ending_ = false;
    std::thread thread_;
};

}  // namespace fettle::app
