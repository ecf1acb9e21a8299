#pragma once
// A game whose main.lua changes.

#include <fstream>
#include <string>

#include "stage.h"
#include "temporary_folder.h"

namespace reloaded_game {

using stage::Stage;

struct Game : Stage {
    TemporaryFolder folder;

    explicit Game(const std::string& text) {
        write("main.lua", text);
        REQUIRE(runtime->load(folder.path));
        CHECK(errors.empty());
    }
    void write(const std::string& name, const std::string& text) const {
        std::ofstream(folder.path / name) << text;
    }
    /// Loads another main.lua; returns the error, or "".
    std::string change(const std::string& text) {
        write("main.lua", text);
        return again();
    }
    std::string again() {
        errors.clear();
        const fettle::script::Reloaded result = runtime->reload({"main.lua"});
        CHECK(result.done == !result.error.has_value());
        for (const std::string& note : result.notes) UNSCOPED_INFO(note);
        CHECK(result.notes.empty());
        CHECK(errors.empty());
        return result.error ? result.error->message : "";
    }
    double number(const std::string& path) const { return get(path).as_double(); }
};

}  // namespace reloaded_game
