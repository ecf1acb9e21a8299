#pragma once
// Reading many values of one instance: the instance is looked up once.

#include <cstdint>

#include <fettle/property/tree.h>

FETTLE_PROPERTY_BEGIN

namespace fettle::property {

/// Reads as `Tree::peek` does: a value whose formula fails is its last valid value, and nothing
/// becomes a dependency of a formula. Made for functions that draw. Invalid once the instance is
/// deleted, its class is redefined, or a snapshot is restored.
class StoredValues {
  public:
    /// Throws Error(deleted).
    StoredValues(const Tree& tree, Handle instance);
    double number(const Property& property) const;
    std::int64_t integer(const Property& property) const;
    Vec2 vec2(const Property& property) const;
    bool boolean(const Property& property) const;
    Color color(const Property& property) const;
    Value peek(const Property& property) const { return tree_.peek(instance_, property); }
    /// In place, valid until the next edit. Only for what the tree stores itself: texts, lists,
    /// references, and values that may be nil. Throws std::logic_error for any other property.
    const Value& value(const Property& property) const;

  private:
    /// Null if the tree does not store the property as a `T`.
    template <class T>
    const T* find(const Property& property) const;

    const Tree& tree_;
    Handle instance_;
    const StoredColumns* columns_;  // null if the class stores no values in the tree
    std::uint32_t row_;
};

}  // namespace fettle::property

FETTLE_PROPERTY_END
