// Checks the map of the project in the documents: the paths and rooms that it names.

#include <algorithm>
#include <regex>

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

Violations rooms_without_line(const std::string& text) {
    Violations found;
    for (const std::string& folder : folders_of_rooms())
        if (text.find("| `" + folder + "` |") == std::string::npos)
            found.push_back(folder + ": the room has no line");
    return found;
}

}  // namespace fettle::architecture
