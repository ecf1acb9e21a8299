#pragma once
// Whether what bytes say of a tree is such as could have been written to it: bytes may come from a
// stranger who knows how a checksum is made.

#include <fettle/property/bytes.h>
#include <fettle/property/tree.h>

#include "nodes.h"

namespace fettle::property {

class RestoredValues {
  public:
    /// `nodes`: who is about to be there. All of them must outlive it.
    RestoredValues(const Tree& tree, const Nodes& nodes, const ByteReader& from)
        : tree_(tree), nodes_(nodes), from_(from) {}

    /// Throws Error(damaged) unless a write of that property would take the value and leave it as
    /// it is. References may lead to who is gone, never to who was not yet there.
    void check(const Property& property, const Value& value) const;
    /// The same of a property that somebody added.
    void check_ad_hoc(const Value& value) const;

  private:
    void check_references(const Property& property, const Value& value) const;
    bool is_or_was(Handle handle, const Class* wanted) const;

    const Tree& tree_;
    const Nodes& nodes_;
    const ByteReader& from_;
};

}  // namespace fettle::property
