// Keeping tweaks: which file each of them belongs to. All other changes are written with the old
// names of instances; the new names are written last, all together.

#include <algorithm>
#include <map>
#include <tuple>

#include <keep/keep_by_path.h>
#include <keep/keep_in_scene.h>
#include <keep/keep_run.h>
#include <scenes/scene_names.h>

namespace fettle::property {

namespace fs = std::filesystem;

namespace {

using Kind = JournalRow::Kind;
using RowState = JournalRow::State;

/// Keeps rows in files. Each file is read, changed and written once.
class Keeping {
  public:
    Keeping(Tweaks::State& state, TweakReport& report) : run_(state, report) {}

    void keep(const Rows& rows) {
        for (JournalRow* row : in_stages(rows)) {
            if (is_of_one_of_several(*row)) {
                row->file.clear();
                row->inside.clear();
            }
            const auto file = run_.state.own_file(row->file);
            // The top of a scene is deleted or restored: a script loads the scene, so no scene file
            // can contain this.
            const bool whole =
                row->inside.empty() && (row->kind == Kind::deleted || row->kind == Kind::restored);
            // The kept-tweaks file first deletes what a script makes there, then makes this
            // instance.
            const bool in_place =
                row->kind == Kind::created && run_.state.deleted_by_path(run_.row_paths.home(*row));
            if (!file || whole || in_place)
                kept_rows_.push_back(row);
            else if (is_consistent(*row, *file))
                scenes_[*file].push_back(row);
        }
        keep_outside_scenes();
        for (const auto& [file, its_rows] : scenes_) keep_in_scene(run_, file, its_rows);
        // A new name may be the former name of a deleted instance, and new instances may be below
        // renamed ones.
        std::map<Stage, Rows> stages;
        for (JournalRow* row : kept_rows_) stages[stage_of(*row, kept_rows_)].push_back(row);
        for (const Stage stage : {Stage::deleted, Stage::restored, Stage::deleted_below_restored})
            keep_by_path(run_, stages[stage]);
        keep_moves_by_path(run_, stages[Stage::moved]);
        stages[Stage::created].insert(stages[Stage::created].end(), stages[Stage::value].begin(),
                                      stages[Stage::value].end());
        keep_by_path(run_, stages[Stage::created]);
    }

  private:
    /// Whether the row deletes or makes an instance below one of several that come from its scene
    /// file: in the file, this would be done to all of them.
    bool is_of_one_of_several(const JournalRow& row) const {
        const bool below = row.kind == Kind::deleted ? !row.inside.empty() : !row.file.empty();
        if ((row.kind != Kind::deleted && row.kind != Kind::created) || !below) return false;
        const std::string top = run_.row_paths.home_of_top(row);
        const Tree& tree = run_.state.tree;
        return std::ranges::any_of(run_.state.origins.tops(tree, row.file), [&](Handle other) {
            return run_.state.attached(other) &&
                   run_.row_paths.home_of_live(tree.path(other)) != top;
        });
    }

    /// False, with a report, if two instances of one scene have different values: the file has one.
    bool is_consistent(const JournalRow& row, const fs::path& file) {
        if (row.kind != Kind::value) return true;
        const auto [first, is_first] = values_.try_emplace({file, row.inside, row.property}, &row);
        const JournalRow& other = *first->second;
        if (is_first || other.now == row.now ||
            run_.row_paths.home_of_top(other) == run_.row_paths.home_of_top(row))
            return true;
        run_.row_report.add_problem(
            row, file.filename().string() + " is the scene of " + path_of(other) +
                     " as well, which has another value: drop one of the two tweaks");
        return false;
    }

    /// When a scene is loaded, only its own instances are certain to exist. So tweaks with
    /// references to other instances are kept by path; they are set when everything exists.
    void keep_outside_scenes() {
        for (bool more = true; more;) {
            more = false;  // another tweak may refer to an instance that this one creates
            for (auto& [file, rows] : scenes_)
                std::erase_if(rows, [&, &file = file](JournalRow* row) {
                    if (!leads_out(*row, file)) return false;
                    kept_rows_.push_back(row);
                    return more = true;
                });
        }
        std::erase_if(scenes_, [](const auto& each) { return each.second.empty(); });
    }

    bool leads_out(const JournalRow& row, const fs::path& file) const {
        bool out = false;
        if (row.kind != Kind::restored)
            run_.row_paths.each_named(
                row, [&](const std::string& home) { out = out || !in_scene(row, file, home); });
        return out;
    }

    bool in_scene(const JournalRow& row, const fs::path& file, const std::string& home) const {
        if (row.kind == Kind::created && is_at_or_below(home, run_.row_paths.home(row)))
            return true;
        const std::string top = run_.row_paths.home_of_top(row);
        if (!is_at_or_below(home, top)) return false;
        const Handle target = run_.row_paths.instance(home);
        if (!target) return true;  // the scene is not loaded, or its check reports the error
        if (const auto origin = run_.state.origins.find(target))
            return run_.row_paths.home_of_live(run_.state.tree.path(origin->top)) == top;
        // A script made it, unless it is a new instance that is kept in the same file.
        const auto rows = scenes_.find(file);
        for (Handle at = target; at; at = run_.state.tree.parent(at))
            if (const auto made = run_.state.created.find(at.key());
                made != run_.state.created.end())
                return made->second->row.state != RowState::kept &&
                       std::find(rows->second.begin(), rows->second.end(), &made->second->row) !=
                           rows->second.end();
        return false;
    }

    KeepRun run_;
    std::map<fs::path, Rows> scenes_;
    /// Key: file, steps, property.
    std::map<std::tuple<fs::path, std::string, std::string>, const JournalRow*> values_;
    Rows kept_rows_;
};

}  // namespace

TweakReport Tweaks::State::keep(std::string_view pattern) {
    TweakReport report;
    barriers_to_retry = 0;
    barrier();  // includes the latest edits
    try {
        // Changes by other runs of the game must be preserved. The lock keeps others from writing
        // between reading and writing.
        const std::shared_ptr<void> locked = files.lock();
        refresh_earlier();
        Keeping(*this, report).keep(matching(pattern, false));
    } catch (const FileError& error) {
        report.problems.emplace_back(error.what());
    }
    barrier();
    return report;
}

}  // namespace fettle::property
