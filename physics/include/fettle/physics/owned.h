#pragma once

#include <fettle/physics/export.h>

#include <utility>

FETTLE_PHYSICS_BEGIN

namespace fettle::physics::detail {

/// The only pointer to an object, which it deletes: <memory> takes too long to compile for a
/// pointer in a public header.
template <class T>
class Owned {
  public:
    Owned() = default;                              ///< null
    explicit Owned(T* object) : object_(object) {}  ///< owns it from now on
    /// Takes over the object; the other is null then.
    Owned(Owned&& other) noexcept : object_(std::exchange(other.object_, nullptr)) {}
    /// Deletes its object and takes over that of the other.
    Owned& operator=(Owned&& other) noexcept {
        Owned old(std::move(*this));
        object_ = std::exchange(other.object_, nullptr);
        return *this;
    }
    ~Owned() { delete object_; }

    T* get() const noexcept { return object_; }         ///< null if there is none
    T* operator->() const noexcept { return object_; }  ///< must not be null
    T& operator*() const noexcept { return *object_; }  ///< must not be null
    explicit operator bool() const noexcept { return object_ != nullptr; }  ///< false: null

  private:
    T* object_ = nullptr;
};

}  // namespace fettle::physics::detail

FETTLE_PHYSICS_END
