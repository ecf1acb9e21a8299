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

/// A copy of a function object, such as a lambda with its captures, a pointer to a function or a
/// `std::function`. It is used like `std::function`, whose header alone takes as long to compile as
/// all headers of this library. The function object must be copyable. If it is trivially copyable
/// and no larger than two pointers, it needs no allocation.
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
        if constexpr (fits_inside<Kept>)
            ::new (storage_.bytes) Kept(std::forward<Called>(called));
        else
            storage_.pointer = new Kept(std::forward<Called>(called));
        actions_ = &actions_of<Kept>;
    }
    /// A copy.
    Function(const Function& other) : actions_(other.actions_) {
        if (actions_ != nullptr) actions_->copy(other.storage_, storage_);
    }
    /// Takes over the other, which is empty then.
    Function(Function&& other) noexcept
        : storage_(other.storage_), actions_(std::exchange(other.actions_, nullptr)) {}
    /// Takes over `other`, which may be a copy.
    Function& operator=(Function other) noexcept {
        std::swap(storage_, other.storage_);
        std::swap(actions_, other.actions_);
        return *this;
    }
    ~Function() {
        if (actions_ != nullptr) actions_->destroy(storage_);
    }

    explicit operator bool() const noexcept { return actions_ != nullptr; }  ///< false: empty
    /// Whether it is empty.
    friend bool operator==(const Function& function, std::nullptr_t) noexcept { return !function; }
    /// Calls the function object. Throws std::logic_error if it is empty.
    Returned operator()(Arguments... arguments) const {
        if (actions_ == nullptr) detail::refuse_empty_call();
        return actions_->call(storage_, std::forward<Arguments>(arguments)...);
    }

  private:
    union Storage {
        void* pointer;
        alignas(void*) std::byte bytes[2 * sizeof(void*)];
    };
    struct Actions {
        Returned (*call)(const Storage&, Arguments&&...);
        void (*copy)(const Storage& from, Storage& to);
        void (*destroy)(Storage&);
    };
    template <class Kept>
    static constexpr bool fits_inside =
        sizeof(Kept) <= sizeof(Storage) &&
        alignof(Kept) <= alignof(void*) && std::is_trivially_copyable_v<Kept>;

    template <class Kept>
    static Kept& kept(const Storage& storage) {
        if constexpr (fits_inside<Kept>)
            return *std::launder(reinterpret_cast<Kept*>(const_cast<std::byte*>(storage.bytes)));
        else
            return *static_cast<Kept*>(storage.pointer);
    }
    template <class Kept>
    static constexpr Actions actions_of = {
        [](const Storage& storage, Arguments&&... arguments) -> Returned {
            if constexpr (std::is_void_v<Returned>)
                static_cast<void>(kept<Kept>(storage)(std::forward<Arguments>(arguments)...));
            else
                return kept<Kept>(storage)(std::forward<Arguments>(arguments)...);
        },
        [](const Storage& from, Storage& to) {
            if constexpr (fits_inside<Kept>)
                to = from;
            else
                to.pointer = new Kept(kept<Kept>(from));
        },
        [](Storage& storage) {
            if constexpr (!fits_inside<Kept>) delete static_cast<Kept*>(storage.pointer);
        }};

    Storage storage_ = {};
    const Actions* actions_ = nullptr;
};

}  // namespace fettle::physics

FETTLE_PHYSICS_END
