#pragma once
// What was typed before: walked by prefix, searched, and kept in a file from run to run.
//
// The file holds one command a line, `\` and newline escaped. A command is appended in one write,
// so two games running at once both keep theirs and a crash can only lose the last line; a file
// grown long is rewritten beside itself and renamed over. Whatever is wrong with the file, the
// console goes on without it and says so once.

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

    /// In memory only when `file` is empty.
    explicit History(std::filesystem::path file = {});

    /// Oldest first. No command appears twice: one typed again moves to the end.
    const std::vector<std::string>& entries() const { return entries_; }
    void add(std::string_view command);
    /// The nearest entry before index `from` that begins with `prefix` and is not `except`.
    std::optional<std::size_t> older(std::string_view prefix, std::size_t from,
                                     std::string_view except = {}) const;
    std::optional<std::size_t> newer(std::string_view prefix, std::size_t from) const;
    /// The nearest entry before index `from` that contains `part`, letter case ignored unless
    /// `part` has a capital.
    std::optional<std::size_t> containing(std::string_view part, std::size_t from) const;

    /// What went wrong with the file since last asked, "" when nothing did.
    std::string take_problem();

  private:
    void load();
    void append(std::string_view command);
    void rewrite();
    void remember(std::string_view command);
    void fail(const std::string& what);

    std::filesystem::path file_;
    std::vector<std::string> entries_;
    std::size_t lines_in_file_ = 0;
    std::string problem_;
    bool writable_ = true;
};

}  // namespace fettle::console
