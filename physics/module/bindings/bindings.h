#pragma once
// Bindings made of a getter and a setter of the physics library.

#include <type_traits>

#include <fettle/property/class.h>

#include <bindings/conversion.h>
#include <hosting/hosting.h>

namespace fettle::physics_module {

using property::accessor;
using property::Binding;
using property::Property;
using property::Range;
using property::Type;
using property::Value;

/// The object that a row refers to.
template <class Object>
decltype(auto) object_at(Hosting& hosting, Row row) {
    if constexpr (std::is_same_v<Object, physics::Body>)
        return hosting.body(row);
    else if constexpr (std::is_same_v<Object, physics::Shape>)
        return hosting.shape(row);
    else if constexpr (std::is_base_of_v<physics::Joint, Object>)
        return hosting.joints.at<Object>(row);
    else
        return (hosting.world(row));  // a reference
}

template <auto Member>
struct Setter;
template <class Of, class Taken, void (Of::*Member)(Taken)>
struct Setter<Member> {
    using Object = Of;
    using Argument = std::remove_cvref_t<Taken>;
};

template <auto Member>
struct Getter;
template <class Of, class Given, Given (Of::*Member)() const>
struct Getter<Member> {
    using Object = Of;
};

/// The result of a getter of the library in the types of the tree; numbers and vectors keep their
/// type, so that scripts read them without a Value in between.
template <class T>
auto widened(const T& got) {
    if constexpr (std::is_same_v<T, float>)
        return static_cast<double>(got);
    else if constexpr (std::is_same_v<T, physics::Vec2>)
        return widen(got);
    else
        return to_value(got);
}

/// Converts the result of writing a number by slot to the enum of the tree.
inline property::WriteResult put(physics::Written written) {
    using physics::Written;
    using property::WriteResult;
    static_assert(static_cast<int>(WriteResult::same) == static_cast<int>(Written::same) &&
                  static_cast<int>(WriteResult::done) == static_cast<int>(Written::done) &&
                  static_cast<int>(WriteResult::declined) == static_cast<int>(Written::refused));
    return static_cast<WriteResult>(written);
}

/// Binds numbers that are written without a Value in between. Both are captureless lambdas: `get`
/// (Hosting&, Row) returns a float, `set` (Hosting&, Row, float) takes one.
template <class Get, class Set>
void put_numbers(Binding& binding, Get, Set) {
    binding.number.put = [](const Binding& self, Row row, double value) {
        auto& h = *static_cast<Hosting*>(self.context);
        if (property::same_bits(static_cast<double>(Get{}(h, row)), value))
            return property::WriteResult::same;
        Set{}(h, row, static_cast<float>(value));
        return property::WriteResult::done;
    };
}

/// As `put_numbers`, but by slot. For the numbers that scripts write most often.
template <physics::BodyNumber number>
void put_by_slot(Binding& binding) {
    binding.number.plain = true;
    binding.number.put = [](const Binding& self, Row row, double value) {
        const auto [in, slot] = static_cast<Hosting*>(self.context)->at(row);
        return put(physics::HostAccess::write<number>(in.world, slot, static_cast<float>(value)));
    };
}

/// Binds a property to a getter and a setter; every write calls the setter.
template <auto Get, auto Set>
Binding setting(Hosting& hosting) {
    using Object = typename Setter<Set>::Object;
    using Argument = typename Setter<Set>::Argument;
    return accessor(
        hosting, [](Hosting& h, Row row) { return widened((object_at<Object>(h, row).*Get)()); },
        [](Hosting& h, Row row, const Value& value) {
            (object_at<Object>(h, row).*Set)(from_value<Argument>(value));
        });
}

/// As `setting`, but a write that does not change a number does not call the setter.
template <auto Get, auto Set>
Binding bound(Hosting& hosting) {
    using Object = typename Setter<Set>::Object;
    using Argument = typename Setter<Set>::Argument;
    Binding binding = setting<Get, Set>(hosting);
    if constexpr (std::is_same_v<Argument, float>)
        put_numbers(
            binding, [](Hosting& h, Row row) { return (object_at<Object>(h, row).*Get)(); },
            [](Hosting& h, Row row, float value) { (object_at<Object>(h, row).*Set)(value); });
    return binding;
}

template <auto Get>
Binding read_only(Hosting& hosting) {
    using Object = typename Getter<Get>::Object;
    return accessor(
        hosting, [](Hosting& h, Row row) { return widened((object_at<Object>(h, row).*Get)()); });
}

/// Binds a value that the library computes, and that a user can override. Writing nil removes the
/// override.
template <auto Get, auto Set, auto Override>
Binding overridable(Hosting& hosting) {
    using Object = typename Setter<Set>::Object;
    Binding binding = bound<Get, Set>(hosting);
    binding.reset = [](void* context, Row row) {
        (object_at<Object>(*static_cast<Hosting*>(context), row).*Set)({});
    };
    binding.overridden = [](void* context, Row row) {
        return (object_at<Object>(*static_cast<Hosting*>(context), row).*Override)().has_value();
    };
    return binding;
}

inline constexpr Range not_negative{.min = 0.0};
inline constexpr Range fraction{.min = 0.0, .max = 1.0};
/// Range of masses and inertias: their reciprocals must be representable as floats, too.
inline constexpr Range inertial{.min = 1e-30};
// Ranges that the library accepts: positions in the world and points of bodies, m; points of
// shapes, m; angles, rad.
inline constexpr Range coordinates{.min = -1e8, .max = 1e8};
inline constexpr Range shape_coordinates{.min = -1e6, .max = 1e6};
inline constexpr Range turns{.min = -1e8, .max = 1e8};

inline Property within(const Range& range, Property property) {
    property.range = range;
    return property;
}

// Properties of the usual types.

/// A property with a fixed set of names. The index of a name is the number of the enumerator in the
/// library.
template <const auto& names, auto Get, auto Set>
Property choice(Hosting& hosting, std::string name, std::string default_value, std::string doc) {
    using Object = typename Setter<Set>::Object;
    using Enumerator = typename Setter<Set>::Argument;
    return {
        .name = std::move(name),
        .type = Type::text,
        .default_value = std::move(default_value),
        .doc = std::move(doc),
        .binding = accessor(
            hosting,
            [](Hosting& h, Row row) {
                return Value(names[static_cast<std::size_t>((object_at<Object>(h, row).*Get)())]);
            },
            [](Hosting& h, Row row, const Value& value) {
                for (std::size_t i = 0; i < names.size(); ++i)
                    if (value.text() == names[i])
                        (object_at<Object>(h, row).*Set)(static_cast<Enumerator>(i));
            }),
        .enumerators = {names.begin(), names.end()}};
}

inline Property simulated(Property property) {
    property.simulated = true;
    return property;
}
inline Property number(std::string name, double default_value, std::string unit, std::string doc,
                       Binding binding) {
    return {.name = std::move(name),
            .default_value = default_value,
            .unit = std::move(unit),
            .doc = std::move(doc),
            .binding = binding,
            .single_precision = true};
}
/// A number that is at least 0.
inline Property amount(std::string name, double default_value, std::string unit, std::string doc,
                       Binding binding) {
    return within(not_negative,
                  number(std::move(name), default_value, std::move(unit), std::move(doc), binding));
}
/// A number that is a limit; infinity means no limit.
inline Property limit_number(std::string name, double default_value, std::string unit,
                             std::string doc, Binding binding) {
    Property property =
        number(std::move(name), default_value, std::move(unit), std::move(doc), binding);
    property.infinity = true;
    return property;
}
/// A read-only number.
inline Property figure(std::string name, std::string unit, std::string doc, Binding binding) {
    Property property = number(std::move(name), 0, std::move(unit), std::move(doc), binding);
    property.read_only = property.transient = property.simulated = true;
    return property;
}
inline Property vector(std::string name, const property::Vec2& default_value, std::string unit,
                       std::string doc, Binding binding) {
    Property property = number(std::move(name), 0, std::move(unit), std::move(doc), binding);
    property.type = Type::vec2;
    property.default_value = default_value;
    return property;
}
inline Property flag(std::string name, bool default_value, std::string doc, Binding binding) {
    return {.name = std::move(name),
            .type = Type::boolean,
            .default_value = default_value,
            .doc = std::move(doc),
            .binding = binding};
}

/// For instances whose row refers to an object of the library.
template <Row (Hosting::*Create)(Handle), Row (Hosting::*Place)(Handle, Row),
          void (Hosting::*Destroy)(Row)>
property::Lifecycle lifecycle_of(Hosting& hosting) {
    property::Lifecycle lifecycle;
    lifecycle.context = &hosting;
    lifecycle.create = [](void* context, property::Tree&, Handle self) {
        return (static_cast<Hosting*>(context)->*Create)(self);
    };
    lifecycle.place = [](void* context, property::Tree&, Handle self, Row row) {
        return (static_cast<Hosting*>(context)->*Place)(self, row);
    };
    lifecycle.destroy = [](void* context, property::Tree&, Handle, Row row) {
        (static_cast<Hosting*>(context)->*Destroy)(row);
    };
    return lifecycle;
}

}  // namespace fettle::physics_module
