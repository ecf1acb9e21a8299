#pragma once
// The project's own sources as the rules of the architecture see them: paths and lines of text.

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace fettle::architecture {

struct Include {
    std::string name;  // between the brackets or quotes
    bool quoted = false;
    int line = 0;  // from 1
};

struct SourceFile {
    std::string path;  // from the project's root, with forward slashes
    std::vector<std::string> lines;

    bool is_header() const;
    bool is_cpp() const;    // header or source
    bool is_cmake() const;  // CMakeLists.txt
    bool is_public_header() const;
    std::vector<Include> includes() const;
};

/// Sources by path. Made from a folder on disk, or from texts, so that a rule can be shown to fail.
class SourceTree {
  public:
    SourceTree() = default;
    explicit SourceTree(const std::map<std::string, std::string>& texts);

    /// Everything under `root` that is code, Lua or CMake; skips `build` and hidden folders.
    static SourceTree read(const std::filesystem::path& root);

    const std::map<std::string, SourceFile>& files() const { return files_; }
    bool contains(const std::string& path) const { return files_.contains(path); }

    /// The project's file that `include` in `from` denotes, or "" when it is none of the project's.
    std::string resolve(const SourceFile& from, const Include& include) const;

  private:
    void add(const std::string& path, const std::string& text);

    std::map<std::string, SourceFile> files_;
};

}  // namespace fettle::architecture
