#pragma once
// The files of a game by name: "images/hero.png" is the file below the game's folder, or else the
// one below a second folder with files that all games share.

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <fettle/property/storage/export.h>

FETTLE_STORAGE_BEGIN

namespace fettle::property {

class GameFiles;

/// A list of file endings, such as ".png", in lower case.
using Endings = std::span<const std::string_view>;

class Assets {
  public:
    /// `files` must outlive this object. Either folder may be empty: it has no files then.
    Assets(GameFiles& files, std::filesystem::path game, std::filesystem::path shared = {})
        : files_(files), game_(std::move(game)), shared_(std::move(shared)) {}

    const std::filesystem::path& game() const { return game_; }

    /// The path of the file `name`, which may not exist. Throws Error(rejected) for a name that is
    /// empty, absolute or leads out of the folder. `what` begins the messages: "Sprite.image".
    std::filesystem::path path_of(std::string_view what, const std::string& name) const;
    /// The path of an existing file. Throws as `path_of`, and Error(unknown_name) with the nearest
    /// name among files with these endings if there is no such file.
    std::filesystem::path find(std::string_view what, const std::string& name,
                               Endings endings) const;
    /// The content of an existing file. Throws as `find`, and FileError.
    std::string read(std::string_view what, const std::string& name, Endings endings) const;

    /// Names of files with one of these endings, for suggestions; at most a thousand from each
    /// folder.
    std::vector<std::string> names(Endings endings) const;

  private:
    GameFiles& files_;
    std::filesystem::path game_, shared_;
};

}  // namespace fettle::property

FETTLE_STORAGE_END
