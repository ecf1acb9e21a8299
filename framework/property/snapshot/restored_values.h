#pragma once
// What bytes say of a tree, as values that could have been written to it: bytes may come from a
// stranger who knows how a checksum is made, or from a game whose classes were others.

#include <optional>

#include <fettle/property/bytes.h>
#include <fettle/property/tree.h>

#include <instances/nodes.h>

namespace fettle::property {

class RestoredValues {
  public:
    /// `nodes`: who is about to be there. All of them must outlive it.
    RestoredValues(const Tree& tree, const Nodes& nodes, const ByteReader& from)
        : tree_(tree), nodes_(nodes), from_(from) {}

    /// The value as the property would have it after a write; nothing: it cannot be written.
    /// References may lead to who is gone; Error(damaged) when they lead to who was not yet there.
    std::optional<Value> fitted(const Property& property, const Value& value) const;
    /// Throws Error(damaged) unless it could be the value of a property that somebody added.
    void check_ad_hoc(const Value& value) const;

  private:
    std::optional<Value> coerced(const Property& property, const Value& value) const;
    bool of_its_class(const Property& property, const Value& value) const;
    [[noreturn]] void nobody(const Property& property) const;

    const Tree& tree_;
    const Nodes& nodes_;
    const ByteReader& from_;
};

}  // namespace fettle::property
