#pragma once
// A game without a window: everything that `fettle run --headless` has. It stores what is printed.

#include <string>
#include <string_view>
#include <vector>

#include <fettle/app/loop.h>
#include <fettle/app/services.h>
#include <fettle/property/path.h>
#include <fettle/property/tree.h>
#include <fettle/script/runtime.h>

namespace fettle::app {

struct Game {
    property::Tree tree;
    Services services{tree};
    script::Runtime runtime{tree, {}};
    Loop loop{tree, runtime, services};
    std::vector<std::string> printed;
    std::vector<script::ScriptError> errors;

    explicit Game(std::string_view script = {}) {
        runtime.on_print([this](std::string_view text) { printed.emplace_back(text); });
        runtime.on_error([this](const script::ScriptError& error) {
            errors.push_back(error);
            loop.halt();
        });
        if (!script.empty()) runtime.run(script, "test");
    }

    property::Value get(std::string_view path) const { return property::get(tree, path); }
    void set(std::string_view path, const property::Value& value) {
        property::set(tree, path, value);
    }
    /// Text printed since the last call; lines are joined by blanks.
    std::string new_output() {
        std::string all;
        for (const std::string& line : printed) all += (all.empty() ? "" : " ") + line;
        printed.clear();
        return all;
    }
    void press(const std::string& key, bool repeated = false) {
        InputEvent event;
        event.kind = EventKind::key_pressed;
        event.name = key;
        event.repeated = repeated;
        loop.handle(event);
    }
    void release(const std::string& key) {
        InputEvent event;
        event.kind = EventKind::key_released;
        event.name = key;
        loop.handle(event);
    }
    void mouse(EventKind kind, float x, float y, const std::string& button = {}) {
        InputEvent event;
        event.kind = kind;
        event.name = button;
        event.x = x;
        event.y = y;
        loop.handle(event);
    }
};

/// Duration of a frame at 60 frames per second, s.
inline constexpr double tick = 1.0 / 60;

}  // namespace fettle::app
