#include <packing/package_problems.h>

#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>

#include <fettle/property/spelling.h>
#include <fettle/property/storage/game_files.h>
#include <fettle/script/syntax.h>

#include <files/game_path.h>
#include <packing/literal_names.h>

namespace fettle::program {

namespace fs = std::filesystem;

namespace {

std::string lower_case(std::string text) {
    for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
}

/// Looks a name up as a game does.
class Names {
  public:
    explicit Names(const PackedGame& game) : left_out_(game.left_out), one_file_(game.one_file) {
        for (const auto& [name, content] : game.files) all_.push_back(name);
        shared_ = assets();
    }
    bool has(const std::string& name) const {
        std::error_code error;
        return std::ranges::binary_search(all_, name) ||
               (!shared_.empty() && fs::is_regular_file(shared_ / name, error));
    }
    std::string hint(const std::string& name) const {
        if (one_file_)
            return ": the package of a game that is one file has that file only; a game with more "
                   "files is a folder with main.lua";
        for (const std::string& each : left_out_)
            if (each == name || (each.ends_with('/') && name.starts_with(each)))
                return ": packages leave " + each + " out";
        const std::string lower = lower_case(name);
        for (const std::string& each : all_)
            if (lower_case(each) == lower)
                return ": the file is called \"" + each +
                       "\", and upper and lower case are different elsewhere";
        return ": there is no such file" + property::suggestion(name, all_);
    }

  private:
    const std::vector<std::string>& left_out_;
    bool one_file_ = false;
    std::vector<std::string> all_;
    fs::path shared_;
};

std::string module_file(std::string name) {
    std::ranges::replace(name, '.', '/');
    return name + ".lua";
}

/// Why the name does not lead to a file; "" if it does. `from`: the file that mentions it.
std::string problem_of(const LiteralName& name, const std::string& from, bool script,
                       const Names& names) {
    const fs::path path(name.name);
    if (path.is_absolute() || (name.name.size() > 1 && name.name[1] == ':'))
        return ": an absolute path exists on this computer only";
    if (name.module) {
        const std::string file = module_file(name.name);
        return names.has(file) ? "" : " (" + file + ")" + names.hint(file);
    }
    const std::string plain = path.lexically_normal().generic_string();
    if (names.has(plain)) return {};
    // Maps and sheets name files beside themselves.
    const std::string beside =
        (fs::path(from).parent_path() / path).lexically_normal().generic_string();
    if (!script && names.has(beside)) return {};
    return names.hint(script ? plain : beside);
}

}  // namespace

std::vector<std::string> problems_of(const PackedGame& game, const std::vector<std::string>& made) {
    const Names names(game);
    std::vector<std::string> problems;
    for (const auto& [file, content] : game.files) {
        const bool script = file.ends_with(".lua");
        if (script)
            if (std::string why = script::syntax_error(content, file); !why.empty())
                problems.push_back(std::move(why));
        const std::string ending = fs::path(file).extension().string();
        constexpr std::string_view data[] = {".json", ".tmj", ".tmx", ".tsj", ".tsx", ".tj", ".tx"};
        if (!script && std::ranges::find(data, ending) == std::end(data)) continue;
        if (file.ends_with(".tweaks.json") && !nlohmann::json::accept(content))
            problems.push_back(file + ": is not JSON, so the edits that were kept are lost");
        for (const LiteralName& name : script ? names_in_script(content) : names_in_data(content)) {
            if (name.written || std::ranges::find(made, name.name) != made.end()) continue;
            const std::string why = problem_of(name, file, script, names);
            if (!why.empty())
                problems.push_back(file + ":" + std::to_string(name.line) + ": \"" + name.name +
                                   "\"" + why);
        }
    }
    return problems;
}

}  // namespace fettle::program
