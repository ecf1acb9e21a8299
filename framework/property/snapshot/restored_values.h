#pragma once
// Validation of values from bytes. The bytes may be forged with a correct checksum, or come from a
// game whose classes were different.

#include <optional>

#include <fettle/property/bytes.h>
#include <fettle/property/tree.h>

#include <instances/nodes.h>

namespace fettle::property {

class RestoredValues {
  public:
    /// `nodes`: the nodes of the snapshot. All arguments must outlive this object.
    RestoredValues(const Tree& tree, const Nodes& nodes, const ByteReader& from)
        : tree_(tree), nodes_(nodes), from_(from) {}

    /// The value that a write to the property would store; nullopt if the property refuses it.
    /// References may lead to deleted instances; Error(damaged) if they lead to instances that
    /// never existed.
    std::optional<Value> fitted(const Property& property, const Value& value) const;
    /// Throws Error(damaged) unless an ad-hoc property can have the value.
    void check_ad_hoc(const Value& value) const;

  private:
    std::optional<Value> coerced(const Property& property, const Value& value) const;
    bool of_its_class(const Property& property, const Value& value) const;
    [[noreturn]] void refuse_reference(const Property& property) const;

    const Tree& tree_;
    const Nodes& nodes_;
    const ByteReader& from_;
};

}  // namespace fettle::property
