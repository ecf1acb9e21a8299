#pragma once
// Data of the process that trees use until their end. A tree may be a global variable of a host, or
// be destroyed by a function of std::atexit, so these data are not destroyed with other static
// objects. When the program ends or the library is unloaded, they are freed if no tree exists.

#include <cstddef>
#include <new>

namespace fettle::property {

/// A member of each tree.
class CountedTree {
  public:
    CountedTree() noexcept;
    ~CountedTree();
    CountedTree(const CountedTree&) = delete;
    CountedTree& operator=(const CountedTree&) = delete;

    static bool any() noexcept;
};

/// The only `Data` of the process, made by the first call. `Data::free` frees its memory, and what
/// is used after that must make it again.
template <class Data>
Data& process_data() {
    alignas(Data) static std::byte room[sizeof(Data)];
    static Data& data = *new (room) Data;
    struct End {
        End() {}
        ~End() {
            if (!CountedTree::any()) data.free();
        }
    };
    static const End end;
    return data;
}

}  // namespace fettle::property
