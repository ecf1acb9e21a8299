#include <game/moment.h>

#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>
#include <span>

#include <fettle/property/error.h>
#include <fettle/property/storage/game_files.h>

#include <files/archive.h>
#include <files/game_path.h>
#include <files/packed_game.h>
#include <files/settings.h>

namespace fettle::program {

namespace fs = std::filesystem;

namespace {

// Hidden names: a package that is made of the files does not contain them.
constexpr const char* about_name = ".moment/about.json";
constexpr const char* state_name = ".moment/state";
constexpr const char* recording_name = ".moment/run.recording";
constexpr std::string_view moment_folder = ".moment/";
constexpr std::size_t longest_moment_name = 64;

[[noreturn]] void cannot_open(const fs::path& file, const std::string& why) {
    throw FileError(file.string() + ": its moment cannot be opened: " + why);
}

/// The files of the game, also of one that is an archive itself.
ArchiveFiles files_of(const fs::path& game) {
    const fs::path archive = archive_of(game);
    ArchiveFiles files = archive.empty()
                             ? packed_game(game, read_settings(game).package_exclude).files
                             : read_archive(archive);
    std::erase_if(files, [](const auto& file) { return file.first.starts_with(moment_folder); });
    if (files.contains("modules.json"))
        throw FileError("modules.json: a moment cannot bring native modules along");
    return files;
}

}  // namespace

fs::path moment_file(const fs::path& player_folder, const std::string& name) {
    const bool good = !name.empty() && std::ranges::all_of(name, [](unsigned char c) {
        return std::isalnum(c) != 0 || c == '-' || c == '_';
    });
    if (name.size() > longest_moment_name)
        throw property::Error(property::ErrorKind::bad_name,
                              "share: the name has " + std::to_string(name.size()) +
                                  " characters; a name has at most " +
                                  std::to_string(longest_moment_name));
    if (!good)
        throw property::Error(property::ErrorKind::bad_name,
                              "share: \"" + name +
                                  "\": expected a name of letters, digits, - and _, without a "
                                  "folder and an ending");
    if (player_folder.empty())
        throw property::Error(property::ErrorKind::rejected,
                              "share: there is no folder for files of the player");
    return player_folder / "moments" / (name + std::string(archive_ending));
}

void write_moment(const fs::path& file, const fs::path& game, const Moment& moment,
                  const std::string& recording) {
    ArchiveFiles files = files_of(game);
    const nlohmann::json about{
        {"fettle", moment.fettle}, {"step", moment.step}, {"tweaks", moment.tweaks}};
    files[about_name] = about.dump(2) + "\n";
    const std::vector<std::byte> state = moment.state.to_bytes();
    files[state_name] = std::string(reinterpret_cast<const char*>(state.data()), state.size());
    if (!recording.empty()) files[recording_name] = recording;
    std::error_code error;
    fs::create_directories(file.parent_path(), error);
    if (error)
        throw FileError(file.parent_path().string() + ": cannot be made: " + error.message());
    write_archive(file, files);
}

std::optional<Moment> moment_of(const fs::path& game) {
    const fs::path archive = archive_of(game);
    if (archive.empty()) return std::nullopt;
    const ArchiveFiles about = read_archive(archive, about_name);
    if (about.empty()) return std::nullopt;
    Moment moment;
    try {
        const auto read = nlohmann::json::parse(about.begin()->second);
        moment.step = read.at("step").get<std::int64_t>();
        moment.fettle = read.at("fettle").get<std::string>();
        moment.tweaks = read.at("tweaks").get<std::vector<std::string>>();
    } catch (const nlohmann::json::exception&) {
        cannot_open(archive, std::string(about_name) + " is damaged");
    }
    const ArchiveFiles state = read_archive(archive, state_name);
    if (state.empty()) cannot_open(archive, std::string(state_name) + " is missing");
    const std::string& bytes = state.begin()->second;
    try {
        moment.state = property::Snapshot::from_bytes(
            std::as_bytes(std::span<const char>(bytes.data(), bytes.size())));
    } catch (const property::Error& error) {
        cannot_open(archive,
                    std::string(error.what()) + (moment.fettle == FETTLE_VERSION
                                                     ? std::string()
                                                     : "; Fettle " + moment.fettle +
                                                           " wrote it, this is " + FETTLE_VERSION));
    }
    return moment;
}

std::vector<std::string> tweak_lines(const std::vector<property::Tweak>& tweaks) {
    std::vector<std::string> lines;
    for (const property::Tweak& tweak : tweaks) {
        if (tweak.earlier) continue;
        const std::string values = tweak.was.empty() && tweak.now.empty()
                                       ? std::string()
                                       : ": " + tweak.was + " → " + tweak.now;
        lines.push_back(tweak.path + values + ", step " + std::to_string(tweak.step));
    }
    return lines;
}

}  // namespace fettle::program
