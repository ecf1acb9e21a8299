#include "rules.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <string_view>

namespace fettle::architecture {
namespace {

/// A part of the project: its folders, the other parts that it may include, and the external
/// libraries that it may include. Parts and libraries are named as in the tables below.
struct Part {
    std::string_view name;
    std::vector<std::string_view> folders;
    std::set<std::string_view> may_know;
    std::set<std::string_view> libraries;
    std::set<std::string_view> sees_inside = {};  // parts whose private headers it may include
};

// The table of the architecture page. Storage is the part of the property tree that accesses files;
// the external libraries follow from "the only place that includes ...". Property and physics must
// run on any system, so they may not include headers of the operating system.
const std::vector<Part>& parts() {
    static const std::vector<Part> table = {
        {"vector", {"vector", "vector/include/fettle/vector"}, {}, {}},
        {"property", {"framework/property", "framework/include/fettle/property"}, {}, {}},
        {"storage",
         {"framework/property/storage", "framework/include/fettle/property/storage"},
         {"property"},
         {"JSON", "SQLite", "POSIX"}},
        {"maps",
         {"framework/maps", "framework/include/fettle/maps"},
         {"property"},
         {"JSON", "pugixml", "zlib", "Zstandard"}},
        {"physics", {"physics", "physics/include/fettle/physics"}, {}, {"Eigen", "intrinsics"}},
        {"physics_c", {"bindings/c", "bindings/c/include/fettle/physics_c"}, {"physics"}, {}},
        {"module",
         {"framework/module", "framework/include/fettle/module"},
         {"property"},
         {"POSIX"}},
        // The code that is linked into a loaded module: the classes of the tree with other private
        // members.
        {"guest", {"framework/module/guest"}, {"module", "property"}, {}, {"module", "property"}},
        {"physics_module",
         {"physics/module", "physics/include/fettle/physics_module"},
         {"module", "guest", "property", "physics"},
         {}},
        {"visuals",
         {"framework/visuals", "framework/include/fettle/visuals"},
         {"module", "property", "storage", "maps"},
         {"JSON", "stb", "FreeType", "HarfBuzz", "FriBidi", "Fontconfig"}},
        {"script",
         {"framework/script", "framework/include/fettle/script"},
         {"property", "storage"},
         {"Lua", "POSIX"}},
        {"app",
         {"framework/app", "framework/include/fettle/app"},
         {"script", "property", "storage"},
         {"SFML", "Zstandard", "stb", "POSIX"}},
        {"interface",
         {"framework/interface", "framework/include/fettle/interface"},
         {"app", "module", "property"},
         {}},
        {"console",
         {"console", "console/include/fettle/console"},
         {"app", "script", "property", "storage"},
         {"ImGui", "FreeType", "POSIX"}},
        {"host",
         {"bindings/host", "bindings/host/include/fettle/host"},
         {"property", "storage", "physics_c", "physics_module", "script", "app", "console"},
         {},
         {"physics_c"}},
        {"fettle",
         {"fettle"},
         {"property", "storage", "physics", "module", "physics_module", "visuals", "script", "app",
          "interface", "console"},
         {"JSON", "CLI11", "libedit", "minizip", "POSIX"}},
    };
    return table;
}

struct Library {
    std::string_view name;
    std::regex header;  // matches the whole text between the brackets
    std::regex target;  // matches the whole name of a CMake target
};

const std::vector<Library>& libraries() {
    static const std::vector<Library> table = {
        {"Eigen", std::regex("(unsupported/)?Eigen/.*"), std::regex("Eigen3::.*")},
        {"Lua", std::regex("(lua5[^/]*/)?(lua|lauxlib|lualib|luaconf)\\.h(pp)?"),
         std::regex("fettle_lua|PkgConfig::LUA")},
        {"SFML", std::regex("SFML/.*"), std::regex("fettle_sfml|sfml-.*|SFML::.*")},
        {"ImGui", std::regex("(imgui/)?(imgui|imstb|imconfig).*"),
         std::regex("fettle_imgui|PkgConfig::IMGUI")},
        {"JSON", std::regex("nlohmann/.*"), std::regex("nlohmann_json::.*")},
        // Only headers; the console links the library for ImGui.
        {"stb", std::regex("stb/stb_.*"), std::regex("")},
        {"FreeType", std::regex("ft2build\\.h"), std::regex("fettle_fonts")},
        {"HarfBuzz", std::regex("hb\\.h"), std::regex("fettle_fonts")},
        {"FriBidi", std::regex("fribidi\\.h"), std::regex("fettle_fonts")},
        {"Fontconfig", std::regex("fontconfig/.*"), std::regex("fettle_fonts")},
        {"SQLite", std::regex("sqlite3.*"), std::regex("fettle_sqlite|SQLite::.*|SQLite3::.*")},
        {"Zstandard", std::regex("zstd\\.h"), std::regex("fettle_zstd|PkgConfig::ZSTD|zstd::.*")},
        {"pugixml", std::regex("pugixml\\.hpp"), std::regex("fettle_pugixml|pugixml::.*")},
        {"zlib", std::regex("zlib\\.h"), std::regex("fettle_zlib|ZLIB::.*")},
        {"minizip", std::regex("minizip/.*"), std::regex("fettle_minizip")},
        {"CLI11", std::regex("CLI/.*"), std::regex("CLI11::.*")},
        {"libedit", std::regex("histedit\\.h"), std::regex("fettle_libedit")},
        {"POSIX",
         std::regex(
             "(sys/.*|unistd|fcntl|dlfcn|link|poll|pthread|signal|spawn|stdio_ext|termios)(\\.h)?"),
         std::regex("dl")},
        {"intrinsics", std::regex("(immintrin|arm_neon)\\.h"),
         std::regex("")},  // from the compiler
        {"Catch2", std::regex("catch2/.*"), std::regex("Catch2::.*|fettle_catch")},
        {"rapidcheck", std::regex("rapidcheck.*"), std::regex("rapidcheck")},
        {"benchmark", std::regex("benchmark/.*"), std::regex("benchmark::.*")},
        {"Box2D", std::regex("box2d/.*"), std::regex("box2d.*")},
        {"Chipmunk", std::regex("chipmunk/.*"), std::regex("chipmunk.*")},
    };
    return table;
}

bool lies_in(std::string_view path, std::string_view folder) {
    return path.starts_with(folder) && path.size() > folder.size() && path[folder.size()] == '/';
}

/// The part with the longest folder that contains `path`; null for tests, benchmarks and other
/// files.
const Part* part_of(std::string_view path) {
    const Part* best = nullptr;
    std::size_t length = 0;
    for (const Part& part : parts()) {
        for (std::string_view folder : part.folders) {
            if (folder.size() > length && lies_in(path, folder)) {
                best = &part;
                length = folder.size();
            }
        }
    }
    return best;
}

const Part* part_named(std::string_view name) {
    const auto found = std::ranges::find(parts(), name, &Part::name);
    return found == parts().end() ? nullptr : &*found;
}

bool may_know(const Part& part, const Part& other) {
    // Vectors are headers only, for every part.
    return &part == &other || other.name == "vector" || part.may_know.contains(other.name);
}

bool is_standard(const std::string& header) {
    static const std::regex modern_or_c("[a-z_0-9]+|std(bool|def|int|io|lib)\\.h|string\\.h");
    return std::regex_match(header, modern_or_c);
}

const Library* library_of_header(const std::string& header) {
    const auto found = std::ranges::find_if(
        libraries(), [&](const Library& it) { return std::regex_match(header, it.header); });
    return found == libraries().end() ? nullptr : &*found;
}

const Library* library_of_target(const std::string& target) {
    const auto found = std::ranges::find_if(
        libraries(), [&](const Library& it) { return std::regex_match(target, it.target); });
    return found == libraries().end() ? nullptr : &*found;
}

std::string join(const std::set<std::string_view>& names) {
    std::string text;
    for (std::string_view name : names) text += (text.empty() ? "" : " ") + std::string(name);
    return text.empty() ? "nothing" : text;
}

std::string at(const SourceFile& file, int line, const std::string& what) {
    return file.path + ":" + std::to_string(line) + ": " + what;
}

/// Calls `visit(file, line number, line)` for every line of every file that `wanted` accepts.
template <typename Wanted, typename Visit>
void each_line(const SourceTree& tree, Wanted wanted, Visit visit) {
    for (const auto& [path, file] : tree.files()) {
        if (!wanted(file)) continue;
        for (std::size_t i = 0; i < file.lines.size(); ++i) {
            visit(file, static_cast<int>(i) + 1, file.lines[i]);
        }
    }
}

}  // namespace

Violations unknown_places(const SourceTree& tree) {
    Violations found;
    for (const auto& [path, file] : tree.files()) {
        if (!file.is_cpp()) continue;
        const bool beside =
            lies_in(path, "tests") || lies_in(path, "bench") || lies_in(path, "examples");
        if (!beside && !part_of(path)) found.push_back(path + ": lies in no part of the project");
    }
    return found;
}

Violations forbidden_includes(const SourceTree& tree) {
    Violations found;
    for (const auto& [path, file] : tree.files()) {
        const Part* part = part_of(path);
        if (!part || !file.is_cpp()) continue;
        for (const Include& include : file.includes()) {
            const std::string target = tree.resolve(file, include);
            if (!target.empty()) {
                const Part* other = part_of(target);
                if (!other || !may_know(*part, *other)) {
                    found.push_back(at(file, include.line,
                                       std::string(part->name) + " may not include " + target +
                                           "; it may know " + join(part->may_know)));
                }
            } else if (include.quoted || include.name.starts_with("fettle/")) {
                found.push_back(at(file, include.line, "no such header: " + include.name));
            } else if (!is_standard(include.name)) {
                const Library* library = library_of_header(include.name);
                if (!library || !part->libraries.contains(library->name)) {
                    found.push_back(
                        at(file, include.line,
                           std::string(part->name) + " may not include <" + include.name +
                               ">; it may use the standard library and " + join(part->libraries)));
                }
            }
        }
    }
    return found;
}

Violations forbidden_links(const SourceTree& tree) {
    static const std::regex word(R"([A-Za-z0-9_]+(::[A-Za-z0-9_]+)?(-[a-z0-9]+)*)");
    static const std::regex own(R"((?:Fettle::|fettle_)(\w+))");
    Violations found;
    const auto is_of_a_part = [](const SourceFile& file) {
        return file.is_cmake() && part_of(file.path);
    };
    each_line(tree, is_of_a_part, [&](const SourceFile& file, int line, const std::string& text) {
        const Part& part = *part_of(file.path);
        const std::string code = text.substr(0, text.find('#'));
        for (std::sregex_iterator it(code.begin(), code.end(), word), end; it != end; ++it) {
            const std::string target = it->str();
            std::smatch match;
            const Part* other =
                std::regex_match(target, match, own) ? part_named(match[1].str()) : nullptr;
            const Library* library = library_of_target(target);
            if ((other && !may_know(part, *other)) ||
                (library && !part.libraries.contains(library->name))) {
                found.push_back(at(file, line, std::string(part.name) + " may not link " + target));
            }
        }
    });
    return found;
}

Violations public_header_violations(const SourceTree& tree) {
    Violations found;
    for (const auto& [path, file] : tree.files()) {
        if (!file.is_header() || path.find("/include/") == std::string::npos ||
            lies_in(path, "tests")) {
            continue;
        }
        if (!file.is_public_header()) {
            found.push_back(path + ": a public header lies in include/fettle/<library>/");
            continue;
        }
        for (const Include& include : file.includes()) {
            const std::string target = tree.resolve(file, include);
            const bool is_public = !target.empty() && tree.files().at(target).is_public_header();
            const bool is_outside = target.empty() && (is_standard(include.name));
            if (!is_public && !is_outside) {
                found.push_back(at(
                    file, include.line,
                    "a public header includes only public headers and std, not " + include.name));
            }
        }
    }
    return found;
}

Violations unmarked_declarations(const SourceTree& tree) {
    // These contain types in C that both sides of the interface have, a library that is always
    // static, and code without a library.
    static const std::set<std::string_view> without = {
        "framework/include/fettle/module/abi.h", "framework/include/fettle/module/guest.h",
        "vector/include/fettle/vector/convert.h", "vector/include/fettle/vector/scalar.h",
        "vector/include/fettle/vector/vector2.h"};
    static const std::regex comment(R"(//.*|/\*.*?\*/|/\*.*)");
    // Names of other libraries; this library does not export them.
    static const std::regex of_others(R"((namespace [a-z:_]+ \{|(class|struct) \w+;|\}| )*)");
    Violations found;
    for (const auto& [path, file] : tree.files()) {
        const Part* part = part_of(path);
        if (!part || !file.is_public_header() || without.contains(path)) continue;
        std::string upper(part->name);
        std::ranges::transform(upper, upper.begin(), [](char c) { return std::toupper(c); });
        const std::string begin = "FETTLE_" + upper + "_BEGIN", end = "FETTLE_" + upper + "_END";
        bool marked = false, commented = false;
        for (std::size_t i = 0; i < file.lines.size(); ++i) {
            std::string code = std::regex_replace(file.lines[i], comment, "");
            if (commented && file.lines[i].find("*/") == std::string::npos) continue;
            if (commented) code = file.lines[i].substr(file.lines[i].find("*/") + 2);
            commented = file.lines[i].rfind("/*") != std::string::npos &&
                        file.lines[i].find("*/") == std::string::npos;
            code.erase(0, code.find_first_not_of(" \t"));
            if (code == begin || code == end) {
                marked = code == begin;
            } else if (!marked && !code.empty() && code[0] != '#' &&
                       !std::regex_match(code, of_others)) {
                found.push_back(at(file, static_cast<int>(i) + 1,
                                   "a declaration outside of " + begin + " and " + end));
                break;  // one is enough to show where the marks are missing
            }
        }
    }
    return found;
}

Violations borrowed_private_headers(const SourceTree& tree) {
    Violations found;
    for (const auto& [path, file] : tree.files()) {
        if (!file.is_cpp() || lies_in(path, "tests") || lies_in(path, "bench")) continue;
        for (const Include& include : file.includes()) {
            const std::string target = tree.resolve(file, include);
            if (target.empty() || tree.files().at(target).is_public_header()) continue;
            // Programs outside the project use only public headers; a part also uses its private
            // ones.
            const Part* of = part_of(target);
            const Part* by = part_of(path);
            if (of != by && !(of && by && by->sees_inside.contains(of->name))) {
                found.push_back(at(file, include.line, target + " is private to its part"));
            }
        }
    }
    return found;
}

Violations vague_names(const SourceTree& tree) {
    static const std::regex snake_case("[a-z][a-z0-9]*(_[a-z0-9]+)*\\.[a-z]+");
    static const std::set<std::string> vague = {"util",    "utils",   "utility", "utilities",
                                                "helper",  "helpers", "common",  "misc",
                                                "manager", "managers"};
    Violations found;
    for (const auto& [path, file] : tree.files()) {
        if (file.is_cmake()) continue;
        const std::filesystem::path name(path);
        if (!std::regex_match(name.filename().string(), snake_case)) {
            found.push_back(path + ": file names are snake_case");
        }
        for (const std::filesystem::path& step : name) {
            std::string word;
            for (const char c : step.stem().string() + "_") {
                if (c != '_') {
                    word += c;
                } else {
                    if (vague.contains(word)) {
                        found.push_back(path + ": \"" + word + "\" does not say what is inside");
                    }
                    word.clear();
                }
            }
        }
    }
    return found;
}

Violations overlong_files(const SourceTree& tree) {
    constexpr std::size_t max_lines = 500;
    Violations found;
    for (const auto& [path, file] : tree.files()) {
        if (file.lines.size() > max_lines) {
            found.push_back(path + ": " + std::to_string(file.lines.size()) + " lines, at most " +
                            std::to_string(max_lines) + " make one idea");
        }
    }
    return found;
}

Violations unportable_names(const SourceTree& tree) {
    static const std::regex name(R"(^[^/]*std::(ranges::|bit_cast|atomic_ref).*)");
    Violations found;
    for (const auto& [path, file] : tree.files()) {
        const bool portable = (lies_in(path, "physics") && !lies_in(path, "physics/module")) ||
                              lies_in(path, "bindings/c") || lies_in(path, "vector");
        for (std::size_t i = 0; portable && i < file.lines.size(); ++i) {
            if (std::regex_match(file.lines[i], name))
                found.push_back(at(file, i + 1, "not every standard library has this"));
        }
    }
    return found;
}

Violations headers_of_linux(const SourceTree& tree) {
    static const std::regex include(R"(#include <(linux/|sys/prctl\.h|sys/epoll\.h).*)");
    Violations found;
    const auto is_of_a_part = [](const SourceFile& file) { return part_of(file.path) != nullptr; };
    each_line(tree, is_of_a_part, [&](const SourceFile& file, int line, const std::string& text) {
        if (std::regex_match(text, include))
            found.push_back(at(file, line, "only Linux has this header"));
    });
    return found;
}

Violations heavy_headers(const SourceTree& tree) {
    static const std::regex include(R"(#include <([a-z_]+)>.*)");
    static const std::set<std::string, std::less<>> light = {
        "array",       "compare",     "concepts", "cstddef",   "cstdint", "limits",
        "new",         "optional",    "span",     "stdexcept", "string",  "utility",
        "string_view", "type_traits", "variant",  "vector"};
    const auto is_public = [](const SourceFile& file) {
        return lies_in(file.path, "physics/include/fettle/physics") ||
               file.path == "vector/include/fettle/vector/vector2.h";
    };
    Violations found;
    each_line(tree, is_public, [&](const SourceFile& file, int line, const std::string& text) {
        std::smatch match;
        if (std::regex_match(text, match, include) && !light.contains(match[1].str()))
            found.push_back(at(file, line,
                               "<" + match[1].str() +
                                   "> is not one of the headers that compile "
                                   "fast: every program that includes physics.h would read it"));
    });
    return found;
}

Violations careless_headers(const SourceTree& tree) {
    static const std::regex opens("^using namespace .*");  // inside a function it would be indented
    Violations found;
    for (const auto& [path, file] : tree.files()) {
        if (file.is_header() && std::ranges::count(file.lines, "#pragma once") != 1) {
            found.push_back(path + ": a header has one line #pragma once");
        }
    }
    const auto is_header_of_a_part = [](const SourceFile& file) {
        return file.is_header() && part_of(file.path);
    };
    each_line(tree, is_header_of_a_part,
              [&](const SourceFile& file, int line, const std::string& text) {
                  if (std::regex_match(text, opens)) {
                      found.push_back(
                          at(file, line, "a header opens no namespace for those who include it"));
                  }
              });
    return found;
}

Violations scattered_version_checks(const SourceTree& tree) {
    static const std::regex condition(R"(^\s*#\s*(if|ifdef|ifndef|elif)\b.*)");
    static const std::array macros = {
        std::pair{"SFML", std::regex(".*\\bSFML_VERSION.*")},
        std::pair{"ImGui", std::regex(".*\\bIMGUI_VERSION.*")},
        std::pair{"Lua", std::regex(".*\\bLUA_VERSION.*")},
        std::pair{"Eigen", std::regex(".*\\bEIGEN_(WORLD|MAJOR|MINOR|VERSION).*")}};
    std::map<std::string, std::set<std::string>> where;
    const auto is_of_a_part = [](const SourceFile& file) {
        return file.is_cpp() && part_of(file.path);
    };
    each_line(tree, is_of_a_part, [&](const SourceFile& file, int, const std::string& text) {
        if (text.find('#') == std::string::npos || !std::regex_match(text, condition)) return;
        for (const auto& [library, macro] : macros) {
            if (std::regex_match(text, macro)) where[library].insert(file.path);
        }
    });
    Violations found;
    for (const auto& [library, files] : where) {
        if (files.size() < 2) continue;
        std::string text = library + ": more than one file tests its version:";
        for (const std::string& path : files) text += " " + path;
        found.push_back(text);
    }
    return found;
}

Violations unfinished_marks(const SourceTree& tree) {
    // In halves, so that this file does not contain them. A pattern for all takes much longer.
    static const std::vector<std::string> marks = {
        std::string("TO") + "DO", std::string("FIX") + "ME", std::string("XX") + "X",
        std::string("HA") + "CK"};
    Violations found;
    const auto any = [](const SourceFile&) { return true; };
    each_line(tree, any, [&](const SourceFile& file, int line, const std::string& text) {
        for (const std::string& mark : marks)
            if (text.find(mark) != text.npos &&
                std::regex_search(text, std::regex("\\b" + mark + "\\b")))
                found.push_back(at(file, line, "unfinished: " + text));
    });
    return found;
}

}  // namespace fettle::architecture
