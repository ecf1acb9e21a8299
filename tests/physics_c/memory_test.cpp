// A world in C when memory has ended in the middle of an edit.

#include <fettle_physics.h>

#include "catch.h"

#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <new>
#include <string>

namespace {

std::atomic<int64_t> allocations_left = -1;  ///< until memory ends; negative: it does not

}  // namespace

// These replace the operators of the whole program, and so of the library that it uses. Inlined,
// they make GCC take `free` for the wrong partner of `new` (-Wmismatched-new-delete).
[[gnu::noinline]] void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
    if (allocations_left.load() >= 0 && allocations_left.fetch_sub(1) == 0) return nullptr;
    return std::malloc(size > 0 ? size : 1);
}
[[gnu::noinline]] void* operator new(std::size_t size) {
    void* const memory = operator new(size, std::nothrow);
    if (memory == nullptr) throw std::bad_alloc();
    return memory;
}
[[gnu::noinline]] void operator delete(void* memory, const std::nothrow_t&) noexcept {
    std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory) noexcept {
    std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}

namespace physics_c_memory_test {

TEST_CASE("a world in C whose memory ended in a step says so until it gets another state") {
    fettle_world *world = nullptr, *copy = nullptr;
    fettle_geometry circle;
    fettle_id body = 0;
    REQUIRE(fettle_world_create(nullptr, &world) == FETTLE_DONE);
    REQUIRE(fettle_geometry_init(&circle, sizeof circle, FETTLE_SHAPE_CIRCLE) == FETTLE_DONE);
    REQUIRE(fettle_world_create_body(world, nullptr, &body) == FETTLE_DONE);
    REQUIRE(fettle_body_add(world, body, &circle, nullptr, nullptr) == FETTLE_DONE);
    REQUIRE(fettle_world_clone(world, &copy) == FETTLE_DONE);

    allocations_left = 0;
    const fettle_code first = fettle_world_step(world, 1.0f / 60);
    allocations_left = -1;
    REQUIRE(first == FETTLE_NO_MEMORY);

    fettle_position position;
    REQUIRE(fettle_body_position(world, body, &position) == FETTLE_NO_MEMORY);
    REQUIRE(std::string(fettle_last_error()).find("incomplete") != std::string::npos);
    REQUIRE(fettle_body_set_angle(world, body, 1) == FETTLE_NO_MEMORY);
    REQUIRE(fettle_world_step(world, 1.0f / 60) == FETTLE_NO_MEMORY);
    REQUIRE(fettle_world_create_body(world, nullptr, nullptr) == FETTLE_NO_MEMORY);
    REQUIRE(fettle_body_position(copy, body, &position) == FETTLE_DONE);

    REQUIRE(fettle_world_assign(world, copy) == FETTLE_DONE);
    REQUIRE(fettle_world_step(world, 1.0f / 60) == FETTLE_DONE);
    REQUIRE(fettle_body_position(world, body, &position) == FETTLE_DONE);
    REQUIRE(fettle_world_destroy(world) == FETTLE_DONE);
    REQUIRE(fettle_world_destroy(copy) == FETTLE_DONE);
}

}  // namespace physics_c_memory_test
