#pragma once
// One run of `keep`: what it reports, and the changes that follow when rows are kept.

#include <filesystem>
#include <string>
#include <vector>

#include <fettle/property/storage/tweaks.h>

#include <keep/row_paths.h>
#include <keep/row_report.h>
#include <keep/row_stages.h>
#include <tweaks/tweaks_state.h>

namespace fettle::property {

struct KeepRun {
    KeepRun(Tweaks::State& state, TweakReport& report);
    ~KeepRun();
    KeepRun(const KeepRun&) = delete;

    /// Writes a file by `write_it`, and marks the rows as kept in it. Returns false if there are no
    /// rows, or if the file cannot be written, which is reported. Throws the SceneError of
    /// `write_it`: the content of a row causes it.
    template <class Write>
    bool write(const std::filesystem::path& file, const Rows& rows, Write write_it) {
        if (rows.empty()) return false;
        try {
            write_it();
        } catch (const SceneError&) {
            throw;
        } catch (const Error& error) {
            report.problems.emplace_back(error.what());
            return false;
        }
        mark_kept(file, rows);
        return true;
    }

    void mark_restored(const Rows& rows);
    /// Marks new instances, and those made with them, as described by a scene file, or as in none:
    /// then what is edited of them is kept by path, too.
    void mark_described(const Rows& rows);
    static void mark_made_by_path(const Rows& rows);
    /// Changes the references in other scene files to instances that were deleted or restored.
    void update_other_scenes(const Rows& rows);
    /// Renames the instances in all other files and rows after `file` got new names.
    InstanceMoves change_homes(const std::vector<MoveStep>& moves,
                               const std::filesystem::path& file);
    /// Does the same after the file of kept tweaks got new names or parents of instances. Scene
    /// files name the parts of scenes as before; `named_by_scenes` are the other moves.
    void moved_by_path(const std::vector<MoveStep>& moves,
                       const std::vector<MoveStep>& named_by_scenes);
    /// Removes deleted instances from the file of kept tweaks.
    void take_out(const Rows& rows, std::vector<std::string> (KeptTweaks::*take)(
                                        const std::vector<std::string>& paths));

    Tweaks::State& state;
    TweakReport& report;
    RowReport row_report;
    RowPaths row_paths;

  private:
    void rename_in_scenes(const InstanceMoves& moves, const std::filesystem::path& except);
    void change_paths_in_rows(const InstanceMoves& moves);
    void mark_kept(const std::filesystem::path& file, const Rows& rows);
    void describe(const Document& document, const Document::Node& node, Handle parent,
                  Handle instance);
};

}  // namespace fettle::property
