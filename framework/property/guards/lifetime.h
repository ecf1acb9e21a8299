#pragma once
// How long a tree lives: what it calls may destroy it, or must not.

#include <memory>
#include <utility>

#include <fettle/property/tree.h>

namespace fettle::property {

struct Lifetime {
    explicit Lifetime(const Tree& tree) : mark(std::make_shared<const Tree*>(&tree)) {}

    std::shared_ptr<const Tree*> mark;  // null from the beginning of the destruction on
    bool ending = false;                // the tree is being destroyed
    const char* pinned = nullptr;       // what is called and must not destroy the tree, if anything
    int uses = 0;                       // calls that call handlers or methods
    std::shared_ptr<void> rest;         // what one of those calls has left of the tree

    /// Throws where the tree must not be destroyed; from its destructor, which ends the program.
    void require_unpinned() const;
};

/// While it lives, what is called may destroy the tree: its state lives on as long.
class Use {
  public:
    explicit Use(Lifetime& lifetime) : lifetime_(lifetime) { ++lifetime_.uses; }
    ~Use() {
        if (--lifetime_.uses == 0) const std::shared_ptr<void> dead = std::move(lifetime_.rest);
    }
    Use(const Use&) = delete;
    /// At the end: throws Error(deleted) if that happened.
    void finish() const;

  private:
    Lifetime& lifetime_;
};

/// While it lives, what is called must not destroy the tree: when it does so nevertheless, the
/// program is ended with a message that names `what`: "a lifecycle function".
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
