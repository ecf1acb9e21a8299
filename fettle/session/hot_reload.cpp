// While a game runs, reads its files again when they change.

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <map>
#include <set>
#include <string_view>

#include <fettle/property/exception_text.h>
#include <fettle/property/storage/scene.h>

#include <command_line/joined.h>
#include <files/game_path.h>
#include <game/preferences.h>
#include <session/game_window.h>
#include <session/session.h>

namespace fettle::program {

namespace fs = std::filesystem;

namespace {

/// Files of these kinds are not code: nothing that a script has computed depends on their content.
bool is_media(const fs::path& file) {
    constexpr std::array<std::string_view, 20> endings = {
        ".png",  ".jpg", ".jpeg", ".bmp", ".tga", ".ttf", ".otf", ".ttc", ".wav",  ".ogg",
        ".flac", ".mp3", ".tmj",  ".tmx", ".tsj", ".tsx", ".tj",  ".tx",  ".frag", ".glsl"};
    const std::string ending = file.extension().string();
    return std::ranges::find(endings, ending) != endings.end();
}

}  // namespace

bool Session::follows_files() const {
    return options_.follow && replayed_ == nullptr && options_.record.empty() && !isolated();
}

/// Each file once: the game and Fettle may have read it by different paths.
std::vector<fs::path> Session::watched_files() const {
    std::set<fs::path> files;
    for (const fs::path& file : files_.seen()) files.insert(fs::absolute(file).lexically_normal());
    return {files.begin(), files.end()};
}

Session::Followed Session::follow_files() {
    if (!follows_files() || !watch_.due() || runtime_->running()) return Followed::nothing;
    const std::vector<fs::path> changed = watch_.changed(watched_files());
    return changed.empty() ? Followed::nothing : apply_changes(changed);
}

Session::Followed Session::apply_changes(const std::vector<fs::path>& changed) {
    // A game whose main.lua has failed has no state to keep.
    if (!run_.loaded) return Followed::restart;
    const auto begin = std::chrono::steady_clock::now();
    const fs::path folder = fs::absolute(folder_of(options_.game)).lexically_normal();
    problems_.erase("");
    std::vector<std::string> names, read;
    std::map<std::string, ChangedScene> scenes;
    bool code = false;
    for (const fs::path& file : changed) {
        const fs::path name = file.lexically_relative(folder);
        names.push_back(name.generic_string());
        end_recording(names.back());
        renew(names.back());
        if (std::optional<ChangedScene> scene = scene_in(file, names.back()))
            scenes.emplace(names.back(), std::move(*scene));
        if (!problems_.contains(names.back())) read.push_back(names.back());
        code = code || (!is_media(file) && names.back() != "game.json");
    }
    if (read.empty()) {
        show_problems();
        return Followed::failed;
    }
    const script::Reloaded result = code ? reload_code(names) : reload_media(read);
    for (const std::string& line : result.notes) note(line);
    if (!result.done) {
        report_error(*result.error);
        if (receivers_.error_over) receivers_.error_over(&*result.error);
        return Followed::failed;
    }
    if (receivers_.error_over) receivers_.error_over(nullptr);
    // The top level of the new code has set volumes and keys again, as at the start of the game.
    if (code) follow_preferences(*preferences_, interface_);
    const std::chrono::duration<double, std::milli> lasted =
        std::chrono::steady_clock::now() - begin;
    // A scene is there again only if the top level loads it.
    std::erase_if(read, [&](const std::string& name) {
        const auto scene = scenes.find(name);
        if (scene == scenes.end() || files_.times_seen(folder / name) > scene->second.times_read)
            return false;
        for (const std::string& line : scene->second.warnings) note(line);
        note(name + " has changed, and is there when the game loads it again");
        return true;
    });
    if (!read.empty())
        note("reloaded " + joined(read) + " in " + std::to_string(std::lround(lasted.count())) +
             " ms");
    run_.failed = false;
    if (loop_->halted()) {
        const bool back = loop_->retry();
        const std::string next = "step " + std::to_string(services_->clock.step + 1);
        if (back)
            note(next + " runs again");
        else if (services_->clock.step < services_->clock.newest && !services_->clock.paused)
            note("the game goes on with " + next);
    }
    show_problems();
    return Followed::changed;
}

/// Nothing for a file that is no scene. If the file cannot be read or is not valid, reports this as
/// a problem of the file.
std::optional<Session::ChangedScene> Session::scene_in(const fs::path& file,
                                                       const std::string& name) {
    std::error_code error;
    if (file.extension() != ".json" || !fs::exists(file, error) || name == "game.json" ||
        problems_.contains(name))
        return {};
    try {
        ChangedScene scene;
        if (property::check_scene_text(tree_, files_.read(file), name, &scene.warnings)) {
            scene.times_read = files_.times_seen(file);
            return scene;
        }
    } catch (const std::exception& failure) {
        report_file_problem(property::exception_text(failure), name);
    }
    return {};
}

/// Also returns an exception as an error: a file may have been removed in the meantime.
script::Reloaded Session::reload_code(const std::vector<std::string>& names) {
    try {
        return runtime_->reload(names);
    } catch (const std::exception& error) {
        script::ScriptError report;
        report.message = property::exception_text(error);
        report.context = "reload";
        return {.done = false, .error = report};
    }
}

/// Calls the callback `reloaded` with the names of the files; the code is not run again.
script::Reloaded Session::reload_media(const std::vector<std::string>& names) {
    property::List list(names.begin(), names.end());
    runtime_->call("reloaded", {property::Value(std::move(list))});
    return {.done = true};
}

/// Reads a file again. If that fails, everything stays as it was, and the reason is in `problems_`.
void Session::renew(const std::string& name) {
    problems_.erase(name);
    run_.renewed = name;
    try {
        visuals_.renew(name);
        services_->audio.renew(name);
        services_->renew_effect(name);
        if (name == "game.json") renew_settings();
    } catch (const std::exception& error) {
        report_file_problem(property::exception_text(error), name);
    }
    run_.renewed.clear();
}

/// The run continues without the file: with a checkerboard for an image, or without an effect.
/// `file`: "" if no change of a file has caused it.
void Session::report_file_problem(const std::string& problem, const std::string& file) {
    script::ScriptError report;
    report.message = problem;
    report.context = "files";
    report_error(report);
    if (!follows_files()) return;
    problems_.try_emplace(file, report);
    show_problems();
}

/// Shows a problem of changed files over the game, unless the game has stopped by an error, which
/// is shown in its place.
void Session::show_problems() {
    if (receivers_.error_over && !problems_.empty() && !loop_->halted())
        receivers_.error_over(&problems_.begin()->second);
}

/// Applies the changed settings of the window in game.json; other settings need a restart.
void Session::renew_settings() {
    const app::WindowState before = window_state(settings_);
    settings_ = property::read_game_settings(files_, options_.game, FETTLE_VERSION);
    const app::WindowState now = window_state(settings_);
    app::WindowState& state = services_->view.window;
    if (now.title != before.title) state.title = now.title;
    if (now.size != before.size) state.size = now.size;
    if (now.fullscreen != before.fullscreen) state.fullscreen = now.fullscreen;
    if (now.resizable != before.resizable) state.resizable = now.resizable;
    if (now.icon != before.icon) state.icon = now.icon;
    if (now.vsync != before.vsync) state.vsync = now.vsync;
}

}  // namespace fettle::program
