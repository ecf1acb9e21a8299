#pragma once
// Scene files: an instance and everything below it as JSON, for people to read, edit and compare.
// Only values that differ from the defaults of the classes are written, in a stable order, and
// loading restores every value exactly. docs/design/scenes.md describes the format.

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <fettle/property/error.h>
#include <fettle/property/storage/export.h>
#include <fettle/property/tree.h>

FETTLE_STORAGE_BEGIN

namespace fettle::property {

/// A file could not be read or written. The message names the file and the error of the system.
class FileError : public Error {
  public:
    FileError(const std::filesystem::path& file, const std::string& what_happened)
        : Error(ErrorKind::rejected, file.string() + ": " + what_happened),
          file_(file),
          what_happened_(what_happened) {}
    const std::filesystem::path& file() const { return file_; }
    /// The same error with another name of the file.
    FileError of(const std::filesystem::path& file) const { return {file, what_happened_}; }

  private:
    std::filesystem::path file_;
    std::string what_happened_;
};

/// An error in a scene file. The message is `file:line:column: path: reason`.
class SceneError : public Error {
  public:
    SceneError(ErrorKind kind, std::string file, std::size_t line, std::size_t column,
               const std::string& reason)
        : Error(kind,
                file + ":" + std::to_string(line) + ":" + std::to_string(column) + ": " + reason),
          file_(std::move(file)),
          line_(line),
          column_(column),
          reason_(reason) {}
    const std::string& file() const { return file_; }
    /// The message without the position.
    const std::string& reason() const { return reason_; }
    /// The same error with a path in front of the reason.
    SceneError about(const std::string& path) const {
        return {kind(), file_, line_, column_, path + ": " + reason_};
    }
    /// Count from 1; columns count characters, not bytes.
    std::size_t line() const { return line_; }
    std::size_t column() const { return column_; }

  private:
    std::string file_;
    std::size_t line_;
    std::size_t column_;
    std::string reason_;
};

/// The format version that this program writes, and the newest that it reads.
inline constexpr int scene_format_version = 1;

/// Name of the ad-hoc text property that holds, as JSON, the keys of a scene file about an instance
/// that this program does not know. Saving writes them back to their places.
inline constexpr std::string_view unknown_keys_property = "unknown_keys";

/// `node` and everything below it as the text of a scene file. Throws Error for data that no file
/// can hold: the root of the tree, NaN, a reference to a detached instance outside `node`, a name
/// that is not UTF-8, more than 400 nested instances. A formula is written as its text and its
/// value; if its text alone does not define the same formula, only the value is written and
/// `warnings`, if given, gets a line.
std::string scene_text(const Tree& tree, Handle node, std::vector<std::string>* warnings = nullptr);

/// Writes `scene_text` to a file: into a temporary file beside it, which is read back, synchronized
/// with the disk, then renamed to `file`. Throws FileError; the old file is then unchanged.
void save_scene(const Tree& tree, Handle node, const std::filesystem::path& file,
                std::vector<std::string>* warnings = nullptr);

/// Position of an instance in its scene file.
struct SceneInstance {
    Handle instance{};
    std::size_t parent = 0;  // index of its parent; for the topmost one, its own
    std::size_t place = 0;   // index among its parent's children in the file
};

/// Builds the instances of a scene file below `parent` (null: detached) and returns the topmost
/// one. Its name is `name`, or that in the file (numbered if `parent` has a child of that name).
/// Names of properties that its class does not have, and other unknown keys, are kept and written
/// back by saving; `warnings`, if given, gets a line for each such property; `instances` gets every
/// instance, parents before children. Every instance emits `ready`, children before parents.
///
/// The tree's compiler makes formulas (`Tree::compile_formulas_with`); without one a formula keeps
/// its text and the value in the file.
///
/// Throws SceneError, FileError, or Error for an impossible `parent` or `name`; nothing has changed
/// then.
Handle load_scene(Tree& tree, const std::filesystem::path& file, Handle parent,
                  std::string_view name = {}, std::vector<std::string>* warnings = nullptr,
                  std::vector<SceneInstance>* instances = nullptr);

/// As `load_scene`, from a text; `file_name` appears in messages and causes.
Handle load_scene_text(Tree& tree, std::string_view text, std::string_view file_name, Handle parent,
                       std::string_view name = {}, std::vector<std::string>* warnings = nullptr,
                       std::vector<SceneInstance>* instances = nullptr);

}  // namespace fettle::property

FETTLE_STORAGE_END
