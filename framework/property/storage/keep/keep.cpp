// Keeping tweaks: which file each of them belongs to. All other changes are written with the old
// names of instances; the new names are written last, all together.

#include <algorithm>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <keep/keep_by_path.h>
#include <keep/keep_in_scene.h>
#include <keep/keep_run.h>

namespace fettle::property {

namespace fs = std::filesystem;

namespace {

using Kind = JournalRow::Kind;
using RowState = JournalRow::State;

/// Keeps rows in files. Each file is read, changed and written once.
class Keeping {
  public:
    /// `for_all`: into scene files, also if several instances come from one of them.
    Keeping(Tweaks::State& state, TweakReport& report, bool for_all)
        : run_(state, report), for_all_(for_all) {}

    void keep(const Rows& rows) {
        for (JournalRow* row : in_stages(rows)) {
            auto file = run_.state.own_file(row->file);
            if (file && is_moved_by_path(*row)) file.reset();
            const std::size_t others = file ? others_of_scene(*row) : 0;
            if (others > 0 && for_all_) for_all_rows_.emplace_back(row, others);
            if (others > 0 && !for_all_) {
                for_one_rows_.push_back({row, file->filename().string(), others});
                file.reset();
                if (row->kind == Kind::created || row->kind == Kind::deleted) {
                    row->file.clear();
                    row->inside.clear();
                }
            }
            // The top of a scene is deleted or restored: a script loads the scene, so no scene file
            // can contain this.
            const bool whole =
                row->inside.empty() && (row->kind == Kind::deleted || row->kind == Kind::restored);
            // The kept-tweaks file first deletes what a script makes there, then makes this
            // instance.
            const bool in_place = row->kind == Kind::created &&
                                  (run_.state.deleted_by_path(run_.row_paths.home(*row)) ||
                                   run_.state.kept.moves_away(run_.row_paths.home(*row)));
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
        // A new parent that is kept below has to be in the file first.
        Rows into_new;
        std::erase_if(stages[Stage::moved], [&](JournalRow* row) {
            if (unkept_parent(run_, *row).empty()) return false;
            into_new.push_back(row);
            return true;
        });
        keep_moves_by_path(run_, stages[Stage::moved]);
        stages[Stage::created].insert(stages[Stage::created].end(), stages[Stage::value].begin(),
                                      stages[Stage::value].end());
        keep_by_path(run_, stages[Stage::created]);
        keep_moves_by_path(run_, into_new);
        note_for_one();
        note_for_all();
    }

  private:
    /// The number of other instances that come from the scene file of the row: in the file, the
    /// change would be made in all of them. 0 for a change of the topmost instance that a file
    /// cannot contain, and for what a file has contained before.
    std::size_t others_of_scene(const JournalRow& row) const {
        if (row.kind == Kind::restored || (row.kind == Kind::deleted && row.inside.empty()))
            return 0;
        return run_.state.others_of_scene(row.file, run_.row_paths.home_of_top(row));
    }

    /// Whether a part of a scene gets another parent, or a name that the scene file still gives to
    /// what has moved away: the scene file cannot contain that.
    bool is_moved_by_path(const JournalRow& row) const {
        if (row.kind != Kind::moved || row.inside.empty()) return false;
        const std::string parent = run_.row_paths.home_of_new_parent(row);
        return (parent != split_path(row.instance).first &&
                (!for_all_ || others_of_scene(row) == 0)) ||
               run_.state.kept.moves_away(path_below(parent, split_path(row.now).second));
    }

    static bool is_kept(const JournalRow& row) { return row.state == RowState::kept; }

    /// Whether `keep_for_all` can write the change later: not for a part that the file of kept
    /// tweaks moves, nor for what is below it.
    static bool is_for_all_later(const JournalRow& row) {
        return row.kind != Kind::moved && (row.kind != Kind::value || !row.file.empty());
    }

    void note_for_one() {
        std::map<std::pair<std::string, bool>, std::vector<const ForOne*>> by_scene;
        for (const ForOne& each : for_one_rows_)
            if (is_kept(*each.row))
                by_scene[{each.scene, is_for_all_later(*each.row)}].push_back(&each);
        for (const auto& [key, rows] : by_scene) {
            const auto& [scene, later] = key;
            run_.report.notes.push_back(
                path_of(*rows.front()->row) +
                (rows.size() == 1 ? std::string(": ")
                                  : " and " + std::to_string(rows.size() - 1) + " more: each ") +
                "for one of " + std::to_string(rows.front()->others + 1) + " instances of " +
                scene + " only" +
                (later ? "; keep_for_all writes into " + scene + ", for all of them" : ""));
        }
    }

    void note_for_all() {
        std::map<std::string, std::size_t> others;
        for (const auto& [row, count] : for_all_rows_)
            if (is_kept(*row) && row->kept_in == fs::path(row->file).filename().string())
                others[row->kept_in] = std::max(others[row->kept_in], count);
        for (const auto& [scene, count] : others)
            run_.report.notes.push_back(
                std::to_string(count) +
                (count == 1 ? " other instance comes from " : " other instances come from ") +
                scene + (count == 1 ? ", and has" : ", and have") +
                " the change when the file is loaded again");
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
            if (const auto made = run_.state.by_instance.created.find(at.key());
                made != run_.state.by_instance.created.end())
                return made->second->row.state != RowState::kept &&
                       std::find(rows->second.begin(), rows->second.end(), &made->second->row) !=
                           rows->second.end();
        return false;
    }

    struct ForOne {
        const JournalRow* row;
        std::string scene;  // name of its file
        std::size_t others;
    };

    KeepRun run_;
    const bool for_all_;
    std::vector<ForOne> for_one_rows_;
    std::vector<std::pair<const JournalRow*, std::size_t>> for_all_rows_;
    std::map<fs::path, Rows> scenes_;
    /// Key: file, steps, property.
    std::map<std::tuple<fs::path, std::string, std::string>, const JournalRow*> values_;
    Rows kept_rows_;
};

}  // namespace

TweakReport Tweaks::State::keep(std::string_view pattern, bool for_all) {
    if (!not_kept_because.empty())
        throw Error(ErrorKind::rejected,
                    (for_all ? "keep_for_all: " : "keep: ") + not_kept_because);
    TweakReport report;
    barriers_to_retry = 0;
    barrier();  // includes the latest edits
    try {
        // Changes by other runs of the game must be preserved. The lock keeps others from writing
        // between reading and writing.
        const std::shared_ptr<void> locked = files.lock();
        refresh_earlier();
        std::vector<JournalRow*> rows = matching(pattern, false);
        if (for_all) add_kept_for_one(rows, pattern);
        Keeping(*this, report, for_all).keep(rows);
    } catch (const FileError& error) {
        report.problems.emplace_back(error.what());
    }
    barrier();
    return report;
}

TweakReport Tweaks::keep(std::string_view pattern) {
    return state_->with_warnings(usable().keep(pattern, false));
}

TweakReport Tweaks::keep_for_all(std::string_view pattern) {
    return state_->with_warnings(usable().keep(pattern, true));
}

std::size_t Tweaks::State::others_of_scene(const fs::path& file,
                                           const std::string& home_of_top) const {
    return static_cast<std::size_t>(std::ranges::count_if(
        origins.tops(tree, file),
        [&](Handle top) { return attached(top) && home_of(top) != home_of_top; }));
}

std::size_t Tweaks::others_of_scene(Handle instance) const {
    const State& state = usable();
    const auto origin = state.origins.find(instance);
    return origin ? state.others_of_scene(origin->file, state.home_of(origin->top)) : 0;
}

}  // namespace fettle::property
