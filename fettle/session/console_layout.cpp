#ifdef FETTLE_WITH_CONSOLE

#include <session/console_layout.h>

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include <fettle/property/storage/replaced_file.h>

#include <files/game_path.h>
#include <session/session.h>

namespace fettle::program {

namespace fs = std::filesystem;

namespace {

using LayoutJson = nlohmann::json;
constexpr std::uintmax_t largest = 1 << 20;  // bytes, of both files

std::string content_of(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

bool is_small_file(const fs::path& file) {
    std::error_code error;
    return fs::is_regular_file(file, error) && fs::file_size(file, error) <= largest && !error;
}

std::vector<std::string> texts_in(const LayoutJson& whole, const char* name) {
    std::vector<std::string> texts;
    if (const auto list = whole.find(name); list != whole.end() && list->is_array())
        for (const auto& each : *list)
            if (each.is_string()) texts.push_back(each.get<std::string>());
    return texts;
}

}  // namespace

console::Layout read_layout(const fs::path& folder) {
    console::Layout layout;
    if (folder.empty() || !is_small_file(folder / "console.json")) return layout;
    const LayoutJson whole =
        LayoutJson::parse(content_of(folder / "console.json"), nullptr, /*allow_exceptions=*/false);
    if (!whole.is_object()) return layout;
    if (const auto settings = whole.find("settings");
        settings != whole.end() && settings->is_object())
        for (const auto& [name, value] : settings->items()) {
            if (value.is_boolean()) layout.settings[name] = property::Value(value.get<bool>());
            if (value.is_number()) layout.settings[name] = property::Value(value.get<double>());
        }
    layout.pins = texts_in(whole, "pins");
    layout.plots = texts_in(whole, "plots");
    return layout;
}

void write_layout(const fs::path& folder, const console::Layout& layout) {
    if (folder.empty()) return;
    LayoutJson whole = {
        {"settings", LayoutJson::object()}, {"pins", layout.pins}, {"plots", layout.plots}};
    for (const auto& [name, value] : layout.settings) {
        if (value.is(property::Type::boolean)) whole["settings"][name] = value.boolean();
        if (value.is_numeric()) whole["settings"][name] = value.as_double();
    }
    const std::string text = whole.dump(2, ' ', false, LayoutJson::error_handler_t::replace) + "\n";
    const fs::path file = folder / "console.json";
    if (content_of(file) == text) return;
    std::error_code error;
    fs::create_directories(folder, error);
    property::replace_file(file, text);
}

std::string autoexec(std::string& problem) {
    const fs::path file = console::default_autoexec_file();
    std::error_code error;
    if (file.empty() || !fs::exists(file, error)) return {};
    if (is_small_file(file)) return content_of(file);
    problem = file.string() + ": is not a file of at most 1 MB; its commands are not run";
    return {};
}

/// A run without a window, a recorded run and a replay do not use the player's files.
void Session::load_players_console(console::Options& options) {
    if (options_.headless || replayed_ != nullptr || isolated() || !options_.record.empty()) return;
    const fs::path folder = property::player_folder(options_.game, settings_.id);
    options.layout = read_layout(folder);
    options.keep_layout = [folder](const console::Layout& layout) { write_layout(folder, layout); };
    std::string problem;
    options.first_commands = autoexec(problem);
    if (!problem.empty()) note(problem);
}

}  // namespace fettle::program

#endif
