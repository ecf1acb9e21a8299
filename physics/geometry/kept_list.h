#pragma once

#include <cstddef>
#include <deque>
#include <vector>

namespace fettle::physics::detail {

/// A list for the time of a call, in memory that its thread keeps: the next one of this type
/// allocates nothing up to the size of this one. The lists of a thread must end in the opposite
/// order of their beginnings, as local variables do; a call inside another one gets other memory.
template <class T>
class KeptList {
  public:
    KeptList() : lists_(lists()), list_(lists_.take()) {}
    ~KeptList() { lists_.give_back(); }
    KeptList(const KeptList&) = delete;
    KeptList& operator=(const KeptList&) = delete;

    std::vector<T>& operator*() { return list_; }
    std::vector<T>* operator->() { return &list_; }
    const std::vector<T>& operator*() const { return list_; }

  private:
    /// Larger memory is freed: a thread should not keep that of the largest chain for ever.
    static constexpr size_t most_bytes = size_t{1} << 16;

    struct Lists {
        std::deque<std::vector<T>> all;  // its elements do not move
        size_t used = 0;

        std::vector<T>& take() {
            if (used == all.size()) all.emplace_back();
            return all[used++];
        }
        void give_back() {
            std::vector<T>& last = all[--used];
            last.clear();
            if (last.capacity() * sizeof(T) > most_bytes) std::vector<T>().swap(last);
        }
    };
    static Lists& lists() {
        thread_local Lists of_thread;
        return of_thread;
    }

    Lists& lists_;
    std::vector<T>& list_;
};

}  // namespace fettle::physics::detail
