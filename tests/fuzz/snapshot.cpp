// A saved game with some changed bytes and a corrected checksum. It is refused and nothing changes,
// or it is restored: then every value is one that a write could have set, and the game can be
// stepped, read, deleted and saved again.

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include <fettle/property/error.h>
#include <fettle/property/snapshot.h>
#include <fettle/property/storage/scene.h>
#include <fettle/script/runtime.h>
#include <saving/checksum.h>

#include "game.h"

using namespace fettle;

namespace {

constexpr const char* script = R"lua(
Ball = class("Ball", Body) { lives = 3, ratio = 0.5, label = "ball", at = vec(1, 2), target = Body }
function Ball:step(dt) self.lives = self.lives + 1 end
Plan = class("Plan") { open = true, tint = color("red"), list = {1, 2, 3} }
world.floor = Body { type = "static", Box { width = 20, height = 1 } }
for i = 1, 4 do world["crate" .. i] = Body { position = vec(i / 4, i), Box {} } end
world.hero = Ball { position = vec(-2, 1), Circle {}, target = world.crate1 }
world.walker = Mover { position = vec(3, 0.6), walk = 1, Circle {} }
world.plan = Plan {}
world.odd = Body { position = vec(-4, 2), Polygon {}, Ellipse {}, Capsule {}, Segment {} }
world.cut = Body { position = vec(-6, 2), Concave {} }
world.rail = Body { type = "static", Chain { points = { vec(-9, 0), vec(-8, 1), vec(-9, 2) }, closed = true } }
for i, class in ipairs { DistanceJoint, RevoluteJoint, PrismaticJoint, WheelJoint, WeldJoint, MotorJoint,
                         PulleyJoint, GearJoint, GrooveJoint, PinSlotJoint, RatchetJoint } do
    local a = Body { position = vec(3 * i, 4), Circle { radius = 0.3 } }
    local b = Body { position = vec(3 * i + 1, 4), Circle { radius = 0.3 } }
    world:add(a) world:add(b) world:add(class { body_a = a, body_b = b })
end
world.mouse = MouseJoint { body = world.crate4, target = vec(1, 5) }
for _, class in ipairs { Wind, Drag, Buoyancy, Attractor } do world:add(class {}) end
world.crate3.spin = formula(function() return world.crate1.angle * 2 end)
world.plan.notes = { "one", 2, vec(3, 4), world.hero }
loose = Body { velocity = vec(1, 1), Circle {} }
every(0.05, function()
    if world:has("crate4") then world.crate4.velocity = vec(random(), 1) end
end)
)lua";

struct ScriptedGame : fuzz::Game {
    script::Runtime runtime{tree, script::Options{.assets = {}}};
    double now = 0;

    ScriptedGame() {
        runtime.on_error([](const script::ScriptError&) {});
        runtime.on_print([](std::string_view) {});
        tree.on_handler_error([](const property::HandlerError&) {});
        // Keeps the classes of the game; deletes the other objects of the script.
        (void)runtime.run(script, "fuzz");
    }
    void step() {
        constexpr double dt = 1.0 / 60;
        now += dt;
        runtime.step(now, dt);
        tree.barrier();
        module.step(dt);
        module.report(tree);
        tree.set_step(tree.step() + 1);
        tree.stepped();
        tree.barrier();
    }
};

std::vector<std::byte> valid_save() {
    ScriptedGame game;
    for (int i = 0; i < 20; ++i) game.step();
    return game.tree.snapshot().to_bytes();
}

/// Bit patterns with a special meaning in one of the encodings of the state.
std::uint32_t odd_number(std::uint8_t which) {
    constexpr float inf = std::numeric_limits<float>::infinity();
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    const std::uint32_t numbers[] = {0,
                                     1,
                                     2,
                                     3,
                                     4,
                                     5,
                                     0xffffffffu,
                                     0x7fffffffu,
                                     1u << 24,
                                     1u << 31,
                                     std::bit_cast<std::uint32_t>(inf),
                                     std::bit_cast<std::uint32_t>(-inf),
                                     std::bit_cast<std::uint32_t>(nan),
                                     std::bit_cast<std::uint32_t>(-1.0f),
                                     std::bit_cast<std::uint32_t>(1e30f),
                                     std::bit_cast<std::uint32_t>(3e38f)};
    return numbers[which % std::size(numbers)];
}

/// Each five bytes of the input are one change: its place, its kind and its value.
void change(std::vector<std::byte>& bytes, const std::uint8_t* data, std::size_t size) {
    for (std::size_t i = 0; i + 4 < size; i += 5) {
        std::size_t at =
            (std::size_t{data[i]} << 16 | std::size_t{data[i + 1]} << 8 | data[i + 2]) %
            bytes.size();
        const std::uint8_t how = data[i + 3], what = data[i + 4];
        if (how % 4 == 0) {
            bytes[at] = static_cast<std::byte>(what);
        } else if (how % 4 == 1) {
            bytes[at] ^= static_cast<std::byte>(1 << what % 8);
        } else {
            at -= at % 4;
            const std::uint32_t number = how % 4 == 2 ? odd_number(what) : what;
            if (at + sizeof number <= bytes.size()) std::memcpy(&bytes[at], &number, sizeof number);
        }
    }
    if (size % 5 == 1) bytes.resize(bytes.size() * data[size - 1] / 256);
}

[[noreturn]] void fail(const std::string& why) {
    std::fprintf(stderr, "%s\n", why.c_str());
    std::abort();
}

/// Every value of the tree can also be written.
void check_values(property::Tree& tree, property::Handle top) {
    tree.each_below(top, [&](property::Handle handle) {
        for (const property::Property* property : tree.properties(handle)) {
            const property::Value value = tree.peek(handle, *property);
            if (property->read_only || value.is(property::Type::reference)) continue;
            // A computed value (a mass of 0 of a body that does not move) need not be writable.
            const bool follows = property->binding.overridden != nullptr;
            if (follows && !tree.overridden(handle, *property)) continue;
            try {
                if (!(tree.coerce(handle, *property, value) == value))
                    fail(tree.path(handle, *property) + " would not be " + tree.text(value));
            } catch (const property::Error& error) {
                // References in lists may refer to deleted instances.
                if (error.kind() != property::ErrorKind::deleted) fail(error.what());
            }
        }
    });
}

/// Corrects the checksums of the physics worlds in the snapshot, which would otherwise refuse every
/// change in them.
void seal_worlds(const std::vector<std::byte>& before, std::vector<std::byte>& bytes) {
    using physics::detail::SavedHeader;
    SavedHeader header;
    for (std::size_t at = 0; at + sizeof header <= std::min(before.size(), bytes.size()); ++at) {
        std::memcpy(&header, &before[at], sizeof header);
        if (header.magic != 0x77546546 || header.size > bytes.size() - at) continue;
        physics::detail::write_checksum(std::span(bytes).subspan(at, header.size));
        at += header.size - 1;
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const std::vector<std::byte> saved = valid_save();
    constexpr std::size_t header = 24, end = 8;  // docs/design/time.md
    std::vector<std::byte> state(saved.begin() + header, saved.end() - end);
    const std::vector<std::byte> before_it = state;
    change(state, data, size);
    if (size % 5 != 2) seal_worlds(before_it, state);
    std::vector<std::byte> file(saved.begin(), saved.begin() + header);
    const std::uint64_t length = state.size();
    std::memcpy(&file[16], &length, sizeof length);
    file.insert(file.end(), state.begin(), state.end());
    const std::uint64_t checksum = property::checksum(file);
    const auto* const sum = reinterpret_cast<const std::byte*>(&checksum);
    file.insert(file.end(), sum, sum + sizeof checksum);

    ScriptedGame game;
    for (int i = 0; i < 2; ++i) game.step();
    const property::Snapshot before = game.tree.snapshot();
    try {
        game.tree.restore(property::Snapshot::from_bytes(file));
    } catch (const property::Error&) {
        const property::Snapshot after = game.tree.snapshot();
        if (!std::ranges::equal(before.payload(), after.payload())) std::abort();
        return 0;
    }
    check_values(game.tree, game.tree.root());
    // The state can be saved again.
    game.tree.check(property::Snapshot::from_bytes(game.tree.snapshot().to_bytes()));
    game.tree.barrier();
    for (int i = 0; i < 3; ++i) {
        try {
            game.step();
        } catch (const property::Error&) {
            // handlers that trigger each other without end
        }
    }
    check_values(game.tree, game.tree.root());
    if (const property::Handle world = game.tree.child(game.tree.root(), "world")) {
        try {
            (void)property::scene_text(game.tree, world);
        } catch (const property::Error&) {
            // a scene file cannot contain every reference
        }
    }
    (void)game.runtime.run(
        "local all = world:all() for i = 1, #all, 3 do if all[i]:alive() then pcall(all[i].clone, "
        "all[i]) pcall(all[i].move, all[i], game) end end for i = 1, #all, 2 do if all[i]:alive() "
        "then pcall(all[i].delete, all[i]) end end",
        "apart");
    game.step();
    (void)game.tree.snapshot();
    return 0;
}
