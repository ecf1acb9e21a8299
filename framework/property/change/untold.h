#pragma once
// Beginnings that nobody was told of, because what they name was deleted before their turn came:
// their ends are not told either, so that who counts what it touches does not count wrong.

#include <vector>

#include <fettle/property/change.h>

namespace fettle::property {

class Tree;

/// Whether a value is an instance, or a list with an instance, that was deleted.
bool names_deleted(const Tree& tree, const Value& value);

class UntoldBeginnings {
  public:
    void note(const Tree& tree, const Occurrence& beginning);
    /// Whether an end is that of one of them, which is over with it.
    bool take(const Occurrence& end);
    void clear() { list_.clear(); }

  private:
    struct Untold {
        Handle instance;
        const Event* event;
        std::vector<Value> names;  // of the fields that the end has too
    };
    std::vector<Untold> list_;
};

}  // namespace fettle::property
