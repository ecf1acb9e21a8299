#include "places.h"

#include "stored_columns.h"

namespace fettle::property {

namespace {

const Property* stored(const Class& of, Symbol name, Type type) {
    const Property* const found = of.property(name);
    const bool fits = found != nullptr && found->binding.kind == BindingKind::stored &&
                      found->type == type && !found->nullable && !found->any_type && !found->sparse;
    return fits ? found : nullptr;
}

}  // namespace

void Places::look_up(const Class& of) {
    static const Symbol position("position"), angle("angle"), scale("scale"), visible("visible"),
        points("points");
    position_ = stored(of, position, Type::vec2);
    angle_ = stored(of, angle, Type::number);
    scale_ = stored(of, scale, Type::number);
    visible_ = stored(of, visible, Type::boolean);
    points_ = stored(of, points, Type::list);
    if (points_ != nullptr && points_->element != Type::vec2) points_ = nullptr;
}

Placement Places::now(const StoredColumns& columns, std::uint32_t row) const {
    Placement now{.position = *columns.find<Vec2>(*position_, row)};
    if (angle_ != nullptr) now.angle = *columns.find<double>(*angle_, row);
    if (scale_ != nullptr) now.scale = *columns.find<double>(*scale_, row);
    return now;
}

Placement Places::drawn(const StoredColumns& columns, std::uint32_t row, double alpha,
                        double far) const {
    const Placement at = now(columns, row);
    return alpha < 1 && row < tracks_.size() ? tracks_[row].drawn(at, alpha, far) : at;
}

bool Places::seen(const StoredColumns& columns, std::uint32_t row) const {
    return visible_ == nullptr || *columns.find<std::uint8_t>(*visible_, row) != 0;
}

void Places::note_step_begins(const StoredColumns& columns) {
    if (!any()) return;
    tracks_.resize(columns.rows());
    for (std::uint32_t row = 0; row < tracks_.size(); ++row)
        tracks_[row].step_begins(now(columns, row), seen(columns, row));
    if (points_ == nullptr) return;
    points_before_.resize(columns.rows());
    for (std::uint32_t row = 0; row < points_before_.size(); ++row)
        points_before_[row] = seen(columns, row) ? *columns.find<Value>(*points_, row) : Value();
}

void Places::note_step_ended(const StoredColumns& columns) {
    for (std::uint32_t row = 0; row < tracks_.size(); ++row)
        tracks_[row].step_ended(now(columns, row));
    if (points_ == nullptr) return;
    points_after_.resize(points_before_.size());
    for (std::uint32_t row = 0; row < points_after_.size(); ++row)
        points_after_[row] = *columns.find<Value>(*points_, row);
}

Value Places::drawn_points(const StoredColumns& columns, std::uint32_t row, double alpha,
                           double far) const {
    const Value& now = *columns.find<Value>(*points_, row);
    if (alpha == 1 || row >= points_after_.size()) return now;
    const Value& before = points_before_[row];
    const bool moved = before.is(Type::list) && before.list().size() == now.list().size() &&
                       !(before == now) && points_after_[row] == now;
    if (!moved) return now;
    List between = now.list();
    for (std::size_t i = 0; i < between.size(); ++i) {
        const Vec2 to = between[i].vec2(), way = to - before.list()[i].vec2();
        if (way.length() > far) return now;
        between[i] = Value(Vec2(to - (1 - alpha) * way));
    }
    return Value(std::move(between));
}

}  // namespace fettle::property
