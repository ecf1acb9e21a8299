#pragma once
// Scene files: an instance and everything below it as JSON, made to be read, edited and compared by
// people. Only what differs from the defaults of the classes is written, in a stable order, and
// loading gives back every value exactly. docs/design/scenes.md describes the format.

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

/// A file could not be read or written. The message names the file and what the system said.
class FileError : public Error {
  public:
    FileError(const std::filesystem::path& file, const std::string& what_happened)
        : Error(ErrorKind::rejected, file.string() + ": " + what_happened),
          file_(file),
          what_happened_(what_happened) {}
    const std::filesystem::path& file() const { return file_; }
    /// The same about a file that is called by another of its names.
    FileError of(const std::filesystem::path& file) const { return {file, what_happened_}; }

  private:
    std::filesystem::path file_;
    std::string what_happened_;
};

/// What a scene file says cannot be. The message is `file:line:column: path: reason`.
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
    /// The message without the place.
    const std::string& reason() const { return reason_; }
    /// The same with the path it is about in front of the reason.
    SceneError about(const std::string& path) const {
        return {kind(), file_, line_, column_, path + ": " + reason_};
    }
    /// From 1; columns count characters, not bytes.
    std::size_t line() const { return line_; }
    std::size_t column() const { return column_; }

  private:
    std::string file_;
    std::size_t line_;
    std::size_t column_;
    std::string reason_;
};

/// The version of the format this program writes, and the newest it reads.
inline constexpr int scene_format_version = 1;

/// The name of the ad-hoc text property that holds, as JSON, what a scene file said about an
/// instance that nothing here understands. Saving writes it back to where it came from.
inline constexpr std::string_view unknown_keys_property = "unknown_keys";

/// `node` and everything below it as the text of a scene file. Throws Error for what no file can
/// hold: the root of the tree, NaN, a reference to a detached instance outside `node`, a name that
/// is not UTF-8, more than 400 instances inside each other. A formula is held by its text and its
/// value; `warnings`, when given, receives a line for each whose text alone would not be the same
/// formula and of which only the value is held.
std::string scene_text(const Tree& tree, Handle node, std::vector<std::string>* warnings = nullptr);

/// Writes `scene_text` to a file: into a temporary file beside it, read back, synchronized with the
/// disk, then renamed over `file`. Throws FileError; the old file is then as it was.
void save_scene(const Tree& tree, Handle node, const std::filesystem::path& file,
                std::vector<std::string>* warnings = nullptr);

/// Where in its scene file an instance was described.
struct SceneInstance {
    Handle instance{};
    std::size_t parent = 0;  // which of the list describes its parent; of the topmost, itself
    std::size_t place = 0;   // among its parent's children in the file, from 0
};

/// Builds the instances a scene file describes below `parent` (null: detached) and returns the
/// topmost one. It is called `name`, or as the file says (numbered when `parent` has a child of
/// that name). Names of properties that its class does not have, and other keys that nothing here
/// understands, are kept and written back by saving; `warnings`, when given, receives a line for
/// each such property; `instances` receives every instance, parents before children. Every instance
/// emits `ready`, children before parents.
///
/// Formulas are made by the tree's compiler (`Tree::compile_formulas_with`); without one a formula
/// keeps its text and the value the file tells.
///
/// Throws SceneError, FileError, or Error for a `parent` or `name` that cannot be; nothing has
/// changed then.
Handle load_scene(Tree& tree, const std::filesystem::path& file, Handle parent,
                  std::string_view name = {}, std::vector<std::string>* warnings = nullptr,
                  std::vector<SceneInstance>* instances = nullptr);

/// The same from a text; `file_name` stands in messages and causes.
Handle load_scene_text(Tree& tree, std::string_view text, std::string_view file_name, Handle parent,
                       std::string_view name = {}, std::vector<std::string>* warnings = nullptr,
                       std::vector<SceneInstance>* instances = nullptr);

}  // namespace fettle::property

FETTLE_STORAGE_END
