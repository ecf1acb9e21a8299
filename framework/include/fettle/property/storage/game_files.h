#pragma once
// The files that a game itself reads and writes while it runs: scripts, scenes, kept tweaks. Who
// records a run learns here what it began with; who makes it again gives that back, and what the
// run writes stays in memory.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fettle/property/storage/export.h>
#include <fettle/property/storage/scene.h>

FETTLE_STORAGE_BEGIN

namespace fettle::property {

/// The checksum of what a file holds; nothing where there is no file. Throws FileError.
std::optional<std::uint64_t> file_checksum(const std::filesystem::path& file);

class GameFiles {
  public:
    /// Bytes; greater files are refused.
    static constexpr std::size_t size_limit = std::size_t{64} << 20;

    /// From now on only what lies below `game` is a file of this game, and, to be read, what lies
    /// below `shared`. Links that lead out of these folders are not followed. Until then every file
    /// is one.
    void stay_below(const std::filesystem::path& game, const std::filesystem::path& shared = {});

    /// Throws FileError: missing, unreadable, not a regular file, too large, outside of the game's
    /// folders.
    std::string read(const std::filesystem::path& file);
    bool exists(const std::filesystem::path& file);
    /// Whole or not at all, and durably. Throws FileError; the old file is then as it was.
    void write(const std::filesystem::path& file, std::string_view content);
    /// The same for the text of a scene, which replaces another scene or nothing: FileError for a
    /// file of another kind, a hidden one, and a name that means something to Fettle itself
    /// (`main.lua`, `modules.json`, `game.json`, `*.tweaks.json`, what ends in .lua, .so or
    /// .sqlite).
    void write_scene(const std::filesystem::path& file, std::string_view text);

    /// While it lives, no other process changes files of this game that way: for those who read a
    /// file, change it and write it again. Throws FileError when another one keeps its own for more
    /// than five seconds. Null where nothing is written, or no folder is known.
    [[nodiscard]] std::shared_ptr<void> lock();

    /// How the run came upon a file.
    struct Finding {
        std::filesystem::path file;
        std::optional<std::uint64_t> checksum;  // nothing: there was no file
        /// It is about to be written. What it holds is lost then.
        bool overwritten = false;
        std::optional<std::string> content{};  // of an overwritten one that was there
    };
    /// Tells of every file once when it is first looked at, and before it is first written: of
    /// those so far at once. Only after `take_note`, which comes before anything is read.
    void tell(std::function<void(const Finding&)> listener);
    void take_note() { notes_ = true; }
    /// Something else of the game reads that file: its module is in there.
    void looks_at(const std::filesystem::path& file);

    /// From now on nothing is written to the disk: it stays here, for whoever reads it.
    void stay_in_memory() { in_memory_ = true; }
    /// What stands for the file on the disk; nothing: none.
    void put(const std::filesystem::path& file, std::optional<std::string> content);

  private:
    using Path = std::filesystem::path;
    static Path key(const Path& file);
    /// Where the file is. Throws FileError outside of the game's folders.
    Path checked(const Path& file, bool to_write) const;
    const std::optional<std::string>* held(const Path& file) const;
    void note(const Path& file, const std::optional<std::string>& content);
    void note_overwritten(const Path& file);
    void add(Finding finding);

    struct Known {
        bool looked_at = false, overwritten = false;
    };
    Path game_, shared_;  // without links; empty: not told
    Path named_;          // the game's folder as it was told
    bool notes_ = false;
    bool in_memory_ = false;
    std::map<Path, std::optional<std::string>> held_;  // stands for what is on the disk
    std::map<Path, Known> known_;
    std::vector<Finding> findings_;  // nobody was told of yet
    std::function<void(const Finding&)> listener_;
};

}  // namespace fettle::property

FETTLE_STORAGE_END
