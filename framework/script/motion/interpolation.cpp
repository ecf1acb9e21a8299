#include <algorithm>
#include <cmath>

#include <motion/interpolation.h>

namespace fettle::script {

using property::Color;
using property::List;
using property::Property;
using property::Range;
using property::Type;
using property::Value;
using property::Vec2;

namespace {

double between(double from, double to, double part, const Range& range) {
    if (part == 1) return to;
    return std::clamp(from + (to - from) * part, range.min, range.max);
}

Value mixed_integers(const Value& from, const Value& to, double part, const Property& property) {
    // At the end, the integer itself: a double is too coarse for large ones.
    if (part == 0) return from;
    if (part == 1) return to;
    const double number = between(from.as_double(), to.as_double(), part, property.range);
    const bool whole = property.type == Type::integer || property.element == Type::integer;
    constexpr double limit = 9.0e18;
    if (!whole) return number;
    return Value(static_cast<std::int64_t>(std::clamp(std::round(number), -limit, limit)));
}

Color between(const Color& from, const Color& to, double part) {
    const auto channel = [part](float a, float b) {
        return static_cast<float>(between(a, b, part, {.min = 0, .max = 1}));
    };
    return {channel(from.r, to.r), channel(from.g, to.g), channel(from.b, to.b),
            channel(from.a, to.a)};
}

}  // namespace

bool mixable(const Value& from, const Value& to) {
    if (from.is_numeric() && to.is_numeric()) return true;
    if (from.type() != to.type()) return false;
    if (!from.is(Type::list)) return from.is(Type::vec2) || from.is(Type::color);
    return std::equal(from.list().begin(), from.list().end(), to.list().begin(), to.list().end(),
                      mixable);
}

Value mix(const Value& from, const Value& to, double part, const Property& property) {
    if (from.is(Type::integer) && to.is(Type::integer))
        return mixed_integers(from, to, part, property);
    if (from.is_numeric()) return between(from.as_double(), to.as_double(), part, property.range);
    if (from.is(Type::vec2)) {
        const Vec2 a = from.vec2(), b = to.vec2();
        return Vec2(between(a.x, b.x, part, property.range),
                    between(a.y, b.y, part, property.range));
    }
    if (from.is(Type::color)) return between(from.color(), to.color(), part);
    List list;
    list.reserve(from.list().size());
    for (std::size_t i = 0; i < from.list().size(); ++i)
        list.push_back(mix(from.list()[i], to.list()[i], part, property));
    return list;
}

}  // namespace fettle::script
