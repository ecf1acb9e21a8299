#pragma once
// Begin events that were not delivered because an instance in them was deleted first. Their end
// events are not delivered either, so that a script that counts begins and ends stays correct.

#include <vector>

#include <fettle/property/change.h>

namespace fettle::property {

class Tree;

/// Whether a value is a deleted instance or a list with one.
bool names_deleted(const Tree& tree, const Value& value);

class UndeliveredBegins {
  public:
    void note(const Tree& tree, const Occurrence& beginning);
    /// Whether `end` is the end of an event in this list. If so, that event is removed from it.
    bool take(const Occurrence& end);
    void clear() { list_.clear(); }

  private:
    struct Undelivered {
        Handle instance;
        const Event* event;
        std::vector<Value> names;  // values of the fields that the end event has as well
    };
    std::vector<Undelivered> list_;
};

}  // namespace fettle::property
