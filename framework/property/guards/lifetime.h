#pragma once
// Lifetime of a tree: callbacks that may destroy it, and callbacks that must not.

#include <memory>
#include <utility>

#include <fettle/property/tree.h>

namespace fettle::property {

struct Lifetime {
    explicit Lifetime(const Tree& tree) : mark(std::make_shared<const Tree*>(&tree)) {}

    std::shared_ptr<const Tree*> mark;  // null from the beginning of the destruction on
    bool ending = false;                // the tree is being destroyed
    const char* pinned = nullptr;       // running callback that must not destroy the tree
    int uses = 0;                       // nested calls that run handlers or methods
    std::shared_ptr<void> rest;         // state of the destroyed tree, held until these calls end

    /// Throws if the tree must not be destroyed. In the destructor of the tree this ends the
    /// program.
    void require_unpinned() const;
    /// Throws Error(deleted) while the tree is being destroyed. `what`: "be observed".
    void require_going_on(const char* what) const;
    /// Whether `other` is the mark of this tree, whose destruction has not begun.
    bool is_marked_by(const std::weak_ptr<const Tree*>& other) const {
        return mark != nullptr && other.lock() == mark;
    }
};

/// While it lives, a callback may destroy the tree; the tree's state is kept until the end of it.
class Use {
  public:
    explicit Use(Lifetime& lifetime) : lifetime_(lifetime) { ++lifetime_.uses; }
    ~Use() {
        if (--lifetime_.uses == 0) const std::shared_ptr<void> dead = std::move(lifetime_.rest);
    }
    Use(const Use&) = delete;
    /// Called at the end: throws Error(deleted) if the tree was destroyed.
    void finish() const;

  private:
    Lifetime& lifetime_;
};

/// While it lives, callbacks must not destroy the tree. If one does, the program ends with a
/// message that names `what`, "a lifecycle function" for example.
class Pin {
  public:
    Pin(Lifetime& lifetime, const char* what)
        : lifetime_(lifetime), outer_(std::exchange(lifetime.pinned, what)) {}
    ~Pin() { lifetime_.pinned = outer_; }
    Pin(const Pin&) = delete;

  private:
    Lifetime& lifetime_;
    const char* outer_;
};

}  // namespace fettle::property
