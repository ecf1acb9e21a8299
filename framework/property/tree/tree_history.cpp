// Public functions of the history.

#include <fettle/property/earlier_writer.h>
#include <fettle/property/located_writes.h>

#include <span>
#include <unordered_set>
#include <vector>

#include "state.h"

namespace fettle::property {

void Tree::observe_edits(EditObserver* observer) {
    if (observer != nullptr) state_->lifetime.require_going_on("be observed");
    state_->history.observe(observer);
}

void Tree::begin_edit(std::string name, bool scripts) {
    state_->require_changeable("begin an edit");
    state_->changes.notify([&](Observer& o) { o.edit_begins(name, scripts); });
    state_->history.begin(std::move(name), scripts);
}
void Tree::end_edit() {
    state_->require_changeable("end an edit");
    state_->history.end();
    state_->changes.notify([](Observer& o) { o.edit_ends(); });
}
UndoResult Tree::undo() {
    state_->require_changeable("undo");
    state_->underway.require_no_deletion("undo");
    state_->underway.require_all_rows("undo");
    return state_->history.undo();
}
UndoResult Tree::redo() {
    state_->require_changeable("redo");
    state_->underway.require_no_deletion("redo");
    state_->underway.require_all_rows("redo");
    return state_->history.redo();
}
std::vector<HistoryEntry> Tree::history() const {
    return state_->history.entries();
}
std::size_t Tree::history_bytes() const {
    return state_->history.bytes();
}
std::size_t Tree::history_bytes_ever() const {
    return state_->history.bytes_ever();
}
void Tree::set_history_limit(std::size_t bytes) {
    state_->require_changeable("limit the history");
    state_->history.set_limit(bytes);
}

void Tree::locate_writes(bool on) {
    state_->changes.writes.close(WritesLog::Reason::located, on);
}

LocatedWrites::LocatedWrites(Tree& tree)
    : tree_(tree), before_(tree.state().changes.writes.closed_for(WritesLog::Reason::located)) {
    tree_.locate_writes(true);
}
LocatedWrites::~LocatedWrites() {
    tree_.locate_writes(before_);
}

void Tree::forget_writers_after(std::uint64_t step) {
    state_->changes.report_plain_writes();
    state_->changes.writes.forget_after(step);
}

namespace {

/// Whether the simulation may have changed a value that was written last by `written`. It reports
/// no writes.
bool simulated_since(const Tree& tree, const Tree::State& state, Handle instance,
                     const Property& property, const Provenance& written) {
    // Until it is set, its owner takes it from elsewhere, and no step writes it.
    const bool unset = property.binding.reset != nullptr &&
                       property.binding.overridden != nullptr &&
                       !tree.overridden(instance, property);
    if (!property.simulated || !property.derives_from.empty() || unset) return false;
    if (!written.known) return true;
    // The step that follows the write still shows the written value, so a break at it names the
    // writer.
    const Value left = state.changes.writes.left_by(instance, property.symbol, written.cause);
    return !(left.is_nil() || written.cause.step + 1 >= tree.step() ||
             tree.peek(instance, property) == left);
}

/// The property of an instance with that symbol; null if it has none that a person may set.
const Property* settable(const Tree& tree, Handle instance, std::uint32_t symbol) {
    const auto with_symbol = [&](std::span<const Property* const> all) -> const Property* {
        for (const Property* each : all)
            if (each->symbol.id() == symbol) return each;
        return nullptr;
    };
    const Property* found = with_symbol(tree.class_of(instance).properties());
    if (found == nullptr) found = with_symbol(tree.ad_hoc(instance));
    return found == nullptr || found->read_only || found->transient ? nullptr : found;
}

}  // namespace

std::unordered_map<std::uint64_t, Provenance> latest_writes(const Tree& tree) {
    // A write of the log is looked at only until its instance has one.
    Tree::State& state = const_cast<Tree&>(tree).state();  // as in Tree::last_writer
    state.changes.report_plain_writes();
    std::unordered_map<std::uint64_t, Provenance> latest;
    std::unordered_map<std::uint64_t, std::uint64_t> numbers;   // of the writes in `latest`
    std::unordered_set<std::uint64_t> rejected;                 // cells
    std::unordered_map<std::uint64_t, std::uint64_t> restored;  // instances, by cell
    std::vector<std::uint32_t> decided;  // by index of an instance: its generation plus one
    state.changes.writes.each_backwards(tree.step(), [&](const WritesLog::Entry& entry) {
        const std::uint32_t index = entry.instance.index;
        const std::uint64_t cell = std::uint64_t{index} << 32 | entry.property;
        if (index >= decided.size()) decided.resize(index + 1);
        const bool is_decided = decided[index] == entry.instance.generation + 1;
        const bool in_full = !entry.cause.where.empty();
        if (is_decided && restored.empty() && !in_full) return;
        if (!entry.later && !restored.empty()) restored.erase(cell);
        const std::uint64_t key = entry.instance.key();
        if (is_decided && !(in_full && entry.number >= numbers[key])) return;
        if (rejected.contains(cell) || !tree.alive(entry.instance)) return;
        const Property* const property = settable(tree, entry.instance, entry.property);
        if (property == nullptr) {
            rejected.insert(cell);
            return;
        }
        if (entry.later) {
            restored.try_emplace(cell, key);
            return;
        }
        const Provenance written{.known = true, .cause = entry.cause};
        const bool simulated = entry.cause.writer == Writer::simulation ||
                               state.changes.shadows.simulated_at({index, property->symbol}) != 0 ||
                               simulated_since(tree, state, entry.instance, *property, written);
        if (simulated) {
            rejected.insert(cell);
            return;
        }
        latest[key] = written;
        numbers[key] = entry.number;
        decided[index] = entry.instance.generation + 1;
    });
    for (const auto& [cell, key] : restored) {
        Provenance& its = latest[key];
        const std::uint64_t step = state.changes.writes.arrival_step();
        if (!its.known || its.cause.step <= step)
            its = {.known = true, .cause = {.writer = Writer::restore, .where = {}, .step = step}};
    }
    return latest;
}

Provenance Tree::last_writer(Handle instance, const Property& property) const {
    state_->instances.require(instance, property);
    if (const auto step = state_->changes.shadows.simulated_at({instance.index, property.symbol}))
        return {.known = true, .cause = {.writer = Writer::simulation, .where = {}, .step = step}};
    state_->changes.report_plain_writes();
    const WritesLog& writes = state_->changes.writes;
    Provenance written = writes.find(instance, property.symbol, step());
    if (!simulated_since(*this, *state_, instance, property, written)) return written;
    return {.known = true, .cause = {.writer = Writer::simulation, .where = {}, .step = step()}};
}

std::string last_writer_text(const Tree& tree, Handle instance, const Property& property) {
    const Provenance written = tree.last_writer(instance, property);
    if (!written.known) return {};
    const Cause& cause = written.cause;
    const bool by_code = cause.writer == Writer::script || cause.writer == Writer::module ||
                         cause.writer == Writer::load;
    const bool may_move = property.simulated && property.derives_from.empty();
    if (!by_code || !may_move || cause.step + 1 >= tree.step()) return cause.text();
    return cause.text() + "; later steps may have changed it";
}

Provenance last_writer_until(Tree& tree, Handle instance, const Property& property,
                             std::uint64_t step) {
    Tree::State& state = tree.state();
    state.instances.require(instance, property);
    state.changes.report_plain_writes();
    return state.changes.writes.find(instance, property.symbol, step);
}

std::size_t edits_without_undo(const Tree& tree) {
    return tree.state().history.edits_without_undo();
}

}  // namespace fettle::property
