// Snapshots of a tree with physics: restored in place, with the same handles and the same bits.

#include <cstring>
#include <string>
#include <vector>

#include "catch.h"
#include "game.h"

#include <saving/checksum.h>

namespace snapshot_test {

using namespace fettle::physics_module::testing;
namespace property = fettle::property;

namespace {

void pile(Game& game, int count) {
    game.floor();
    const char* const shapes[] = {"Box", "Circle", "Polygon", "Capsule"};
    for (int i = 0; i < count; ++i) {
        const Handle body = game.body(shapes[i % 4], Vec2(0.9 * (i % 8) - 3.5, 1 + 1.1 * (i / 8)));
        if (i % 5 == 0) game.make("Circle", body, {{"radius", 0.3}, {"center", Vec2(0.5, 0)}});
    }
}

void seal_worlds(std::vector<std::byte>& bytes) {
    using fettle::physics::detail::SavedHeader;
    SavedHeader header;
    for (std::size_t at = 0; at + sizeof header <= bytes.size(); ++at) {
        std::memcpy(&header, &bytes[at], sizeof header);
        if (header.magic != 0x77546546 || header.size > bytes.size() - at) continue;
        fettle::physics::detail::write_checksum(std::span(bytes).subspan(at, header.size));
        at += header.size - 1;
    }
}

std::vector<std::uint64_t> hashes(Game& game, int steps) {
    std::vector<std::uint64_t> all;
    for (int i = 0; i < steps; ++i) {
        game.step();
        all.push_back(game.physics.hash());
    }
    return all;
}

}  // namespace

TEST_CASE("a restored game continues bit for bit") {
    Game game;
    pile(game, 40);
    const Handle drum = game.body("Box", Vec2(8, 5));
    game.make("RevoluteJoint", game.world(),
              {{"body_b", drum},
               {"motor_speed", 3},
               {"max_motor_torque", 1e5},
               {"anchor_a", Vec2(8, 5)}});
    game.step(60);
    const property::Snapshot snapshot = game.tree.snapshot();
    const auto expected = hashes(game, 150);
    game.tree.restore(snapshot);
    REQUIRE(hashes(game, 150) == expected);
    game.tree.restore(property::Snapshot::from_bytes(snapshot.to_bytes()));
    REQUIRE(hashes(game, 150) == expected);
}

TEST_CASE("bodies deleted and made since a snapshot do not disturb a restore") {
    Game game;
    pile(game, 30);
    game.step(30);
    const Handle ball = game.body("Circle", Vec2(0, 20));
    const Handle shape = game.shape_of(ball);
    const property::Snapshot snapshot = game.tree.snapshot();
    const auto expected = hashes(game, 120);

    game.tree.destroy(ball);
    const Handle other = game.body("Box", Vec2(0, 30));
    const Handle world = game.make("World", game.tree.root(), "second");
    const Handle inside = game.make("Body", world);
    game.tree.destroy(game.tree.children(game.world())[4]);
    game.set(game.world(), "gravity", Vec2(4, 0));
    game.step(20);
    game.tree.restore(snapshot);
    for (const Handle gone : {other, world, inside}) REQUIRE_FALSE(game.tree.alive(gone));
    REQUIRE(game.y(ball) == 20.0);
    REQUIRE(game.get(shape, "radius") == Value(0.5));
    REQUIRE(hashes(game, 120) == expected);
    // The instance and the simulated body still belong together: an edit of the instance moves the
    // body.
    game.set(ball, "position", Vec2(3, 40));
    game.step();
    REQUIRE(game.physics.body(ball).position().y > 39);
}

TEST_CASE("a world deleted since a snapshot is restored with its contents") {
    Game game;
    const Handle world = game.make("World", game.tree.root(), "second");
    const Handle body = game.make("Body", world, {{"position", Vec2(1, 2)}});
    game.make("Circle", body);
    game.step(5);
    const double y = game.y(body);
    const property::Snapshot snapshot = game.tree.snapshot();
    game.tree.destroy(world);
    game.step(5);
    game.tree.restore(snapshot);
    REQUIRE(game.y(body) == y);
    game.step(5);
    REQUIRE(game.y(body) < y);
}

TEST_CASE("detached bodies and colors and looks are part of a snapshot") {
    Game game;
    const Handle body = game.body("Box", Vec2(0, 5));
    const Handle loose = game.make("Body", {}, {{"velocity", Vec2(3, 0)}});
    const Value red(property::Color{1, 0, 0, 1});
    game.set(game.shape_of(body), "color", red);
    game.set(body, "color", red);
    const property::Snapshot snapshot = game.tree.snapshot();
    game.set(game.shape_of(body), "color", Value());
    game.set(body, "color", Value());
    game.set(loose, "velocity", Vec2(0, 0));
    game.tree.restore(snapshot);
    REQUIRE(game.get(game.shape_of(body), "color") == red);
    REQUIRE(game.get(body, "color") == red);
    game.make("Circle", loose);
    game.tree.move(loose, game.world());
    REQUIRE(game.vec(loose, "velocity") == Vec2(3, 0));
}

TEST_CASE("watchers of a simulated property are notified of the restore") {
    Game game;
    const Handle ball = game.body("Circle", Vec2(0, 20));
    const property::Snapshot snapshot = game.tree.snapshot();
    std::vector<std::string> reported;
    game.tree.watch(ball, "position", [&](const property::Change& change) {
        reported.push_back(std::string(property::writer_name(change.cause.writer)));
    });
    game.step(3);
    reported.clear();
    game.tree.restore(snapshot);
    game.tree.barrier();
    REQUIRE(reported == std::vector<std::string>{"restore"});
    game.step();
    REQUIRE(reported == std::vector<std::string>{"restore", "simulation"});
}

TEST_CASE("damaged physics in a snapshot is refused and nothing changes") {
    Game game;
    pile(game, 12);
    game.step(40);
    const property::Snapshot snapshot = game.tree.snapshot();
    game.step(10);
    const std::uint64_t before = game.physics.hash();
    const auto payload = snapshot.payload();
    int refused = 0;
    for (std::size_t size = 0; size < payload.size(); size += 997) {
        const auto part = payload.first(size);
        REQUIRE_THROWS_AS(game.tree.restore(property::Snapshot({part.begin(), part.end()}, {})),
                          property::Error);
        ++refused;
    }
    REQUIRE(refused > 10);
    REQUIRE(game.physics.hash() == before);
}

TEST_CASE("a tree without physics refuses a snapshot with physics") {
    Game game;
    const property::Snapshot snapshot = game.tree.snapshot();
    Tree other;
    REQUIRE_THROWS_AS(other.restore(snapshot), property::Error);
}

TEST_CASE("joints of every type and fields continue bit for bit in a restored game") {
    Game game;
    game.floor();
    std::vector<Handle> joints;
    double x = -12;
    for (const char* of : {"DistanceJoint", "RevoluteJoint", "PrismaticJoint", "WheelJoint",
                           "WeldJoint", "MotorJoint", "PulleyJoint", "GearJoint", "GrooveJoint",
                           "PinSlotJoint", "RatchetJoint", "FilterJoint", "RotaryLimitJoint"}) {
        const Handle a = game.body("Box", Vec2(x, 3)), b = game.body("Circle", Vec2(x + 1, 4));
        joints.push_back(game.make(of, game.world(), {{"body_a", a}, {"body_b", b}}));
        game.set(b, "angular_velocity", 3);
        x += 2.5;
    }
    game.set(joints[4], "break_force", 40);
    game.set(joints[10], "tooth", 0.3);
    const Handle water = game.make("Buoyancy", game.world(), {{"level", 1}, {"density", 3}});
    game.make("Wind", game.world());
    game.step(20);
    const property::Snapshot snapshot = game.tree.snapshot();
    const auto expected = hashes(game, 200);
    const bool broken = game.get(joints[4], "broken").boolean();

    game.tree.destroy(joints[2]);
    game.set(joints[4], "broken", !broken);
    game.set(water, "density", 9);
    game.make("Attractor", game.world(), {{"strength", 50}});
    game.step(10);
    game.tree.destroy(water);
    game.step(10);
    game.tree.restore(snapshot);
    REQUIRE(game.tree.alive(water));
    REQUIRE(game.get(water, "density") == Value(3.0));
    REQUIRE(game.tree.alive(joints[2]));
    REQUIRE(hashes(game, 200) == expected);
    REQUIRE(game.get(joints[4], "broken") == Value(broken));
    REQUIRE_FALSE(game.physics.world(game.world()).validate());
}

TEST_CASE("a snapshot in which an instance has the row of another object is refused") {
    Game game;
    pile(game, 40);
    const Handle body = game.body("Polygon", Vec2(8, 5));
    const Handle wind = game.make("Wind", game.world());
    // The last of many joints, so that no other object has the same number.
    Handle joint;
    for (int i = 0; i < 100; ++i)
        joint = game.make("RevoluteJoint", game.world(), {{"body_b", body}, {"enabled", false}});
    game.step(10);
    const property::Snapshot snapshot = game.tree.snapshot();
    const auto expected = hashes(game, 20);
    /// Changes every occurrence of the number, one at a time. `sealed`: the checksums of the saved
    /// worlds are corrected.
    const auto with = [&](std::uint32_t was, std::uint32_t now,
                          const char* because = "a row that is not its own", bool sealed = false) {
        int refused = 0;
        for (std::size_t at = 0; at + sizeof was <= snapshot.payload().size(); ++at) {
            if (std::memcmp(&snapshot.payload()[at], &was, sizeof was) != 0) continue;
            std::vector<std::byte> bytes(snapshot.payload().begin(), snapshot.payload().end());
            std::memcpy(&bytes[at], &now, sizeof now);
            if (sealed) seal_worlds(bytes);
            try {
                game.tree.restore(property::Snapshot(std::move(bytes), snapshot.memories()));
            } catch (const property::Error& error) {
                refused += std::string(error.what()).find(because) != std::string::npos;
            }
        }
        return refused;
    };
    const property::Row row = game.tree.row(body), shape = game.tree.row(game.shape_of(body));
    CHECK(with(row, row + 1000) >= 1);        // no object
    CHECK(with(row, row + (7u << 24)) >= 1);  // an object of a world that does not exist
    CHECK(with(row, row - 1) >= 1);           // the object of another instance
    CHECK(with(shape, shape + 1000) >= 1);
    CHECK(with(shape, shape - 1) >= 1);
    CHECK(with(game.tree.row(wind), game.tree.row(wind) + 1) >= 1);
    CHECK(with(game.tree.row(joint), 77) >= 1);
    CHECK(with(body.index, wind.index, "a joint that ties no body") >= 1);
    CHECK(with(joint.index, body.index, "a RevoluteJoint has a row that is not its own", true) >=
          1);
    game.tree.restore(snapshot);
    CHECK(hashes(game, 20) == expected);
}

}  // namespace snapshot_test
