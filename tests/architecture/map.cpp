// Checks the map of the project in the documents: the paths, functions and rooms that it names.

#include <algorithm>
#include <regex>
#include <string_view>

#include "rules.h"

namespace fettle::architecture {
namespace {

constexpr std::string_view folders_of_parts[] = {"vector/",   "framework/", "physics/",
                                                 "bindings/", "console/",   "fettle/"};

bool is_path(const std::string& code) {
    return code.find_first_of(" <>*()") == std::string::npos &&
           std::ranges::any_of(folders_of_parts,
                               [&](std::string_view part) { return code.starts_with(part); });
}

bool mentions(const SourceFile& file, const std::string& name) {
    const std::regex word("\\b" + name + "\\b");
    return std::ranges::any_of(file.lines, [&](const std::string& line) {
        return line.find(name) != line.npos && std::regex_search(line, word);
    });
}

bool exists(const SourceTree& tree, std::string path) {
    for (const char* root : {"", "vector/include/", "framework/include/", "physics/include/",
                             "bindings/c/include/", "bindings/host/include/", "console/include/"})
        if (tree.contains(root + path))
            return true;  // as in an #include, relative to an include folder
    if (!path.ends_with('/')) path += '/';
    const auto next = tree.files().lower_bound(path);
    return next != tree.files().end() && next->first.starts_with(path);
}

}  // namespace

Violations lost_paths(const SourceTree& tree, const std::string& text) {
    static const std::regex code("`([^`\\n]+)`");
    Violations found;
    for (std::sregex_iterator each(text.begin(), text.end(), code), end; each != end; ++each)
        if (const std::string path = (*each)[1]; is_path(path) && !exists(tree, path))
            found.push_back(path + ": there is no such file or folder");
    return found;
}

Violations lost_functions(const SourceTree& tree, const std::string& text) {
    // One name or several, and a path in brackets: "`find_pairs` and `collide` (`physics/a.cpp`)".
    static const std::regex place("((?:`[\\w:]+`(?:,| and| or)?\\s+)+)\\(`([^`\\n]+)`\\)");
    static const std::regex name("(\\w+)`");  // without its class
    Violations found;
    for (std::sregex_iterator each(text.begin(), text.end(), place), end; each != end; ++each) {
        const auto file = tree.files().find((*each)[2]);
        if (file == tree.files().end()) continue;  // a lost path
        const std::string names = (*each)[1];
        for (std::sregex_iterator one(names.begin(), names.end(), name); one != end; ++one)
            if (!mentions(file->second, (*one)[1]))
                found.push_back(file->first + ": " + (*one)[1].str() + " is not in it");
    }
    return found;
}

Violations lost_members(const SourceTree& tree, const std::string& text) {
    static const std::regex member("`(\\w+)::(\\w+)`");
    Violations found;
    for (std::sregex_iterator each(text.begin(), text.end(), member), end; each != end; ++each) {
        const std::string type = (*each)[1], name = (*each)[2];
        if (type == "std" || type == "sf" || type == "Fettle")
            continue;  // libraries, targets of CMake
        const std::regex definition("\\b(class|struct|enum|namespace)\\b.*\\b" + type + "\\b");
        const bool any = std::ranges::any_of(tree.files(), [&](const auto& entry) {
            return std::ranges::any_of(entry.second.lines,
                                       [&](const std::string& line) {
                                           return line.find(type) != line.npos &&
                                                  std::regex_search(line, definition);
                                       }) &&
                   mentions(entry.second, name);
        });
        if (!any) found.push_back(type + "::" + name + ": no file has it");
    }
    return found;
}

Violations rooms_without_line(const std::string& text) {
    Violations found;
    for (const std::string& folder : folders_of_rooms())
        if (text.find("| `" + folder + "` |") == std::string::npos)
            found.push_back(folder + ": the room has no line");
    return found;
}

}  // namespace fettle::architecture
