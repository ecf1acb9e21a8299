#include <fettle/physics/hooks.h>
#include <fettle/physics/host_access.h>
#include <fettle/physics/recording.h>
#include <recording/chunks.h>

#include <stdexcept>
#include <string>

#include "catch.h"
#include "every_method.h"
#include "thorough.h"

namespace recording_test {

// Recordings of worlds, and what becomes of them when they are replayed.

using namespace scenes;
using Bytes = std::vector<std::byte>;

namespace {

RecordingSink into(Bytes& bytes) {
    return [&bytes](std::span<const std::byte> more) {
        bytes.insert(bytes.end(), more.begin(), more.end());
    };
}

/// Replays all; the number of steps, all of which are the same.
uint64_t replayed(const Bytes& bytes, uint64_t hash) {
    Replay replay(bytes);
    uint64_t steps = 0;
    while (const auto step = replay.step()) {
        INFO("step " << step->number << " after " << step->calls);
        REQUIRE(step->same);
        REQUIRE(step->number == steps++);
    }
    REQUIRE(steps == replay.steps());
    REQUIRE(replay.world().hash() == hash);
    return steps;
}

std::string refusal(const Bytes& bytes) {
    try {
        Replay replay(bytes);
        while (replay.step()) {
        }
    } catch (const std::invalid_argument& refused) {
        return refused.what();
    }
    return "it was taken";
}

/// A recording of a heap with edits and callbacks.
Bytes some_recording() {
    Bytes bytes;
    World world;
    Things things = make_things(world);
    world.start_recording(into(bytes));
    world.set_before_solve([](ContactEdit& edit) { edit.friction = 0.1f; });
    for (int i = 0; i < 6; ++i) {
        add_ball(world, {float(i), 9});
        world.step(frame);
    }
    return bytes;
}

struct ChunkAt {
    size_t header;
    detail::ChunkHeader chunk;
};

std::vector<ChunkAt> chunks_in(const Bytes& bytes) {
    std::vector<ChunkAt> found;
    for (size_t at = sizeof(detail::RecordingHeader); at < bytes.size();) {
        ChunkAt chunk = {at, {}};
        std::memcpy(&chunk.chunk, &bytes[at], sizeof chunk.chunk);
        at += sizeof chunk.chunk + chunk.chunk.size;
        found.push_back(chunk);
    }
    return found;
}

/// Makes the checksums of all chunks right.
void seal_again(Bytes& bytes) {
    uint64_t number = 0;
    for (ChunkAt& each : chunks_in(bytes)) {
        const auto content = std::span<const std::byte>(bytes).subspan(
            each.header + sizeof each.chunk, each.chunk.size);
        each.chunk = detail::chunk_header(each.chunk.kind, number++, content);
        std::memcpy(&bytes[each.header], &each.chunk, sizeof each.chunk);
    }
}

}  // namespace

TEST_CASE("a recorded heap with edits of every kind is replayed bit for bit") {
    Bytes bytes;
    World world;
    Things things = make_things(world);
    world.start_recording(into(bytes));
    REQUIRE(world.is_recorded());
    int steps = 0;
    const auto step = [&] {
        world.step(frame);
        ++steps;
    };
    for (int i = 0; i < 20; ++i) step();
    size_t made = 0;
    for (const Method& method : every_method()) {
        const bool ends = method.name == "World::step" || method.name == "World::clear" ||
                          method.name == "World::restore" || method.name == "World::take" ||
                          method.name.ends_with("_recording") || method.name.ends_with("::destroy");
        if (!method.edits || ends) continue;
        try {
            method.call(things);
        } catch (const std::invalid_argument&) {  // no longer what it was after the edits before
        }
        ++made;
        step();
    }
    REQUIRE(made > 150);
    for (const char* last : {"World::restore", "World::clear"})
        for (const Method& method : every_method())
            if (method.name == last) {
                method.call(things);
                add_box(world, {0, 3});
                step();
            }
    world.stop_recording();
    REQUIRE_FALSE(world.is_recorded());
    REQUIRE(replayed(bytes, world.hash()) == uint64_t(steps));
}

TEST_CASE("the answers of callbacks are recorded") {
    for (const int threads : {1, 3}) {
        Bytes bytes;
        World world;
        world.set_threads(threads);
        add_floor(world);
        for (int i = 0; i < 40; ++i)
            add_box(world, {0.4f * float(i % 5), 0.5f + 1.1f * float(i / 5)}, 1.0f);
        int callback_calls = 0;
        world.set_filter([&](const Shape&, const Shape&) { return ++callback_calls % 7 != 0; });
        world.set_mixing(
            [&](ContactEdit& edit) { edit.friction = float(++callback_calls % 5) * 0.2f; });
        world.set_before_solve([&](ContactEdit& edit) {
            edit.enabled = ++callback_calls % 11 != 0;
            edit.ignored = callback_calls % 97 == 0;
            if (callback_calls % 3 == 0) edit.restitution = 0.5f;
        });
        world.start_recording(into(bytes));
        const auto moved = [&](VelocityEdit& edit) {
            edit.velocity.x = float(++callback_calls % 4);
        };
        Body pushed = world.bodies()[7];
        pushed.set_velocity_function(moved);
        world.bodies()[9].set_position_function([&](PositionEdit& edit) {
            if (++callback_calls % 5 == 0) edit.pose.position.x += 0.01f;
        });
        run(world, 0.5f);
        world.set_mixing({});
        pushed.set_velocity_function({});
        run(world, 0.5f);
        REQUIRE(callback_calls > 500);
        REQUIRE(replayed(bytes, world.hash()) == 60);
    }
}

TEST_CASE("a replay of a world with a filter can be checked while it runs and after it") {
    Bytes bytes;
    World world;
    add_floor(world);
    add_box(world, {0, 0.5f});
    add_box(world, {0.3f, 0.5f});
    world.set_filter([](const Shape& a, const Shape& b) {
        return a.body().type() != b.body().type();  // the boxes overlap
    });
    run(world, 0.1f);
    world.start_recording(into(bytes));
    run(world, 0.5f);
    add_box(world, {0.5f, 0.5f});
    run(world, 0.5f);
    std::string faults;
    set_failure_function([](void* user, const World&,
                            const char* what) { *static_cast<std::string*>(user) += what; },
                         &faults);
    Replay replay(bytes);
    uint64_t same = 0;
    while (const auto step = replay.step()) same += step->same;
    set_failure_function(nullptr, nullptr);
    REQUIRE(faults.empty());
    REQUIRE(same == 60);
    REQUIRE_FALSE(replay.world().validate());
    REQUIRE(replay.world().hash() == world.hash());
}

TEST_CASE("callbacks that throw are replayed as callbacks that gave no answer") {
    Bytes bytes;
    World world;
    Things things = make_things(world);
    int callback_calls = 0;
    world.set_before_solve([&](ContactEdit& edit) {
        edit.friction = 0.9f;
        if (++callback_calls % 13 == 0) throw std::runtime_error("a fault of the host");
    });
    things.body.set_velocity_function([&](VelocityEdit& edit) {
        edit.velocity = {};
        if (++callback_calls % 3 == 0) throw std::runtime_error("another");
    });
    world.start_recording(into(bytes));
    int thrown = 0;
    for (int i = 0; i < 40; ++i) {
        try {
            world.step(frame);
        } catch (const std::runtime_error&) {
            ++thrown;
        }
    }
    REQUIRE(thrown > 10);
    REQUIRE(replayed(bytes, world.hash()) == 40);
}

TEST_CASE("a replay names the calls before each step and its world can be read") {
    Bytes bytes;
    World world;
    Body ball = add_ball(world, {0, 5});
    world.start_recording(into(bytes));
    world.step(frame);
    for (int i = 0; i < 3; ++i) ball.set_velocity({1, float(i)});
    world.create_body();
    world.step(frame);
    HostAccess::write_velocity(world, ball.index(), {4, 4});
    world.step(2 * frame);
    Replay replay(bytes);
    REQUIRE(replay.steps() == 3);
    REQUIRE(replay.world().bodies().size() == 1);
    REQUIRE(replay.step()->calls.empty());
    const auto second = replay.step();
    REQUIRE(second->calls == "Body::set_velocity 3, World::create_body");
    REQUIRE(second->dt == frame);
    REQUIRE(replay.world().bodies().size() == 2);
    const auto third = replay.step();
    REQUIRE(third->calls.empty());  // written by slot: the effect is recorded, and no name
    REQUIRE(third->dt == 2 * frame);
    REQUIRE(HostAccess::state(replay.world(), ball.index()).velocity.x == 4.0f);
    REQUIRE_FALSE(replay.step());
    World copy = replay.world().clone();
    copy.step(frame);
    world.step(frame);
    REQUIRE(copy.hash() == world.hash());
}

TEST_CASE("a step that differs is found and ends the replay") {
    Bytes bytes = some_recording();
    auto chunks = chunks_in(bytes);
    size_t results = 0;
    for (const ChunkAt& each : chunks) {
        if (each.chunk.kind != detail::ChunkKind::result || results++ != 2) continue;
        bytes[each.header + sizeof each.chunk] ^= std::byte(1);  // the hash
    }
    seal_again(bytes);
    Replay replay(bytes);
    REQUIRE(replay.step()->same);
    REQUIRE(replay.step()->same);
    const auto third = replay.step();
    REQUIRE_FALSE(third->same);
    REQUIRE(third->recorded_hash);
    REQUIRE(third->hash != third->recorded_hash);
    REQUIRE_FALSE(replay.step());
}

TEST_CASE("a recording that ends inside a step is replayed up to that step") {
    Bytes bytes;
    World world;
    add_floor(world);
    add_box(world, {0, 1});
    world.start_recording(into(bytes));
    world.step(frame);
    Bytes whole;
    world.set_before_solve([&](ContactEdit&) { whole = bytes; });
    for (int i = 0; i < 60 && whole.empty(); ++i) world.step(frame);
    REQUIRE_FALSE(whole.empty());
    Replay replay(whole);
    std::optional<ReplayedStep> last;
    while (const auto step = replay.step()) last = step;
    REQUIRE(last->number + 1 == replay.steps());
    REQUIRE_FALSE(last->recorded_hash);
    REQUIRE(last->same);
}

TEST_CASE("a world is recorded once at a time and not in its copies") {
    Bytes bytes, other;
    World world;
    world.start_recording(into(bytes));
    REQUIRE_THROWS_WITH(world.start_recording(into(other)), contains("recorded already"));
    REQUIRE_THROWS_WITH(world.start_recording({}), contains("expected a function"));
    World copy = world.clone();
    REQUIRE_FALSE(copy.is_recorded());
    world.restore(copy);
    REQUIRE(world.is_recorded());
    World moved = std::move(world);
    REQUIRE(moved.is_recorded());
    REQUIRE_FALSE(world.is_recorded());
    add_ball(moved, {0, 1});
    moved.step(frame);
    moved.stop_recording();
    moved.stop_recording();
    REQUIRE(replayed(bytes, moved.hash()) == 1);
    REQUIRE(other.empty());
}

TEST_CASE("a sink that throws ends the recording and the step is complete") {
    World world;
    add_ball(world, {0, 5});
    REQUIRE_THROWS_WITH(world.start_recording([](auto) { throw std::runtime_error("no disk"); }),
                        "no disk");
    REQUIRE_FALSE(world.is_recorded());
    for (const int fatal : {2, 3}) {
        int calls = 0;
        world.start_recording([&](std::span<const std::byte>) {
            if (++calls == fatal) throw std::runtime_error("the disk is full");
        });
        const uint64_t steps = world.statistics().steps;
        REQUIRE_THROWS_WITH(world.step(frame), contains("the disk is full"));
        REQUIRE(world.statistics().steps == steps + 1);
        REQUIRE_FALSE(world.is_recorded());
        REQUIRE_FALSE(world.locked());
        world.step(frame);
    }
    REQUIRE_FALSE(world.validate());
}

TEST_CASE("recording changes no result") {
    World plain, recorded;
    Bytes bytes;
    for (World* world : {&plain, &recorded}) make_things(*world);
    recorded.start_recording(into(bytes));
    run(plain, 1.0f);
    run(recorded, 1.0f);
    REQUIRE(plain.hash() == recorded.hash());
}

TEST_CASE("recordings of edits of one body are small") {
    Bytes bytes;
    World world;
    add_floor(world);
    for (int i = 0; i < 300; ++i) add_box(world, {float(i % 40) * 1.1f, 0.5f + float(i / 40)});
    world.step(frame);
    Bytes state;
    world.save(state);
    world.start_recording(into(bytes));
    const size_t begin = bytes.size();
    for (int i = 0; i < 10; ++i) {
        world.bodies()[5].set_velocity({1, 0});
        add_ball(world, {0, 20.0f + 2.0f * float(i)});
        world.step(frame);
    }
    REQUIRE(bytes.size() - begin < 10 * state.size() / 10);
    REQUIRE(replayed(bytes, world.hash()) == 10);
}

TEST_CASE("a recording with any byte changed is refused with a reason") {
    const Bytes bytes = some_recording();
    REQUIRE(refusal(bytes) == "it was taken");
    size_t taken = 0;
    for (size_t at = 0; at < bytes.size(); at += at < 1000 ? 1 : 37) {
        Bytes damaged = bytes;
        damaged[at] ^= std::byte(1 << at % 8);
        taken += refusal(damaged) == "it was taken";
    }
    REQUIRE(taken == 0);
    REQUIRE_THAT(refusal({}), contains("not a recording"));
    REQUIRE_THAT(refusal(Bytes(5000)), contains("not a recording"));
    Bytes newer = bytes;
    newer[4] = std::byte(9);
    REQUIRE_THAT(refusal(newer), contains("another version"));
    REQUIRE_THAT(refusal(newer), contains("in format 9: expected format "));
    Bytes precise = bytes;
    const bool is_single = sizeof(Position) == sizeof(Vec2);
    precise[8] = std::byte(is_single ? 8 : 4);
    REQUIRE_THAT(refusal(precise), contains(is_single ? "made with positions in double precision"
                                                      : "made with positions in single precision"));
    precise[8] = std::byte(3);
    REQUIRE_THAT(refusal(precise), contains("its header differs"));
    Bytes flipped = bytes;
    flipped[bytes.size() - 1] ^= std::byte(4);
    REQUIRE_THAT(refusal(flipped), contains("checksum"));
}

TEST_CASE("a recording that ends within a part is replayed up to the part before") {
    const Bytes bytes = some_recording();
    const auto chunks = chunks_in(bytes);
    const size_t state_ends = chunks.at(1).header;
    for (size_t size = 0; size < bytes.size(); size += size < state_ends ? 91
                                                       : thorough()      ? 7
                                                                         : 37) {
        const Bytes cut(bytes.begin(), bytes.begin() + std::ptrdiff_t(size));
        if (size < state_ends) {
            REQUIRE(refusal(cut) != "it was taken");
            continue;
        }
        uint64_t whole_steps = 0;
        bool between = false;  // two chunks
        for (size_t i = 0; i < chunks.size(); ++i) {
            const size_t end = chunks[i].header + sizeof chunks[i].chunk + chunks[i].chunk.size;
            whole_steps += end <= size && chunks[i].chunk.kind == detail::ChunkKind::step;
            between |= end == size;
        }
        Replay replay(cut);
        REQUIRE(replay.is_cut_off() == !between);
        REQUIRE(replay.steps() == whole_steps);
        uint64_t repeated = 0;
        while (const auto step = replay.step()) {
            REQUIRE(step->same);
            ++repeated;
        }
        REQUIRE(repeated == whole_steps);
    }
    REQUIRE_FALSE(Replay(bytes).is_cut_off());
    Bytes longer = bytes;
    longer.push_back(std::byte(0));
    REQUIRE(Replay(longer).is_cut_off());
}

TEST_CASE("a damaged recording with valid checksums is refused or replayed without harm") {
    const Bytes bytes = some_recording();
    const auto chunks = chunks_in(bytes);
    uint64_t state = 77;
    const auto next = [&state] {
        return (state = state * 6364136223846793005u + 1442695040888963407u) >> 20;
    };
    int refused = 0, differ = 0;
    for (int trial = 0; trial < 300; ++trial) {
        Bytes damaged = bytes;
        for (int flips = 0; flips < 2; ++flips) {
            const ChunkAt& chunk = chunks[1 + next() % (chunks.size() - 1)];
            if (chunk.chunk.size == 0) continue;
            // The first bytes of a chunk are counts and sizes.
            const uint64_t reach =
                next() % 2 == 0 ? std::min<uint64_t>(chunk.chunk.size, 64) : chunk.chunk.size;
            damaged[chunk.header + sizeof chunk.chunk + next() % reach] ^=
                std::byte(1 << next() % 8);
        }
        seal_again(damaged);
        try {
            Replay replay(damaged);
            while (const auto step = replay.step()) differ += !step->same;
        } catch (const std::invalid_argument&) {
            ++refused;
        }
    }
    REQUIRE(refused > 0);
    REQUIRE(differ > 0);
}

TEST_CASE("shapes of several parts that are made and destroyed in a recording are replayed") {
    const bool before = GENERATE(false, true);
    const int between = GENERATE(0, 1, 3);
    Bytes bytes;
    World world;
    Body ground = world.create_body({.type = BodyType::static_body});
    Shape chain;
    if (before) chain = ground.add(Chain{.points = {{-9, 0}, {0, -1}, {9, 0}}});
    world.start_recording(into(bytes));
    world.step(frame);
    if (!before) chain = ground.add(Chain{.points = {{-9, 0}, {0, -1}, {9, 0}}});
    Body star = world.create_body({.position = {0, 1}});
    Shape concave = star.add(Concave{.vertices = {{-1, -1}, {1, -1}, {1, 1}, {0, 0}, {-1, 1}}});
    for (int i = 0; i < between; ++i) world.step(frame);
    chain.destroy();
    concave.set_geometry(Circle{});
    world.step(frame);
    star.destroy();
    ground.add(Chain{.points = {{-9, 0}, {9, 0}}});
    world.step(frame);
    world.stop_recording();
    CHECK(replayed(bytes, world.hash()) == uint64_t(3 + between));
}

TEST_CASE("a replay that was moved away refuses every call until it is assigned to") {
    Bytes bytes;
    World world;
    world.start_recording(into(bytes));
    world.step(frame);
    world.stop_recording();
    Replay from(bytes);
    Replay to = std::move(from);
    const auto moved = contains("was moved to another one");
    CHECK_THROWS_WITH(from.steps(), moved);
    CHECK_THROWS_WITH(from.world(), moved);
    CHECK_THROWS_WITH(from.step(), moved);
    from = std::move(to);
    CHECK(from.steps() == 1);
    CHECK(from.step()->same);
}

}  // namespace recording_test
