// Keeping tweaks, making them again, dropping them.

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "scene_check.h"
#include "scene_edit.h"
#include "scene_names.h"
#include "tweaks_state.h"

namespace fettle::property {

namespace fs = std::filesystem;

namespace {

using Kind = JournalRow::Kind;
using RowState = JournalRow::State;

/// Keeps rows in files, each of which is read, changed and written once.
class Keeping {
  public:
    Keeping(Tweaks::State& state, TweakReport& report) : state_(state), report_(report) {
        state_.kept.read_again();
    }

    void keep(const std::vector<JournalRow*>& rows) {
        for (JournalRow* row : rows) {
            const fs::path file = scene_file(*row);
            // A scene that goes as a whole is loaded by somebody: a script.
            const bool whole = row->kind == Kind::deleted && row->inside.empty();
            if (!file.empty() && !whole)
                scenes_[file].push_back(row);
            else
                kept_rows_.push_back(row);
        }
        leave_scenes();
        for (const auto& [file, its_rows] : scenes_) keep_in_scene(file, its_rows);
        keep_by_path(kept_rows_);
        forget_overridden();
    }

  private:
    template <class Keep>
    bool tried(const JournalRow& row, Keep keep_it) {
        try {
            keep_it();
            return true;
        } catch (const SceneError& error) {
            tell(row, error.reason());  // the place is one in a text that nobody will see
        } catch (const Error& error) {
            tell(row, error.what());
        }
        return false;
    }
    void tell(const JournalRow& row, const std::string& reason) {
        // What a file says of an instance begins at the top of its scene: "ball.mass: expected ..."
        const std::string path = path_of(row), about = reason.substr(0, reason.find(": "));
        const bool same = about.size() < reason.size() && path.ends_with(about);
        report_.problems.push_back(path + (same ? reason.substr(about.size()) : ": " + reason));
    }

    /// Empty when it is none of the game's own: what was loaded from elsewhere is not ours to
    /// write.
    fs::path scene_file(const JournalRow& row) const {
        std::error_code error;
        if (row.file.empty()) return {};
        fs::path file = fs::weakly_canonical(row.file, error);
        const fs::path relative = file.lexically_relative(state_.folder);
        if (error || relative.empty() || *relative.begin() == ".." || !state_.files.exists(file))
            return {};
        return file;
    }

    // --- References out of a scene

    /// A scene is loaded before there is anything else, so what it names must be in it. A tweak
    /// that names something else is kept by path, which is set when everything is there.
    void leave_scenes() {
        for (bool more = true; more;) {
            more = false;  // one that leaves may be what another one names
            for (auto& [file, rows] : scenes_)
                std::erase_if(rows, [&](JournalRow* row) {
                    if (!leads_out(*row, file)) return false;
                    kept_rows_.push_back(row);
                    return more = true;
                });
        }
        std::erase_if(scenes_, [](const auto& each) { return each.second.empty(); });
    }

    bool leads_out(const JournalRow& row, const fs::path& file) const {
        bool out = false;
        const NewPath look = [&](const std::string& path) -> std::optional<std::string> {
            out = out || !in_scene(row, file, path);
            return std::nullopt;
        };
        try {
            if (row.kind == Kind::value)
                (void)value_with_paths(read_image(row.now).value, look);
            else if (row.kind == Kind::created)
                (void)scene_with_paths(state_.tree, row.now, look);
        } catch (const Error&) {  // what is wrong with it is told when it is written
        }
        return out;
    }

    /// Where the top of the row's scene is, or was when the row was written.
    std::string top_path(const JournalRow& row) const {
        const SceneSteps steps = read_steps(row.inside);
        const std::string above =
            row.kind == Kind::created ? split_path(row.instance).first : row.instance;
        if (const auto origin = state_.origins.find(found(above)))
            return state_.tree.path(origin->top);
        const std::vector<Segment> names = parse_path(above);
        return joined_path(names, names.size() - std::min(names.size(), steps.size()));
    }

    bool in_scene(const JournalRow& row, const fs::path& file, const std::string& path) const {
        if (row.kind == Kind::created && is_at_or_below(path, row.instance)) return true;
        const std::string top = top_path(row);
        if (!is_at_or_below(path, top)) return false;
        const Handle target = found(path);
        if (!target) return true;  // the scene is not loaded, or the check of the scene will tell
        if (const auto origin = state_.origins.find(target))
            return state_.tree.path(origin->top) == top;
        // A script made it, unless somebody made it who keeps it in the same file.
        const auto rows = scenes_.find(file);
        for (Handle at = target; at; at = state_.tree.parent(at))
            if (const auto made = state_.created.find(Tweaks::State::key(at));
                made != state_.created.end())
                return made->second->row.state == RowState::kept
                           ? made->second->row.kept_in == file.filename().string()
                           : std::find(rows->second.begin(), rows->second.end(),
                                       &made->second->row) != rows->second.end();
        return false;
    }

    /// The scene may be loaded somewhere else the next time: what is in it is named from its top.
    std::string from_top(const JournalRow& row) const {
        const std::string top = top_path(row);
        return scene_with_paths(state_.tree, row.now,
                                [&](const std::string& path) -> std::optional<std::string> {
                                    if (!is_at_or_below(path, top)) return std::nullopt;
                                    return path == top ? "." : path.substr(top.size());
                                });
    }

    /// What a scene says now must not be undone by what was kept by path before.
    void forget_overridden() {
        try {
            for (const JournalRow* row : in_scenes_)
                if (row->kind == Kind::value)
                    state_.kept.forget_value(row->instance, row->property);
                else if (row->kind == Kind::deleted)
                    state_.kept.forget_values_below(row->instance);
                else if (row->kind == Kind::moved)
                    state_.kept.move_values(row->instance, row->now);
            if (!in_scenes_.empty()) state_.kept.write();
        } catch (const Error& error) {
            report_.problems.emplace_back(error.what());
        }
    }

    bool loadable(const SceneEdit& edit) const {
        try {
            check_scene(state_.tree, edit.document());
            return true;
        } catch (const Error&) {
            return false;
        }
    }

    /// A row may say anything: an earlier run, whose classes were other ones, has left it. What
    /// would make the scene one that cannot be loaded is not kept in it.
    void keep_in_scene(const fs::path& file, const std::vector<JournalRow*>& rows) {
        try {
            const std::string text = state_.files.read(file);
            std::optional<SceneEdit> edit(std::in_place, state_.tree, text, file.string());
            const bool was_loadable = loadable(*edit);
            const std::size_t told_before = report_.problems.size();
            std::vector<JournalRow*> done = edited(edit, rows, false);
            if (was_loadable && !loadable(*edit)) {
                report_.problems.resize(told_before);
                edit.emplace(state_.tree, text, file.string());
                done = edited(edit, rows, true);
            }
            if (write(file, done, [&] { state_.files.write(file, edit->text()); }))
                in_scenes_.insert(in_scenes_.end(), done.begin(), done.end());
        } catch (const Error& error) {
            report_.problems.emplace_back(error.what());
        }
    }

    /// Those that are in the text now. `each`: the scene is checked after each of them.
    std::vector<JournalRow*> edited(std::optional<SceneEdit>& edit,
                                    const std::vector<JournalRow*>& rows, bool each) {
        std::vector<JournalRow*> done;
        for (JournalRow* row : rows) {
            const std::string before = edit->text(), name = edit->document().file_name();
            const bool kept = tried(*row, [&] {
                edit_scene(*row, *edit);
                if (each) check_scene(state_.tree, edit->document());
            });
            if (kept)
                done.push_back(row);
            else
                edit.emplace(state_.tree, before, name);
        }
        return done;
    }

    Handle scene_top(const JournalRow& row) const {
        const auto origin = state_.origins.find(found(row.instance));
        return origin ? origin->top : Handle{};
    }

    void edit_scene(const JournalRow& row, SceneEdit& edit) {
        const SceneSteps steps = read_steps(row.inside);
        switch (row.kind) {
            case Kind::value:
                return edit.set(steps, row.property, told(row), scene_top(row));
            case Kind::created: {
                const Document made(row.now, "its scene");
                const auto [parent, name] = split_path(row.instance);
                check_scene(state_.tree, made, found(parent), name);
                return edit.add_child(steps, from_top(row));
            }
            case Kind::deleted:
                return edit.remove(steps);
            case Kind::moved:
                if (split_path(row.instance).first != split_path(row.now).first)
                    throw Error(ErrorKind::rejected,
                                "another parent cannot be kept: move it in the file");
                return edit.rename(steps, split_path(row.now).second);
        }
    }

    /// What the file cannot hold must not keep the rest out of it: it is looked for by halves.
    void keep_by_path(const std::vector<JournalRow*>& rows) {
        const std::size_t told_before = report_.problems.size();
        std::vector<JournalRow*> done;
        for (JournalRow* row : rows)
            if (tried(*row, [&] { into_kept(*row); })) done.push_back(row);
        try {
            write(state_.kept.file(), done, [&] { state_.kept.write(); });
        } catch (const SceneError& error) {
            state_.kept.read_again();
            if (done.size() == 1) return tell(*done.front(), error.reason());
            report_.problems.resize(told_before);
            const auto middle = rows.begin() + static_cast<std::ptrdiff_t>(rows.size() / 2);
            keep_by_path({rows.begin(), middle});
            keep_by_path({middle, rows.end()});
        }
    }

    /// Null where there is none now.
    Handle found(const std::string& path) const {
        try {
            return instance_at(state_.tree, path);
        } catch (const Error&) {
            return {};
        }
    }

    void into_kept(JournalRow& row) {
        switch (row.kind) {
            case Kind::value:
                state_.kept.set(row.instance, row.property, told(row));
                break;
            case Kind::created: {
                const Document made(row.now, "its scene");
                const auto [parent, name] = split_path(row.instance);
                check_scene(state_.tree, made, found(parent), name);
                state_.kept.add(row.instance, row.now);
                break;
            }
            case Kind::deleted:
                state_.kept.remove(row.instance);
                break;
            case Kind::moved:
                if (state_.kept.move(row.instance, row.now)) break;
                if (const std::string file = scene_it_was_kept_in(row); !file.empty())
                    throw Error(ErrorKind::rejected,
                                "it was kept in " + file +
                                    " in this run: change its name there, or in the next run");
                throw Error(
                    ErrorKind::rejected,
                    "a name or parent that a script gives cannot be kept: change the script");
        }
    }

    /// The file that holds an instance made in this run; "" when it is none.
    std::string scene_it_was_kept_in(const JournalRow& row) const {
        for (Handle at = found(row.now); at; at = state_.tree.parent(at))
            if (const auto made = state_.created.find(Tweaks::State::key(at));
                made != state_.created.end())
                return made->second->row.kept_in;
        return {};
    }

    Image told(const JournalRow& row) const {
        Image image = read_image(row.now);
        if (image.kind == Image::Kind::value && !image.not_saved.empty())
            throw Error(ErrorKind::rejected, image.not_saved);
        if (image.kind == Image::Kind::formula && !image.not_saved.empty())
            report_.problems.push_back(path_of(row) + ": its formula " + image.not_saved +
                                       ", so its value is kept instead");
        return image;
    }

    template <class Write>
    bool write(const fs::path& file, const std::vector<JournalRow*>& rows, Write write_it) {
        if (rows.empty()) return false;
        try {
            write_it();
        } catch (const SceneError&) {
            throw;  // by what the rows say
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
        }
        return true;
    }

    Tweaks::State& state_;
    TweakReport& report_;
    std::map<fs::path, std::vector<JournalRow*>> scenes_;
    std::vector<JournalRow*> kept_rows_;
    std::vector<const JournalRow*> in_scenes_;  // that were kept in one
};

}  // namespace

std::vector<JournalRow*> Tweaks::State::matching(std::string_view text, bool earlier_only) {
    const TweakPattern pattern(text);
    std::vector<JournalRow*> rows;
    for (JournalRow& row : earlier)
        if (row.state == RowState::open && pattern.matches(row)) rows.push_back(&row);
    if (earlier_only) return rows;
    for (const auto& each : entries)
        if (each->row.state == RowState::open && visible(*each) && pattern.matches(each->row))
            rows.push_back(&each->row);
    return rows;
}

void Tweaks::State::refresh_earlier() {
    if (!journal) return;
    journal->refresh(earlier);
    for (JournalRow& row : earlier)
        if (row.state == RowState::open && !problem_of(row).empty()) row.state = RowState::dropped;
}

void Tweaks::State::set_state(JournalRow& row, RowState state) {
    row.state = state;
    rest = 0;
    if (row.run == JournalRow::elsewhere) return;
    if (row.run != 0) return changed.push_back(&row);
    Entry& its = *entries[static_cast<std::size_t>(row.number) - 1];
    if (its.dirty) return;
    its.dirty = true;
    dirty.push_back(&its);
}

TweakReport Tweaks::State::keep(std::string_view pattern) {
    TweakReport report;
    rest = 0;
    barrier();  // whatever was edited just now counts as well
    try {
        // What other runs of the game have kept meanwhile stays: nobody writes between reading and
        // writing.
        const std::shared_ptr<void> locked = files.lock();
        refresh_earlier();
        Keeping(*this, report).keep(matching(pattern, false));
    } catch (const FileError& error) {
        report.problems.emplace_back(error.what());
    }
    barrier();
    return report;
}

/// How many. Those whose path is none are meant by the pattern of everything alone.
std::size_t Tweaks::State::drop_left_aside(std::string_view text) {
    const TweakPattern pattern(text);
    return std::erase_if(left_aside, [&](JournalRow& row) {
        try {
            if (text != "**" && !pattern.matches(row)) return false;
        } catch (const Error&) {
            return false;
        }
        rest = 0;
        if (row.run != JournalRow::elsewhere) removed.push_back(std::move(row));
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
