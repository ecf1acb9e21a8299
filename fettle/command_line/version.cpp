#include <command_line/version.h>

#include <array>
#include <string_view>
#include <utility>

#include <fettle/module/abi.h>
#ifdef FETTLE_WITH_PHYSICS
#include <fettle/physics/instruction_set.h>
#endif

namespace fettle::program {

std::string version_text() {
    // The build defines these: the versions that the program was compiled with.
    const std::array parts = {std::pair{"SFML", FETTLE_VERSION_OF_SFML},
                              std::pair{"Lua", FETTLE_VERSION_OF_LUA},
                              std::pair{"Dear ImGui", FETTLE_VERSION_OF_IMGUI},
                              std::pair{"Eigen", FETTLE_VERSION_OF_EIGEN},
                              std::pair{"SQLite", FETTLE_VERSION_OF_SQLITE},
                              std::pair{"nlohmann-json", FETTLE_VERSION_OF_JSON},
                              std::pair{"CLI11", FETTLE_VERSION_OF_CLI11},
                              std::pair{"zstd", FETTLE_VERSION_OF_ZSTD},
                              std::pair{"compiler", FETTLE_COMPILER}};
    std::string text = "fettle " FETTLE_VERSION "\n";
    const auto line = [&](std::string_view name, const std::string& version) {
        text += "  " + std::string(name) + std::string(18 - name.size(), ' ') + version + "\n";
    };
    line("module interface",
         std::to_string(FETTLE_ABI_MAJOR) + "." + std::to_string(FETTLE_ABI_MINOR));
#ifdef FETTLE_WITH_PHYSICS
    line("SIMD width", std::to_string(physics::simd_width()) + " (as this machine allows)");
#endif
    for (const auto& [name, version] : parts)
        if (*version != '\0') line(name, version);
    text.pop_back();
    return text;
}

}  // namespace fettle::program
