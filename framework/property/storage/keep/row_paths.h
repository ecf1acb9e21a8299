#pragma once
// Paths of instances in three forms: as in rows of the journal, as in the game's files (home
// paths), and as in the tree now.

#include <cstdint>
#include <functional>
#include <map>
#include <string>

#include <scenes/image.h>
#include <tweaks/tweaks_state.h>

namespace fettle::property {

class RowPaths {
  public:
    explicit RowPaths(const Tweaks::State& state);

    /// The home path of the instance that a row calls `path`. Rows about moves and deletions
    /// contain it directly.
    std::string home(const JournalRow& row, const std::string& path) const;
    /// The home path of the instance that the row is about.
    std::string home(const JournalRow& row) const;
    /// The home path of the new parent of a moved instance.
    std::string home_of_new_parent(const JournalRow& row) const;
    /// The home path of the topmost instance of the scene in which the row is to be kept.
    std::string home_of_top(const JournalRow& row) const;
    /// The inverse of `home`: the path that rows of the same run use for the instance.
    std::string path_in_rows(const JournalRow& row, const std::string& home) const;
    /// The home path of the instance at a current path.
    std::string home_of_live(const std::string& path) const;
    /// The current path of the instance with that home path if they differ; otherwise "".
    std::string moved_from(const std::string& home) const { return now_.moved_from(home); }
    /// The current path of an instance that was moved out of a deleted one; "" if there is none.
    std::string moved_out_of(const JournalRow& deletion) const;
    /// The current path of the instance that a row calls `path`.
    std::string live(const JournalRow& row, const std::string& path) const;
    /// The instance with that home path; null if it does not exist now.
    Handle instance(const std::string& home) const;

    /// Calls `visit` with the home path of each instance that the value or the scene of the row
    /// names.
    void each_named(const JournalRow& row,
                    const std::function<void(const std::string& home)>& visit) const;
    /// Whether the row is about an instance below the one with that home path, or names it.
    bool needs(const JournalRow& row, const std::string& home) const;

    /// The value with current paths in its references. Throws Error if it cannot be kept.
    Image live_image(const JournalRow& row) const;
    /// The scene of a new instance. References are home paths, or the result of `written` for
    /// these.
    std::string home_scene(const JournalRow& row, const NewPath& written = {}) const;

  private:
    const InstanceMoves& moves_of(const JournalRow& row) const;

    const Tweaks::State* state_;
    InstanceMoves now_;
    std::map<std::int64_t, InstanceMoves> earlier_;  // by run
};

}  // namespace fettle::property
