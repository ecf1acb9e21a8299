#include <world/world_data.h>

#include <cstddef>
#include <memory>
#include <mutex>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

namespace fettle::physics::detail {
namespace {

/// Multiples of 2³² divided by the golden ratio are far apart, for any number of them.
constexpr uint32_t apart = 2654435769u;
/// `skip` treats a generation that is at most this far ahead as one of this link. It is far more
/// than the generations that a world creates between two restored states, and far less than the
/// distance between the first generations of two links.
constexpr uint32_t farthest_ahead = 1u << 24;

struct Links {
    std::mutex mutex;
    std::vector<std::unique_ptr<WorldLink>> all;
    std::vector<WorldLink*> unused;
};

/// Never destroyed, because a world or a handle may be a global variable.
Links& links() {
    alignas(Links) static std::byte room[sizeof(Links)];
    static Links& all = *new (room) Links;
    return all;
}

/// Frees the links when the program ends or the library is unloaded, if no world exists any more.
struct AtEnd {
    ~AtEnd() {
        Links& known = links();
        const std::lock_guard lock(known.mutex);
        if (known.unused.size() != known.all.size()) return;
        known.unused.clear();
        known.unused.shrink_to_fit();
        known.all.clear();
        known.all.shrink_to_fit();
    }
};
const AtEnd at_end;

/// An id does not tell whether its object was destroyed or lives in another world.
std::string no_object(const char* kind, uint32_t index, uint32_t generation) {
    return std::string(kind) + " " + std::to_string(index) + " of generation " +
           std::to_string(generation) + " was destroyed, or is of another world";
}

}  // namespace

void WorldLink::skip(std::span<const uint32_t> given) {
    uint32_t ahead = 0;
    for (const uint32_t generation : given) {
        const uint32_t distance = generation - generations.next;
        if (generation != 0 && distance < farthest_ahead && distance + 1 > ahead)
            ahead = distance + 1;
    }
    generations.next += ahead;
    if (generations.next == 0) generations.next = 1;
}

WorldLink& acquire_link() {
    Links& known = links();
    const std::lock_guard lock(known.mutex);
    if (!known.unused.empty()) {
        WorldLink& link = *known.unused.back();
        known.unused.pop_back();
        return link;
    }
    known.unused.reserve(known.all.size() + 1);  // returning a link must not throw
    const auto number = uint32_t(known.all.size());
    WorldLink& link = *known.all.emplace_back(std::make_unique<WorldLink>());
    link.generations.next = number * apart + 1;
    if (link.generations.next == 0) link.generations.next = 1;
    return link;
}

void release_link(WorldLink& link) {
    Links& known = links();
    const std::lock_guard lock(known.mutex);
    link.world = nullptr;
    link.data = nullptr;
    known.unused.push_back(&link);
}

void refuse_dangling(const char* kind, const WorldLink* link, uint32_t index, uint32_t generation) {
    if (link == nullptr || generation == 0)
        throw std::invalid_argument(std::string("this handle names no ") + kind);
    const std::string named = std::string(kind) + " " + std::to_string(index);
    if (link->data == nullptr)
        throw std::invalid_argument(named + " does not exist any more: its world was destroyed");
    link->data->self.may_read();
    throw std::invalid_argument(no_object(kind, index, generation));
}

void refuse_foreign(const char* name, const char* kind, uint32_t index, uint32_t generation) {
    throw std::invalid_argument(std::string(name) + ": " + no_object(kind, index, generation));
}

}  // namespace fettle::physics::detail
