// Reading, writing and locking of the files of a game.

#include <fettle/property/storage/game_files.h>

#include <algorithm>
#include <cctype>
#include <span>
#include <utility>

#include <fettle/property/bytes.h>

#include <files/durable_file.h>
#include <files/file_access.h>
#include <json/document.h>
#include <json/unknown_keys.h>

namespace fettle::property {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t greatest_module = std::size_t{1} << 30;  // bytes; includes debug information

std::uint64_t checksum_of(std::string_view content) {
    return checksum(std::as_bytes(std::span(content)));
}

bool is_below(const fs::path& file, const fs::path& folder) {
    if (folder.empty()) return false;
    const fs::path relative = file.lexically_relative(folder);
    return !relative.empty() && *relative.begin() != "..";
}

std::optional<std::string> content_on_disk(const fs::path& file, std::size_t limit) {
    std::error_code error;
    if (!fs::exists(file, error)) return std::nullopt;
    return read_file(file, limit);
}

}  // namespace

std::optional<std::uint64_t> file_checksum(const fs::path& file) {
    const std::optional<std::string> content = content_on_disk(file, greatest_module);
    if (!content) return std::nullopt;
    return checksum_of(*content);
}

/// The same key for all names of one file.
fs::path GameFiles::key(const fs::path& file) {
    std::error_code error;
    fs::path found = fs::weakly_canonical(file, error);
    return error ? file : found;
}

const std::optional<std::string>* GameFiles::held(const Path& file) const {
    if (held_.empty()) return nullptr;
    const auto found = held_.find(key(file));
    return found == held_.end() ? nullptr : &found->second;
}

void GameFiles::stay_below(const Path& game, const Path& shared) {
    named_ = fs::absolute(game).lexically_normal();
    game_ = key(named_);
    shared_ = shared.empty() ? Path() : key(fs::absolute(shared));
}

fs::path GameFiles::checked(const Path& file, bool to_write) const {
    if (game_.empty()) return file;
    Path found = key(fs::absolute(file));
    if (is_below(found, game_) || (!to_write && is_below(found, shared_))) return found;
    const Path named = fs::absolute(file).lexically_normal();
    const bool leads_out = is_below(named, game_) || is_below(named, named_);
    throw FileError(file, leads_out ? "is a link that leads out of the game's folder, to " +
                                          found.string() + ": it is not followed"
                                    : "lies outside of the game's folder");
}

std::string GameFiles::read(const Path& file) {
    if (const auto* content = held(file)) {
        if (*content) return **content;
        throw FileError(file, "could not be read: there was no such file then");
    }
    const Path found = checked(file, false);
    see(file);
    std::string content;
    try {
        content = read_file(found, size_limit);
    } catch (const FileError& error) {
        throw error.of(file);
    }
    note(file, content);
    return content;
}

bool GameFiles::exists(const Path& file) {
    if (const auto* content = held(file)) return content->has_value();
    see(file);
    std::error_code error;
    const bool there = fs::exists(file, error);
    if (!there) note(file, std::nullopt);
    return there;
}

void GameFiles::write(const Path& file, std::string_view content) {
    const Path found = checked(file, true);
    if (writable_ && content.size() > *writable_)
        throw FileError(file, "was not written: this game has written as much as it may in a run");
    if (in_memory_) {
        put(file, std::string(content));
    } else {
        note_overwritten(file);
        replace_file(found, content);
    }
    if (writable_) *writable_ -= content.size();
    if (!in_memory_ && on_write_) on_write_(file);
}

void GameFiles::put(const Path& file, std::optional<std::string> content) {
    held_[key(file)] = std::move(content);
}

std::vector<fs::path> GameFiles::seen() const {
    std::vector<fs::path> files;
    for (const auto& [file, times] : seen_) files.push_back(file);
    return files;
}

std::size_t GameFiles::times_seen(const Path& file) const {
    const Path wanted = fs::absolute(file).lexically_normal();
    std::size_t sum = 0;
    for (const auto& [each, times] : seen_)
        if (fs::absolute(each).lexically_normal() == wanted) sum += times;
    return sum;
}

std::vector<std::string> GameFiles::names_in_memory(const Path& folder) const {
    std::vector<std::string> names;
    const Path top = key(folder);
    for (const auto& [file, content] : held_)
        if (content && is_below(file, top))
            names.push_back(file.lexically_relative(top).generic_string());
    return names;
}

// --- Scenes --------------------------------------------------------------------------------------

namespace {

/// Why a scene must not have this name; "" if it may. `name`: relative to the game's folder.
std::string why_no_name_of_a_scene(const fs::path& name) {
    for (const fs::path& part : name)
        if (part.string().starts_with('.')) return "a game cannot write hidden files";
    std::string last = name.filename().string();
    // Some file systems do not distinguish upper case and lower case.
    std::transform(last.begin(), last.end(), last.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    for (const char* const ending : {".lua", ".so", ".sqlite", ".tweaks.json"})
        if (last.ends_with(ending))
            return std::string("what ends in ") + ending + " is not a scene";
    const bool taken = last == "modules.json" || last == "game.json";
    return taken ? "Fettle uses this name itself" : "";
}

/// Why a scene must not replace a file with this text; "" if it may.
std::string why_no_scene(std::string text, const std::string& name) {
    try {
        const Document document(std::move(text), name);
        const Document::Node* version = document.member(document.root(), version_key);
        if (version == nullptr) return "there is a file already, and it is not a scene";
        if (version->kind == Document::Kind::integer && version->integer > scene_format_version)
            return "there is a scene of a newer Fettle";
        return {};
    } catch (const Error&) {
        return "there is a file already, and it is not a scene";
    }
}

}  // namespace

void GameFiles::write_scene(const Path& file, std::string_view text) {
    const auto refuse = [&](const std::string& why) {
        if (!why.empty()) throw FileError(file, "was not written: " + why);
    };
    // Both the given name and the target of a link are checked.
    const Path found = checked(file, true);
    const Path named = fs::absolute(file).lexically_normal();
    for (const auto& [name, folder] : {std::pair(named, named_), std::pair(found, game_)})
        refuse(why_no_name_of_a_scene(is_below(name, folder) ? name.lexically_relative(folder)
                                                             : name.filename()));
    const std::shared_ptr<void> locked = lock();
    if (exists(file)) refuse(why_no_scene(read(file), file.filename().string()));
    write(file, text);
}

// --- Several processes ---------------------------------------------------------------------------

std::shared_ptr<void> GameFiles::lock() {
    if (in_memory_ || game_.empty()) return nullptr;
    return std::make_shared<Descriptor>(lock_folder(game_));
}

// --- Reports -------------------------------------------------------------------------------------

void GameFiles::on_first_access(std::function<void(const FileState&)> listener) {
    listener_ = std::move(listener);
    for (FileState& state : std::exchange(unreported_, {})) add(std::move(state));
}

void GameFiles::add(FileState state) {
    if (const auto listener = listener_)  // a copy, because it may replace itself
        listener(state);
    else
        unreported_.push_back(std::move(state));
}

void GameFiles::note(const Path& file, const std::optional<std::string>& content) {
    if (!records_reads_) return;
    Path path = key(file);
    Known& known = known_[path];
    if (known.looked_at || known.overwritten) return;
    known.looked_at = true;
    add({.file = std::move(path),
         .checksum = content ? std::optional(checksum_of(*content)) : std::nullopt});
}

void GameFiles::note_read(const Path& file) {
    if (records_reads_) note(file, content_on_disk(file, greatest_module));
}

void GameFiles::note_overwritten(const Path& file) {
    if (!records_reads_) return;
    Path path = key(file);
    Known& known = known_[path];
    if (known.overwritten) return;
    known.overwritten = true;
    std::optional<std::string> was = content_on_disk(path, size_limit);
    std::optional<std::uint64_t> its_checksum;
    if (was) its_checksum = checksum_of(*was);
    add({.file = std::move(path),
         .checksum = its_checksum,
         .overwritten = true,
         .content = std::move(was)});
}

}  // namespace fettle::property
