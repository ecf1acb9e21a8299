#pragma once
// Looks: colors of shapes, which the physics library does not have. A list by slot for each world,
// empty until a shape gets a look other than the default.

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include <fettle/physics/types.h>
#include <fettle/property/value.h>

namespace fettle::physics_module {

struct Look {
    std::optional<property::Color> fill;    // empty: the color of the body, or of its type
    std::optional<property::Color> border;  // empty: a darker fill
    bool visible = true;
    bool orientation_mark = false;  // a line from the middle of a circle or an ellipse to its rim
};

/// Values of type T by slot; slots that were never written hold T{} and take no memory.
template <class T>
class SlotValues {
  public:
    T get(std::uint32_t slot) const { return slot < values_.size() ? values_[slot] : T{}; }
    void set(std::uint32_t slot, const T& value) {
        if (slot >= values_.size()) values_.resize(slot + 1);
        values_[slot] = value;
    }
    /// Resets the slot: another object will use it.
    void reset(std::uint32_t slot) {
        if (slot < values_.size()) values_[slot] = T{};
    }
    /// Removes and returns the value of the slot, for an object that moves to another world.
    T take(std::uint32_t slot) {
        const T value = get(slot);
        reset(slot);
        return value;
    }
    bool empty() const { return values_.empty(); }
    const std::vector<T>& all() const { return values_; }
    void replace(std::vector<T> values) { values_ = std::move(values); }

  private:
    std::vector<T> values_;
};

/// Default color of a body's shapes.
property::Color default_fill(physics::BodyType type);
/// Default border of a figure that is filled with that color.
property::Color default_border(property::Color fill);

}  // namespace fettle::physics_module
