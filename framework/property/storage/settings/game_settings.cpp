#include <fettle/property/storage/game_settings.h>

#include <algorithm>
#include <charconv>
#include <string>
#include <system_error>
#include <vector>

#include <fettle/property/exception_text.h>
#include <fettle/property/spelling.h>
#include <fettle/property/storage/game_files.h>

#include <json/document.h>

namespace fettle::property {

namespace fs = std::filesystem;

namespace {

/// Reads the members of one object. Each function checks the type of the value.
class SettingsReader {
  public:
    using Node = Document::Node;
    using Kind = Document::Kind;
    explicit SettingsReader(const Document& document) : document_(document) {}

    /// Calls `take(reader, key, node)` for each member; it returns false for unknown keys.
    template <class Take>
    void members(const Node& object, const std::vector<std::string>& keys, Take take) {
        if (object.kind != Kind::object) refuse(object, "an object with settings");
        const std::string above = path_;
        for (const Node* node = document_.first(object); node != nullptr;
             node = document_.next(*node)) {
            const std::string& key = document_.key(*node);
            path_ = above.empty() ? key : above + "." + key;
            if (!take(*node, key))
                document_.fail(ErrorKind::unknown_name, node->key_begin,
                               (key.empty() ? "an empty key" : path_) +
                                   ": there is no such setting" + suggestion(key, keys));
        }
        path_ = above;
    }

    std::string text(const Node& node) {
        if (node.kind != Kind::text) refuse(node, "a text");
        return document_.text(node);
    }
    bool boolean(const Node& node) {
        if (node.kind != Kind::boolean) refuse(node, "true or false");
        return node.boolean;
    }
    std::vector<std::string> texts(const Node& node) {
        if (node.kind != Kind::array) refuse(node, "a list of texts");
        std::vector<std::string> all;
        for (const Node* each = document_.first(node); each != nullptr;
             each = document_.next(*each))
            all.push_back(text(*each));
        return all;
    }
    Vec2 size(const Node& node) {
        constexpr const char* wanted = "width and height from 1 to 16384 pixels, as in [1280, 800]";
        if (node.kind != Kind::array || document_.count(node) != 2) refuse(node, wanted);
        Vec2 size;
        int i = 0;
        for (const Node* side = document_.first(node); side != nullptr;
             side = document_.next(*side)) {
            if (side->kind != Kind::integer || side->integer < 1 ||
                static_cast<double>(side->integer) > WindowSettings::largest)
                refuse(*side, wanted);
            size[i++] = static_cast<double>(side->integer);
        }
        return size;
    }
    /// File, line and column of a value.
    std::string place(const Node& node) const { return document_.place(node.begin); }
    [[noreturn]] void refuse(const Node& node, const std::string& expected) {
        constexpr std::size_t longest = 60;
        std::string found(kind_words(node.kind));
        if (node.kind == Kind::array && document_.count(node) != 0)
            found += " of " + std::to_string(document_.count(node));
        const std::string_view raw = document_.raw(node);
        if (node.kind != Kind::object && node.kind != Kind::array && raw.size() <= longest)
            found += " (" + std::string(raw) + ")";
        document_.fail(
            ErrorKind::wrong_type, node.begin,
            (path_.empty() ? "" : path_ + ": ") + "expected " + expected + ", found " + found);
    }
    [[noreturn]] void reject(const Node& node, const std::string& why) {
        document_.fail(ErrorKind::rejected, node.begin, path_ + ": " + why);
    }

  private:
    const Document& document_;
    std::string path_;
};

/// The numbers of a version like "1.2.3"; empty if the text is not a version.
std::vector<unsigned> version_numbers(std::string_view text) {
    std::vector<unsigned> numbers;
    while (true) {
        unsigned number = 0;
        const char* const end = text.data() + text.size();
        const auto [stopped, error] = std::from_chars(text.data(), end, number);
        if (error != std::errc()) return {};
        numbers.push_back(number);
        if (stopped == end) return numbers;
        if (*stopped != '.' || numbers.size() == 3) return {};
        text.remove_prefix(static_cast<std::size_t>(stopped - text.data()) + 1);
    }
}

/// Whether the name can be a folder on every system.
bool is_id(std::string_view id) {
    constexpr std::size_t longest = 100;
    const auto letter = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    };
    return !id.empty() && id.size() <= longest && letter(id.front()) && id.back() != '.' &&
           std::ranges::all_of(
               id, [&](char c) { return letter(c) || c == '.' || c == '-' || c == '_'; });
}

std::string read_id(SettingsReader& reader, const Document::Node& node) {
    std::string id = reader.text(node);
    if (!is_id(id))
        reader.refuse(node,
                      "an id of 1 to 100 letters, digits, \".\", \"-\" and \"_\", as in "
                      "\"org.example.marbles\"");
    return id;
}

void read_icon(SettingsReader& reader, const Document::Node& node, GameSettings& settings) {
    settings.icon = reader.text(node);
    settings.icon_at = reader.place(node);
    const std::string ending = fs::path(settings.icon).extension().string();
    if (!settings.icon.empty() && std::ranges::find(icon_endings, ending) == icon_endings.end())
        reader.refuse(node, "an image (.png, .jpg, .jpeg, .bmp or .tga)");
}

std::string read_fettle(SettingsReader& reader, const Document::Node& node,
                        std::string_view program) {
    std::string version = reader.text(node);
    const std::vector<unsigned> wanted = version_numbers(version);
    if (wanted.empty()) reader.refuse(node, "a version, as in \"1.2\"");
    if (version_numbers(program) < wanted)
        reader.reject(node, "the game was written for Fettle " + version + ", and this is Fettle " +
                                std::string(program));
    return version;
}

ConsoleUse read_console(SettingsReader& reader, const Document::Node& node) {
    const std::vector<std::string> names = {"on", "developer", "off"};
    const std::string name = reader.text(node);
    const auto found = std::ranges::find(names, name);
    if (found == names.end())
        reader.refuse(node, "\"on\", \"developer\" or \"off\"" + suggestion(name, names));
    return static_cast<ConsoleUse>(found - names.begin());
}

std::uint64_t read_memory(SettingsReader& reader, const Document::Node& node) {
    if (node.kind != Document::Kind::integer || node.integer < 1 ||
        node.integer > GameSettings::most_memory)
        reader.refuse(node,
                      "whole megabytes from 1 to " + std::to_string(GameSettings::most_memory));
    return static_cast<std::uint64_t>(node.integer);
}

const std::vector<std::string> window_keys = {"title", "size", "fullscreen", "resizable", "vsync"};

WindowSettings read_window(SettingsReader& reader, const Document::Node& object) {
    WindowSettings window;
    reader.members(object, window_keys, [&](const Document::Node& node, const std::string& key) {
        if (key == "title")
            window.title = reader.text(node);
        else if (key == "size")
            window.size = reader.size(node);
        else if (key == "fullscreen")
            window.fullscreen = reader.boolean(node);
        else if (key == "resizable")
            window.resizable = reader.boolean(node);
        else if (key == "vsync")
            window.vsync = reader.boolean(node);
        else
            return false;
        return true;
    });
    return window;
}

std::vector<std::string> read_package(SettingsReader& reader, const Document::Node& object) {
    std::vector<std::string> exclude;
    reader.members(object, {"exclude"}, [&](const Document::Node& node, const std::string& key) {
        if (key != "exclude") return false;
        exclude = reader.texts(node);
        return true;
    });
    return exclude;
}

void read_seed(SettingsReader& reader, const Document::Node& node, GameSettings& settings) {
    if (node.kind == Document::Kind::text && reader.text(node) == "random")
        settings.random_seed = true;
    else if (node.kind == Document::Kind::integer && node.integer >= 0)
        settings.seed = static_cast<std::uint64_t>(node.integer);
    else
        reader.refuse(node, "a whole number that is not negative, or \"random\"");
}

}  // namespace

GameSettings game_settings(std::string text, const std::string& file_name,
                           std::string_view program) {
    const Document document(std::move(text), file_name);
    SettingsReader reader(document);
    GameSettings settings;
    reader.members(document.root(),
                   {"name", "id", "version", "author", "window", "icon", "console", "fettle",
                    "seed", "smooth", "memory", "package"},
                   [&](const Document::Node& node, const std::string& key) {
                       if (key == "name")
                           settings.name = reader.text(node);
                       else if (key == "id")
                           settings.id = read_id(reader, node);
                       else if (key == "version")
                           settings.version = reader.text(node);
                       else if (key == "author")
                           settings.author = reader.text(node);
                       else if (key == "window")
                           settings.window = read_window(reader, node);
                       else if (key == "icon")
                           read_icon(reader, node, settings);
                       else if (key == "console")
                           settings.console = read_console(reader, node);
                       else if (key == "fettle")
                           settings.fettle = read_fettle(reader, node, program);
                       else if (key == "package")
                           settings.package_exclude = read_package(reader, node);
                       else if (key == "seed")
                           read_seed(reader, node, settings);
                       else if (key == "memory")
                           settings.memory = read_memory(reader, node);
                       else if (key == "smooth")
                           settings.smooth = reader.boolean(node);
                       else if (std::ranges::find(window_keys, key) != window_keys.end())
                           reader.reject(node, "belongs into \"window\": { }");
                       else
                           return false;
                       return true;
                   });
    return settings;
}

namespace {

/// Whether the game has a file of that name. Throws FileError for a link that leads nowhere and for
/// a name in another case, since such a file would have no effect.
bool has_file(GameFiles& files, const fs::path& file) {
    if (files.exists(file)) return true;
    std::error_code error;
    if (fs::is_symlink(file, error)) throw FileError(file, "this link leads nowhere");
    const auto lower = [](std::string text) {
        for (char& c : text)
            if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
        return text;
    };
    const std::string wanted = file.filename().string();
    for (fs::directory_iterator it(file.parent_path(), error), end; !error && it != end;
         it.increment(error)) {
        const std::string name = it->path().filename().string();
        if (name != wanted && lower(name) == wanted)
            throw FileError(it->path(), "expected the name " + wanted + ", in lower case");
    }
    return false;
}

}  // namespace

GameSettings read_game_settings(GameFiles& files, const fs::path& game, std::string_view program) {
    std::error_code error;
    fs::path file = (fs::is_directory(game, error) ? game : game.parent_path()) / "game.json";
    if (!has_file(files, file)) return {};
    return game_settings(files.read(file), file.string(), program);
}

void read_module_list(GameFiles& files, const fs::path& folder,
                      const std::function<void(const std::string&)>& take) {
    const fs::path file = folder / "modules.json";
    if (!has_file(files, file)) return;
    const Document document(files.read(file), file.string());
    SettingsReader reader(document);
    if (document.root().kind != Document::Kind::object || document.count(document.root()) == 0)
        reader.refuse(document.root(), "{ \"modules\": [ \"a file or a name\", ... ] }");
    reader.members(document.root(), {"modules"}, [&](const auto& list, const std::string& key) {
        if (key != "modules") return false;
        reader.texts(list);  // checks all of them before the first is taken
        for (const auto* each = document.first(list); each != nullptr; each = document.next(*each))
            try {
                take(document.text(*each));
            } catch (const std::exception& problem) {
                document.fail(ErrorKind::rejected, each->begin, exception_text(problem));
            }
        return true;
    });
}

}  // namespace fettle::property
