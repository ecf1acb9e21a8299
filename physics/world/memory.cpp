#include <state/member_list.h>
#include <world/world_data.h>

#include <algorithm>
#include <string_view>
#include <type_traits>

// Heap memory of a world. Slots grow by a fifth (geometry/make_room.h). The scratch data of a step
// are released when most bodies sleep, so that a world at rest uses little more memory than its
// state.

namespace fettle::physics {

namespace detail {
namespace {

template <class T, class Io>
concept ListsScratch = requires(Io& io, T& value) {
    std::remove_const_t<T>::scratch(io, value);
};

/// Adds up the memory of vectors, line by line.
class MemoryLines {
  public:
    void line(const char* name) {
        if (*name == 0) return;
        const auto same = [name](const MemoryShare& one) {
            return std::string_view(one.purpose) == name;
        };
        auto found = std::find_if(shares_.begin(), shares_.end(), same);
        if (found == shares_.end()) found = shares_.insert(found, {name, 0, 0});
        line_ = size_t(found - shares_.begin());
    }
    template <class T>
    void operator()(const std::vector<T>& list) {
        add(list);
        if constexpr (!std::is_trivially_destructible_v<T>)
            for (const T& element : list) (*this)(element);
    }
    template <class T, std::size_t n>
    void operator()(const std::array<T, n>& lists) {
        each_of(*this, lists);
    }
    void operator()(const Events& events) { event_members(*this, events); }
    template <class T>
    void operator()(const T& value) {
        if constexpr (ListsMembers<const T, MemoryLines>)
            T::members(*this, value);
        else if constexpr (ListsScratch<const T, MemoryLines>)
            T::scratch(*this, value);
    }

    std::vector<MemoryShare> shares() const { return shares_; }

  private:
    template <class T>
    void add(const std::vector<T>& list) {
        shares_[line_].used += list.size() * sizeof(T);
        shares_[line_].reserved += list.capacity() * sizeof(T);
    }

    std::vector<MemoryShare> shares_;
    size_t line_ = 0;
};

/// Releases the memory of vectors.
struct MemoryRelease {
    template <class T>
    void operator()(std::vector<T>& list) {
        list = std::vector<T>();
    }
    template <class T, std::size_t n>
    void operator()(std::array<T, n>& lists) {
        each_of(*this, lists);
    }
    template <class T>
    void operator()(T& value) {
        if constexpr (ListsScratch<T, MemoryRelease>) T::scratch(*this, value);
    }
};

}  // namespace

/// Releases scratch data if the awake bodies are fewer than a quarter of the bodies for which these
/// data have room. The list of moved shapes counts only when all bodies sleep: one awake body may
/// have many shapes, and then the data would be released in every step.
void WorldData::trim() {
    const size_t listed = awake_bodies.empty() ? moved_shapes.capacity() : 0;
    const size_t once = std::max(solver_bodies.capacity(), listed);
    if ((awake_bodies.size() + 1) * 4 > once) return;
    MemoryRelease release;
    StepScratch::scratch(release, part<StepScratch>(*this));
    event_members(release, pending);
    Tree::scratch(release, moving_tree);
    Tree::scratch(release, fixed_tree);
    for (std::vector<uint32_t>* list :
         {&moved_shapes, &awake_bodies, &awake_contacts, &edited_bodies, &edited_shapes})
        list->shrink_to_fit();
    for (auto& list : awake_joints) list.shrink_to_fit();
}

}  // namespace detail

using namespace detail;

std::vector<MemoryShare> World::memory() const {
    const WorldData& data = *data_;
    MemoryLines lines;
    lines(part<const WorldState>(data));
    lines(part<const StepScratch>(data));
    Tree::scratch(lines, data.moving_tree);
    Tree::scratch(lines, data.fixed_tree);
    return lines.shares();
}

}  // namespace fettle::physics
