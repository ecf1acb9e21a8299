#pragma once
// Members of a row as properties. The rows are in the memory of this part, because the layout must
// follow at once when one of them changes.

#include <optional>
#include <string>
#include <type_traits>
#include <utility>

#include <fettle/property/class.h>

namespace fettle::interface {

template <class T>
property::Value held(const T& v) {
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

/// The value in a row: a member of it, or a member of a struct in it.
template <auto Member>
auto& value_in(auto& row) {
    return row.*Member;
}
template <auto Part, auto Member>
auto& value_in(auto& row) {
    return row.*Part.*Member;
}

/// `Owner` has a type `Element` of its rows, `operator[]` for a row, and `changed(row)`, which is
/// called after a write. `Members`: as of `value_in`.
template <auto... Members, class Owner>
property::Property field(Owner& owner, property::Property described) {
    using Element = typename Owner::Element;
    using Field =
        Kept<std::remove_cvref_t<decltype(value_in<Members...>(std::declval<Element&>()))>>;
    described.type = type_of<typename Field::Plain>;
    described.nullable = Field::nullable;
    if (described.type == property::Type::color) described.range = {0, 1};
    Element plain{};
    if (described.type != property::Type::reference)
        described.default_value = held(value_in<Members...>(plain));
    described.binding = property::accessor(
        owner, [](Owner& in, property::Row row) { return held(value_in<Members...>(in[row])); },
        [](Owner& in, property::Row row, const property::Value& value) {
            take(value_in<Members...>(in[row]), value);
            in.changed(row);
        });
    return described;
}

}  // namespace fettle::interface
