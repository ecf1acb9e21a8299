#pragma once
// The stored properties by which the instances of one class have their places.

#include <cstdint>
#include <vector>

#include <fettle/property/between_steps.h>
#include <fettle/property/class.h>

namespace fettle::property {

class StoredColumns;

class Places {
  public:
    /// To be called again when the class has changed.
    void look_up(const Class& of);
    /// Whether the tree stores a position for each instance of the class.
    bool any() const { return position_ != nullptr; }
    /// Whether it stores an angle or a scale, too.
    bool has_angle() const { return angle_ != nullptr; }
    bool has_scale() const { return scale_ != nullptr; }
    /// Whether it stores a list of vec2s with the name `points`.
    bool has_points() const { return points_ != nullptr; }
    /// Where it is drawn: see `Track`.
    Placement drawn(const StoredColumns& columns, std::uint32_t row, double alpha,
                    double far) const;
    /// The property `points` as it is drawn.
    Value drawn_points(const StoredColumns& columns, std::uint32_t row, double alpha,
                       double far) const;
    /// Only if there are `any`.
    void note_step_begins(const StoredColumns& columns);
    void note_step_ended(const StoredColumns& columns);
    void forget(std::uint32_t row) {
        if (row < tracks_.size()) tracks_[row].forget();
        if (row < points_before_.size()) points_before_[row] = {};
    }

  private:
    class Reader;

    // Null if the class does not store it in this type.
    const Property *position_ = nullptr, *angle_ = nullptr, *scale_ = nullptr, *visible_ = nullptr,
                   *points_ = nullptr;
    // By row; empty while no step was noted.
    std::vector<Track> tracks_;
    std::vector<Value> points_before_, points_after_;  // nil: not known
};

}  // namespace fettle::property
