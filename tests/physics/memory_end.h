#pragma once

#include <cstdint>

namespace scenes {

/// While it lives, the program gets memory so many times, then once none, and then some again.
class MemoryEnd {
  public:
    explicit MemoryEnd(int64_t allocations);
    ~MemoryEnd();
    MemoryEnd(const MemoryEnd&) = delete;
    MemoryEnd& operator=(const MemoryEnd&) = delete;
};

}  // namespace scenes
