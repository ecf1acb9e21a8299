#include <keep/keep_run.h>

#include <utility>

#include <keep/other_scenes.h>
#include <keep/scene_keeping.h>

namespace fettle::property {

using Kind = JournalRow::Kind;
using RowState = JournalRow::State;

KeepRun::KeepRun(Tweaks::State& s, TweakReport& r)
    : state(s), report(r), row_report(r), row_paths(s) {
    state.kept.reload();
    state.kept.find_by([this](const std::string& home) { return row_paths.instance(home); });
}

KeepRun::~KeepRun() {
    state.kept.find_by({});
}

void KeepRun::mark_kept(const std::filesystem::path& file, const Rows& kept) {
    if (report.files.empty() || report.files.back() != file.string())
        report.files.push_back(file.string());
    report.count += kept.size();
    for (JournalRow* row : kept) {
        row->kept_in = file.filename().string();
        state.set_state(*row, RowState::kept);
        if (row->run != 0 && row->kind == Kind::value) state.set_former_value(*row);
    }
}

void KeepRun::mark_restored(const Rows& rows) {
    for (const JournalRow* row : rows) {
        if (row->kind != Kind::restored || row->run != 0) continue;
        Tweaks::State::Entry& its = state.entry_of(*row);
        Tweaks::State::Entry& deletion = *state.by_instance.deleted.at(its.handle.key());
        deletion.gone = true;
        deletion.kept_version = 0;  // the file has it again
        state.touch(deletion);
    }
}

void KeepRun::mark_described(const Rows& rows) {
    for (const JournalRow* row : rows) {
        if (row->kind != Kind::created || row->run != 0) continue;
        const Handle made = state.entry_of(*row).handle;
        if (!state.tree.alive(made)) continue;
        const Document document(row->now, "its scene");
        describe(document, document.root(), state.tree.parent(made), made);
    }
}

void KeepRun::mark_made_by_path(const Rows& rows) {
    for (JournalRow* row : rows) {
        if (row->kind != Kind::created) continue;
        row->file.clear();
        row->inside.clear();
    }
}

void KeepRun::describe(const Document& document, const Document::Node& node, Handle parent,
                       Handle instance) {
    state.origins.added(state.tree, parent, instance);
    const Document::Node* children = document.member(node, "children");
    for (const Document::Node* child = children ? document.first(*children) : nullptr; child;
         child = document.next(*child))
        if (const Document::Node* name = document.member(*child, "name"))
            if (const Handle handle = state.tree.child(instance, document.text(*name)))
                describe(document, *child, instance, handle);
}

void KeepRun::update_other_scenes(const Rows& rows) {
    OtherScenes others(state, report);
    for (const JournalRow* row : rows)
        if (row->kind == Kind::deleted)
            others.forget(*row);
        else if (row->kind == Kind::restored)
            others.put_back(*row);
    others.write();
}

InstanceMoves KeepRun::change_homes(const std::vector<MoveStep>& moves,
                                    const std::filesystem::path& file) {
    InstanceMoves all = combined_moves(moves);
    rename_in_scenes(all, file);
    change_paths_in_rows(all);
    return all;
}

void KeepRun::moved_by_path(const std::vector<MoveStep>& moves,
                            const std::vector<MoveStep>& named_by_scenes) {
    rename_in_scenes(combined_moves(named_by_scenes), state.kept.file());
    change_paths_in_rows(combined_moves(moves));
}

void KeepRun::rename_in_scenes(const InstanceMoves& moves, const std::filesystem::path& except) {
    OtherScenes others(state, report);
    others.rename(moves, except);
    others.write();
}

void KeepRun::change_paths_in_rows(const InstanceMoves& all) {
    std::vector<std::pair<JournalRow*, std::string>> homes;
    for (JournalRow& row : state.earlier.rows)
        if (row.state == RowState::open) homes.emplace_back(&row, all.now(row_paths.home(row)));
    state.homes_changed([all](const std::string& home) { return all.now(home); });
    for (const auto& [row, home] : homes)
        if (row->kind == Kind::moved) row->instance = home;
    row_paths = RowPaths(state);  // the moves have new home paths
    for (const auto& [row, home] : homes) {
        const std::string path = row_paths.path_in_rows(*row, home);
        if (std::exchange(row->instance, path) != path || row->kind == Kind::moved)
            state.renamed_earlier(*row);
    }
}

void KeepRun::take_out(const Rows& rows, std::vector<std::string> (KeptTweaks::*take)(
                                             const std::vector<std::string>& paths)) {
    Rows deletions;
    std::vector<std::string> paths;
    for (JournalRow* row : rows)
        if (row->kind == Kind::deleted) {
            deletions.push_back(row);
            paths.push_back(row->instance);
        }
    const std::vector<std::string> before = (state.kept.*take)(paths);
    for (std::size_t i = 0; i < paths.size(); ++i)
        store_removed_text(state, *deletions[i], before[i]);
}

}  // namespace fettle::property
