#include <fettle/physics/recording.h>

#include "every_method.h"
#include "saved_worlds.h"
#include "thorough.h"

namespace checksum_test {

// Saved worlds have a checksum: no byte of one can change, be missing or be added unnoticed.

using namespace scenes;

namespace {

/// Small worlds that together contain every kind of object.
std::vector<std::vector<std::byte>> several() {
    std::vector<std::vector<std::byte>> all;
    World empty({.gravity = {0, 0}});
    all.push_back(saved(empty));
    World one;
    add_ball(one, {0, 1});
    all.push_back(saved(one));
    World shapes({.bounds = Aabb{{-9, -9}, {9, 9}}});
    Body body = shapes.create_body();
    for (const Geometry& geometry : {Geometry(Circle{}), Geometry(Box{}), Geometry(Segment{}),
                                     Geometry(Ellipse{}), Geometry(Polygon{.vertices = triangle()}),
                                     Geometry(Concave{{{0, 0}, {2, 0}, {2, 2}, {1, 0.5f}}}),
                                     Geometry(Chain{.points = {{-3, 0}, {0, 1}, {3, 0}}})})
        body.add(geometry);
    shapes.step(frame);
    all.push_back(saved(shapes));
    World things;
    make_things(things);
    things.step(frame);
    all.push_back(saved(things));
    return all;
}

bool is_refused(World& target, std::span<const std::byte> bytes) {
    try {
        target.restore(bytes);
    } catch (const std::invalid_argument&) {
        return true;
    }
    return false;
}

}  // namespace

TEST_CASE(
    "a world saved by a library with the other precision of positions is refused with the reason") {
    World target;
    auto bytes = several().back();
    detail::SavedHeader header;
    std::memcpy(&header, bytes.data(), sizeof header);
    const bool is_single = sizeof(Position) == sizeof(Vec2);
    REQUIRE(header.coordinate == (is_single ? 4 : 8));
    header.coordinate = is_single ? 8 : 4;
    header.records ^= 1;
    std::memcpy(bytes.data(), &header, sizeof header);
    const std::string saved_with = is_single ? "double" : "single";
    REQUIRE_THROWS_WITH(target.restore(bytes), contains("saved with positions in " + saved_with));
}

TEST_CASE("a world saved by another version is refused with what differs") {
    World target;
    const auto bytes = several().back();
    const auto refused = [&](auto change, const char* reason) {
        auto other = bytes;
        detail::SavedHeader header;
        std::memcpy(&header, other.data(), sizeof header);
        change(header);
        std::memcpy(other.data(), &header, sizeof header);
        REQUIRE_THROWS_WITH(target.restore(other), contains(reason));
    };
    using detail::SavedHeader;
    refused([](SavedHeader& header) { header.version = 3; }, "in format 3: expected format ");
    refused([](SavedHeader& header) { header.records ^= 1; }, "records have other fields");
    refused([](SavedHeader& header) { header.coordinate = 0x04000000; }, "other fields");
    refused([](SavedHeader& header) { header.magic = 1; }, "not a saved world");
}

TEST_CASE("a saved world is the same bytes on every machine") {
    // Not what memory holds: the lowest byte first, and no gaps between the fields.
    World world({.gravity = {1.5f, -10}, .substeps = 5});
    const auto bytes = saved(world);
    const auto starts_with = [&](size_t at, std::initializer_list<int> expected) {
        for (const int byte : expected) REQUIRE(int(bytes[at++]) == byte);
    };
    starts_with(0, {'F', 'e', 'T', 'w'});
    const size_t coordinate = sizeof(WorldCoordinate);
    starts_with(12, {int(coordinate), 0, 0, 0, int(bytes.size() & 0xff), int(bytes.size() >> 8)});
    starts_with(32, {0, 0, 0xc0, 0x3f, 0, 0, 0x20, 0xc1, 5, 0, 0, 0, 0});  // no bounds
    // Then four coordinates of the bounds, two numbers, two flags and the first number after them.
    starts_with(45 + 4 * coordinate + 8, {1, 1, 0, 0, 0x80, 0x3f});
    REQUIRE(detail::encoded_size<BodyState>() == 24 + 2 * coordinate);
    REQUIRE(detail::encoded_size<detail::ShapeForm>() == 28 + 2 * coordinate);
}

TEST_CASE("a copy and a replay with the same history are saved as the same bytes") {
    World world;
    make_things(world);
    for (int i = 0; i < 30; ++i) world.step(frame);
    World copy = world.clone();
    World restored;
    restored.restore(saved(world));
    std::vector<std::byte> recorded;
    world.start_recording(
        [&](auto more) { recorded.insert(recorded.end(), more.begin(), more.end()); });
    for (int i = 0; i < 60; ++i)
        for (World* each : {&world, &copy, &restored}) each->step(frame);
    REQUIRE(world.statistics().total_ms > 0);  // which is not saved
    REQUIRE((saved(copy) == saved(world)));
    REQUIRE((saved(restored) == saved(world)));
    Replay replay(recorded);
    while (replay.step()) {
    }
    REQUIRE((saved(replay.world()) == saved(world)));
    restored.restore(saved(world));
    REQUIRE(restored.statistics().steps == 90);
    REQUIRE(restored.statistics().total_ms == 0);
}

TEST_CASE("encoded records are read as they were written") {
    using namespace fettle::physics::detail;
    const auto again = [](const auto& record) {
        std::vector<std::byte> bytes(encoded_size<std::remove_cvref_t<decltype(record)>>());
        Encoder{bytes.data()}(record);
        std::remove_cvref_t<decltype(record)> read;
        Decoder{bytes.data()}(read);
        return read;
    };
    BodyRecord body;
    body.mobility = Mobility::dynamic;
    body.listed = 1;
    body.flags.locked_rotation = true;
    REQUIRE(again(body).mobility == Mobility::dynamic);
    REQUIRE(again(body).listed == 1);
    REQUIRE(again(body).flags.locked_rotation);
    REQUIRE_FALSE(is_given(again(body).given.mass));
    ShapeForm form;
    form.count = 0xabcdef;
    form.kind = FormKind::piece;
    REQUIRE(again(form).count == 0xabcdef);
    REQUIRE(again(form).kind == FormKind::piece);
    FieldDef field = {.force = BuoyancyField{.level = 3, .drag = 7},
                      .region = Aabb{{1, 2}, {3, 4}}};
    REQUIRE(std::get<BuoyancyField>(again(field).force).drag == 7);
    REQUIRE(again(field).region == field.region);
    REQUIRE_FALSE(again(FieldDef{}).region);
    std::vector<std::byte> bytes(encoded_size<FieldDef>());
    Encoder{bytes.data()}(field);
    bytes[0] = std::byte{4};
    REQUIRE_THROWS_AS(Decoder{bytes.data()}(field), std::invalid_argument);
}

TEST_CASE("a saved world with any byte changed is refused and the world stays as it was") {
    World target;
    add_ball(target, {3, 4});
    const uint64_t before = target.hash();
    const auto all = several();
    REQUIRE(all.back().size() > 20000);
    for (const auto& bytes : all) {
        auto damaged = bytes;
        size_t unnoticed = 0;
        for (size_t at = 0; at < bytes.size(); ++at) {
            if (!is_tested(at, 5)) continue;
            for (const unsigned flip : {0xffu, 1u << (at % 8)}) {
                damaged[at] ^= std::byte(flip);
                unnoticed += !is_refused(target, damaged);
                damaged[at] = bytes[at];
            }
        }
        REQUIRE(unnoticed == 0);
        for (size_t at = 0; at < 64; ++at)  // every bit of the header, and of what follows
            for (int bit = 0; bit < 8; ++bit) {
                damaged[at] ^= std::byte(1 << bit);
                REQUIRE(is_refused(target, damaged));
                damaged[at] = bytes[at];
            }
        REQUIRE(target.hash() == before);
        REQUIRE(target.body_count() == 1);
        World whole;
        REQUIRE_FALSE(is_refused(whole, damaged));
    }
    REQUIRE_FALSE(target.validate());
}

TEST_CASE("a saved world with missing or additional bytes is refused") {
    World target;
    for (const auto& bytes : several()) {
        const std::span all(bytes);
        for (size_t size = 0; size < bytes.size(); ++size)
            if (!is_refused(target, all.first(size))) FAIL("cut off at " << size);
        auto longer = bytes;
        for (const size_t more : {size_t{1}, size_t{7}, size_t{8}, size_t{32}, bytes.size()}) {
            longer.resize(bytes.size() + more);
            REQUIRE(is_refused(target, longer));
        }
    }
}

TEST_CASE("the checksum of a saved world covers the number and the order of its bytes") {
    std::vector<std::byte> zeros;
    std::vector<uint64_t> seen;
    for (size_t size = 0; size < 100; ++size) {
        zeros.assign(size, std::byte{0});
        seen.push_back(detail::checksum(zeros));
        for (size_t at = 0; at < size; ++at) {
            zeros[at] = std::byte{1};
            seen.push_back(detail::checksum(zeros));
            zeros[at] = std::byte{0};
        }
    }
    std::sort(seen.begin(), seen.end());
    REQUIRE(std::adjacent_find(seen.begin(), seen.end()) == seen.end());
    const auto bytes = several().back();
    auto exchanged = bytes;
    std::swap_ranges(exchanged.begin() + 100, exchanged.begin() + 108, exchanged.begin() + 132);
    REQUIRE((exchanged == bytes || detail::checksum(exchanged) != detail::checksum(bytes)));
}

TEST_CASE("a world that is saved after other bytes has a checksum of its own") {
    World world;
    add_ball(world, {0, 5});
    std::vector<std::byte> bytes(13, std::byte{7});
    world.save(bytes);
    World target;
    REQUIRE(is_refused(target, bytes));
    REQUIRE_FALSE(is_refused(target, std::span(bytes).subspan(13)));
    REQUIRE(target.hash() == world.hash());
}

TEST_CASE("flags of a world with a valid checksum are checked before they are read as flags") {
    World world;
    add_floor(world);
    Body ball = add_ball(world, {0, 0.5f});
    world.create_revolute_joint({.body_b = ball.id()});
    world.create_field({.region = Aabb{{-9, -9}, {9, 9}}});
    world.create_field({}).destroy();
    world.step(frame);
    REQUIRE_FALSE(world.contacts().empty());
    const auto bytes = saved(world);
    size_t refused = 0, accepted = 0;
    for (size_t at = sizeof(detail::SavedHeader); at < bytes.size(); ++at) {
        auto damaged = bytes;
        damaged[at] ^= std::byte{16};
        detail::write_checksum(damaged);
        World target;
        if (is_refused(target, damaged)) {
            ++refused;
            continue;
        }
        ++accepted;
        target.step(frame);
    }
    CHECK(refused > 0);
    CHECK(accepted > 0);
}

}  // namespace checksum_test
