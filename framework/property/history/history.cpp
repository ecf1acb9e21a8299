#include "history.h"

#include <algorithm>
#include <utility>

#include <fettle/property/utf8.h>

namespace fettle::property {
namespace {

std::string short_text(std::string text) {
    if (text.size() > 48) text = text.substr(0, code_point_boundary(text, 45)) + "...";
    return text;
}

}  // namespace

// --- Recording

void History::note_recording() {
    Changes& changes = structure_.changes;
    changes.writes.close(WritesLog::Reason::recorded, recording(changes.author.writer));
}

void History::begin(std::string name, bool scripts) {
    scripts_.push_back(scripts);
    script_edits_ += scripts;
    note_recording();
    if (depth_++ > 0) return;
    open_ = {};
    open_bytes_ = 0;
    written_.clear();
    references_.clear();
    has_references_ = false;
    needs_references_ = true;
    open_.name = std::move(name);
    open_.cause = tree_.cause();
}

void History::end() {
    if (depth_ == 0) return;
    script_edits_ -= scripts_.back();
    scripts_.pop_back();
    note_recording();
    if (--depth_ > 0) return;
    references_.clear();
    needs_references_ = false;
    close();
}

void History::close() {
    if (open_.steps.empty() && !open_.too_large) return;
    clear(lists_.undone);
    put(lists_.done, std::exchange(open_, {}));
    if (lists_.done.top().too_large) ++edits_without_undo_;
    trim();
}

void History::put(Transactions& list, Transaction transaction) {
    if (transaction.bytes() > max_edit_bytes()) make_void(transaction);
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

/// Forgets what the transaction did. Its name stays in the list.
void History::make_void(Transaction& transaction) {
    forget(transaction);
    transaction.steps = {};
    transaction.taken = {};
    transaction.too_large = true;
}

void History::add(EditStep step, const std::string& name) {
    const bool single = depth_ == 0;
    if (single) begin(name, false);
    if (open_.steps.empty()) {  // `cause.where` stays the place at which the edit began
        open_.cause.writer = tree_.cause().writer;
        open_.cause.step = tree_.cause().step;
    }
    open_bytes_ += bytes_of(step);  // the list has its own memory limit
    if (const auto* edit = std::get_if<CellEdit>(&step))
        written_[{edit->instance.index, edit->property}] = open_.steps.size();
    else
        written_.clear();
    open_.steps.push_back(std::move(step));
    if (open_.too_large || open_bytes_ > max_edit_bytes()) {
        make_void(open_);
        written_.clear();
    }
    if (single) end();
}

CellState History::capture(Handle instance, const Property& property) const {
    CellState state;
    state.present = true;
    state.overridden = tree_.overridden(instance, property);
    state.value = tree_.peek(instance, property);
    if (const Formula* formula = tree_.formula(instance, property)) state.formula = *formula;
    return state;
}

/// The state of an ad-hoc property; `present` is false if there is none of that name.
CellState History::capture(Handle instance, Symbol name) const {
    const Property* property = tree_.find(instance, name);
    return property == nullptr ? CellState{} : capture(instance, *property);
}

void History::edited(Handle instance, const Property& property, CellState before) {
    inform([&](EditObserver& observer) { observer.edited(instance, property, before); });
    references_.erase({instance.index, property.symbol});
    CellState after = capture(instance, property.symbol);
    // A drag writes one cell many times. Only the first and the last value are kept.
    const Cell cell{instance.index, property.symbol};
    if (const auto step = written_.find(cell); depth_ > 0 && step != written_.end()) {
        auto& edit = std::get<CellEdit>(open_.steps[step->second]);
        if (edit.instance == instance) {
            edit.after = std::move(after);
            return;
        }
    }
    // The value was there already.
    if (before.present == after.present && before.overridden == after.overridden &&
        !before.formula && !after.formula && before.value == after.value)
        return;
    const std::string name = tree_.path(instance, property) + ": " +
                             short_text(tree_.text(before.value, property.precision())) + " → " +
                             short_text(tree_.text(after.value, property.precision()));
    add(CellEdit{instance, property.symbol, std::move(before), std::move(after)}, name);
}

void History::moved(Handle instance, const Position& before) {
    inform([&](EditObserver& observer) {
        observer.moved(instance, before.parent, before.name.text());
    });
    add(MoveEdit{instance, before, nodes_.position(instance.index)},
        "move " + tree_.path(instance));
}

void History::instance_created(Handle instance) {
    inform([&](EditObserver& observer) { observer.instance_created(instance); });
    ExistenceEdit existence;
    existence.top = instance;
    existence.birth = true;
    add(std::move(existence), "create " + tree_.path(instance));
}

void History::instance_deleting(Handle instance) {
    inform([&](EditObserver& observer) { observer.instance_deleting(instance); });
    note_references();
    ExistenceEdit existence;
    existence.top = instance;
    existence.deleted = deleted_below(instance);
    for (const DeletedInstance& deleted : existence.deleted) {
        const Node& node = nodes_[deleted.handle.index];
        if (node.watched) ++existence.lost_watchers;
    }
    const bool single = depth_ == 0;
    add(std::move(existence), "delete " + tree_.path(instance));
    instances_.keep_slots =
        single ? !lists_.done.empty() && !lists_.done.top().too_large : !open_.too_large;
}

/// Leaves out every cell that has its initial state. For most instances that is nearly all cells.
std::vector<DeletedInstance> History::deleted_below(Handle top) const {
    std::vector<DeletedInstance> all;
    tree_.each_below(top, [&](Handle handle) {
        DeletedInstance deleted;
        deleted.handle = handle;
        deleted.of = &tree_.class_of(handle);
        deleted.position = nodes_.position(handle.index);
        for (const Property* property : tree_.properties(handle)) {
            if (property->read_only || property->binding.kind == BindingKind::node) continue;
            CellState state = before_deletion(handle, *property);
            if (state.overridden || state.formula)
                deleted.cells.emplace_back(property->symbol, std::move(state));
        }
        all.push_back(std::move(deleted));
    });
    return all;
}

/// Collects all references once per edit, however many instances the edit deletes.
void History::note_references() {
    if (!needs_references_ || has_references_) return;
    has_references_ = true;
    std::vector<std::vector<const Property*>> of_class(instances_.classes.size());
    for (std::uint32_t id = 0; id < instances_.classes.size(); ++id)
        for (const Property* property : instances_.classes[id].properties())
            if (property->type == Type::reference && !property->read_only &&
                property->binding.kind != BindingKind::node)
                of_class[id].push_back(property);
    for (std::uint32_t i = 1; i < nodes_.end(); ++i) {
        if (!nodes_[i].alive()) continue;
        for (const Property* property : of_class[nodes_[i].class_id]) try {
                const Value value = instances_.read(i, nodes_[i], *property);
                if (value.is(Type::reference) && value.reference())
                    references_[{i, property->symbol}] = value.reference();
            } catch (...) {
                // This instance is not deleted by the edit, so an unreadable property of it does
                // not matter.
            }
    }
}

/// State of a cell whose instance is about to be deleted. A reference has the target that it had
/// before the first deletion of this edit.
CellState History::before_deletion(Handle instance, const Property& property) const {
    for (const Unresolved& each : unresolved_)
        if (each.instance == instance && each.property == property.symbol && may_resolve(each))
            return each.state;
    CellState state = capture(instance, property);
    if (property.type != Type::reference || state.formula || references_.empty()) return state;
    const auto known = references_.find({instance.index, property.symbol});
    if (known == references_.end() || tree_.alive(known->second)) return state;
    if (state.value.is(Type::reference) && state.value.reference()) return state;
    state.value = known->second;
    state.overridden = true;
    return state;
}

// --- Forgetting

void History::forget(const Transaction& transaction) {
    for (const EditStep& step : transaction.steps)
        if (const auto* existence = std::get_if<ExistenceEdit>(&step))
            for (const DeletedInstance& deleted : existence->deleted)
                if (!tree_.alive(deleted.handle)) nodes_.free_kept(deleted.handle);
}

std::size_t History::bytes() const {
    if (!bytes_) bytes_ = lists_.done.bytes() + lists_.undone.bytes();
    return *bytes_;
}

/// Frees a quarter more than necessary, so that not every edit has to look for the oldest entry.
void History::trim() {
    if (bytes() <= limit_) return;
    const std::size_t limit = max_edit_bytes();
    const auto forgotten = [this](const Transaction& transaction) { forget(transaction); };
    lists_.undone.trim(limit, forgotten);
    lists_.done.trim(limit - lists_.undone.bytes(), forgotten);
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
    EditMoment moment = observer_ != nullptr ? observer_->moment() : EditMoment{};
    observed_bytes_ += moment.bytes;
    return std::make_shared<const Image>(
        Image{structure_.changes.lifetime.mark, lists_, std::move(moment.state)});
}

bool History::owns(const Memory& image) const {
    return image != nullptr &&
           structure_.changes.lifetime.is_marked_by(static_cast<const Image*>(image.get())->of);
}

// The image of the nodes contains the slots that are reserved for undo.
void History::restore(const Memory& image) {
    unresolved_.clear();
    const Image* const known = owns(image) ? static_cast<const Image*>(image.get()) : nullptr;
    lists_ = known != nullptr ? known->lists : Lists{};
    if (observer_ != nullptr) observer_->went_to(known != nullptr ? known->observed : Memory{});
    bytes_.reset();
    // An edit that is open now continues after the restore.
    open_.steps.clear();
    open_.too_large = false;
    open_bytes_ = 0;
    written_.clear();
    references_.clear();
    has_references_ = false;
    ++version_;
}

void History::free_unclaimed() {
    Nodes& nodes = nodes_;
    if (!nodes.keeps_any()) return;
    std::vector<bool> claimed(nodes.end());
    const auto claim = [&](const Transaction& transaction) {
        for (const EditStep& step : transaction.steps)
            if (const auto* existence = std::get_if<ExistenceEdit>(&step))
                for (const DeletedInstance& deleted : existence->deleted)
                    if (nodes.keeps(deleted.handle)) claimed[deleted.handle.index] = true;
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
    std::reverse(all.begin(), all.end());  // the entry that was undone first was done last
    list(lists_.done, false);
    return all;
}

}  // namespace fettle::property
