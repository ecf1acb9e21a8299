#include <packing/scene_problems.h>

#include <algorithm>
#include <optional>
#include <string_view>

#include <fettle/property/exception_text.h>
#include <fettle/property/storage/scene.h>

#include <session/session.h>

namespace fettle::program {

namespace {

/// Limit of a call into the scripts of the game that is loaded, s.
constexpr double longest_call = 10;

/// Whether the file may be a scene. A text that is no valid JSON cannot say more.
bool is_scene(const std::string& name, std::string_view content) {
    return name.ends_with(".json") && content.find("\"fettle_scene\"") != content.npos;
}

/// Whether a script names the class. It may be defined later than when the game is loaded.
bool is_named(const PackedGame& packed, std::string_view of) {
    return std::ranges::any_of(packed.files, [&](const auto& file) {
        return file.first.ends_with(".lua") && file.second.find(of) != file.second.npos;
    });
}

/// The class that the error says is unknown.
std::optional<std::string> unknown_class(const property::SceneError& error) {
    constexpr std::string_view begin = "no class is called \"";
    const std::size_t at = error.reason().find(begin);
    if (error.kind() != property::ErrorKind::unknown_name || at == std::string::npos) return {};
    const std::size_t name = at + begin.size();
    return error.reason().substr(name, error.reason().find('"', name) - name);
}

}  // namespace

std::vector<std::string> scene_problems(const std::filesystem::path& game,
                                        const PackedGame& packed) {
    if (std::ranges::none_of(packed.files,
                             [](const auto& file) { return is_scene(file.first, file.second); }))
        return {};
    std::vector<std::string> problems;
    RunOptions options;
    options.game = game;
    options.headless = options.isolated = true;
    Session session(options, nullptr, [&](const script::ScriptError& error) {
        if (problems.empty()) problems.push_back(error.message);
    });
    session.on_output([](std::string_view) {});
    session.runtime().limit_calls(longest_call, {});
    session.start();
    if (session.failed()) return problems;
    for (const auto& [name, content] : packed.files) {
        if (!is_scene(name, content)) continue;
        try {
            (void)property::check_scene_text(session.tree(), content, name);
        } catch (const property::SceneError& error) {
            if (const auto of = unknown_class(error); of && is_named(packed, *of)) continue;
            problems.emplace_back(error.what());
        } catch (const std::exception& error) {
            problems.push_back(name + ": " + property::exception_text(error));
        }
    }
    return problems;
}

}  // namespace fettle::program
