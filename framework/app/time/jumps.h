#pragma once
// Restored snapshots: those of the timeline itself, and jumps of other code.

#include <memory>

#include <fettle/app/timeline.h>
#include <fettle/property/observer.h>

namespace fettle::app {

/// Detects that other code restores a snapshot, that is, that time jumps.
class Timeline::Jumps : public property::Observer {
  public:
    explicit Jumps(property::Tree& tree) : tree_(tree), tree_life_(tree.lifetime()) {
        tree_.observe(*this);
    }
    ~Jumps() override {
        if (!tree_life_.expired()) tree_.unobserve(*this);
    }
    void restored() override {
        jumped = !travelling;
        arrived = true;
    }
    void wrote_plain(const property::PlainWrites&) override {
        // Overrides a slow default: single writes are not needed here.
    }

    bool jumped = false;      // other code has restored a snapshot
    bool travelling = false;  // the timeline itself is restoring one
    bool arrived = false;     // a snapshot was restored since `travelling` was set

  private:
    property::Tree& tree_;
    std::weak_ptr<const property::Tree*> tree_life_;
};

/// While it lives, restoring a snapshot is not a jump of other code.
class Timeline::Travelling {
  public:
    explicit Travelling(Jumps& jumps) : jumps_(jumps) {
        jumps_.travelling = true;
        jumps_.arrived = false;
    }
    ~Travelling() { jumps_.travelling = false; }
    Travelling(const Travelling&) = delete;

  private:
    Jumps& jumps_;
};

}  // namespace fettle::app
