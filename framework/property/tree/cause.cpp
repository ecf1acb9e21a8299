// The cause of a write: its writer, place and step.

#include "state.h"

namespace fettle::property {

std::uint64_t Tree::step() const {
    return state_->changes.author.step;
}

void Tree::set_step(std::uint64_t step) {
    state_->require_changeable("set the step");
    state_->changes.report_plain_writes();
    if (!state_->changes.replaying) state_->changes.writes.begin_step(step);
    state_->changes.author.step = step;
    ++state_->changes.invalidations;  // the property of the clock changes without a report
}

void Tree::stepped() {
    state_->changes.stepped = true;
    ++state_->changes.invalidations;
}

namespace {

void set_author(Tree::State& s, Writer writer, std::function<std::string()>* locate) {
    s.changes.report_plain_writes();
    s.changes.author.writer = writer;
    s.changes.author.locate = locate;
    s.history.note_recording();
}

}  // namespace

Tree::CauseScope::CauseScope(Tree& tree, Writer writer, std::function<std::string()>* locate)
    : tree_(tree),
      writer_(tree.state().changes.author.writer),
      locate_(tree.state().changes.author.locate) {
    set_author(tree.state(), writer, locate);
}

Tree::CauseScope::~CauseScope() {
    set_author(tree_.state(), writer_, locate_);
}

Cause Tree::cause() const {
    return state_->changes.author.cause();
}

}  // namespace fettle::property
