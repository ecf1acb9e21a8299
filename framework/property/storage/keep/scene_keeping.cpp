#include <keep/scene_keeping.h>

#include <algorithm>

#include <scenes/scene_check.h>
#include <scenes/scene_names.h>

namespace fettle::property {

using Kind = JournalRow::Kind;

void check_made(const Tweaks::State& state, const RowPaths& paths, const JournalRow& row) {
    const std::string scene = scene_with_paths(state.tree, row.now, [&](const std::string& path) {
        return std::optional(paths.live(row, path));
    });
    check_scene(state.tree, Document(scene, "its scene"),
                paths.instance(split_path(paths.home(row)).first), split_path(row.instance).second);
}

namespace {

std::string what_goes_with_it(const std::string& path) {
    return "what is " + path + " now is a part of it in the file, and would go with it";
}

}  // namespace

void require_nothing_moved_out(const RowPaths& paths, const JournalRow& row) {
    if (const std::string path = paths.moved_out_of(row); !path.empty())
        throw Error(ErrorKind::rejected, what_goes_with_it(path));
}

void store_removed_text(Tweaks::State& state, const JournalRow& row, const std::string& text) {
    if (row.run != 0) return;
    std::string& all = state.entry_of(row).taken_out;
    if (all.empty() || row.state != JournalRow::State::kept)
        all = text;
    else
        all = all.substr(0, all.size() - 1) + ", " + text.substr(1);
}

namespace {

/// References inside a scene begin at its top, because the scene may be loaded elsewhere the next
/// time.
NewPath from_top(const std::string& top) {
    return [top](const std::string& home) -> std::optional<std::string> {
        if (!is_at_or_below(home, top)) return std::nullopt;
        return home == top ? "." : home.substr(top.size());
    };
}

}  // namespace

SceneKeeping::SceneKeeping(Tweaks::State& state, const RowPaths& paths, RowReport& report,
                           const std::filesystem::path& file)
    : state_(state),
      paths_(paths),
      report_(report),
      edit_(state.tree, state.files.read(file), file.string()) {}

void SceneKeeping::set_text(std::string text) {
    edit_ = SceneEdit(state_.tree, std::move(text), edit_.document().file_name());
}

bool SceneKeeping::loadable() const {
    try {
        check_scene(state_.tree, edit_.document());
        return true;
    } catch (const Error&) {
        return false;
    }
}

/// A row may be invalid, for example from a run with other classes. A row that would make the scene
/// unloadable is not kept.
Rows SceneKeeping::keep(const Rows& rows) {
    const std::string before = text();
    const bool was_loadable = loadable();
    const std::size_t reported_before = report_.count();
    Rows done = edited(rows, false);
    if (!was_loadable || loadable()) return done;
    report_.forget_since(reported_before);
    set_text(before);
    return edited(rows, true);
}

/// `each`: the scene is checked after each row.
Rows SceneKeeping::edited(const Rows& rows, bool each) {
    const Rows moves = moves_in(rows);
    const std::string at_first = text();
    Rows done = report_.tried_together(
        without_moves(rows), paths_, [&] { set_text(at_first); },
        [&](const JournalRow& row) {
            restore_text_on_error([&] {
                edit_scene(row, moves);
                if (each) check_scene(state_.tree, edit_.document());
            });
        });
    if (moves.empty()) {
        remove_marks();
        return done;
    }
    const std::string before = text();
    try {
        rename(moves, each);
        done.insert(done.end(), moves.begin(), moves.end());
    } catch (const Error&) {  // one of the rows has an error, so each is tried alone
        set_text(before);
        for (JournalRow* row : moves)
            if (report_.tried(*row, [&] { restore_text_on_error([&] { rename({row}, true); }); }))
                done.push_back(row);
    }
    return done;
}

template <class Edit>
void SceneKeeping::restore_text_on_error(Edit edit) {
    const std::string before = text();
    try {
        edit();
    } catch (const Error&) {
        set_text(before);
        throw;
    }
}

/// `moves`: those that are kept in the same file.
void SceneKeeping::edit_scene(const JournalRow& row, const Rows& moves) {
    const SceneSteps steps = read_steps(row.inside);
    const NewPath in_file = from_top(paths_.home_of_top(row));
    switch (row.kind) {
        case Kind::value:
            return edit_.set(steps, row.property, report_.kept_image(row, paths_),
                             [&](const std::string& path) {
                                 const std::string home = paths_.home_of_live(path);
                                 const auto inside = in_file(home);
                                 return inside ? inside : home;
                             });
        case Kind::created:
            check_made(state_, paths_, row);
            require_name_free(paths_.home(row), moves);
            return edit_.add_child(steps, paths_.home_scene(row, in_file));
        case Kind::deleted:
            require_nothing_moved_out(paths_, row);
            if (const std::string path = state_.kept.moved_out_of(row.instance); !path.empty())
                throw Error(ErrorKind::rejected, what_goes_with_it(path));
            return store_removed_text(state_, row, edit_.remove(steps, row.instance));
        case Kind::restored:
            edit_.put_back(steps, row.was);
            return edit_.name_as_in(
                steps,
                SceneEdit(state_.tree, paths_.home_scene(row, named_in_file(row)), "its scene"),
                {});
        case Kind::moved:
            return;
    }
}

/// References that the scene may contain: those to instances that are loaded with it. All others
/// become null; a tweak contains them.
NewPath SceneKeeping::named_in_file(const JournalRow& row) const {
    return [this, in_file = from_top(paths_.home_of_top(row))](const std::string& home) {
        const Handle target = paths_.instance(home);
        const bool by_script =
            target && !state_.origins.find(target) && state_.created_above(target) == nullptr;
        return std::optional(by_script ? std::string() : in_file(home).value_or(std::string()));
    };
}

/// Renames instances, also in every reference inside the scene.
void SceneKeeping::rename(const Rows& rows, bool check) {
    std::vector<MoveStep> moves;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const JournalRow& row = *rows[i];
        const std::string parent = split_path(row.instance).first;
        if (paths_.home_of_new_parent(row) != parent)
            throw Error(ErrorKind::rejected,
                        "another parent cannot be kept for all: move it in the file");
        if (row.inside.empty()) require_named_by_file(row);
        moves.push_back({i, row.instance, path_below(parent, split_path(row.now).second)});
        require_name_free(moves.back().to, rows);
        if (state_.deleted_by_path(moves.back().to))
            throw Error(ErrorKind::rejected, name_of_deleted);
    }
    for (const MoveStep& step : in_order(moves)) {
        const JournalRow& row = *rows[step.which];
        SceneSteps steps = read_steps(row.inside);
        if (step.from != row.instance) steps.back() = {split_path(step.from).second, no_place};
        edit_.rename(steps, split_path(step.to).second);
    }
    const std::string top = paths_.home_of_top(*rows.front());
    const InstanceMoves homes = combined_moves(moves);
    InstanceMoves in_file;  // from the top of the scene
    for (const MoveStep& move : moves)
        if (is_at_or_below(move.from, top) && move.from != top)
            in_file.add(move.from.substr(top.size()),
                        homes.now(move.from).substr(homes.now(top).size()));
    set_text(scene_with_paths(state_.tree, text(), [&](const std::string& path) {
        return std::optional(is_from_top(path) ? in_file.now(path) : homes.now(path));
    }));
    remove_marks();
    if (check) check_scene(state_.tree, edit_.document());
}

/// Throws Error if another instance has that home path and `moves` do not give it another name.
void SceneKeeping::require_name_free(const std::string& home, const Rows& moves) const {
    const std::string path = without_marks(home), other = paths_.moved_from(path);
    if (other.empty() ||
        std::ranges::any_of(moves, [&](const JournalRow* each) { return each->instance == path; }))
        return;
    throw Error(ErrorKind::rejected, "a script or another file gives the name to what is " + other +
                                         " now: choose another one");
}

/// Removes the marks from paths: the moved instance has its new name in the file, so the new
/// instance can have the old one.
void SceneKeeping::remove_marks() {
    if (!may_have_marked_path(text())) return;
    set_text(scene_with_paths(state_.tree, text(), [](const std::string& path) {
        return std::optional(without_marks(path));
    }));
}

/// Throws unless the file, and not a script, names the topmost instance.
void SceneKeeping::require_named_by_file(const JournalRow& row) const {
    const Document& document = edit_.document();
    const Document::Node* name = document.member(document.root(), "name");
    if (name == nullptr || name->kind != Document::Kind::text ||
        document.text(*name) != split_path(row.instance).second ||
        state_.origins.named_by_script(paths_.instance(row.instance)))
        throw Error(ErrorKind::rejected, given_by_script);
}

}  // namespace fettle::property
