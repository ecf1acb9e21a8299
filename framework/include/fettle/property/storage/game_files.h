#pragma once
// The files that a game itself reads and writes while it runs: scripts, scenes, kept tweaks. A
// recording gets their content at the start of the run from this class. A replay puts that content
// back, and files that it writes stay in memory.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fettle/property/storage/export.h>
#include <fettle/property/storage/scene.h>

FETTLE_STORAGE_BEGIN

namespace fettle::property {

/// The checksum of a file's content; none if the file does not exist. Throws FileError.
std::optional<std::uint64_t> file_checksum(const std::filesystem::path& file);

class GameFiles {
  public:
    /// Bytes; larger files are refused.
    static constexpr std::size_t size_limit = std::size_t{64} << 20;

    /// From now on only files below `game` are files of this game, and, for reading, files below
    /// `shared`. Links that lead out of these folders are not followed. Before this call all files
    /// are allowed.
    void stay_below(const std::filesystem::path& game, const std::filesystem::path& shared = {});

    /// Throws FileError: missing, unreadable, not a regular file, too large, outside of the game's
    /// folders.
    std::string read(const std::filesystem::path& file);
    bool exists(const std::filesystem::path& file);
    /// Writes the whole file or nothing, and waits for the disk. Throws FileError; the old file is
    /// then unchanged.
    void write(const std::filesystem::path& file, std::string_view content);
    /// Like `write`, for the text of a scene, which may replace only another scene. FileError for a
    /// file of another kind, a hidden file, and names that Fettle uses itself (`main.lua`,
    /// `modules.json`, `game.json`, `*.tweaks.json`, names that end in .lua, .so or .sqlite).
    void write_scene(const std::filesystem::path& file, std::string_view text);

    /// While the result lives, no other process with this lock changes files of this game. Needed
    /// for reading a file, changing it and writing it again. Throws FileError if another process
    /// holds the lock for more than five seconds. Null if the files are held in memory, or if no
    /// folder is set.
    [[nodiscard]] std::shared_ptr<void> lock();

    /// The state in which the run found a file.
    struct FileState {
        std::filesystem::path file;
        std::optional<std::uint64_t> checksum;  // none: the file did not exist
        /// True if it is about to be written, which loses its content.
        bool overwritten = false;
        std::optional<std::string> content{};  // of an overwritten file that existed
    };
    /// Reports every file once when it is first read or checked, and before it is first written.
    /// Earlier ones are reported at once. Requires a call of `record_reads` before anything is
    /// read.
    void on_first_access(std::function<void(const FileState&)> listener);
    /// Remembers from now on which files are read, for `on_first_access`.
    void record_reads() { records_reads_ = true; }
    /// Calls `listener` after each write to the disk, with the file as it was passed.
    void on_write(std::function<void(const std::filesystem::path&)> listener) {
        on_write_ = std::move(listener);
    }
    /// Must be called when other code of the game reads that file, for example the loader of its
    /// module.
    void note_read(const std::filesystem::path& file);

    /// The game's files that were read or found missing so far, without those that are held in
    /// memory.
    std::vector<std::filesystem::path> seen() const;
    /// How often that file was read, or looked for.
    std::size_t times_seen(const std::filesystem::path& file) const;
    /// The files below `folder` that are held in memory: their names relative to it, with forward
    /// slashes.
    std::vector<std::string> names_in_memory(const std::filesystem::path& folder) const;
    /// Bytes that may be written from now on, all files together; further writes throw FileError.
    void limit_writes(std::size_t bytes) { writable_ = bytes; }

    /// From now on nothing is written to the disk: written files stay in memory, and reads find
    /// them there.
    void stay_in_memory() { in_memory_ = true; }
    /// Replaces the content of the file for reads; none: the file does not exist.
    void put(const std::filesystem::path& file, std::optional<std::string> content);

  private:
    using Path = std::filesystem::path;
    static Path key(const Path& file);
    /// The real path of the file. Throws FileError outside of the game's folders.
    Path checked(const Path& file, bool to_write) const;
    const std::optional<std::string>* held(const Path& file) const;
    void note(const Path& file, const std::optional<std::string>& content);
    void note_overwritten(const Path& file);
    void add(FileState state);

    void see(const Path& file) { ++seen_[file]; }

    struct Known {
        bool looked_at = false, overwritten = false;
    };
    Path game_, shared_;  // without links; empty: not set
    Path named_;          // the game's folder as it was passed
    bool records_reads_ = false;
    bool in_memory_ = false;
    std::map<Path, std::optional<std::string>> held_;  // in place of the files on the disk
    std::map<Path, Known> known_;
    std::map<Path, std::size_t> seen_;  // as they were passed; how often
    std::optional<std::size_t> writable_;
    std::vector<FileState> unreported_;  // not yet reported
    std::function<void(const FileState&)> listener_;
    std::function<void(const Path&)> on_write_;
};

}  // namespace fettle::property

FETTLE_STORAGE_END
