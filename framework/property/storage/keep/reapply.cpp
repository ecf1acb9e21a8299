// Applies tweaks of earlier runs again.

#include <algorithm>
#include <map>
#include <memory>

#include <keep/row_paths.h>
#include <keep/scene_keeping.h>
#include <scenes/scene_load.h>
#include <scenes/scene_names.h>
#include <tweaks/tweaks_state.h>
#include <values/scene_value.h>

namespace fettle::property {

namespace {

using Kind = JournalRow::Kind;
using RowState = JournalRow::State;

/// All writes inside are one edit, also those by scripts.
class EditScope {
  public:
    EditScope(Tree& tree, const std::string& name) : tree_(tree) { tree_.begin_edit(name); }
    ~EditScope() { tree_.end_edit(); }
    EditScope(const EditScope&) = delete;

  private:
    Tree& tree_;
};

/// Applies rows of earlier runs. A row describes the state at the end of its run. So it waits until
/// its parent exists and its name is free there.
class Reapplying {
  public:
    Reapplying(Tweaks::State& state, TweakReport& report)
        : state_(state), tree_(state.tree), report_(report), paths_(state) {}

    void reapply(const Rows& rows) {
        for (JournalRow* row : rows)
            if (row->kind == Kind::deleted) waiting_.push_back(row);
        // Deletions below another deletion come first.
        std::stable_sort(waiting_.begin(), waiting_.end(),
                         [](const JournalRow* a, const JournalRow* b) {
                             return a->instance.size() > b->instance.size();
                         });
        for (JournalRow* row : rows)  // an instance may replace a deleted one
            if (row->kind != Kind::value && row->kind != Kind::deleted) waiting_.push_back(row);
        find_instances();
        while (!waiting_.empty() && (apply_ready() || make_room())) {
        }
        for (JournalRow* row : std::exchange(waiting_, {})) apply(*row);  // reports the errors
        set_open_references();
        for (JournalRow* row : rows)
            if (row->kind == Kind::value) apply(*row);
    }
    /// The applied rows and their instances.
    const std::vector<std::pair<JournalRow*, Handle>>& applied() const { return applied_; }

  private:
    Handle at(const std::string& home) const {
        if (const Handle instance = at_or_none(home)) return instance;
        return instance_at(tree_, path_now(home));  // throws the error
    }
    Handle at_or_none(const std::string& home) const {
        // Before a marked instance is made again, its path may belong to another instance.
        const bool there = !is_marked(home) || std::ranges::any_of(new_homes_, [&](const auto& at) {
            return is_at_or_below(home, at);
        });
        return there ? instance_or_none(tree_, path_now(home)) : Handle{};
    }
    std::string path_now(const std::string& home) const {
        return without_marks(state_.moves().now(home));
    }

    /// Finds the instances to be moved or deleted while they are at their home paths.
    void find_instances() {
        for (JournalRow* row : waiting_)
            if (row->kind == Kind::moved || row->kind == Kind::deleted)
                instances_[row] = at_or_none(row->instance);
    }

    /// Home path of the future parent, and the final name.
    std::pair<std::string, std::string> place_of(const JournalRow& row) const {
        if (row.kind == Kind::moved)
            return {paths_.home_of_new_parent(row), split_path(row.now).second};
        return {split_path(paths_.home(row)).first, split_path(row.instance).second};
    }

    bool is_ready(const JournalRow& row) const {
        if (row.kind == Kind::deleted)
            return std::none_of(waiting_.begin(), waiting_.end(), [&](const JournalRow* other) {
                return other->kind == Kind::moved && is_at_or_below(other->instance, row.instance);
            });
        const auto [parent, name] = place_of(row);
        const Handle above = at_or_none(parent);
        return above && !tree_.child(above, name);
    }

    /// Applies the waiting rows that are ready, and returns whether there were any. New instances
    /// are made last, because they may refer to instances that are moved or made.
    bool apply_ready() {
        const Rows before = waiting_;
        for (const bool created : {false, true}) {
            for (JournalRow* row : before)
                if ((row->kind == Kind::created) == created && is_ready(*row)) {
                    std::erase(waiting_, row);
                    apply(*row);
                }
            if (waiting_.size() < before.size()) return true;
        }
        return false;
    }

    /// If instances exchange their places, gives one of them a temporary name, and returns true.
    bool make_room() {
        for (const JournalRow* row : waiting_) {
            const auto [parent, name] = place_of(*row);
            const Handle above = row->kind == Kind::deleted ? Handle{} : at_or_none(parent);
            const Handle there = above ? tree_.child(above, name) : Handle{};
            for (const JournalRow* other : waiting_)
                if (other != row && there && instances_[other] == there) {
                    tree_.rename(there, free_name(above));
                    paths_ = RowPaths(state_);
                    return true;
                }
        }
        return false;
    }

    std::string free_name(Handle parent) {
        std::string name;
        do name = "_in_between_" + std::to_string(++in_between_);
        while (tree_.child(parent, name));
        return name;
    }

    void apply(JournalRow& row) {
        try {
            const Handle instance = row.kind == Kind::value     ? set(row)
                                    : row.kind == Kind::deleted ? destroy(row)
                                    : row.kind == Kind::moved   ? move(row)
                                                                : create(row);
            applied_.emplace_back(&row, instance);
            ++report_.count;
            state_.set_state(row, RowState::dropped);
        } catch (const Error& error) {
            report_.problems.push_back(path_of(row) + ": " + error.what());
        }
    }

    Handle set(const JournalRow& row) {
        const Image image = paths_.live_image(row);
        const Handle instance = at(paths_.home(row));
        apply_image(tree_, instance, row.property, image);
        if (!image.not_saved.empty())
            report_.problems.push_back(path_of(row) + ": its formula " + image.not_saved +
                                       ", so its value is set instead");
        return instance;
    }

    Handle create(const JournalRow& row) {
        const auto [parent, name] = place_of(row);
        const Handle above = at(parent);
        if (tree_.child(above, name))
            throw Error(ErrorKind::bad_name, "there is something of this name already");
        const auto scene = std::make_shared<const Document>(scene_to_make(row), "journal");
        std::vector<OpenReference> open;
        const Handle made = make_scene(tree_, *scene, above, name, open);
        if (const std::string home = paths_.home(row); is_marked(home)) new_homes_.push_back(home);
        for (OpenReference& each : open) open_.push_back({&row, scene, std::move(each)});
        return made;
    }

    /// The scene with valid references: the current path for instances that exist, the home path
    /// for later ones, and paths from its own top for instances inside it.
    std::string scene_to_make(const JournalRow& row) const {
        return scene_with_paths(tree_, row.now, [&](const std::string& path) {
            if (path == row.instance) return std::optional<std::string>(".");
            if (is_at_or_below(path, row.instance))
                return std::optional(path.substr(row.instance.size()));
            const std::string home = paths_.home(row, path);
            const Handle there = at_or_none(home);
            return std::optional(there ? tree_.path(there) : home);
        });
    }

    /// Sets references of new instances to instances that were made after them.
    void set_open_references() {
        for (const auto& [row, scene, open] : open_) try {
                const Property* declared = tree_.find(open.instance, open.property);
                const std::string top = paths_.home(*row);
                const ReferenceResolver resolve = [&](const std::string& path,
                                                      const Document::Node&) {
                    return at(is_from_top(path) ? top + path : path);
                };
                tree_.set_or_add(
                    open.instance, open.property,
                    read_value(*scene, *open.node, declared ? declared_type(*declared) : Type::nil,
                               declared ? declared->element : Type::nil, resolve));
            } catch (const Error& error) {
                report_.problems.push_back(path_of(*row) + ": " + error.what());
            }
    }

    Handle destroy(const JournalRow& row) {
        const Handle instance = instances_[&row] ? instances_[&row] : at(row.instance);
        tree_.destroy(instance);
        return instance;
    }

    Handle move(const JournalRow& row) {
        const auto [parent, name] = place_of(row);
        const Handle instance = instances_[&row] ? instances_[&row] : at(row.instance);
        const Handle above = at(parent);
        if (tree_.parent(instance) == above)
            tree_.rename(instance, name);
        else
            tree_.move(instance, above, name);
        paths_ = RowPaths(state_);
        return instance;
    }

    Tweaks::State& state_;
    Tree& tree_;
    TweakReport& report_;
    RowPaths paths_;
    Rows waiting_;
    std::map<const JournalRow*, Handle> instances_;
    std::vector<std::pair<JournalRow*, Handle>> applied_;
    struct Open {
        const JournalRow* row;
        std::shared_ptr<const Document> scene;
        OpenReference reference;
    };
    std::vector<Open> open_;
    std::vector<std::string> new_homes_;  // marked home paths of instances that were made again
    int in_between_ = 0;
};

}  // namespace

TweakReport Tweaks::State::reapply(std::string_view pattern) {
    TweakReport report;
    barriers_to_retry = 0;
    barrier();
    refresh_earlier();
    const Rows rows = matching(pattern, true);
    Reapplying reapplying(*this, report);
    {
        const EditScope edit(tree, "reapply tweaks of " + std::string(pattern));
        reapplying.reapply(rows);
    }
    make_fresh_entries();
    for (const auto& applied : reapplying.applied()) {
        JournalRow* const row = applied.first;
        if (Entry* entry = entry_about(*row, applied.second)) {
            // What it became before, if that was undone, says nothing about it any more.
            std::erase_if(earlier.reapplied, [&](const auto& each) { return each.first == row; });
            earlier.reapplied.emplace_back(row, entry);
        }
    }
    return report;
}

/// The tweak of this run with the same content as the row.
Tweaks::State::Entry* Tweaks::State::entry_about(const JournalRow& row, Handle instance) const {
    const auto found_in = [&](const auto& entries_by_instance) -> Entry* {
        const auto found = entries_by_instance.find(instance.key());
        return found == entries_by_instance.end() ? nullptr : found->second;
    };
    // Changes of an instance inside a new one are part of the tweak of the new one.
    if (Entry* above = tree.alive(instance) ? created_above(instance) : nullptr) return above;
    switch (row.kind) {
        case Kind::value: {
            const auto found = by_key.find(key_of(Kind::value, tree.path(instance), row.property));
            return found == by_key.end() ? nullptr : found->second;
        }
        case Kind::created:
        case Kind::restored:
            return found_in(by_instance.created);
        case Kind::deleted:
            return found_in(by_instance.deleted);
        case Kind::moved:
            return found_in(by_instance.moved);
    }
    return nullptr;
}

/// A row whose repetition was undone becomes open again.
void Tweaks::State::reopen_undone_rows() {
    std::erase_if(earlier.reapplied, [](const auto& each) {
        return each.second->row.state == RowState::kept || each.first->state == RowState::kept;
    });
    for (const auto& [row, entry] : earlier.reapplied) {
        const bool undone = entry->row.state == RowState::open && !visible(*entry) &&
                            entry->deletion == nullptr &&  // otherwise a part of another tweak
                            !is_left_behind(*entry);       // otherwise listed itself
        const RowState state = undone ? RowState::open : RowState::dropped;
        if (row->state == state) continue;
        if (row->run != JournalRow::left_behind) {
            set_state(*row, state);
            continue;
        }
        row->state = state;  // the edit itself still holds in its branch
        add_to_dirty(entry_of(*row));
    }
}

}  // namespace fettle::property
