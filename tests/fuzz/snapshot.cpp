// The state of a whole game: a true one with some bytes changed. Refused, with nothing changed, or
// restored to a game that can be stepped, looked at and saved again.

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <vector>

#include <fettle/property/error.h>
#include <fettle/property/snapshot.h>
#include <fettle/property/storage/scene.h>
#include <fettle/script/runtime.h>
#include <world/seal.h>

#include "game.h"

using namespace fettle;

namespace {

constexpr const char* script = R"lua(
world.floor = Body { type = "static", Box { width = 20, height = 1 } }
for i = 1, 4 do world["crate" .. i] = Body { position = vec(i / 4, i), Box {} } end
world.hinge = RevoluteJoint { body_a = world.crate1, body_b = world.crate2, anchor = vec(0.4, 1.5) }
world.crate3.spin = formula(function() return world.crate1.angle * 2 end)
every(0.05, function() world.crate4.velocity = vec(random(), 1) end)
)lua";

struct Played : fuzz::Game {
    script::Runtime runtime{tree, script::Options{.assets = {}}};
    double now = 0;

    Played() {
        runtime.on_error([](const script::ScriptError&) {});
        runtime.on_print([](std::string_view) {});
        tree.on_handler_error([](const property::HandlerError&) {});
    }
    void step() {
        constexpr double dt = 1.0 / 60;
        now += dt;
        runtime.step(now, dt);
        tree.barrier();
        module.step(dt);
        tree.set_step(tree.step() + 1);
        tree.stepped();
        tree.barrier();
    }
};

property::Snapshot true_state() {
    Played game;
    if (!game.runtime.run(script, "fuzz")) std::abort();
    for (int i = 0; i < 20; ++i) game.step();
    const property::Snapshot taken = game.tree.snapshot();
    return property::Snapshot({taken.payload().begin(), taken.payload().end()}, {});
}

/// The physics worlds in it have checksums of their own, which would refuse every change to them.
void seal_worlds(const std::vector<std::byte>& before, std::vector<std::byte>& bytes) {
    using physics::detail::SavedHeader;
    SavedHeader header;
    for (std::size_t at = 0; at + sizeof header <= std::min(before.size(), bytes.size()); ++at) {
        std::memcpy(&header, &before[at], sizeof header);
        if (header.byte_order != 0x01020304 || header.size > bytes.size() - at) continue;
        physics::detail::seal(std::span(bytes).subspan(at, header.size));
        at += header.size - 1;
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const property::Snapshot saved = true_state();
    std::vector<std::byte> bytes(saved.payload().begin(), saved.payload().end());
    // Each four bytes: where, and what is there instead.
    for (std::size_t i = 0; i + 3 < size; i += 4) {
        const std::size_t at =
            std::size_t{data[i]} << 16 | std::size_t{data[i + 1]} << 8 | data[i + 2];
        bytes[at % bytes.size()] = static_cast<std::byte>(data[i + 3]);
    }
    if (size % 4 != 2) seal_worlds({saved.payload().begin(), saved.payload().end()}, bytes);
    if (size % 4 == 1) bytes.resize(bytes.size() * data[size - 1] / 256);

    Played game;
    for (int i = 0; i < 2; ++i) game.step();
    const property::Snapshot before = game.tree.snapshot();
    try {
        game.tree.restore(property::Snapshot(std::move(bytes), {}));
    } catch (const property::Error&) {
        const property::Snapshot after = game.tree.snapshot();
        if (!std::ranges::equal(before.payload(), after.payload())) std::abort();
        return 0;
    }
    game.tree.barrier();
    for (int i = 0; i < 3; ++i) {
        try {
            game.step();
        } catch (const property::Error&) {
            // handlers that answer each other for ever
        }
    }
    if (const property::Handle world = game.tree.child(game.tree.root(), "world")) {
        try {
            (void)property::scene_text(game.tree, world);
        } catch (const property::Error&) {
            // what it refers to need not make a scene
        }
    }
    (void)game.tree.snapshot();
    return 0;
}
