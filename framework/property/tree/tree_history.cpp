// Public functions of the history.

#include <fettle/property/earlier_writer.h>
#include <fettle/property/located_writes.h>

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

Provenance Tree::last_writer(Handle instance, const Property& property) const {
    state_->instances.require(instance, property);
    if (const auto step = state_->changes.shadows.simulated_at({instance.index, property.symbol}))
        return {.known = true, .cause = {.writer = Writer::simulation, .where = {}, .step = step}};
    state_->changes.report_plain_writes();
    const WritesLog& writes = state_->changes.writes;
    Provenance written = writes.find(instance, property.symbol, step());
    // Until it is set, its owner takes it from elsewhere, and no step writes it.
    const bool unset = property.binding.reset != nullptr &&
                       property.binding.overridden != nullptr && !overridden(instance, property);
    if (!property.simulated || !property.derives_from.empty() || unset) return written;
    if (written.known) {
        // Later steps may have changed the value, which nothing reports. The step that follows the
        // write still shows the written value, so a break at it names the writer.
        const Value left = writes.left_by(instance, property.symbol, written.cause);
        if (left.is_nil() || written.cause.step + 1 >= step() || peek(instance, property) == left)
            return written;
    }
    return {.known = true, .cause = {.writer = Writer::simulation, .where = {}, .step = step()}};
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
