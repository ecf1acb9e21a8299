// Calls of the functions that accept or reject instances in a search.

#include <fettle/property/acceptance.h>

#include <utility>

#include <fettle/property/question.h>

#include <tree/state.h>

namespace fettle::property {
namespace {

thread_local Acceptance* in_force = nullptr;

constexpr std::string_view acceptance_rule =
    "calls `accept` in the middle of a search; `accept` cannot";

std::function<bool(Handle)> required(std::function<bool(Handle)> accepts) {
    if (!accepts) throw Error(ErrorKind::wrong_type, "Acceptance: `accepts` needs a function");
    return accepts;
}

}  // namespace

Acceptance::Acceptance(Tree& tree, std::string method, std::function<bool(Handle)> accepts)
    : tree_(tree),
      method_(std::move(method)),
      accepts_(required(std::move(accepts))),
      outer_(std::exchange(in_force, this)) {
    // During the search, formulas keep the values that they have now.
    Tree::State& s = tree.state();
    if (s.underway.inquiry == nullptr && !s.instances.reads.noted() && !s.changes.replaying)
        s.formulas.settle_all(false);
}

Acceptance::~Acceptance() {
    in_force = outer_;
}

bool Acceptance::is_accepted(Handle instance) noexcept {
    if (in_force == nullptr) return true;
    Acceptance& asked = *in_force;
    try {
        asked.answers_.push_back(0);
        if (asked.thrown_) return false;
        const Inquiry inquiry(asked.tree_, asked.method_, acceptance_rule);
        const bool accepted = asked.accepts_(instance);
        asked.answers_.back() = accepted;
        return accepted;
    } catch (...) {
        asked.thrown_ = std::current_exception();
        return false;
    }
}

std::vector<std::uint8_t> Acceptance::answers() {
    return in_force != nullptr ? in_force->answers_ : std::vector<std::uint8_t>();
}

void Acceptance::finish() const {
    if (thrown_) std::rethrow_exception(thrown_);
}

}  // namespace fettle::property
