#pragma once
// The paths that rows of the journal say, the paths by which the game's files know the same
// instances, and where these are in the tree now.

#include <cstdint>
#include <map>
#include <string>

#include <scenes/image.h>
#include <tweaks/tweaks_state.h>

namespace fettle::property {

class RowPaths {
  public:
    explicit RowPaths(const Tweaks::State& state);

    /// The home path of what a row calls `path`: of a moved or deleted instance rows say it at
    /// once.
    std::string home(const JournalRow& row, const std::string& path) const;
    /// The home path of what the row is about.
    std::string home(const JournalRow& row) const;
    /// Where the parent of a moved instance is at home.
    std::string home_of_new_parent(const JournalRow& row) const;
    /// Of the topmost instance of the scene that the row is to be kept in.
    std::string home_of_top(const JournalRow& row) const;
    /// What a row of the same run calls an instance.
    std::string said(const JournalRow& row, const std::string& home) const;
    /// Of what is at a path of the tree now.
    std::string home_of_live(const std::string& path) const;
    /// Where the instance of that home path is now, if that is another path; else "".
    std::string moved_from(const std::string& home) const { return now_.moved_from(home); }
    /// Where something is that has moved out of a deleted instance; "": nothing has.
    std::string moved_out_of(const JournalRow& deletion) const;
    /// Where what a row calls `path` is now.
    std::string live(const JournalRow& row, const std::string& path) const;
    /// The instance of that home path; null where there is none now.
    Handle instance(const std::string& home) const;

    /// Whether the row is about something below the instance of that home path, or names it.
    bool needs(const JournalRow& row, const std::string& home) const;

    /// A value with its references as they are in the tree now. Throws Error for one that cannot be
    /// kept.
    Image live_image(const JournalRow& row) const;
    /// The scene of a new instance with the home path in every reference, or what `written` makes
    /// of that.
    std::string home_scene(const JournalRow& row, const NewPath& written = {}) const;

  private:
    const InstanceMoves& moves_of(const JournalRow& row) const;

    const Tweaks::State* state_;
    InstanceMoves now_;
    std::map<std::int64_t, InstanceMoves> earlier_;  // by run
};

}  // namespace fettle::property
