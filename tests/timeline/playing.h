#pragma once
// A game with physics, scripts and a loop; the hash after every step is stored.

#include <fettle/app/loop.h>
#include <fettle/physics_module/physics_module.h>
#include <fettle/property/bytes.h>
#include <fettle/property/path.h>
#include <fettle/property/storage/game_saves.h>

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace fettle::app {

struct Playing {
    physics_module::PhysicsModule physics;
    property::Tree tree;
    Services services{tree};
    std::unique_ptr<property::GameSaves> saves;
    std::unique_ptr<script::Runtime> runtime;
    std::unique_ptr<Loop> loop;
    std::vector<std::string> printed, errors;
    std::vector<std::uint64_t> hashes{0};
    /// (parent, stem) -> the last number that was used in a name; one map for each step of
    /// `hashes`.
    using Numbers = std::map<std::pair<std::uint32_t, std::string>, std::uint32_t>;
    std::vector<Numbers> numbers{{}};

    /// `slots`: folder of saved games; "": none.
    explicit Playing(std::string_view script, const std::filesystem::path& slots = {}) {
        physics.attach(tree);
        if (!slots.empty())
            saves = std::make_unique<property::GameSaves>(
                tree, property::Saves(slots, "game", "test"),
                property::GameSaves::Options{
                    // A saved game reports that it contains no timers, which is not an error here.
                    .warn = [this](const std::string& text) {
                        if (text.find("a file holds no functions") == std::string::npos)
                            errors.push_back(text);
                    }});
        script::Options with = options();
        with.saves = saves.get();
        runtime = std::make_unique<script::Runtime>(tree, with);
        loop = std::make_unique<Loop>(tree, *runtime, services);
        loop->add({.name = "physics",
                   .step = [this](double dt) { physics.step(dt); },
                   .report = [this] { physics.report(tree); },
                   .hash = [this] { return physics.hash(); }});
        runtime->on_print([this](std::string_view text) { printed.emplace_back(text); });
        runtime->on_error(
            [this](const script::ScriptError& error) { errors.push_back(error.message); });
        loop->timeline().set_share(1e9);  // the same keyframes in every run
        runtime->run(script, "test");
        hashes[0] = loop->hash();
        numbers[0] = given_numbers();
    }
    /// The next names are not in any value or hash. They are in snapshots: in the block of the
    /// tree, which begins with the nodes (Nodes::save).
    Numbers given_numbers() const {
        const property::Snapshot snapshot = tree.snapshot();
        property::ByteReader from(snapshot.payload());
        from.get<std::uint64_t>();
        from.get<std::uint64_t>();
        REQUIRE(from.text() == "tree");
        from = from.block();
        from.get<std::uint64_t>();
        from.get<property::Handle>();
        for (std::size_t n = from.count(); n > 0; --n) from.text();
        std::map<std::uint32_t, std::string> names;
        for (std::size_t n = from.count(); n > 0; --n) {
            const auto id = from.get<std::uint32_t>();
            names[id] = from.text();
        }
        const auto node = from.get<std::uint32_t>();
        for (std::size_t n = from.count() * node; n > 0; --n) from.get<std::byte>();
        from.list<std::uint32_t>();
        Numbers given;
        for (std::size_t n = from.count(); n > 0; --n) {
            const auto key = from.get<std::uint64_t>();
            given[{key >> 32, names.at(std::uint32_t(key))}] = from.get<std::uint32_t>();
        }
        return given;
    }
    static script::Options options() {
        script::Options options;
        options.seed = 5;
        return options;
    }
    void play(int steps) {
        for (int i = 0; i < steps; ++i) {
            loop->turn();
            hashes.resize(std::size_t(services.clock.step));
            hashes.push_back(loop->hash());
            numbers.resize(std::size_t(services.clock.step));
            numbers.push_back(given_numbers());
        }
        CAPTURE(errors);
        REQUIRE(errors.empty());
    }
    Timeline& time() { return loop->timeline(); }
    void check(std::int64_t step) {
        CAPTURE(step);
        time().go_to(step);
        REQUIRE(services.clock.step == step);
        REQUIRE(loop->hash() == hashes[std::size_t(step)]);
        REQUIRE(given_numbers() == numbers[std::size_t(step)]);
    }
    property::Value get(std::string_view path) { return property::get(tree, path); }
    void console(std::string_view command) { runtime->evaluate(command); }
};

}  // namespace fettle::app
