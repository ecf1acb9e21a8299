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

/// Reads many rows: the columns are looked up once.
class Places::Reader {
  public:
    Reader(const Places& places, const StoredColumns& columns)
        : positions_(columns.find<Vec2>(*places.position_, 0)),
          angles_(cells<double>(columns, places.angle_)),
          scales_(cells<double>(columns, places.scale_)),
          visible_(cells<std::uint8_t>(columns, places.visible_)) {}
    Placement now(std::uint32_t row) const {
        return {.position = positions_[row],
                .angle = angles_ == nullptr ? 0 : angles_[row],
                .scale = scales_ == nullptr ? 1 : scales_[row]};
    }
    bool seen(std::uint32_t row) const { return visible_ == nullptr || visible_[row] != 0; }

  private:
    template <class T>
    static const T* cells(const StoredColumns& columns, const Property* of) {
        return of == nullptr ? nullptr : columns.find<T>(*of, 0);
    }
    const Vec2* positions_;
    const double *angles_, *scales_;
    const std::uint8_t* visible_;
};

Placement Places::drawn(const StoredColumns& columns, std::uint32_t row, double alpha,
                        double far) const {
    const Placement at = Reader(*this, columns).now(row);
    return alpha < 1 && row < tracks_.size() ? tracks_[row].drawn(at, alpha, far) : at;
}

void Places::note_step_begins(const StoredColumns& columns) {
    const std::uint32_t rows = columns.rows();
    tracks_.resize(rows);
    if (points_ != nullptr) points_before_.resize(rows);
    if (rows == 0) return;
    const Reader read(*this, columns);
    for (std::uint32_t row = 0; row < rows; ++row)
        tracks_[row].step_begins(read.now(row), read.seen(row));
    if (points_ == nullptr) return;
    const Value* const points = columns.find<Value>(*points_, 0);
    for (std::uint32_t row = 0; row < rows; ++row)
        points_before_[row] = read.seen(row) ? points[row] : Value();
}

void Places::note_step_ended(const StoredColumns& columns) {
    if (tracks_.empty()) return;
    const Reader read(*this, columns);
    for (std::uint32_t row = 0; row < tracks_.size(); ++row) tracks_[row].step_ended(read.now(row));
    if (points_ == nullptr) return;
    points_after_.resize(points_before_.size());
    const Value* const points = columns.find<Value>(*points_, 0);
    for (std::uint32_t row = 0; row < points_after_.size(); ++row) points_after_[row] = points[row];
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
