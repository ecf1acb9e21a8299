#pragma once
// The memory allocator of Lua. Small blocks (vectors, proxies, closures, short texts) come from
// free lists by size, which makes temporary objects such as the result of `ball.velocity` cheap.
// All bytes are counted, and requests above a limit are refused.

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

namespace fettle::script {

class Arena {
  public:
    explicit Arena(std::size_t limit) : limit_(limit) {}
    Arena(const Arena&) = delete;

    /// Allocator function of Lua; `user` is the arena. Returns nullptr if the limit is reached.
    static void* allocate(void* user, void* block, std::size_t old_size, std::size_t new_size);

    std::size_t bytes() const { return bytes_; }
    std::size_t limit() const { return limit_; }
    void set_limit(std::size_t limit) { limit_ = limit; }
    /// Functions of Lua that go through a whole text cannot be stopped, so it bounds their time.
    /// Bytes; 0: no limit.
    void set_longest_text(std::size_t size) { longest_text_ = size; }
    std::size_t longest_text() const { return longest_text_; }

    /// A refused request. `by_system`: there was no memory; otherwise the limit was reached. After
    /// a refusal that is not `final`, Lua may make a full collection and try again, but parts of
    /// Lua do not.
    struct Refusal {
        std::size_t size = 0;
        bool by_system = false;
        bool final = false;
        bool text = false;  // it is for a text beyond the longest one
    };
    /// Called for every refusal. If it returns false, the arena exceeds the limit and allocates the
    /// memory, unless the system has none.
    std::function<bool(const Refusal& refusal)> on_refusal;
    /// Called for every large block.
    std::function<void(std::size_t size)> on_large;

  private:
    static constexpr std::size_t granule = 16;
    static constexpr std::size_t small = 256;
    static constexpr std::size_t chunk_bytes = 64 * 1024;
    static constexpr std::size_t large = 64 * 1024;

    struct Free {
        Free* next;
    };
    static std::size_t list_of(std::size_t size) { return (size + granule - 1) / granule; }

    void* allocate_block(std::size_t size);
    void free_block(void* block, std::size_t size);
    void free_small(void* block, std::size_t size) {
        auto* node = static_cast<Free*>(block);
        Free*& head = lists_[list_of(size)];
        node->next = head;
        head = node;
    }
    bool refuse(std::size_t growth, std::size_t size);
    bool report_refusal(std::size_t size, bool by_system, bool text = false);

    std::array<Free*, small / granule + 1> lists_{};
    std::vector<std::unique_ptr<std::byte[]>> chunks_;
    std::byte* fresh_ = nullptr;
    std::size_t fresh_left_ = 0;
    std::size_t bytes_ = 0;
    std::size_t limit_;
    std::size_t longest_text_ = 0;
    std::size_t refused_ = 0;  // size of the last refused request; 0 after a success
};

}  // namespace fettle::script
