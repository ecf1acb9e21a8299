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
    /// Lines and columns count from 1; columns count characters, not bytes.
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

/// Name of an ad-hoc text property. It holds the unknown keys of an instance in its scene file, as
/// JSON. Saving writes them back to their places.
inline constexpr std::string_view unknown_keys_property = "unknown_keys";

/// Returns the text of a scene file with `node` and everything below it. Throws Error for data that
/// a file cannot contain: the root of the tree, NaN, a reference to a detached instance outside
/// `node`, a name that is not UTF-8, more than 400 nested instances. A formula is written as its
/// text and its value. If its text alone does not define the same formula, only the value is
/// written, and a line is added to `warnings` (unless it is null).
std::string scene_text(const Tree& tree, Handle node, std::vector<std::string>* warnings = nullptr);

/// Writes `scene_text` to a file: into a temporary file beside it, which is read back, synchronized
/// with the disk, then renamed to `file`. Throws Error like `scene_text`, and FileError; the old
/// file is then unchanged, unless the message says that the file was written but may be lost.
void save_scene(const Tree& tree, Handle node, const std::filesystem::path& file,
                std::vector<std::string>* warnings = nullptr);

/// Position of an instance in its scene file.
struct SceneInstance {
    Handle instance{};
    std::size_t parent = 0;  // index of the parent in the list; the topmost one has its own index
    std::size_t place = 0;   // index among the children of the parent in the file
};

/// Creates the instances of a scene file below `parent` (null: detached) and returns the topmost
/// one. Its name is `name`, or the name in the file if `name` is empty (with a number if `parent`
/// has a child of that name). Properties that the class does not have, and other unknown keys, are
/// stored and written back by saving. For each such property, a line is added to `warnings` (unless
/// it is null). `instances` (unless it is null) gets every instance, parents before children. Every
/// instance emits `ready`, children before parents.
///
/// Formulas are compiled by the compiler of the tree (`Tree::compile_formulas_with`). Without a
/// compiler, a formula keeps its text and its value in the file.
///
/// Throws SceneError, FileError, or Error for an invalid `parent` or `name`; then nothing has
/// changed.
Handle load_scene(Tree& tree, const std::filesystem::path& file, Handle parent,
                  std::string_view name = {}, std::vector<std::string>* warnings = nullptr,
                  std::vector<SceneInstance>* instances = nullptr);

/// Whether the text of a JSON file is a scene. Throws the SceneError that loading it would throw,
/// as far as the classes show, also for a text that is not JSON. Nothing is made. For each key that
/// is probably a mistake, a line is added to `warnings` (unless it is null).
bool check_scene_text(const Tree& tree, std::string_view text, std::string_view file_name,
                      std::vector<std::string>* warnings = nullptr);

/// Like `load_scene`, from a text; `file_name` appears in messages and causes.
Handle load_scene_text(Tree& tree, std::string_view text, std::string_view file_name, Handle parent,
                       std::string_view name = {}, std::vector<std::string>* warnings = nullptr,
                       std::vector<SceneInstance>* instances = nullptr);

}  // namespace fettle::property

FETTLE_STORAGE_END
