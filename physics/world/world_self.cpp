#include <fettle/physics/locked.h>
#include <world/world_data.h>

#include <memory>
#include <string>
#include <utility>

// User functions run in the middle of library functions. Forbidden calls are refused here, and if a
// user function throws or destroys the world, the world's data stay valid.

namespace fettle::physics::detail {

WorldObserver::~WorldObserver() = default;

WorldSelf::WorldSelf() = default;

WorldSelf::~WorldSelf() {
    if (link != nullptr) release_link(*link);
}

void WorldSelf::refuse_edit(const char* of, const char* function) const {
    throw Locked(std::string(of) + "::" + function + " is not allowed inside " + operation() +
                 ": it may only read the world that calls it. Note what is to be changed, and "
                 "change it when that call has returned");
}

void WorldSelf::refuse_or_report(const char* of, const char* function) const {
    may_read();
    if (locked()) refuse_edit(of, function);
    observer_->edit_called(of, function);
}

void WorldSelf::set_observer(std::unique_ptr<WorldObserver> observer) {
    // The old one is destroyed with the argument, after this call: its sink may hold or use the
    // world.
    std::swap(observer_, observer);
    if (observer_ != nullptr)
        work_.fetch_or(watched, std::memory_order_relaxed);
    else
        work_.fetch_and(~watched, std::memory_order_relaxed);
}

void WorldSelf::refuse_non_owner(const char* of, const char* function) const {
    throw Locked(std::string(of) + "::" + function + ": " + owner->advice());
}

void WorldSelf::refuse_copy(const char* what) const {
    throw Locked(std::string(what) + " is not allowed inside " + operation() +
                 ": the state of the world is incomplete there. Do it when that call has returned");
}

void WorldSelf::keep_alive(Owned<WorldData> data) {
    destroyed_inside_ = operation();
    orphan_ = std::move(data);
}

void WorldSelf::throw_orphaned() const {
    throw Locked(std::string("the world was destroyed inside ") + destroyed_inside_ +
                 ": a world has to outlive the call that calls back");
}

WorldLock::WorldLock(const WorldSelf& self, During during, const char* inside)
    : self_(&self),
      weight_(during == During::query ? 1 : WorldSelf::middle),
      outer_(self.enter(inside)) {
    self.work_.fetch_add(weight_, std::memory_order_relaxed);
}

WorldLock::~WorldLock() {
    unlock();
}

void WorldLock::unlock() {
    if (self_ == nullptr) return;
    const WorldSelf& self = *std::exchange(self_, nullptr);
    self.set_operation(outer_);
    const uint32_t before = self.work_.fetch_sub(weight_, std::memory_order_acq_rel);
    if ((before & ~WorldSelf::marks) != weight_) return;
    if (!self.orphaned()) {
        if (self.owner != nullptr) self.owner->notify_unlocked();
        return;
    }
    // The World is destroyed, and this was the last use of its data.
    const Owned<WorldData> dead = std::move(self.orphan_);
}

void WorldLock::finish() {
    const WorldSelf& self = *self_;
    std::exception_ptr thrown;
    if (weight_ == WorldSelf::middle) thrown = std::exchange(self.thrown_, nullptr);
    if (!thrown && self.orphaned()) self.throw_orphaned();
    unlock();  // functions of `after_step` run after an exception, too, and may edit
    if (thrown) std::rethrow_exception(thrown);
}

}  // namespace fettle::physics::detail
