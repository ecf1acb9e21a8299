#include <fettle/property/storage/assets.h>

#include <algorithm>

#include <fettle/property/error.h>
#include <fettle/property/spelling.h>
#include <fettle/property/storage/game_files.h>

namespace fettle::property {

namespace fs = std::filesystem;

namespace {

bool has_ending(const fs::path& file, Endings endings) {
    std::string ending = file.extension().string();
    std::ranges::transform(ending, ending.begin(), [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
    return std::ranges::find(endings, ending) != endings.end();
}

void add_names(const fs::path& folder, Endings endings, std::vector<std::string>& names) {
    constexpr std::size_t most = 1000;
    constexpr int deepest = 4;
    const std::size_t before = names.size();
    std::error_code code;
    for (fs::recursive_directory_iterator it(folder, code), end; !code && it != end;
         it.increment(code)) {
        if (names.size() - before >= most || it.depth() > deepest) break;
        if (has_ending(it->path(), endings))
            names.push_back(it->path().lexically_relative(folder).generic_string());
    }
}

}  // namespace

fs::path Assets::path_of(std::string_view what, const std::string& name) const {
    // Paths of a million folders take minutes, and no system opens one that is longer.
    constexpr std::size_t longest = 4096;
    if (name.size() > longest)
        throw Error(ErrorKind::rejected, std::string(what) + ": the name of a file has at most " +
                                             std::to_string(longest) + " bytes");
    const fs::path path(name);
    bool leaves = path.is_absolute() || name.empty() || name.find('\0') != std::string::npos;
    for (const fs::path& part : path) leaves = leaves || part == "..";
    if (leaves)
        throw Error(ErrorKind::rejected, std::string(what) + ": \"" + name.substr(0, 80) +
                                             "\" is not a file below the game's folder");
    return game_ / path;
}

fs::path Assets::find(std::string_view what, const std::string& name, Endings endings) const {
    fs::path own = path_of(what, name);
    if (!game_.empty() && files_.exists(own)) return own;
    if (!shared_.empty() && files_.exists(shared_ / name)) return shared_ / name;
    throw Error(ErrorKind::unknown_name, std::string(what) + ": there is no file \"" + name + "\"" +
                                             suggestion(name, names(endings)));
}

std::string Assets::read(std::string_view what, const std::string& name, Endings endings) const {
    return files_.read(find(what, name, endings));
}

std::vector<std::string> Assets::names(Endings endings) const {
    std::vector<std::string> found;
    if (!game_.empty()) add_names(game_, endings, found);
    if (!game_.empty())
        for (std::string& name : files_.names_in_memory(game_))
            if (has_ending(name, endings) && std::ranges::find(found, name) == found.end())
                found.push_back(std::move(name));
    if (!shared_.empty()) add_names(shared_, endings, found);
    return found;
}

}  // namespace fettle::property
