// Undo and redo. Values that cannot be restored are reported in notes; the rest of the step is
// undone all the same.

#include <algorithm>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include <fettle/property/error.h>
#include <fettle/property/exception_text.h>

#include "history.h"

namespace fettle::property {

UndoResult History::undo() {
    if (edit_is_open())
        throw Error(ErrorKind::bad_structure, "undo is not possible in the middle of an edit");
    return carry_over(lists_.done, lists_.undone, true);
}

UndoResult History::redo() {
    if (edit_is_open())
        throw Error(ErrorKind::bad_structure, "redo is not possible in the middle of an edit");
    return carry_over(lists_.undone, lists_.done, false);
}

/// Undoes or redoes the latest transaction of `from`.
UndoResult History::carry_over(Transactions& from, Transactions& to, bool back) {
    if (from.empty()) return {};
    Transaction transaction = take(from);
    UndoResult result = run(transaction, back);
    put(to, std::move(transaction));
    trim();
    return result;
}

namespace {

/// Finds which instances a step of undo makes, deletes or moves: their paths before and after it.
class InstanceChanges {
  public:
    InstanceChanges(const Tree& tree, const Transaction& transaction) : tree_(tree) {
        std::unordered_set<std::uint32_t> seen;
        const auto add = [&](Handle instance, bool moves) {
            if (seen.insert(instance.index).second) all_.push_back({instance, moves, "", false});
        };
        for (const EditStep& step : transaction.steps)
            if (const auto* made = std::get_if<ExistenceEdit>(&step)) {
                add(made->top, false);
                tops_.insert(made->top.index);
            }
        for (const EditStep& step : transaction.steps)
            if (const auto* move = std::get_if<MoveEdit>(&step)) add(move->instance, true);
        for (Changed& each : all_) {
            if (!tree_.alive(each.instance)) continue;
            each.before = tree_.path(each.instance);
            each.is_part = is_part(each.instance);
        }
    }

    /// Puts them before the other changes.
    void put_before(UndoResult& result) const {
        std::vector<UndoChange> others = std::exchange(result.changes, {});
        const auto add = [&](UndoChange change) {
            if (result.changes.size() == UndoResult::max_changes)
                ++result.more_changes;
            else
                result.changes.push_back(std::move(change));
        };
        for (const Changed& each : all_) {
            const bool lives = tree_.alive(each.instance);
            if (each.is_part || (lives && is_part(each.instance))) continue;
            if (!lives) {
                if (!each.before.empty() && !each.moves) add({each.before, "", "deleted"});
                continue;
            }
            const std::string now = tree_.path(each.instance);
            if (each.before.empty())
                add({now, "", "exists again (" + tree_.class_of(each.instance).name() + ")"});
            else if (each.before != now)
                add({each.before, "", "is " + now + " now"});
            else if (each.moves)
                add({now, "", "has another place among its siblings"});
        }
        for (UndoChange& each : others) add(std::move(each));
    }

  private:
    struct Changed {
        Handle instance;
        bool moves;
        std::string before;  // its path; "" if it did not exist
        bool is_part;
    };
    /// Whether it is below another instance that this step makes or deletes.
    bool is_part(Handle instance) const {
        Handle above = tree_.parent(instance);
        while (above && !tops_.contains(above.index)) above = tree_.parent(above);
        return static_cast<bool>(above);
    }

    const Tree& tree_;
    std::vector<Changed> all_;
    std::unordered_set<std::uint32_t> tops_;
};

}  // namespace

History::References::References(History& history, bool wanted)
    : history_(history), before_(std::exchange(history.needs_references_, wanted)) {
    history_.references_.clear();
    history_.has_references_ = false;
}

History::References::~References() {
    history_.references_.clear();
    history_.has_references_ = false;
    history_.needs_references_ = before_;
}

UndoResult History::run(Transaction& transaction, bool back) {
    UndoResult result{.done = true, .name = transaction.name, .notes = {}};
    result.too_large = transaction.too_large;
    if (transaction.too_large)
        result.notes.emplace_back("it took more memory than the history may: nothing was changed");
    const Tree::CauseScope scope(tree_, Writer::undo);
    struct Applying {
        bool& flag;
        explicit Applying(bool& f) : flag(f) { flag = true; }
        ~Applying() { flag = false; }
    } applying(applying_);
    // A module may clear a reference when its target is deleted, so all references are collected
    // before.
    const References references(*this, transaction.steps.size() > 1);
    // Values of instances that this step makes or deletes are not listed: there may be many of
    // them, and they are in no path of the tree.
    std::unordered_set<std::uint32_t> created_tops;
    for (const EditStep& step : transaction.steps)
        if (const auto* made = std::get_if<ExistenceEdit>(&step); made != nullptr && made->birth)
            created_tops.insert(made->top.index);
    const auto is_born = [&](const EditStep& step) {
        const auto* cell = std::get_if<CellEdit>(&step);
        if (created_tops.empty() || cell == nullptr || !tree_.alive(cell->instance)) return false;
        Handle above = cell->instance;
        while (above && !created_tops.contains(above.index)) above = tree_.parent(above);
        return static_cast<bool>(above);
    };
    InstanceChanges instances(tree_, transaction);
    if (back) transaction.taken = made_by(transaction);
    const auto one = [&](EditStep& step) {
        const bool silent = is_born(step);
        const std::size_t listed = result.changes.size(), more = result.more_changes;
        try {
            std::visit([&](auto& what) { apply(what, back, result); }, step);
        } catch (...) {  // the rest is undone all the same
            instances_.keep_slots = false;
            result.notes.push_back(exception_text());
        }
        if (!silent) return;
        result.changes.resize(listed);
        result.more_changes = more;
    };
    if (back)
        for (auto step = transaction.steps.rbegin(); step != transaction.steps.rend(); ++step)
            one(*step);
    else
        for (EditStep& step : transaction.steps) one(step);
    if (!back) give_back(std::exchange(transaction.taken, {}), result);
    resolve(result);
    instances.put_before(result);
    return result;
}

/// The new instances of a transaction that still exist, and those below them, as they are now.
std::vector<DeletedInstance> History::made_by(const Transaction& transaction) const {
    std::vector<DeletedInstance> all;
    std::unordered_set<std::uint32_t> seen;
    for (const EditStep& step : transaction.steps) {
        const auto* const made = std::get_if<ExistenceEdit>(&step);
        if (made == nullptr || !made->birth || !tree_.alive(made->top)) continue;
        for (DeletedInstance& each : deleted_below(made->top))
            if (seen.insert(each.handle.index).second) all.push_back(std::move(each));
    }
    return all;
}

/// The steps of a transaction contain the values and places that its new instances got first. After
/// they are made again, they get those that undo took away, all of one moment.
void History::give_back(const std::vector<DeletedInstance>& taken, UndoResult& result) {
    const std::size_t listed = result.changes.size(), more = result.more_changes;
    for (const DeletedInstance& each : taken)
        if (tree_.alive(each.handle)) give_back(each, result);
    result.changes.resize(listed);
    result.more_changes = more;
}

void History::give_back(const DeletedInstance& taken, UndoResult& result) {
    const Position now = nodes_.position(taken.handle.index);
    if (now.parent != taken.position.parent || now.name != taken.position.name) {
        place(taken.handle, taken.position, result);
        inform([&](EditObserver& observer) {
            observer.moved(taken.handle, now.parent, now.name.text());
        });
    }
    std::unordered_map<Symbol, const CellState*> states;
    for (const auto& [symbol, state] : taken.cells) states[symbol] = &state;
    std::vector<Symbol> all;
    for (const Property* property : tree_.properties(taken.handle))
        if (!property->read_only && property->binding.kind != BindingKind::node)
            all.push_back(property->symbol);
    for (const auto& [symbol, state] : taken.cells)
        if (tree_.find(taken.handle, symbol) == nullptr) all.push_back(symbol);
    for (const Symbol symbol : all) {
        const CellState found = capture(taken.handle, symbol);
        const Property* property = tree_.find(taken.handle, symbol);
        CellState to{.present =
                         property != nullptr && property->binding.kind != BindingKind::ad_hoc};
        if (const auto known = states.find(symbol); known != states.end()) to = *known->second;
        const bool formulas = found.formula && to.formula;
        const bool same = found.present == to.present && found.overridden == to.overridden &&
                          found.formula.has_value() == to.formula.has_value() &&
                          (formulas ? found.formula->source == to.formula->source
                                    : !to.overridden || found.value == to.value);
        if (same) continue;
        set_cell(taken.handle, symbol, to, result);
        if (property == nullptr) property = tree_.find(taken.handle, symbol);
        if (property != nullptr)
            inform(
                [&](EditObserver& observer) { observer.edited(taken.handle, *property, found); });
    }
}

/// Writes the references whose targets exist again. The other cells keep the best possible state
/// until then.
void History::resolve(UndoResult& result) {
    for (Unresolved& each : std::exchange(unresolved_, {})) {
        if (!may_resolve(each)) continue;
        const bool resolved = !names_deleted(tree_, each.state.value);
        if (resolved || !each.meanwhile) {
            const CellState found = capture(each.instance, each.property);
            write_cell(each.instance, each.property, each.state, result);
            const Property* property = tree_.find(each.instance, each.property);
            if (property != nullptr)
                inform([&](EditObserver& observer) {
                    observer.edited(each.instance, *property, found);
                });
            each.meanwhile = capture(each.instance, each.property);
        }
        if (!resolved) unresolved_.push_back(std::move(each));
    }
}

bool History::may_resolve(const Unresolved& cell) const {
    if (!tree_.alive(cell.instance)) return false;
    if (!cell.meanwhile) return true;
    const CellState now = capture(cell.instance, cell.property);
    return now.present == cell.meanwhile->present && now.overridden == cell.meanwhile->overridden &&
           now.formula.has_value() == cell.meanwhile->formula.has_value() &&
           now.value == cell.meanwhile->value;
}

void History::set_cell(Handle instance, Symbol name, const CellState& state, UndoResult& result) {
    references_.erase({instance.index, name});
    std::erase_if(unresolved_, [&](const Unresolved& each) {
        return each.instance == instance && each.property == name;
    });
    if (names_deleted(tree_, state.value))
        unresolved_.push_back({instance, name, state});  // this step may restore it
    else
        write_cell(instance, name, state, result);
}

void History::write_cell(Handle instance, Symbol name, const CellState& state, UndoResult& result) {
    try {
        const Property* property = tree_.find(instance, name);
        if (!state.present) {
            if (property != nullptr) tree_.remove_ad_hoc(instance, name.text());
            return;
        }
        if (property == nullptr) {
            tree_.set_or_add(instance, name.text(),
                             state.value.is_nil() ? Value(false) : state.value);
            property = tree_.find(instance, name);
        }
        if (property == nullptr) return;
        // A formula that fails does not override the default, but it has to be removed as well.
        const bool is_set =
            tree_.overridden(instance, *property) || tree_.formula(instance, *property) != nullptr;
        if (!state.overridden && is_set)
            tree_.reset(instance, *property);
        else if (state.overridden && !(state.formula && state.value.is_nil()))
            tree_.set(instance, *property, state.value);
        if (state.formula) tree_.set_formula(instance, *property, *state.formula);
    } catch (...) {
        result.notes.push_back(exception_text());
    }
}

namespace {

std::string text_of(const Tree& tree, const Property& property, const CellState& state) {
    if (!state.present) return "nil";
    if (state.formula)
        return "is " + (state.formula->source.empty() ? "a function" : state.formula->source);
    return tree.text(state.value, property.precision());
}

}  // namespace

/// Adds to the result how the cell was changed.
void History::add_change(Handle instance, const Property& property, const CellState& from,
                         UndoResult& result) const {
    if (result.changes.size() == UndoResult::max_changes) {
        ++result.more_changes;
        return;
    }
    CellState to;
    if (const Property* now = tree_.find(instance, property.name)) to = capture(instance, *now);
    std::string after = text_of(tree_, property, to);
    const bool plain = to.present && !to.formula && !to.value.is_nil();
    if (plain && !property.unit.empty()) after += " " + property.unit;
    result.changes.push_back(
        {tree_.path(instance, property), text_of(tree_, property, from), std::move(after)});
}

void History::apply(CellEdit& edit, bool back, UndoResult& result) {
    if (!tree_.alive(edit.instance)) {
        result.notes.push_back("an edit of \"" + edit.property.text() +
                               "\" is void: its instance was deleted since");
        return;
    }
    const CellState found = capture(edit.instance, edit.property);
    const Property* property = tree_.find(edit.instance, edit.property);
    set_cell(edit.instance, edit.property, back ? edit.before : edit.after, result);
    if (property == nullptr) property = tree_.find(edit.instance, edit.property);
    if (property == nullptr) return;
    inform([&](EditObserver& observer) { observer.edited(edit.instance, *property, found); });
    add_change(edit.instance, *property, found, result);
}

void History::apply(MoveEdit& move, bool back, UndoResult& result) {
    if (!tree_.alive(move.instance)) {
        result.notes.emplace_back("a move is void: its instance was deleted since");
        return;
    }
    const Position found = nodes_.position(move.instance.index);
    place(move.instance, back ? move.before : move.after, result);
    inform([&](EditObserver& observer) {
        observer.moved(move.instance, found.parent, found.name.text());
    });
}

void History::apply(ExistenceEdit& existence, bool back, UndoResult& result) {
    if (existence.birth == back)
        delete_again(existence, result);
    else
        revive(existence, result);
}

void History::delete_again(ExistenceEdit& existence, UndoResult& result) {
    if (!tree_.alive(existence.top)) {
        result.notes.emplace_back("an instance to be deleted does not exist any more");
        return;
    }
    inform([&](EditObserver& observer) { observer.instance_deleting(existence.top); });
    note_references();
    existence.deleted = deleted_below(existence.top);
    existence.lost_watchers = 0;
    for (const DeletedInstance& deleted : existence.deleted)
        if (nodes_[deleted.handle.index].watched) ++existence.lost_watchers;
    instances_.keep_slots = true;
    tree_.destroy(existence.top);
    instances_.keep_slots = false;
}

bool History::would_be_too_deep(const ExistenceEdit& existence) const {
    const Nodes& nodes = nodes_;
    std::unordered_map<std::uint32_t, std::size_t> depths;  // parents come before their children
    for (const DeletedInstance& deleted : existence.deleted) {
        const std::uint32_t parent = deleted.position.parent.index;
        const auto above = depths.find(parent);
        const std::size_t depth = above != depths.end() ? above->second : nodes.depth(parent);
        if (depth + 1 > Nodes::deepest) return true;
        depths[deleted.handle.index] = depth + 1;
    }
    return false;
}

void History::revive(ExistenceEdit& existence, UndoResult& result) {
    if (existence.deleted.empty() || tree_.alive(existence.top)) {
        result.notes.emplace_back("an instance cannot be brought back: nothing is known of it");
        return;
    }
    if (!std::all_of(
            existence.deleted.begin(), existence.deleted.end(),
            [this](const DeletedInstance& deleted) { return nodes_.keeps(deleted.handle); })) {
        result.notes.emplace_back(
            "an instance cannot be brought back: its slot is no longer reserved");
        return;
    }
    if (const Handle parent = existence.deleted.front().position.parent;
        parent && !tree_.alive(parent)) {
        result.notes.push_back(
            "\"" + existence.deleted.front().position.name.text() +
            "\" cannot be brought back: its former parent does not exist any more");
        return;
    }
    if (would_be_too_deep(existence)) {
        result.notes.push_back(
            "\"" + existence.deleted.front().position.name.text() +
            "\" cannot be brought back: its former parent is too deep in the tree now");
        return;
    }
    for (const DeletedInstance& deleted : existence.deleted) {
        NodeName name = deleted.position.name;
        const std::uint32_t parent = deleted.position.parent.index;
        if (const std::uint32_t there = parent == 0 ? 0 : nodes_.child(parent, name); there != 0) {
            // Below the top, a child of this name was just made by its new parent. At the top, it
            // belongs to the game and stays.
            if (&deleted != &existence.deleted.front()) tree_.destroy(nodes_.handle(there));
        }
        if (parent != 0 && instances_.is_taken(parent, name))
            name = structure_.free_name(parent, name.base.text());
        try {
            instances_.keep_slots = true;
            structure_.make(*deleted.of, parent, name, deleted.position.named, deleted.handle);
            instances_.keep_slots = false;
        } catch (...) {  // the module refuses it, so all of them stay deleted
            const std::string& top = existence.deleted.front().position.name.text();
            result.notes.push_back(
                "\"" + top + "\" cannot be brought back: " +
                (&deleted == &existence.deleted.front() ? "" : name.text() + ": ") +
                exception_text());
            if (tree_.alive(existence.top)) tree_.destroy(existence.top);
            instances_.keep_slots = false;
            return;
        }
    }
    // Values are set after all instances exist, so that references find their targets.
    for (const DeletedInstance& deleted : existence.deleted)
        for (const auto& [symbol, state] : deleted.cells)
            set_cell(deleted.handle, symbol, state, result);
    place(existence.top, existence.deleted.front().position, result);
    inform([&](EditObserver& observer) { observer.instance_created(existence.top); });
    // The next deletion stores the current state and decides which slots to free.
    existence.deleted.clear();
    if (existence.lost_watchers > 0)
        result.notes.push_back("watchers of " + tree_.path(existence.top) +
                               " ended when it was deleted; they are not brought back");
}

void History::place(Handle instance, const Position& at, UndoResult& result) {
    if (at.parent && !tree_.alive(at.parent)) {
        result.notes.push_back(tree_.path(instance) +
                               " stays: its former parent does not exist any more");
        return;
    }
    try {
        const bool taken = at.parent && instances_.is_taken(at.parent.index, at.name) &&
                           nodes_.child(at.parent.index, at.name) != instance.index;
        if (tree_.parent(instance) != at.parent)
            tree_.move(instance, at.parent, taken ? std::string() : at.name.text());
        else if (!taken)
            tree_.rename(instance, at.name.text());
        nodes_[instance.index].named = at.named;
        if (at.parent) nodes_.reorder(instance.index, tree_.alive(at.before) ? at.before.index : 0);
        structure_.changes.notify([&](Observer& o) { o.moved(instance); });
    } catch (const Error& error) {
        result.notes.emplace_back(error.what());
    }
}

}  // namespace fettle::property
