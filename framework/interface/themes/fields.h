#pragma once
// Members of a row as properties. The rows are in the memory of this part, because the layout must
// know at once when one of them changes.

#include <optional>
#include <string>
#include <utility>

#include <fettle/property/class.h>

namespace fettle::interface {

inline property::Value held(bool v) {
    return {v};
}
inline property::Value held(double v) {
    return {v};
}
inline property::Value held(std::int64_t v) {
    return {v};
}
inline property::Value held(const property::Vec2& v) {
    return {v};
}
inline property::Value held(const std::string& v) {
    return {v};
}
inline property::Value held(property::Color v) {
    return {v};
}
inline property::Value held(property::Handle v) {
    return {v};
}
inline property::Value held(const property::List& v) {
    return {v};
}
template <class T>
property::Value held(const std::optional<T>& v) {
    return v ? held(*v) : property::Value();
}

inline void take(bool& to, const property::Value& v) {
    to = v.boolean();
}
inline void take(double& to, const property::Value& v) {
    to = v.as_double();
}
inline void take(std::int64_t& to, const property::Value& v) {
    to = v.integer();
}
inline void take(property::Vec2& to, const property::Value& v) {
    to = v.vec2();
}
inline void take(std::string& to, const property::Value& v) {
    to = v.text();
}
inline void take(property::Color& to, const property::Value& v) {
    to = v.color();
}
inline void take(property::Handle& to, const property::Value& v) {
    to = v.is_nil() ? property::Handle{} : v.reference();
}
inline void take(property::List& to, const property::Value& v) {
    to = v.list();
}
template <class T>
void take(std::optional<T>& to, const property::Value& v) {
    if (v.is_nil()) {
        to.reset();
        return;
    }
    T value{};
    take(value, v);
    to = std::move(value);
}

template <class T>
struct Kept {
    using Plain = T;
    static constexpr bool nullable = false;
};
template <class T>
struct Kept<std::optional<T>> {
    using Plain = T;
    static constexpr bool nullable = true;
};

/// The type of a property that has a member of this type.
template <class T>
inline constexpr property::Type type_of = property::Type::nil;
template <>
inline constexpr property::Type type_of<bool> = property::Type::boolean;
template <>
inline constexpr property::Type type_of<double> = property::Type::number;
template <>
inline constexpr property::Type type_of<std::int64_t> = property::Type::integer;
template <>
inline constexpr property::Type type_of<property::Vec2> = property::Type::vec2;
template <>
inline constexpr property::Type type_of<std::string> = property::Type::text;
template <>
inline constexpr property::Type type_of<property::Color> = property::Type::color;
template <>
inline constexpr property::Type type_of<property::Handle> = property::Type::reference;
template <>
inline constexpr property::Type type_of<property::List> = property::Type::list;

template <class Row, class T>
Row row_of(T Row::*);
template <class Row, class T>
T member_of(T Row::*);

/// `Owner` has a type `Element` of its rows, `operator[]` for a row, and `changed(row)`, which is
/// called after a write.
template <auto Member, class Owner>
property::Property field(Owner& owner, property::Property described) {
    using Element = decltype(row_of(Member));
    using Field = Kept<decltype(member_of(Member))>;
    described.type = type_of<typename Field::Plain>;
    described.nullable = Field::nullable;
    if (described.type == property::Type::color) described.range = {0, 1};
    if (described.type != property::Type::reference)
        described.default_value = held(Element{}.*Member);
    described.binding = property::accessor(
        owner, [](Owner& in, property::Row row) { return held(in[row].*Member); },
        [](Owner& in, property::Row row, const property::Value& value) {
            take(in[row].*Member, value);
            in.changed(row);
        });
    return described;
}

}  // namespace fettle::interface
