// Keeping and dropping tweaks. All other changes are written with the old names of instances; the
// new names are written last, all together.

#include <algorithm>
#include <map>
#include <tuple>
#include <unordered_set>
#include <utility>

#include <scenes/scene_check.h>
#include <scenes/scene_names.h>
#include <tweaks/other_scenes.h>
#include <tweaks/row_paths.h>
#include <tweaks/row_report.h>
#include <tweaks/row_stages.h>
#include <tweaks/scene_keeping.h>
#include <tweaks/tweaks_state.h>

namespace fettle::property {

namespace fs = std::filesystem;

namespace {

using Kind = JournalRow::Kind;
using RowState = JournalRow::State;

/// Keeps rows in files. Each file is read, changed and written once.
class Keeping {
  public:
    Keeping(Tweaks::State& state, TweakReport& report)
        : state_(state), report_(report), rows_(report), paths_(state) {
        state_.kept.read_again();
        state_.kept.find_by([this](const std::string& home) { return paths_.instance(home); });
    }
    ~Keeping() { state_.kept.find_by({}); }
    Keeping(const Keeping&) = delete;

    void keep(const Rows& rows) {
        for (JournalRow* row : in_stages(rows)) {
            const auto file = state_.own_file(row->file);
            // The top of a scene is deleted or restored: a script loads the scene, so no scene file
            // can contain this.
            const bool whole =
                row->inside.empty() && (row->kind == Kind::deleted || row->kind == Kind::restored);
            // The kept-tweaks file first deletes what a script makes there, then makes this
            // instance.
            const bool in_place =
                row->kind == Kind::created && state_.deleted_by_path(paths_.home(*row));
            if (!file || whole || in_place)
                kept_rows_.push_back(row);
            else if (is_consistent(*row, *file))
                scenes_[*file].push_back(row);
        }
        keep_outside_scenes();
        for (const auto& [file, its_rows] : scenes_) keep_in_scene(file, its_rows);
        // A new name may be the former name of a deleted instance, and new instances may be below
        // renamed ones.
        std::map<Stage, Rows> stages;
        for (JournalRow* row : kept_rows_) stages[stage_of(*row, kept_rows_)].push_back(row);
        for (const Stage stage : {Stage::deleted, Stage::restored, Stage::deleted_below_restored})
            keep_by_path(stages[stage]);
        keep_moves_by_path(stages[Stage::moved]);
        stages[Stage::created].insert(stages[Stage::created].end(), stages[Stage::value].begin(),
                                      stages[Stage::value].end());
        keep_by_path(stages[Stage::created]);
    }

  private:
    /// Two instances of one scene share one value in the file.
    bool is_consistent(const JournalRow& row, const fs::path& file) {
        if (row.kind != Kind::value) return true;
        const auto [first, is_first] = values_.try_emplace({file, row.inside, row.property}, &row);
        const JournalRow& other = *first->second;
        if (is_first || other.now == row.now ||
            paths_.home_of_top(other) == paths_.home_of_top(row))
            return true;
        rows_.tell(row, file.filename().string() + " is the scene of " + path_of(other) +
                            " as well, which has another value: drop one of the two tweaks");
        return false;
    }

    // --- References out of a scene

    /// When a scene is loaded, only its own instances are certain to exist. So tweaks with
    /// references to other instances are kept by path; they are set when everything exists.
    void keep_outside_scenes() {
        for (bool more = true; more;) {
            more = false;  // another tweak may refer to an instance of this one
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
            paths_.each_named(
                row, [&](const std::string& home) { out = out || !in_scene(row, file, home); });
        return out;
    }

    bool in_scene(const JournalRow& row, const fs::path& file, const std::string& home) const {
        if (row.kind == Kind::created && is_at_or_below(home, paths_.home(row))) return true;
        const std::string top = paths_.home_of_top(row);
        if (!is_at_or_below(home, top)) return false;
        const Handle target = paths_.instance(home);
        if (!target) return true;  // the scene is not loaded, or its check reports the error
        if (const auto origin = state_.origins.find(target))
            return paths_.home_of_live(state_.tree.path(origin->top)) == top;
        // A script made it, unless it is a new instance that is kept in the same file.
        const auto rows = scenes_.find(file);
        for (Handle at = target; at; at = state_.tree.parent(at))
            if (const auto made = state_.created.find(at.key()); made != state_.created.end())
                return made->second->row.state != RowState::kept &&
                       std::find(rows->second.begin(), rows->second.end(), &made->second->row) !=
                           rows->second.end();
        return false;
    }

    // --- Scenes

    void keep_in_scene(const fs::path& file, const Rows& rows) {
        try {
            SceneKeeping scene(state_, paths_, rows_, file);
            const Rows done = scene.keep(rows);
            if (!write(file, done, [&] { state_.files.write(file, scene.text()); })) return;
            forget_kept_by_path(without_moves(done));
            now_described(done);
            update_other_scenes(done);
            names_are_kept(file, moves_in(done));
        } catch (const Error& error) {
            report_.problems.emplace_back(error.what());
        }
    }

    /// Marks new instances, and those made with them, as described by the file.
    void now_described(const Rows& rows) {
        for (const JournalRow* row : rows) {
            if (row->kind == Kind::restored && row->run == 0) {
                Tweaks::State::Entry& its = state_.entry_of(*row);
                Tweaks::State::Entry& deletion = *state_.deleted.at(its.handle.key());
                deletion.gone = true;
                state_.touch(deletion);
            }
            if (row->kind != Kind::created || row->run != 0) continue;
            const Handle made = state_.entry_of(*row).handle;
            if (!state_.tree.alive(made)) continue;
            const Document document(row->now, "its scene");
            describe(document, document.root(), state_.tree.parent(made), made);
        }
    }

    void describe(const Document& document, const Document::Node& node, Handle parent,
                  Handle instance) {
        state_.origins.added(state_.tree, parent, instance);
        const Document::Node* children = document.member(node, "children");
        for (const Document::Node* child = children ? document.first(*children) : nullptr; child;
             child = document.next(*child))
            if (const Document::Node* name = document.member(*child, "name"))
                if (const Handle handle = state_.tree.child(instance, document.text(*name)))
                    describe(document, *child, instance, handle);
    }

    /// Removes tweaks that were kept by path and would override the scene.
    void forget_kept_by_path(const Rows& rows) {
        take_out(rows, &KeptTweaks::forget_below);
        for (const JournalRow* row : rows)
            if (row->kind == Kind::value)
                state_.kept.forget_value(paths_.home(*row), row->property);
            else if (row->kind == Kind::restored)
                state_.kept.put_back(row->instance, row->was, paths_.home_scene(*row));
        state_.kept.write();
    }

    void names_are_kept(const fs::path& file, const Rows& rows) {
        if (rows.empty()) return;
        std::vector<MoveStep> moves;
        std::vector<std::pair<SceneSteps, std::string>> names;
        for (const JournalRow* row : rows) {
            const auto [parent, name] = split_path(row->instance);
            moves.push_back({0, row->instance, path_below(parent, split_path(row->now).second)});
            names.emplace_back(read_steps(row->inside), split_path(row->now).second);
        }
        state_.origins.renamed(file, names);
        state_.steps_renamed(file, names);
        const InstanceMoves all = homes_changed(moves, file);
        state_.kept.rename([&](const std::string& home) { return all.now(home); });
        state_.kept.write();
    }

    void update_other_scenes(const Rows& rows) {
        OtherScenes others(state_, report_);
        for (const JournalRow* row : rows)
            if (row->kind == Kind::deleted)
                others.forget(*row);
            else if (row->kind == Kind::restored)
                others.put_back(*row);
        others.write();
    }

    /// Renames the instances in all other files and rows after the files got new names.
    InstanceMoves homes_changed(const std::vector<MoveStep>& moves, const fs::path& file) {
        const InstanceMoves all = whole_moves(moves);
        OtherScenes others(state_, report_);
        others.rename(all, file);
        others.write();
        std::vector<std::pair<JournalRow*, std::string>> homes;
        for (JournalRow& row : state_.earlier.rows)
            if (row.state == RowState::open) homes.emplace_back(&row, all.now(paths_.home(row)));
        state_.homes_changed([&](const std::string& home) { return all.now(home); });
        for (const auto& [row, home] : homes)
            if (row->kind == Kind::moved) row->instance = home;
        paths_ = RowPaths(state_);  // the moves have new home paths
        for (const auto& [row, home] : homes) {
            const std::string said = paths_.path_in_rows(*row, home);
            if (std::exchange(row->instance, said) != said || row->kind == Kind::moved)
                state_.renamed_earlier(*row);
        }
        return all;
    }

    // --- By path

    /// An invalid row must not prevent the others from being kept. It is found by splitting the
    /// rows into halves.
    void keep_by_path(const Rows& rows) {
        const std::size_t told_before = report_.problems.size();
        Rows done;
        try {
            for (JournalRow* row : rows)
                if (row->kind == Kind::deleted &&
                    rows_.tried(*row, [&] { require_nothing_moved_out(paths_, *row); }))
                    done.push_back(row);
            take_out(done, &KeptTweaks::remove);
            Rows others;
            for (JournalRow* row : rows)
                if (row->kind != Kind::deleted) others.push_back(row);
            const Rows into = rows_.tried_together(
                others, paths_,
                [&] {
                    if (!others.empty()) state_.kept.read_again();
                },
                [&](const JournalRow& row) { into_kept(row); });
            done.insert(done.end(), into.begin(), into.end());
            if (!write(state_.kept.file(), done, [&] { state_.kept.write(); })) return;
            now_described(done);
            update_other_scenes(done);
        } catch (const SceneError& error) {
            state_.kept.read_again();
            if (done.size() == 1) return rows_.refuse(*done.front(), paths_, error.reason());
            report_.problems.resize(told_before);
            const auto middle = rows.begin() + static_cast<std::ptrdiff_t>(rows.size() / 2);
            keep_by_path({rows.begin(), middle});
            keep_by_path({middle, rows.end()});
        }
    }

    /// Removes deleted instances from the file of kept tweaks.
    void take_out(const Rows& rows, std::vector<std::string> (KeptTweaks::*take)(
                                        const std::vector<std::string>& paths)) {
        Rows deletions;
        std::vector<std::string> paths;
        for (JournalRow* row : rows)
            if (row->kind == Kind::deleted) {
                deletions.push_back(row);
                paths.push_back(row->instance);
            }
        const std::vector<std::string> before = (state_.kept.*take)(paths);
        for (std::size_t i = 0; i < paths.size(); ++i) taken_out(state_, *deletions[i], before[i]);
    }

    void into_kept(const JournalRow& row) {
        const std::string home = paths_.home(row);
        switch (row.kind) {
            case Kind::value:
                return state_.kept.set(unmarked(home), row.property, declared(home, row.property),
                                       rows_.kept_image(row, paths_), [&](const std::string& path) {
                                           return unmarked(paths_.home_of_live(path));
                                       });
            case Kind::created:
                check_made(state_, paths_, row);
                require_free(home);
                return state_.kept.add(home, unmarked_scene(row));
            case Kind::restored:
                return state_.kept.put_back(home, row.was, unmarked_scene(row));
            case Kind::deleted:
            case Kind::moved:
                return;
        }
    }

    /// Throws if a script makes an instance at that path, which was moved away now: both would need
    /// the path.
    void require_free(const std::string& home) const {
        if (const std::string other = paths_.moved_from(without_marks(home)); !other.empty())
            throw Error(ErrorKind::rejected,
                        "a script gives this name to what is " + other + " now: change the script");
    }

    /// Throws for a marked path: the file cannot distinguish two instances with the same home path.
    std::string unmarked(std::string home) const {
        if (!is_marked(home)) return home;
        std::string path = without_marks(home);
        while (path != "game" && paths_.moved_from(path).empty()) path = split_path(path).first;
        throw Error(ErrorKind::rejected, without_marks(home) +
                                             " is new and has a name that a script gives to " +
                                             paths_.moved_from(path) + ": change the script");
    }

    std::string unmarked_scene(const JournalRow& row) const {
        return paths_.home_scene(row, [&](const std::string& home) { return unmarked(home); });
    }

    const Property* declared(const std::string& home, const std::string& property) const {
        const Handle instance = paths_.instance(home);
        return instance ? state_.tree.class_of(instance).property(property) : nullptr;
    }

    /// For instances that the file of kept tweaks makes.
    void keep_moves_by_path(Rows rows) {
        const auto target = [&](const JournalRow& row) {
            return path_below(paths_.home_of_new_parent(row), split_path(row.now).second);
        };
        std::erase_if(rows, [&](const JournalRow* row) {
            return !rows_.tried(*row, [&] {
                if (!state_.kept.makes(row->instance))
                    throw Error(ErrorKind::rejected, given_by_script);
                state_.kept.require_movable(row->instance, target(*row));
            });
        });
        std::unordered_set<std::string> moving_away;
        for (const JournalRow* row : rows) moving_away.insert(row->instance);
        std::erase_if(rows, [&](const JournalRow* row) {
            const std::string to = target(*row);
            return !moving_away.contains(to) && !rows_.tried(*row, [&] { require_free(to); });
        });
        const auto steps = [&](const Rows& some) {
            std::vector<MoveStep> moves;
            for (std::size_t i = 0; i < some.size(); ++i)
                moves.push_back({i, some[i]->instance, target(*some[i])});
            return moves;
        };
        rows = possible_together(rows, [&](const Rows& some) { (void)whole_moves(steps(some)); });
        if (rows.empty()) return;
        const std::vector<MoveStep> moves = steps(rows);
        try {
            if (write(state_.kept.file(), rows, [&] {
                    state_.kept.move(moves);
                    state_.kept.write();
                }))
                homes_changed(moves, state_.kept.file());
        } catch (const SceneError& error) {
            state_.kept.read_again();
            report_.problems.emplace_back(error.what());
        }
    }

    /// Returns the rows without those that contradict earlier ones, which are reported.
    template <class Check>
    Rows possible_together(const Rows& rows, Check check) {
        try {
            check(rows);
            return rows;
        } catch (const Error&) {  // not all together: the loop finds the rows that fail
        }
        Rows possible;
        for (JournalRow* row : rows) {
            possible.push_back(row);
            if (!rows_.tried(*row, [&] { check(possible); })) possible.pop_back();
        }
        return possible;
    }

    template <class Write>
    bool write(const fs::path& file, const Rows& rows, Write write_it) {
        if (rows.empty()) return false;
        try {
            write_it();
        } catch (const SceneError&) {
            throw;  // caused by the content of a row
        } catch (const Error& error) {
            report_.problems.emplace_back(error.what());
            return false;
        }
        if (report_.files.empty() || report_.files.back() != file.string())
            report_.files.push_back(file.string());
        report_.count += rows.size();
        for (JournalRow* row : rows) {
            row->kept_in = file.filename().string();
            state_.set_state(*row, RowState::kept);
            if (row->run != 0 && row->kind == Kind::value) state_.file_says(*row);
        }
        return true;
    }

    Tweaks::State& state_;
    TweakReport& report_;
    RowReport rows_;
    RowPaths paths_;
    std::map<fs::path, Rows> scenes_;
    /// Key: file, steps, property.
    std::map<std::tuple<fs::path, std::string, std::string>, const JournalRow*> values_;
    Rows kept_rows_;
};

}  // namespace

std::vector<JournalRow*> Tweaks::State::matching(std::string_view text, bool earlier_only) {
    const TweakPattern pattern(text);
    std::vector<JournalRow*> rows;
    for (JournalRow& row : earlier.rows)
        if (row.state == RowState::open && pattern.matches(row)) rows.push_back(&row);
    if (earlier_only) return rows;
    for (const auto& each : entries)
        if (each->row.state == RowState::open && visible(*each) && pattern.matches(each->row))
            rows.push_back(&each->row);
    return rows;
}

void Tweaks::State::refresh_earlier() {
    if (!journal) return;
    journal->refresh(earlier.rows);
    for (JournalRow& row : earlier.rows)
        if (row.state == RowState::open && !problem_of(row).empty()) row.state = RowState::dropped;
}

void Tweaks::State::set_state(JournalRow& row, RowState state) {
    row.state = state;
    rest = 0;
    if (row.run == JournalRow::elsewhere) return;
    if (row.run != 0) return earlier.changed.push_back(&row);
    Entry& its = entry_of(row);
    if (its.dirty) return;
    its.dirty = true;
    dirty.push_back(&its);
}

TweakReport Tweaks::State::keep(std::string_view pattern) {
    TweakReport report;
    rest = 0;
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

/// Returns the number of dropped rows. Rows without a valid path match only the pattern "**".
std::size_t Tweaks::State::drop_left_aside(std::string_view text) {
    const TweakPattern pattern(text);
    return std::erase_if(earlier.left_aside, [&](JournalRow& row) {
        try {
            if (text != "**" && !pattern.matches(row)) return false;
        } catch (const Error&) {
            return false;
        }
        rest = 0;
        if (row.run != JournalRow::elsewhere) earlier.removed.push_back(std::move(row));
        return true;
    });
}

TweakReport Tweaks::State::drop(std::string_view pattern) {
    TweakReport report;
    barrier();
    refresh_earlier();
    for (JournalRow* row : matching(pattern, false)) {
        set_state(*row, RowState::dropped);
        ++report.count;
    }
    report.count += drop_left_aside(pattern);
    barrier();
    return report;
}

}  // namespace fettle::property
