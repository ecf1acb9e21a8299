#pragma once
// Keyframes of a timeline, packed by a thread of their own so that no frame waits for it: neither
// thread ever holds what the other wants. The game hands a state over and looks, when it comes by
// again, whether it is packed.

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

/// The state of a keyframe, and later the same in fewer bytes.
class PackedBytes {
  public:
    /// Memory for a state. `touched`: as much of it has been written to, and so is there.
    struct Buffer {
        std::vector<std::byte> bytes;
        std::size_t touched = 0;
    };
    /// `prepare`: bytes of memory that the packing thread is to make for later states; 0: none.
    explicit PackedBytes(Buffer plain, std::size_t prepare = 0)
        : plain_(std::move(plain.bytes)),
          touched_(std::max(plain.touched, plain_.size())),
          plain_size_(plain_.size()),
          prepare_(prepare) {}

    // --- By the game's thread
    std::vector<std::byte> payload() const;
    /// Bytes of the state.
    std::size_t plain_size() const { return plain_size_; }
    /// Bytes of memory it takes now.
    std::size_t memory() const;
    /// Once it is packed, memory for the next: that of what was packed, or more. Nothing before,
    /// and after that.
    std::optional<Buffer> settle();

    // --- By the packing thread
    void pack();

  private:
    std::vector<std::byte> plain_;   // the game's again once it is packed
    std::size_t touched_ = 0;        // of its memory
    std::vector<std::byte> packed_;  // the packing thread's until then
    std::vector<std::byte> next_;    // as well: memory for later states
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

    std::mutex mutex_;  // held to hand over, never while packing
    std::condition_variable wake_;
    std::deque<std::weak_ptr<PackedBytes>> waiting_;
    bool ending_ = false;
    std::thread thread_;
};

}  // namespace fettle::app
