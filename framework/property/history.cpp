#include "history.h"

#include <algorithm>
#include <utility>

#include <fettle/property/error.h>
#include <fettle/property/exception_text.h>

#include "state.h"

namespace fettle::property {
namespace {

std::string short_text(std::string text) {
    if (text.size() > 48) text = text.substr(0, 45) + "...";
    return text;
}

}  // namespace

// --- Recording
// -------------------------------------------------------------------------------------------------------

bool History::recording() const {
    return !tree_.state().replaying && recording(tree_.state().writer);
}

void History::begin(std::string name, bool scripts) {
    scripts_.push_back(scripts);
    script_edits_ += scripts;
    tree_.state().note_recording();
    if (depth_++ > 0) return;
    open_ = {};
    open_bytes_ = 0;
    written_.clear();
    open_.name = std::move(name);
    open_.cause = tree_.cause();
}

void History::end() {
    if (depth_ == 0) return;
    script_edits_ -= scripts_.back();
    scripts_.pop_back();
    tree_.state().note_recording();
    if (--depth_ > 0) return;
    close();
}

void History::close() {
    if (open_.steps.empty() && !open_.too_large) return;
    clear(lists_.undone);
    put(lists_.done, std::exchange(open_, {}));
    trim();
}

void History::put(Transactions& list, Transaction transaction) {
    if (transaction.bytes() > most_of_one()) make_void(transaction);
    list.push(std::move(transaction));
    if (bytes_) *bytes_ += list.top_bytes();
    bytes_ever_ += list.top_bytes();
    ++version_;
}

Transaction History::take(Transactions& list) {
    Transaction taken = list.top();
    if (bytes_) *bytes_ -= list.top_bytes();
    list.pop();
    ++version_;
    return taken;
}

/// It stays in the list by its name.
void History::make_void(Transaction& transaction) {
    forget(transaction);
    transaction.steps = {};
    transaction.too_large = true;
}

void History::add(EditStep step, const std::string& name) {
    const bool single = depth_ == 0;
    if (single) begin(name, false);
    open_bytes_ += bytes_of(step);  // no part of the tree's weight: the list has its own limit
    if (const auto* edit = std::get_if<CellEdit>(&step))
        written_[{edit->instance.index, edit->property}] = open_.steps.size();
    else
        written_.clear();
    open_.steps.push_back(std::move(step));
    if (open_.too_large || open_bytes_ > most_of_one()) {
        make_void(open_);
        written_.clear();
    }
    if (single) end();
}

History::CellState History::capture(Handle instance, const Property& property) const {
    CellState state;
    state.present = true;
    state.overridden = tree_.overridden(instance, property);
    state.value = tree_.peek(instance, property);
    if (const Formula* formula = tree_.formula(instance, property)) state.formula = *formula;
    return state;
}

History::Position History::position(Handle instance) const {
    const Tree::State& s = tree_.state();
    const Node& node = s.nodes[instance.index];
    Position at{.parent = s.nodes.handle(node.parent),
                .before = {},
                .name = node.name,
                .named = node.named != 0};
    if (node.parent != 0 && s.nodes[node.parent].first_child != instance.index)
        at.before = s.nodes.handle(node.previous);
    return at;
}

void History::edited(Handle instance, const Property& property, CellState before) {
    if (observer_ != nullptr) observer_->edited(instance, property, before);
    CellState after;
    if (tree_.find(instance, property.symbol) != nullptr) after = capture(instance, property);
    // A drag is many edits of one cell: only its ends are kept.
    const Cell cell{instance.index, property.symbol};
    if (const auto step = written_.find(cell); depth_ > 0 && step != written_.end()) {
        auto& edit = std::get<CellEdit>(open_.steps[step->second]);
        if (edit.instance == instance) {
            edit.after = std::move(after);
            return;
        }
    }
    const std::string name = tree_.path(instance, property) + ": " +
                             short_text(tree_.text(before.value, property.precision())) + " → " +
                             short_text(tree_.text(after.value, property.precision()));
    add(CellEdit{instance, property.symbol, std::move(before), std::move(after)}, name);
}

void History::moved(Handle instance, const Position& before) {
    if (observer_ != nullptr) observer_->moved(instance, before.parent, before.name.text());
    add(MoveEdit{instance, before, position(instance)}, "move " + tree_.path(instance));
}

void History::born(Handle instance) {
    if (observer_ != nullptr) observer_->born(instance);
    ExistenceEdit existence;
    existence.top = instance;
    existence.birth = true;
    add(std::move(existence), "create " + tree_.path(instance));
}

void History::dying(Handle instance) {
    if (observer_ != nullptr) observer_->dying(instance);
    ExistenceEdit existence;
    existence.top = instance;
    existence.buried = buried_below(instance);
    for (const Buried& buried : existence.buried) {
        const Node& node = tree_.state().nodes[buried.handle.index];
        if (node.watched) ++existence.lost_watchers;
    }
    const bool single = depth_ == 0;
    add(std::move(existence), "delete " + tree_.path(instance));
    keep_slots_ = single ? !lists_.done.empty() && !lists_.done.top().too_large : !open_.too_large;
}

/// What is as in an instance just made is left out: of most, that is nearly all.
std::vector<Buried> History::buried_below(Handle top) const {
    std::vector<Buried> all;
    tree_.each_below(top, [&](Handle handle) {
        Buried buried;
        buried.handle = handle;
        buried.of = &tree_.class_of(handle);
        buried.position = position(handle);
        for (const Property* property : tree_.properties(handle)) {
            if (property->read_only || property->binding.kind == BindingKind::node) continue;
            CellState state = capture(handle, *property);
            if (state.overridden || state.formula)
                buried.cells.emplace_back(property->symbol, std::move(state));
        }
        all.push_back(std::move(buried));
    });
    return all;
}

// --- Forgetting
// ------------------------------------------------------------------------------------------------------

void History::forget(const Transaction& transaction) {
    for (const EditStep& step : transaction.steps)
        if (const auto* existence = std::get_if<ExistenceEdit>(&step))
            for (const Buried& buried : existence->buried)
                if (!tree_.alive(buried.handle)) tree_.state().nodes.free_kept(buried.handle);
}

std::size_t History::bytes() const {
    if (!bytes_) bytes_ = lists_.done.bytes() + lists_.undone.bytes();
    return *bytes_;
}

/// By a quarter more than has to be, so that it is not every edit that looks for the last.
void History::trim() {
    if (bytes() <= limit_) return;
    const std::size_t most = most_of_one();
    const auto forgotten = [this](const Transaction& transaction) { forget(transaction); };
    lists_.undone.trim(most, forgotten);
    lists_.done.trim(most - lists_.undone.bytes(), forgotten);
    bytes_.reset();
    ++version_;
}

void History::set_limit(std::size_t bytes) {
    limit_ = bytes;
    trim();
}

void History::clear(Transactions& list) {
    if (list.empty()) return;
    list.each([this](const Transaction& transaction) { forget(transaction); });
    list = {};
    bytes_.reset();
    ++version_;
}

Memory History::image() const {
    return std::make_shared<const Lists>(lists_);
}

// The slots of the dead that may come back are kept in the nodes' own image.
void History::restore(const Memory& image) {
    lists_ = image == nullptr ? Lists{} : *static_cast<const Lists*>(image.get());
    bytes_.reset();
    // An edit that is under way goes on from here.
    open_.steps.clear();
    open_.too_large = false;
    open_bytes_ = 0;
    written_.clear();
    ++version_;
}

void History::free_unclaimed() {
    Nodes& nodes = tree_.state().nodes;
    if (!nodes.keeps_any()) return;
    std::vector<bool> claimed(nodes.end());
    const auto claim = [&](const Transaction& transaction) {
        for (const EditStep& step : transaction.steps)
            if (const auto* existence = std::get_if<ExistenceEdit>(&step))
                for (const Buried& buried : existence->buried)
                    if (nodes.keeps(buried.handle)) claimed[buried.handle.index] = true;
    };
    lists_.done.each(claim);
    lists_.undone.each(claim);
    nodes.free_kept_but([&](std::uint32_t index) { return claimed[index]; });
}

std::vector<HistoryEntry> History::entries() const {
    std::vector<HistoryEntry> all;
    const auto list = [&all](const Transactions& of, bool undone) {
        of.each([&](const Transaction& t) {
            all.push_back({t.name, t.cause, t.steps.size(), undone, t.too_large});
        });
    };
    list(lists_.undone, true);
    std::reverse(all.begin(), all.end());  // what was undone first was done last
    list(lists_.done, false);
    return all;
}

// --- Undoing
// ---------------------------------------------------------------------------------------------------------

UndoResult History::undo() {
    if (edit_is_open())
        throw Error(ErrorKind::bad_structure, "nothing can be undone in the middle of an edit");
    return carry_over(lists_.done, lists_.undone, true);
}

UndoResult History::redo() {
    if (edit_is_open())
        throw Error(ErrorKind::bad_structure, "nothing can be done again in the middle of an edit");
    return carry_over(lists_.undone, lists_.done, false);
}

/// Undoes, or does again, the latest of `from`.
UndoResult History::carry_over(Transactions& from, Transactions& to, bool back) {
    if (from.empty()) return {};
    Transaction transaction = take(from);
    UndoResult result;
    try {
        result = run(transaction, back);
    } catch (...) {  // a module has no room: it can be tried again
        put(from, std::move(transaction));
        throw;
    }
    put(to, std::move(transaction));
    trim();
    return result;
}

UndoResult History::run(Transaction& transaction, bool back) {
    UndoResult result{.done = true, .name = transaction.name, .notes = {}};
    if (transaction.too_large)
        result.notes.emplace_back("it took more memory than the history may: nothing was changed");
    const Tree::CauseScope scope(tree_, Writer::undo);
    struct Applying {
        bool& flag;
        explicit Applying(bool& f) : flag(f) { flag = true; }
        ~Applying() { flag = false; }
    } applying(applying_);
    const auto one = [&](EditStep& step) {
        std::visit([&](auto& what) { apply(what, back, result); }, step);
    };
    if (back)
        for (auto step = transaction.steps.rbegin(); step != transaction.steps.rend(); ++step)
            one(*step);
    else
        for (EditStep& step : transaction.steps) one(step);
    return result;
}

void History::set_cell(Handle instance, Symbol name, const CellState& state, UndoResult& result) {
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
        // A formula that is in error leaves the default where it was, and is to go all the same.
        const bool stands =
            tree_.overridden(instance, *property) || tree_.formula(instance, *property) != nullptr;
        if (!state.overridden && stands)
            tree_.reset(instance, *property);
        else if (state.overridden && !(state.formula && state.value.is_nil()))
            tree_.set(instance, *property, state.value);
        if (state.formula) tree_.set_formula(instance, *property, *state.formula);
    } catch (...) {
        result.notes.push_back(exception_text());
    }
}

void History::apply(CellEdit& edit, bool back, UndoResult& result) {
    if (!tree_.alive(edit.instance)) {
        result.notes.push_back("an edit of \"" + edit.property.text() +
                               "\" is void: its instance was deleted since");
        return;
    }
    const Property* property = tree_.find(edit.instance, edit.property);
    CellState found;
    if (property != nullptr) found = capture(edit.instance, *property);
    set_cell(edit.instance, edit.property, back ? edit.before : edit.after, result);
    if (property == nullptr) property = tree_.find(edit.instance, edit.property);
    if (observer_ != nullptr && property != nullptr)
        observer_->edited(edit.instance, *property, found);
}

void History::apply(MoveEdit& move, bool back, UndoResult& result) {
    if (!tree_.alive(move.instance)) {
        result.notes.emplace_back("a move is void: its instance was deleted since");
        return;
    }
    const Position found = position(move.instance);
    place(move.instance, back ? move.before : move.after, result);
    if (observer_ != nullptr) observer_->moved(move.instance, found.parent, found.name.text());
}

void History::apply(ExistenceEdit& existence, bool back, UndoResult& result) {
    if (existence.birth == back)
        bury(existence, result);
    else
        revive(existence, result);
}

void History::bury(ExistenceEdit& existence, UndoResult& result) {
    if (!tree_.alive(existence.top)) {
        result.notes.emplace_back("an instance to be deleted is gone already");
        return;
    }
    if (observer_ != nullptr) observer_->dying(existence.top);
    existence.buried = buried_below(existence.top);
    existence.lost_watchers = 0;
    for (const Buried& buried : existence.buried)
        if (tree_.state().nodes[buried.handle.index].watched) ++existence.lost_watchers;
    keep_slots_ = true;
    tree_.destroy(existence.top);
    keep_slots_ = false;
}

bool History::hangs_too_deep(const ExistenceEdit& existence) const {
    const Nodes& nodes = tree_.state().nodes;
    std::unordered_map<std::uint32_t, std::size_t> depths;  // parents come before their children
    for (const Buried& buried : existence.buried) {
        const std::uint32_t parent = buried.position.parent.index;
        const auto above = depths.find(parent);
        const std::size_t depth = above != depths.end() ? above->second : nodes.depth(parent);
        if (depth + 1 > Nodes::deepest) return true;
        depths[buried.handle.index] = depth + 1;
    }
    return false;
}

void History::revive(ExistenceEdit& existence, UndoResult& result) {
    Tree::State& s = tree_.state();
    if (existence.buried.empty() || tree_.alive(existence.top)) {
        result.notes.emplace_back("an instance cannot be brought back: nothing is known of it");
        return;
    }
    if (!std::all_of(existence.buried.begin(), existence.buried.end(),
                     [&s](const Buried& buried) { return s.nodes.keeps(buried.handle); })) {
        result.notes.emplace_back("an instance cannot be brought back: its place was given away");
        return;
    }
    if (const Handle parent = existence.buried.front().position.parent;
        parent && !tree_.alive(parent)) {
        result.notes.push_back("\"" + existence.buried.front().position.name.text() +
                               "\" cannot be brought back: what it hung under is gone");
        return;
    }
    if (hangs_too_deep(existence)) {
        result.notes.push_back("\"" + existence.buried.front().position.name.text() +
                               "\" cannot be brought back: what it hung under hangs deeper now");
        return;
    }
    for (const Buried& buried : existence.buried) {
        NodeName name = buried.position.name;
        const std::uint32_t parent = buried.position.parent.index;
        if (const std::uint32_t there = parent == 0 ? 0 : s.nodes.child(parent, name); there != 0) {
            // Below, it can only be what the parent made for itself just now; at the top, the
            // game's own.
            if (&buried != &existence.buried.front()) tree_.destroy(s.nodes.handle(there));
        }
        if (parent != 0 && s.is_taken(parent, name)) name = s.free_name(parent, name.base.text());
        try {
            keep_slots_ = true;
            s.make(*buried.of, parent, name, buried.position.named, buried.handle);
            keep_slots_ = false;
        } catch (...) {  // its module has no room: they stay dead, and may be tried again
            if (tree_.alive(existence.top)) tree_.destroy(existence.top);
            keep_slots_ = false;
            throw;
        }
    }
    // Values when all are there, so that references find whom they mean.
    for (const Buried& buried : existence.buried)
        for (const auto& [symbol, state] : buried.cells)
            set_cell(buried.handle, symbol, state, result);
    place(existence.top, existence.buried.front().position, result);
    if (observer_ != nullptr) observer_->born(existence.top);
    // Whoever buries them next knows better what they are, and the slots to give back.
    existence.buried.clear();
    if (existence.lost_watchers > 0)
        result.notes.push_back("watchers of " + tree_.path(existence.top) +
                               " ended when it was deleted; they are not brought back");
}

void History::place(Handle instance, const Position& at, UndoResult& result) {
    Tree::State& s = tree_.state();
    if (at.parent && !tree_.alive(at.parent)) {
        result.notes.push_back(tree_.path(instance) + " stays: where it was is gone");
        return;
    }
    try {
        const bool taken = at.parent && s.is_taken(at.parent.index, at.name) &&
                           s.nodes.child(at.parent.index, at.name) != instance.index;
        if (tree_.parent(instance) != at.parent)
            tree_.move(instance, at.parent, taken ? std::string() : at.name.text());
        else if (!taken)
            tree_.rename(instance, at.name.text());
        s.nodes[instance.index].named = at.named;
        if (at.parent)
            s.nodes.reorder(instance.index, tree_.alive(at.before) ? at.before.index : 0);
        s.tell([&](Observer& o) { o.moved(instance); });
    } catch (const Error& error) {
        result.notes.emplace_back(error.what());
    }
}

}  // namespace fettle::property
