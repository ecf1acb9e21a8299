#pragma once
// Earlier commands: stepping through them by prefix, searching, and a file for all runs.
//
// The file contains one command per line, with `\` and newline escaped. A command is appended in
// one write, so two games that run at once both keep their commands, and a crash can lose only the
// last line. A long file is written again under a temporary name, which then replaces it. After an
// error of the file, the console continues without it and reports the error once.

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fettle::console {

class History {
  public:
    static constexpr std::size_t max_entries = 2000;
    static constexpr std::size_t max_entry_bytes = 64 * 1024;
    static constexpr std::size_t max_file_bytes = std::size_t{4} << 20;

    /// Without a `file`, the history exists only in memory.
    explicit History(std::filesystem::path file = {});

    /// Oldest first. Each command occurs once: a repeated one moves to the end.
    const std::vector<std::string>& entries() const { return entries_; }
    void add(std::string_view command);
    /// The nearest entry before index `from` that begins with `prefix` and is not `except`.
    std::optional<std::size_t> older(std::string_view prefix, std::size_t from,
                                     std::string_view except = {}) const;
    std::optional<std::size_t> newer(std::string_view prefix, std::size_t from) const;
    /// The nearest entry before index `from` that contains `part`. Case is ignored unless `part`
    /// contains a capital letter.
    std::optional<std::size_t> containing(std::string_view part, std::size_t from) const;

    /// Returns and clears the last error of the file, "" if there was none.
    std::string consume_problem();

  private:
    void load();
    void append(std::string_view command);
    void rewrite();
    void add_entry(std::string_view command);
    void fail(const std::string& what);

    std::filesystem::path file_;
    std::vector<std::string> entries_;
    std::size_t lines_in_file_ = 0;
    std::string problem_;
    bool writable_ = true;
};

}  // namespace fettle::console
