#pragma once
// Saved games: one file for each slot. It is written completely or not at all, and refused with a
// reason if it is damaged, newer or of another game.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <fettle/property/storage/export.h>
#include <fettle/property/storage/scene.h>

namespace fettle::property {
class Database;  // not exported
}

FETTLE_STORAGE_BEGIN

namespace fettle::property {

/// A small picture of the game: rows from the top, four bytes a pixel (red, green, blue, opacity).
struct Thumbnail {
    std::uint32_t width = 0, height = 0;  // px; 0: no picture
    std::vector<std::uint8_t> pixels{};
    bool empty() const { return width == 0 || height == 0; }
};

/// The picture, at most `widest` px wide, its pixels averaged. Throws Error(out_of_range) unless it
/// has four bytes a pixel.
Thumbnail scaled_down(const Thumbnail& picture, std::uint32_t widest);

struct SaveInfo {
    std::string slot;
    std::uint64_t step = 0;
    std::int64_t time = 0;  // s since 1970
    std::string program;    // version of Fettle that wrote it
    std::size_t bytes = 0;  // of the file
    bool thumbnail = false;
    std::string problem;  // why it cannot be loaded; "" if it can
};

struct SavedGame {
    SaveInfo info;
    std::vector<std::byte> state;
    Thumbnail thumbnail;
};

class Saves {
  public:
    /// The first save creates `folder`. `game`: name of the game; saves of another game are
    /// refused. `program`: written into the saves.
    Saves(std::filesystem::path folder, std::string game, std::string program);

    /// Throws Error(bad_name) unless the name is 1 to 64 letters, digits, spaces, - or _, without a
    /// space at its beginning or end.
    static void check_slot(std::string_view slot);

    /// Writes a file, reads it back and compares it before it replaces an older save of that slot,
    /// which stays in case of any error. Throws FileError, Error(bad_name), Error(out_of_range) for
    /// a step above 2⁶³-1 and for a picture that does not have four bytes a pixel or has more than
    /// 16 MiB.
    void save(const std::string& slot, std::uint64_t step, std::span<const std::byte> state,
              const Thumbnail& thumbnail = {}) const;
    /// Throws FileError with the reason if the file cannot be used, Error(unknown_name) with the
    /// nearest spelling if there is no such slot.
    SavedGame load(const std::string& slot) const;
    /// Sorted by name; saves that cannot be loaded contain the reason. `problem_of` can check
    /// further, for saves without damage, whether the game can restore them: it returns the reason,
    /// or "".
    using Check = std::function<std::string(const SavedGame&)>;
    std::vector<SaveInfo> list(const Check& problem_of = {}) const;
    /// Whether there is a file of that slot, valid or not. Throws Error(bad_name).
    bool exists(const std::string& slot) const;
    /// Throws as `load` does if there is no such slot, FileError if the file cannot be removed.
    void remove(const std::string& slot) const;

    const std::filesystem::path& folder() const { return folder_; }
    /// Path of the file of a slot, also if there is none. Throws Error(bad_name).
    std::filesystem::path file(const std::string& slot) const;

  private:
    std::filesystem::path existing(const std::string& slot) const;
    SavedGame read(const std::filesystem::path& file) const;
    void read(Database& database, SavedGame& into) const;

    std::filesystem::path folder_;
    std::string game_;
    std::string program_;
};

}  // namespace fettle::property

FETTLE_STORAGE_END
