#include <fettle/property/acceptance.h>

#include <utility>

#include "state.h"

namespace fettle::property {
namespace {

thread_local const Acceptance* in_force = nullptr;

}  // namespace

Acceptance::Acceptance(Tree& tree, std::string asker, std::function<bool(Handle)> accepts)
    : tree_(tree), asker_(std::move(asker)), accepts_(std::move(accepts)), before_(in_force) {
    put_in_force(this);
}

Acceptance::~Acceptance() {
    put_in_force(before_);
}

void Acceptance::put_in_force(const Acceptance* which) {
    in_force = which;
    tree_.state().note_listeners();
}

bool Acceptance::accepts(Handle instance) {
    return in_force == nullptr || in_force->accepts_(instance);
}

const Acceptance* Acceptance::current() {
    return in_force;
}

}  // namespace fettle::property
