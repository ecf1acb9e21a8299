#include <keep/keep_by_path.h>

#include <string>
#include <unordered_set>
#include <vector>

#include <keep/scene_keeping.h>

namespace fettle::property {

namespace {

using Kind = JournalRow::Kind;

/// Throws if a script makes an instance at that path, which was moved away now: both would need
/// the path.
void require_free(const KeepRun& run, const std::string& home) {
    if (const std::string other = run.row_paths.moved_from(without_marks(home)); !other.empty())
        throw Error(ErrorKind::rejected,
                    "a script gives this name to what is " + other + " now: change the script");
}

/// Throws for a marked path: the file cannot distinguish two instances with the same home path.
std::string unmarked(const KeepRun& run, std::string home) {
    if (!is_marked(home)) return home;
    std::string path = without_marks(home);
    while (path != "game" && run.row_paths.moved_from(path).empty()) path = split_path(path).first;
    throw Error(ErrorKind::rejected, without_marks(home) +
                                         " is new and has a name that a script gives to " +
                                         run.row_paths.moved_from(path) + ": change the script");
}

std::string unmarked_scene(const KeepRun& run, const JournalRow& row) {
    return run.row_paths.home_scene(row,
                                    [&](const std::string& home) { return unmarked(run, home); });
}

/// Throws if a script gives the name or the parent, or if the new parent is in no file.
void require_movable(const KeepRun& run, const JournalRow& row) {
    const KeptTweaks& kept = run.state.kept;
    const bool by_scene =
        !row.file.empty() &&
        (!row.inside.empty() ||
         (run.row_paths.home_of_new_parent(row) == split_path(row.instance).first &&
          !run.state.origins.named_by_script(run.row_paths.instance(row.instance))));
    if (!by_scene && !kept.makes(row.instance) && !kept.moves_to(row.instance))
        throw Error(ErrorKind::rejected, given_by_script);
    if (const std::string parent = unkept_parent(run, row); !parent.empty())
        throw Error(ErrorKind::rejected, "it depends on " + parent + ", which is not kept");
}

const Property* declared(const KeepRun& run, const std::string& home, const std::string& property) {
    const Handle instance = run.row_paths.instance(home);
    return instance ? run.state.tree.class_of(instance).property(property) : nullptr;
}

void apply_to_kept(KeepRun& run, const JournalRow& row) {
    const std::string home = run.row_paths.home(row);
    switch (row.kind) {
        case Kind::value: {
            const Property* const property = declared(run, home, row.property);
            const auto in_file = [&](const std::string& path) {
                return unmarked(run, run.row_paths.home_of_live(path));
            };
            run.state.kept.set(unmarked(run, home), row.property, property,
                               run.row_report.kept_image(row, run.row_paths), in_file);
            if (row.run == 0 && run.state.entry_of(row).given)
                run.state.kept.note_given(unmarked(run, home), row.property, property,
                                          *run.state.entry_of(row).given, in_file);
            return;
        }
        case Kind::created:
            check_made(run.state, run.row_paths, row);
            require_free(run, home);
            return run.state.kept.add(home, unmarked_scene(run, row));
        case Kind::restored:
            return run.state.kept.put_back(home, row.was, unmarked_scene(run, row));
        case Kind::deleted:
        case Kind::moved:
            return;
    }
}

/// Returns the rows without those that contradict earlier ones, which are reported.
template <class Check>
Rows possible_together(KeepRun& run, const Rows& rows, Check check) {
    try {
        check(rows);
        return rows;
    } catch (const Error&) {  // not all together: the loop finds the rows that fail
    }
    Rows possible;
    for (JournalRow* row : rows) {
        possible.push_back(row);
        if (!run.row_report.tried(*row, [&] { check(possible); })) possible.pop_back();
    }
    return possible;
}

}  // namespace

/// An invalid row must not prevent the others from being kept. It is found by splitting the
/// rows into halves.
void keep_by_path(KeepRun& run, const Rows& rows) {
    const std::size_t reported_before = run.report.problems.size();
    Rows done;
    try {
        for (JournalRow* row : rows)
            if (row->kind == Kind::deleted &&
                run.row_report.tried(*row, [&] { require_nothing_moved_out(run.row_paths, *row); }))
                done.push_back(row);
        run.take_out(done, &KeptTweaks::remove);
        Rows others;
        for (JournalRow* row : rows)
            if (row->kind != Kind::deleted) others.push_back(row);
        const Rows into = run.row_report.tried_together(
            others, run.row_paths,
            [&] {
                if (!others.empty()) run.state.kept.reload();
            },
            [&](const JournalRow& row) { apply_to_kept(run, row); });
        done.insert(done.end(), into.begin(), into.end());
        if (!run.write(run.state.kept.file(), done, [&] { run.state.kept.write(); })) return;
        run.mark_restored(done);
        KeepRun::mark_made_by_path(done);
        run.update_other_scenes(done);
    } catch (const SceneError& error) {
        run.state.kept.reload();
        if (done.size() == 1)
            return run.row_report.refuse(*done.front(), run.row_paths, error.reason());
        run.report.problems.resize(reported_before);
        const auto middle = rows.begin() + static_cast<std::ptrdiff_t>(rows.size() / 2);
        keep_by_path(run, {rows.begin(), middle});
        keep_by_path(run, {middle, rows.end()});
    }
}

std::string unkept_parent(const KeepRun& run, const JournalRow& row) {
    const std::string parent = run.row_paths.home_of_new_parent(row);
    const auto is_open = [&](const JournalRow& made) {
        return made.kind == Kind::created && made.state == JournalRow::State::open &&
               is_at_or_below(parent, run.row_paths.home(made));
    };
    for (const JournalRow& made : run.state.earlier.rows)
        if (is_open(made)) return made.instance;
    for (const auto& [handle, made] : run.state.by_instance.created)
        if (!made->gone && is_open(made->row)) return made->row.instance;
    return {};
}

void keep_moves_by_path(KeepRun& run, Rows rows) {
    const auto target = [&](const JournalRow& row) {
        return path_below(run.row_paths.home_of_new_parent(row), split_path(row.now).second);
    };
    std::erase_if(rows, [&](const JournalRow* row) {
        return !run.row_report.tried(*row, [&] {
            require_movable(run, *row);
            run.state.kept.require_movable(row->instance, target(*row));
        });
    });
    std::unordered_set<std::string> moving_away;
    for (const JournalRow* row : rows) moving_away.insert(row->instance);
    std::erase_if(rows, [&](const JournalRow* row) {
        const std::string to = target(*row);
        return !run.row_report.tried(*row, [&] {
            if (!moving_away.contains(to)) require_free(run, to);
            if (!run.state.kept.makes(row->instance) && run.state.deleted_by_path(to))
                throw Error(ErrorKind::rejected, name_of_deleted);
        });
    });
    const auto steps = [&](const Rows& some) {
        std::vector<MoveStep> moves;
        moves.reserve(some.size());
        for (std::size_t i = 0; i < some.size(); ++i)
            moves.push_back({i, some[i]->instance, target(*some[i])});
        return moves;
    };
    rows =
        possible_together(run, rows, [&](const Rows& some) { (void)combined_moves(steps(some)); });
    if (rows.empty()) return;
    const std::vector<MoveStep> moves = steps(rows);
    std::vector<MoveStep> made;  // of instances that the file makes: a scene file may name them
    Rows parts;                  // of scenes
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (run.state.kept.makes(rows[i]->instance))
            made.push_back(moves[i]);
        else
            parts.push_back(rows[i]);
    try {
        if (!run.write(run.state.kept.file(), rows, [&] {
                run.state.kept.move(moves);
                run.state.kept.write();
            }))
            return;
        for (const JournalRow* row : parts)
            run.state.part_moved(*row, run.row_paths.instance(row->instance));
        run.moved_by_path(moves, made);
    } catch (const SceneError& error) {
        run.state.kept.reload();
        run.report.problems.emplace_back(error.what());
    }
}

}  // namespace fettle::property
