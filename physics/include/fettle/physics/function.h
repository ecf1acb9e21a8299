#pragma once

#include <fettle/physics/export.h>

#include <cstddef>
#include <new>
#include <type_traits>
#include <utility>

FETTLE_PHYSICS_BEGIN

namespace fettle::physics {

template <class Signature>
class Function;

namespace detail {
/// Throws std::logic_error: an empty function was called.
[[noreturn]] void refuse_empty_call();

/// A function that may be empty, such as another type of function or a pointer.
template <class Called>
bool is_empty(const Called& called) {
    if constexpr (requires { called == nullptr; })
        return called == nullptr;
    else
        return false;
}
}  // namespace detail

/// A function that is kept: a lambda with what it captures, a pointer to a function, a
/// `std::function`. It is used as `std::function` is, whose header alone takes as long to compile
/// as all headers of this library. What it keeps must be copyable; two pointers, if they are
/// trivially copyable, need no memory of their own.
template <class Returned, class... Arguments>
class Function<Returned(Arguments...)> {
  public:
    Function() = default;                     ///< empty
    Function(std::nullptr_t) : Function() {}  ///< empty
    /// Keeps a copy; empty if `called` is an empty function or a null pointer.
    template <class Called>
    requires(!std::is_same_v<std::remove_cvref_t<Called>, Function> &&
             std::is_invocable_r_v<Returned, std::decay_t<Called>&, Arguments...>)
        Function(Called&& called) {  // NOLINT: converts
        using Kept = std::decay_t<Called>;
        if (detail::is_empty(called)) return;
        if constexpr (lies_inside<Kept>)
            ::new (room_.bytes) Kept(std::forward<Called>(called));
        else
            room_.pointer = new Kept(std::forward<Called>(called));
        actions_ = &actions_of<Kept>;
    }
    /// A copy.
    Function(const Function& other) : actions_(other.actions_) {
        if (actions_ != nullptr) actions_->copy(other.room_, room_);
    }
    /// Takes over the other, which is empty then.
    Function(Function&& other) noexcept
        : room_(other.room_), actions_(std::exchange(other.actions_, nullptr)) {}
    /// Takes over `other`, which may be a copy.
    Function& operator=(Function other) noexcept {
        std::swap(room_, other.room_);
        std::swap(actions_, other.actions_);
        return *this;
    }
    ~Function() {
        if (actions_ != nullptr) actions_->destroy(room_);
    }

    explicit operator bool() const noexcept { return actions_ != nullptr; }  ///< false: empty
    /// Whether it is empty.
    friend bool operator==(const Function& function, std::nullptr_t) noexcept { return !function; }
    /// Calls what it keeps. Throws std::logic_error if it is empty.
    Returned operator()(Arguments... arguments) const {
        if (actions_ == nullptr) detail::refuse_empty_call();
        return actions_->call(room_, std::forward<Arguments>(arguments)...);
    }

  private:
    union Room {
        void* pointer;
        alignas(void*) std::byte bytes[2 * sizeof(void*)];
    };
    struct Actions {
        Returned (*call)(const Room&, Arguments&&...);
        void (*copy)(const Room& from, Room& to);
        void (*destroy)(Room&);
    };
    template <class Kept>
    static constexpr bool lies_inside =
        sizeof(Kept) <= sizeof(Room) &&
        alignof(Kept) <= alignof(Room) && std::is_trivially_copyable_v<Kept>;

    template <class Kept>
    static Kept& kept(const Room& room) {
        if constexpr (lies_inside<Kept>)
            return *std::launder(reinterpret_cast<Kept*>(const_cast<std::byte*>(room.bytes)));
        else
            return *static_cast<Kept*>(room.pointer);
    }
    template <class Kept>
    static constexpr Actions actions_of = {
        [](const Room& room, Arguments&&... arguments) -> Returned {
            if constexpr (std::is_void_v<Returned>)
                static_cast<void>(kept<Kept>(room)(std::forward<Arguments>(arguments)...));
            else
                return kept<Kept>(room)(std::forward<Arguments>(arguments)...);
        },
        [](const Room& from, Room& to) {
            if constexpr (lies_inside<Kept>)
                to = from;
            else
                to.pointer = new Kept(kept<Kept>(from));
        },
        [](Room& room) {
            if constexpr (!lies_inside<Kept>) delete static_cast<Kept*>(room.pointer);
        }};

    Room room_ = {};
    const Actions* actions_ = nullptr;
};

}  // namespace fettle::physics

FETTLE_PHYSICS_END
