#pragma once

#include <fettle/physics/events.h>

#include <concepts>
#include <cstddef>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

// Lists of the members of a struct, checked by the compiler: omitting a member is an error.
// Writing, reading, counting memory and releasing it use the same list.

namespace fettle::physics::detail {

/// Converts to any type; a placeholder for a member.
struct AnyMember {
    template <class T>
    operator T() const;
};

template <class Aggregate, std::size_t... I>
constexpr bool takes_members(std::index_sequence<I...>) {
    return requires {
        Aggregate{(static_cast<void>(I), AnyMember())...};
    };
}

/// Number of members and bases of an aggregate.
template <class Aggregate, std::size_t least = 0>
constexpr std::size_t count_members() {
    static_assert(std::is_aggregate_v<Aggregate>);
    if constexpr (takes_members<Aggregate>(std::make_index_sequence<least + 1>()))
        return count_members<Aggregate, least + 1>();
    else
        return least;
}

/// Several members under one name: one line of `World::memory`; "" if they own no memory.
template <class... Member>
struct NamedMembers {
    const char* name;
    std::tuple<Member&...> members;
};

template <class... Member>
NamedMembers<Member...> named(const char* name, Member&... members) {
    return {name, {members...}};
}

/// The base `Part` of `self`.
template <class Part, class Self>
auto& part(Self& self) {
    return static_cast<std::conditional_t<std::is_const_v<Self>, const Part, Part>&>(self);
}

/// Passes every member to `io`; if `io` has `line`, calls `io.line(name)` before. The members of
/// `Base` are listed with those of `Whole`.
template <class Whole, class... Base, class Io, class... Line>
void list_members(Io& io, const Line&... lines) {
    constexpr std::size_t listed =
        (std::tuple_size_v<decltype(std::declval<Line>().members)> + ... + 0);
    static_assert(
        listed == count_members<Whole>() + (count_members<Base>() + ... + 0) - sizeof...(Base),
        "a member is not listed");
    const auto show = [&io](const auto& line) {
        if constexpr (requires { io.line(line.name); }) io.line(line.name);
        std::apply([&io](auto&... each) { (io(each), ...); }, line.members);
    };
    (show(lines), ...);
}

/// Types with a function `members`.
template <class T, class Io>
concept ListsMembers = requires(Io& io, T& value) {
    std::remove_const_t<T>::members(io, value);
};

/// Passes the lists of events one by one.
template <class Io, class Happened>
void event_members(Io& io, Happened& e) {
    static_assert(sizeof(Events) == 10 * sizeof(std::vector<int>), "list the new member here");
    io(e.contact_begin), io(e.contact_persist), io(e.contact_end), io(e.contact_hit);
    io(e.sensor_begin), io(e.sensor_end), io(e.joint_broke), io(e.joint_loaded);
    io(e.slept), io(e.woke);
}

/// Passes every part of an object whose parts are all of one type.
template <class Io, class T>
void each_of(Io& io, T& parts) {
    std::apply([&io](auto&... each) { (io(each), ...); }, parts);
}

}  // namespace fettle::physics::detail
