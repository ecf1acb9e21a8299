#include <fettle/property/acceptance.h>

#include <utility>

namespace fettle::property {
namespace {

thread_local const Acceptance* in_force = nullptr;

}  // namespace

Acceptance::Acceptance(std::function<bool(Handle)> accepts)
    : accepts_(std::move(accepts)), before_(std::exchange(in_force, this)) {}

Acceptance::~Acceptance() {
    in_force = before_;
}

bool Acceptance::accepts(Handle instance) {
    return in_force == nullptr || in_force->accepts_(instance);
}

}  // namespace fettle::property
