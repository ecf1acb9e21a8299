#pragma once
// Names of files that the texts of a game mention literally: "hero.png" in a script or a map,
// require("enemies.boss").

#include <string>
#include <string_view>
#include <vector>

namespace fettle::program {

struct LiteralName {
    std::string name;
    int line = 0;
    bool module = false;   // of require
    bool written = false;  // the game itself makes this file: scene.save("level.json", ...)
};

/// Names of files with an ending that games read, and of modules, in a script. Comments do not
/// count.
std::vector<LiteralName> names_in_script(std::string_view text);
/// The same in a JSON text or another text with names in double quotes.
std::vector<LiteralName> names_in_data(std::string_view text);

}  // namespace fettle::program
