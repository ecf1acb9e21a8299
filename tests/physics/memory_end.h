#pragma once

#include <cstdint>

#ifndef __linux__
#error "CMakeLists.txt leaves out what includes this, except on Linux"
#endif

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
