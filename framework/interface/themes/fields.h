#pragma once
// Members of a row as properties. The rows are in the memory of this module, because a change of
// one of them must mark the layout as outdated at once.

#include <optional>
#include <string>
#include <type_traits>
#include <utility>

#include <fettle/property/class.h>

namespace fettle::interface {

template <class T>
property::Value to_value(const T& v) {
    return {v};
}
template <class T>
property::Value to_value(const std::optional<T>& v) {
    return v ? to_value(*v) : property::Value();
}

inline void assign(bool& to, const property::Value& v) {
    to = v.boolean();
}
inline void assign(double& to, const property::Value& v) {
    to = v.as_double();
}
inline void assign(std::int64_t& to, const property::Value& v) {
    to = v.integer();
}
inline void assign(property::Vec2& to, const property::Value& v) {
    to = v.vec2();
}
inline void assign(std::string& to, const property::Value& v) {
    to = v.text();
}
inline void assign(property::Color& to, const property::Value& v) {
    to = v.color();
}
inline void assign(property::Handle& to, const property::Value& v) {
    to = v.is_nil() ? property::Handle{} : v.reference();
}
inline void assign(property::List& to, const property::Value& v) {
    to = v.list();
}
template <class T>
void assign(std::optional<T>& to, const property::Value& v) {
    if (v.is_nil()) {
        to.reset();
        return;
    }
    T value{};
    assign(value, v);
    to = std::move(value);
}

template <class T>
struct FieldType {
    using Plain = T;
    static constexpr bool nullable = false;
};
template <class T>
struct FieldType<std::optional<T>> {
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
        FieldType<std::remove_cvref_t<decltype(value_in<Members...>(std::declval<Element&>()))>>;
    described.type = type_of<typename Field::Plain>;
    described.nullable = Field::nullable;
    if (described.type == property::Type::color) described.range = {0, 1};
    Element plain{};
    if (described.type != property::Type::reference)
        described.default_value = to_value(value_in<Members...>(plain));
    described.binding = property::accessor(
        owner, [](Owner& in, property::Row row) { return to_value(value_in<Members...>(in[row])); },
        [](Owner& in, property::Row row, const property::Value& value) {
            assign(value_in<Members...>(in[row]), value);
            in.changed(row);
        });
    return described;
}

}  // namespace fettle::interface
