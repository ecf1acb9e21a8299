// The cause of a write: which writer, at which place, in which step.

#include <fettle/property/tree.h>

#include "state.h"

namespace fettle::property {

std::string_view writer_name(Writer writer) {
    switch (writer) {
        case Writer::module:
            return "module";
        case Writer::simulation:
            return "simulation";
        case Writer::script:
            return "script";
        case Writer::console:
            return "console";
        case Writer::inspector:
            return "inspector";
        case Writer::formula:
            return "formula";
        case Writer::undo:
            return "undo";
        case Writer::load:
            return "load";
        case Writer::remote:
            return "remote";
        case Writer::restore:
            return "restore";
    }
    return "?";
}

std::string Cause::text() const {
    return (where.empty() ? std::string(writer_name(writer)) : where) + ", step " +
           std::to_string(step);
}

std::uint64_t Tree::step() const {
    return state_->step;
}

void Tree::set_step(std::uint64_t step) {
    state_->require_changeable("set the step");
    state_->tell_plain_writes();
    state_->step = step;
    ++state_->upheavals;  // the clock, too, is written without telling
}

void Tree::stepped() {
    state_->stepped = true;
    ++state_->upheavals;
}

Tree::CauseScope::CauseScope(Tree& tree, Writer writer, std::function<std::string()>* locate)
    : tree_(tree), writer_(tree.state_->writer), locate_(tree.state_->locate) {
    tree.state_->tell_plain_writes();
    tree.state_->writer = writer;
    tree.state_->locate = locate;
    tree.state_->note_recording();
}

Tree::CauseScope::~CauseScope() {
    tree_.state_->tell_plain_writes();
    tree_.state_->writer = writer_;
    tree_.state_->locate = locate_;
    tree_.state_->note_recording();
}

Cause Tree::cause() const {
    const State& s = *state_;
    return {.writer = s.writer, .where = s.place(), .step = s.step};
}

/// Whose edit it is, should the barrier find that it changed something else. Its place costs more
/// than a callback of a game may pay, so it is looked up only while something is watched that an
/// edit elsewhere changes.
void Tree::State::note_edit() {
    edited = true;
    ++upheavals;
    if (shadows.empty()) return;
    last_edit.writer = writer;
    last_edit.step = step;
    last_edit.where.clear();
    if (shadows.any_derived() || history.recording(writer)) last_edit.where = place();
}

std::string Tree::State::place() const {
    if (locate == nullptr) return {};
    try {
        return (*locate)();
    } catch (...) {  // the write itself is good
        return {};
    }
}

}  // namespace fettle::property
