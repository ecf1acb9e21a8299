// Making tweaks of earlier runs again.

#include "row_paths.h"
#include "scene_keeping.h"
#include "scene_load.h"
#include "scene_names.h"
#include "tweaks_state.h"

namespace fettle::property {

namespace {

using Kind = JournalRow::Kind;
using RowState = JournalRow::State;

/// Whatever it does is one edit, scripts' or not.
class EditScope {
  public:
    EditScope(Tree& tree, const std::string& name) : tree_(tree) { tree_.begin_edit(name); }
    ~EditScope() { tree_.end_edit(); }
    EditScope(const EditScope&) = delete;

  private:
    Tree& tree_;
};

/// Makes rows of earlier runs again. They say the paths that instances had when all of it was done,
/// so names come first.
class Reapplying {
  public:
    Reapplying(Tweaks::State& state, TweakReport& report)
        : state_(state), tree_(state.tree), report_(report), paths_(state) {}

    void reapply(const Rows& rows) {
        move(moves_in(rows));
        for (const Kind kind : {Kind::deleted, Kind::restored, Kind::created, Kind::value})
            for (JournalRow* row : rows)
                if (row->kind == kind && tried(*row, [&] { make(*row); })) done(*row);
    }
    /// With the instances they are about.
    const std::vector<std::pair<JournalRow*, Handle>>& made() const { return made_; }

  private:
    template <class Make>
    bool tried(const JournalRow& row, Make make_it) {
        try {
            make_it();
            return true;
        } catch (const Error& error) {
            report_.problems.push_back(path_of(row) + ": " + error.what());
            return false;
        }
    }

    void done(JournalRow& row) {
        ++report_.count;
        state_.set_state(row, RowState::dropped);
    }

    void make(JournalRow& row) {
        if (row.kind == Kind::value)
            set(row);
        else if (row.kind == Kind::deleted)
            destroy(row);
        else
            create(row);
    }

    Handle at(const std::string& home) const {
        return instance_at(tree_, state_.moves().now(home));
    }

    void set(JournalRow& row) {
        const Image image = paths_.live_image(row);
        const Handle instance = at(paths_.home(row));
        apply_image(tree_, instance, row.property, image);
        if (!image.not_saved.empty())
            report_.problems.push_back(path_of(row) + ": its formula " + image.not_saved +
                                       ", so its value is set instead");
        made_.push_back({&row, instance});
    }

    void create(JournalRow& row) {
        const auto [parent, name] = split_path(paths_.home(row));
        const Handle above = at(parent);
        if (tree_.child(above, name))
            throw Error(ErrorKind::bad_name, "there is something of this name already");
        const Document scene(paths_.live_scene(row), "journal");
        made_.push_back({&row, make_scene(tree_, scene, above, name)});
    }

    void destroy(JournalRow& row) {
        const Handle instance = at(row.instance);
        tree_.destroy(instance);
        made_.push_back({&row, instance});
    }

    /// New names all together, since instances may have changed places; then new parents.
    void move(const Rows& rows) {
        std::vector<MoveStep> renames;
        std::vector<Handle> handles(rows.size());
        std::vector<bool> failed(rows.size());
        for (std::size_t i = 0; i < rows.size(); ++i)
            failed[i] = !tried(*rows[i], [&] { handles[i] = at(rows[i]->instance); });
        for (std::size_t i = 0; i < rows.size(); ++i)
            if (const std::string parent = split_path(rows[i]->instance).first;
                !failed[i] && paths_.home_of_new_parent(*rows[i]) == parent)
                renames.push_back(
                    {i, rows[i]->instance, path_below(parent, split_path(rows[i]->now).second)});
        for (const MoveStep& step : in_order(renames))
            failed[step.which] = !tried(*rows[step.which], [&] {
                tree_.rename(handles[step.which], split_path(step.to).second);
            });
        for (std::size_t i = 0; i < rows.size(); ++i) {
            if (!failed[i] &&
                paths_.home_of_new_parent(*rows[i]) != split_path(rows[i]->instance).first)
                failed[i] = !tried(*rows[i], [&] {
                    const auto [parent, name] = split_path(rows[i]->now);
                    tree_.move(handles[i], instance_at(tree_, parent), name);
                });
            if (!failed[i]) done(*rows[i]);
            if (!failed[i]) made_.push_back({rows[i], handles[i]});
        }
    }

    Tweaks::State& state_;
    Tree& tree_;
    TweakReport& report_;
    RowPaths paths_;
    std::vector<std::pair<JournalRow*, Handle>> made_;
};

}  // namespace

TweakReport Tweaks::State::reapply(std::string_view pattern) {
    TweakReport report;
    rest = 0;
    barrier();
    refresh_earlier();
    const Rows rows = matching(pattern, true);
    Reapplying reapplying(*this, report);
    {
        const EditScope edit(tree, "reapply tweaks of " + std::string(pattern));
        reapplying.reapply(rows);
    }
    settle_fresh();
    for (const auto& [row, instance] : reapplying.made())
        if (Entry* entry = entry_about(*row, instance)) reapplied.emplace_back(row, entry);
    return report;
}

/// The tweak of this run that says of the instance what the row says.
Tweaks::State::Entry* Tweaks::State::entry_about(const JournalRow& row, Handle instance) const {
    const auto found_in = [&](const auto& entries_by_instance) -> Entry* {
        const auto found = entries_by_instance.find(key(instance));
        return found == entries_by_instance.end() ? nullptr : found->second;
    };
    switch (row.kind) {
        case Kind::value: {
            const auto found = by_key.find(key_of(Kind::value, tree.path(instance), row.property));
            return found == by_key.end() ? nullptr : found->second;
        }
        case Kind::created:
        case Kind::restored:
            return found_in(created);
        case Kind::deleted:
            return found_in(deleted);
        case Kind::moved:
            return found_in(moved_entries);
    }
    return nullptr;
}

/// A row of an earlier run that was made again is open once more when that was undone.
void Tweaks::State::settle_reapplied() {
    std::erase_if(reapplied, [](const auto& each) {
        return each.second->row.state == RowState::kept || each.first->state == RowState::kept;
    });
    for (const auto& [row, entry] : reapplied) {
        const bool undone = entry->row.state == RowState::open && !visible(*entry);
        const RowState state = undone ? RowState::open : RowState::dropped;
        if (row->state != state) set_state(*row, state);
    }
}

}  // namespace fettle::property
