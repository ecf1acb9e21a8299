#pragma once
// Keeping of rows in a scene file.

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <keep/row_report.h>
#include <keep/row_stages.h>
#include <scenes/scene_edit.h>

namespace fettle::property {

inline constexpr const char* given_by_script =
    "a name or parent that a script gives cannot be kept: change the script";

inline constexpr const char* name_of_deleted =
    "a script gives the name to what was deleted: choose another one";

/// Throws Error if the scene of a new instance could not be loaded in its place.
void check_made(const Tweaks::State& state, const RowPaths& paths, const JournalRow& row);
/// Throws Error if an instance was moved out of the deleted one: its move is in no file, so it
/// would be deleted too.
void require_nothing_moved_out(const RowPaths& paths, const JournalRow& row);
/// Stores the text that a deletion removed from a file, a JSON object, in addition to texts from
/// other files.
void store_removed_text(Tweaks::State& state, const JournalRow& row, const std::string& text);

class SceneKeeping {
  public:
    /// Reads the file. Throws Error.
    SceneKeeping(Tweaks::State& state, const RowPaths& paths, RowReport& report,
                 const std::filesystem::path& file);
    /// Returns the rows that are in the text now; reports the others.
    Rows keep(const Rows& rows);
    const std::string& text() const { return edit_.text(); }

  private:
    bool loadable() const;
    Rows edited(const Rows& rows, bool each);
    template <class Edit>
    void restore_text_on_error(Edit edit);
    void edit_scene(const JournalRow& row, const Rows& moves);
    void require_name_free(const std::string& home, const Rows& moves) const;
    NewPath named_in_file(const JournalRow& row) const;
    void remove_marks();
    void rename(const Rows& rows, bool check);
    void require_named_by_file(const JournalRow& row) const;
    void set_text(std::string text);

    Tweaks::State& state_;
    const RowPaths& paths_;
    RowReport& report_;
    SceneEdit edit_;
};

}  // namespace fettle::property
