#pragma once
// Looks: what the physics library does not know of its shapes. Kept by the slots of one world, and
// only from the first shape on that does not look as it would by itself.

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include <fettle/physics/types.h>
#include <fettle/property/value.h>

namespace fettle::physics_module {

struct Look {
    std::optional<property::Color> fill;    // none: the body's, or by the type of the body
    std::optional<property::Color> border;  // none: a darker fill
    bool visible = true;
};

/// Values of type T by slot; slots that nobody wrote hold T{} and take no memory.
template <class T>
class SlotValues {
  public:
    T get(std::uint32_t slot) const { return slot < values_.size() ? values_[slot] : T{}; }
    void set(std::uint32_t slot, const T& value) {
        if (slot >= values_.size()) values_.resize(slot + 1);
        values_[slot] = value;
    }
    /// The slot is somebody else's soon.
    void forget(std::uint32_t slot) {
        if (slot < values_.size()) values_[slot] = T{};
    }
    /// What the slot held, for who moves elsewhere.
    T take(std::uint32_t slot) {
        const T value = get(slot);
        forget(slot);
        return value;
    }
    bool empty() const { return values_.empty(); }
    const std::vector<T>& all() const { return values_; }
    void replace(std::vector<T> values) { values_ = std::move(values); }

  private:
    std::vector<T> values_;
};

/// The color of a body's shapes when nobody gives one.
property::Color default_fill(physics::BodyType type);
/// The border of a figure filled with that color when nobody gives one.
property::Color default_border(property::Color fill);

}  // namespace fettle::physics_module
