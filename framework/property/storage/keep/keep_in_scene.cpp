#include <keep/keep_in_scene.h>

#include <utility>

#include <keep/scene_keeping.h>

namespace fettle::property {

namespace {

using Kind = JournalRow::Kind;

/// Removes tweaks that were kept by path and would override the scene.
void forget_kept_by_path(KeepRun& run, const Rows& rows) {
    run.take_out(rows, &KeptTweaks::forget_below);
    for (const JournalRow* row : rows)
        if (row->kind == Kind::value)
            run.state.kept.forget_value(run.row_paths.home(*row), row->property);
        else if (row->kind == Kind::restored)
            run.state.kept.put_back(row->instance, row->was, run.row_paths.home_scene(*row));
    run.state.kept.write();
}

/// The instances of the scene have new names in the file: everything else that names them follows.
void change_names(KeepRun& run, const std::filesystem::path& file, const Rows& rows) {
    if (rows.empty()) return;
    std::vector<MoveStep> moves;
    std::vector<std::pair<SceneSteps, std::string>> names;
    for (const JournalRow* row : rows) {
        const auto [parent, name] = split_path(row->instance);
        moves.push_back({0, row->instance, path_below(parent, split_path(row->now).second)});
        names.emplace_back(read_steps(row->inside), split_path(row->now).second);
    }
    run.state.origins.renamed(file, names);
    run.state.steps_renamed(file, names);
    const InstanceMoves all = run.change_homes(moves, file);
    run.state.kept.rename([&](const std::string& home) { return all.now(home); });
    run.state.kept.write();
}

}  // namespace

void keep_in_scene(KeepRun& run, const std::filesystem::path& file, const Rows& rows) {
    try {
        SceneKeeping scene(run.state, run.row_paths, run.row_report, file);
        const Rows done = scene.keep(rows);
        if (!run.write(file, done, [&] { run.state.files.write(file, scene.text()); })) return;
        forget_kept_by_path(run, without_moves(done));
        run.mark_restored(done);
        run.mark_described(done);
        run.update_other_scenes(done);
        change_names(run, file, moves_in(done));
    } catch (const Error& error) {
        run.report.problems.emplace_back(error.what());
    }
}

}  // namespace fettle::property
