#pragma once
// The sources of the project, as the rules of the architecture read them: paths and lines of text.

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace fettle::architecture {

struct Include {
    std::string name;  // between the brackets or quotes
    bool quoted = false;
    int line = 0;  // the first line is 1
};

struct SourceFile {
    std::string path;  // relative to the root of the project, with forward slashes
    std::vector<std::string> lines;

    bool is_header() const;
    bool is_cpp() const;    // header or source
    bool is_cmake() const;  // CMakeLists.txt
    bool is_public_header() const;
    std::vector<Include> includes() const;
};

/// Sources by path. They are read from a folder, or given as texts, so that a test can show that a
/// rule reports a violation.
class SourceTree {
  public:
    SourceTree() = default;
    explicit SourceTree(const std::map<std::string, std::string>& texts);

    /// Reads all C++, C, Lua and CMake files below `root`; skips `build` and hidden folders.
    static SourceTree read(const std::filesystem::path& root);

    const std::map<std::string, SourceFile>& files() const { return files_; }
    bool contains(const std::string& path) const { return files_.contains(path); }

    /// Path of the file of the project that `include` in `from` denotes; "" if it is not a file of
    /// the project.
    std::string resolve(const SourceFile& from, const Include& include) const;

  private:
    void add(const std::string& path, const std::string& text);

    std::map<std::string, SourceFile> files_;
};

}  // namespace fettle::architecture
