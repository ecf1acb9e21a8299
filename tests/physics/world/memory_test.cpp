// The memory of a world: bytes are counted when they are allocated.

#include "catch.h"
#include "memory_end.h"
#include "scenes.h"

#include <malloc.h>

#include <atomic>
#include <cstdlib>
#include <memory>
#include <new>

using namespace scenes;

namespace {

std::atomic<std::size_t> bytes_in_use = 0;
std::atomic<int64_t> allocations_left = -1;  ///< until memory ends; negative: it does not

/// Whether memory has ended.
bool refuse() noexcept {
    return allocations_left.load() >= 0 && allocations_left.fetch_sub(1) == 0;
}

void* allocate(std::size_t size) noexcept {
    if (refuse()) return nullptr;
    void* const memory = std::malloc(size > 0 ? size : 1);
    if (memory != nullptr) bytes_in_use += malloc_usable_size(memory);
    return memory;
}

void* allocate(std::size_t size, std::align_val_t alignment) noexcept {
    if (refuse()) return nullptr;
    const auto unit = static_cast<std::size_t>(alignment);
    void* const memory = std::aligned_alloc(unit, (size + unit - 1) / unit * unit);
    if (memory != nullptr) bytes_in_use += malloc_usable_size(memory);
    return memory;
}

void* or_throw(void* memory) {
    if (memory == nullptr) throw std::bad_alloc();
    return memory;
}

void discount(void* memory) {
    bytes_in_use -= malloc_usable_size(memory);
    std::free(memory);
}

}  // namespace

scenes::MemoryEnd::MemoryEnd(int64_t allocations) {
    allocations_left = allocations;
}
scenes::MemoryEnd::~MemoryEnd() {
    allocations_left = -1;
}

// These replace the operators of the whole program, so they count in other tests as well, which
// does no harm. All forms but those for arrays are replaced: a sanitizer defines the missing ones,
// and reports a mixture.
void* operator new(std::size_t size) {
    return or_throw(allocate(size));
}
void* operator new(std::size_t size, std::align_val_t alignment) {
    return or_throw(allocate(size, alignment));
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
    return allocate(size);
}
void* operator new(std::size_t size, std::align_val_t alignment, const std::nothrow_t&) noexcept {
    return allocate(size, alignment);
}
void operator delete(void* memory) noexcept {
    discount(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    discount(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept {
    discount(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
    discount(memory);
}
void operator delete(void* memory, const std::nothrow_t&) noexcept {
    discount(memory);
}
void operator delete(void* memory, std::align_val_t, const std::nothrow_t&) noexcept {
    discount(memory);
}

namespace {

/// In double precision, a body with a box has five positions of eight bytes more each, and unused
/// room for some.
constexpr int more_for_precision = sizeof(Position) > sizeof(Vec2) ? 60 : 0;

/// Boxes in a row, each of which rests on the ground; they sleep after some steps.
void add_row(World& world, int count) {
    Body ground = world.create_body({.type = BodyType::static_body});
    ground.add(Box{.width = 4.0f * float(count), .height = 1});
    for (int i = 0; i < count; ++i)
        world.create_body({.position = {2.0f * float(i - count / 2), 1.0f}}).add(Box{});
}

void settle(World& world) {
    for (int i = 0; i < 1000 && (i == 0 || world.statistics().awake_bodies > 0); ++i)
        world.step(frame);
    world.step(frame);  // clears the events of the bodies that fell asleep
}

std::size_t reserved(const World& world) {
    std::size_t sum = 0;
    for (const MemoryShare& share : world.memory()) sum += share.reserved;
    return sum;
}

std::size_t reserved(const World& world, const std::string& purpose) {
    for (const MemoryShare& share : world.memory())
        if (share.purpose == purpose) return share.reserved;
    FAIL("no memory for " << purpose);
    return 0;
}

}  // namespace

TEST_CASE("a sleeping body with a box that rests on the ground takes less than a kilobyte") {
    // Several counts, because the unused capacity of the vectors depends on the count.
    for (const int count : {500, 1000, 3300, 9000, 20000}) {
        const std::size_t before = bytes_in_use;
        auto world = std::make_unique<World>(WorldDef{.sleep_delay = 0.05f});
        add_row(*world, count);
        settle(*world);
        REQUIRE(world->statistics().awake_bodies == 0);
        REQUIRE(world->contacts().size() == std::size_t(count));
        const auto bytes = double(bytes_in_use - before) / count;
        INFO(count << " bodies, " << bytes << " bytes each");
        REQUIRE(bytes < 1024 + more_for_precision);
        REQUIRE(bytes > 500);  // the counter works
    }
}

TEST_CASE("a body that was made asleep takes less than 800 bytes") {
    constexpr int count = 5000;
    const std::size_t before = bytes_in_use;
    auto world = std::make_unique<World>();
    for (int i = 0; i < count; ++i)
        world->create_body({.position = {2.0f * float(i), 0}, .awake = false}).add(Box{});
    for (int i = 0; i < 2; ++i) world->step(frame);
    REQUIRE(world->statistics().awake_bodies == 0);
    const auto bytes = double(bytes_in_use - before) / count;
    INFO(bytes << " bytes each");
    REQUIRE(bytes < 800 + more_for_precision);  // no contact
}

TEST_CASE("a world reports where its memory is") {
    const std::size_t before = bytes_in_use;
    auto world = std::make_unique<World>(WorldDef{.sleep_delay = 0.05f});
    const std::size_t empty = bytes_in_use - before;
    add_row(*world, 2000);
    world->step(frame);
    // All but the world itself, and what the heap rounds up.
    const auto difference = double(bytes_in_use - before) - double(reserved(*world));
    REQUIRE(difference >= 0);
    REQUIRE(difference < double(empty) + 4096);
    for (const MemoryShare& share : world->memory()) REQUIRE(share.used <= share.reserved);
}

TEST_CASE("the scratch memory of a step is given back when most bodies sleep") {
    World world({.sleep_delay = 0.05f});
    add_row(world, 1000);
    world.step(frame);
    const std::size_t awake = reserved(world, "step");
    settle(world);
    REQUIRE(world.statistics().awake_bodies == 0);
    REQUIRE(reserved(world, "step") < awake / 20);
    // A body that wakes brings back the memory that one body needs.
    world.bodies()[500].apply_impulse({0, 1});
    world.step(frame);
    REQUIRE(world.statistics().awake_bodies == 1);
    REQUIRE(reserved(world, "step") < awake / 20);
    REQUIRE_FALSE(world.validate());
}

TEST_CASE("a world whose memory was given back goes on as its copy does") {
    World world({.sleep_delay = 0.05f});
    add_row(world, 100);
    for (int i = 0; i < 20; ++i) add_box(world, {0.02f * float(i % 3), 1.5f + 1.01f * float(i)});
    settle(world);
    REQUIRE(world.statistics().awake_bodies == 0);
    const auto bytes = [&] {
        std::vector<std::byte> saved;
        world.save(saved);
        return saved;
    }();
    World other;
    other.restore(bytes);  // its vectors are as long as what they hold
    for (World* each : {&world, &other}) {
        each->bodies()[50].apply_impulse({0.3f, 4});
        for (int i = 0; i < 100; ++i) each->step(frame);
    }
    REQUIRE(world.hash() == other.hash());
    REQUIRE_FALSE(world.validate());
}

TEST_CASE("joints work after the memory of many more was given back") {
    World world;
    add_floor(world, 500.0f);
    std::vector<Body> hung;
    for (int i = 0; i < 200; ++i) {
        hung.push_back(add_box(world, {1.5f * float(i), 20}));
        world.create_distance_joint(
            {.body_b = hung.back().id(), .anchor_a = {1.5f * float(i), 24}});
    }
    world.step(frame);
    const std::size_t many = reserved(world, "step");
    for (Body& body : hung) body.destroy();
    world.step(frame);
    REQUIRE(reserved(world, "step") < many / 4);
    // One joint of another type, among many more contacts.
    std::vector<Body> boxes;
    for (int i = 0; i < 20; ++i) boxes.push_back(add_box(world, {1.5f * float(i), 0.5f}));
    world.create_revolute_joint({.body_a = boxes[0].id(),
                                 .body_b = boxes[1].id(),
                                 .anchor_a = {0.75f, 0},
                                 .anchor_b = {-0.75f, 0}});
    run(world, 1.0f);
    REQUIRE_FALSE(world.validate());
    for (std::size_t i = 0; i < boxes.size(); ++i)
        REQUIRE(std::fabs(boxes[i].position().x - 1.5f * float(i)) < 0.05f);
}
