#pragma once
// Where Lua's memory comes from. Small blocks (vectors, proxies, closures, short texts) come from
// free lists of their size, which makes the garbage of `ball.velocity` cheap; every byte is counted
// and a limit refuses more.

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

    /// In the form Lua wants: `user` is the arena. Returns nullptr when the limit refuses.
    static void* allocate(void* user, void* block, std::size_t old_size, std::size_t new_size);

    std::size_t bytes() const { return bytes_; }
    std::size_t limit() const { return limit_; }
    void set_limit(std::size_t limit) { limit_ = limit; }

    /// A refusal, by the limit or by the system. A full collection may avert one that is not final;
    /// parts of Lua ask once and give up, though.
    struct Refusal {
        std::size_t size = 0;
        bool by_system = false;
        bool final = false;
    };
    /// Told of every refusal and of every large block.
    std::function<void(const Refusal& refusal)> on_refusal;
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

    void* take(std::size_t size);
    void give(void* block, std::size_t size);
    void give_small(void* block, std::size_t size) {
        auto* node = static_cast<Free*>(block);
        Free*& head = lists_[list_of(size)];
        node->next = head;
        head = node;
    }
    bool refuse(std::size_t growth, std::size_t size);
    bool tell_refusal(std::size_t size, bool by_system);

    std::array<Free*, small / granule + 1> lists_{};
    std::vector<std::unique_ptr<std::byte[]>> chunks_;
    std::byte* fresh_ = nullptr;
    std::size_t fresh_left_ = 0;
    std::size_t bytes_ = 0;
    std::size_t limit_;
    std::size_t refused_ = 0;  // size refused last, until something else is granted
};

}  // namespace fettle::script
