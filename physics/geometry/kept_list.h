#pragma once

#include <cstddef>
#include <deque>
#include <vector>

namespace fettle::physics::detail {

/// A list for the time of a call, in memory that its thread keeps: the next one of this type
/// allocates nothing up to the size of this one. The lists of a thread must end in the opposite
/// order of their beginnings, as local variables do; a call inside another one gets other memory.
///
/// A host may call the library from the destructor of a static or thread-local object, when the
/// thread has freed this memory already. Such a call makes its own memory and frees it.
template <class T>
class KeptList {
  public:
    KeptList() : list_(memory().take()) {}
    ~KeptList() { give_back(); }
    KeptList(const KeptList&) = delete;
    KeptList& operator=(const KeptList&) = delete;

    std::vector<T>& operator*() { return list_; }
    std::vector<T>* operator->() { return &list_; }
    const std::vector<T>& operator*() const { return list_; }

  private:
    /// Larger memory is freed: a thread should not keep that of the largest chain for ever.
    static constexpr size_t most_bytes = size_t{1} << 16;

    struct Memory {
        std::deque<std::vector<T>> all;  // its elements do not move
        size_t used = 0;

        std::vector<T>& take() {
            if (used == all.size()) all.emplace_back();
            return all[used++];
        }
    };
    /// It has no destructor, so it can be used until the thread is gone.
    struct Kept {
        Memory* memory;
        bool ended;
        void free() {
            delete memory;
            memory = nullptr;
        }
    };
    static Kept& kept() {
        thread_local Kept of_thread = {nullptr, false};
        return of_thread;
    }
    struct End {
        End() {}
        ~End() {
            kept().free();
            kept().ended = true;
        }
    };
    static Memory& memory() {
        Kept& of_thread = kept();
        if (of_thread.memory == nullptr) [[unlikely]] {
            if (!of_thread.ended) {
                thread_local const End end;  // at the end of the thread
            }
            of_thread.memory = new Memory;
        }
        return *of_thread.memory;
    }
    static void give_back() {
        Kept& of_thread = kept();
        Memory& memory = *of_thread.memory;
        std::vector<T>& last = memory.all[--memory.used];
        last.clear();
        if (last.capacity() * sizeof(T) > most_bytes) std::vector<T>().swap(last);
        if (of_thread.ended && memory.used == 0) of_thread.free();
    }

    std::vector<T>& list_;
};

}  // namespace fettle::physics::detail
