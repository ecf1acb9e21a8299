#pragma once
// Keyframes of a timeline, packed by a thread of their own so that no frame waits for it.

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <memory>
#include <mutex>
#include <span>
#include <thread>
#include <vector>

namespace fettle::app {

/// Bytes, and later fewer of them. Shared between the game's thread and the packing one.
struct PackedBytes {
    explicit PackedBytes(std::vector<std::byte> payload) : plain(std::move(payload)) {}
    /// What went in.
    std::vector<std::byte> bytes() const;
    std::size_t size() const;

    mutable std::mutex mutex;
    std::vector<std::byte> plain;  // empty when packed
    std::vector<std::byte> packed;
    std::size_t plain_size = 0;  // when packed
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
    bool ending_ = false;
    bool busy_ = false;
    std::thread thread_;
};

}  // namespace fettle::app
