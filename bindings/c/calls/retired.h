#pragma once

#include <cstddef>
#include <deque>
#include <memory>
#include <mutex>

#include "failure.h"

// The memory of objects to which a caller in C has pointers. The caller may use a pointer after the
// object was destroyed. Used by this library and by that of a whole game (bindings/host).

namespace fettle::physics_c {

/// The memory of destroyed objects. It is used again when a thousand more have been destroyed;
/// until then a stale pointer is recognized. A default-constructed `Object` is in the state of a
/// destroyed one.
template <class Object>
class Retired {
  public:
    /// Allocates an object, in the state of a destroyed one.
    static std::unique_ptr<Object> allocate() {
        Retired& known = all();
        const std::lock_guard lock(known.mutex_);
        if (known.objects_.size() <= most) return std::make_unique<Object>();
        std::unique_ptr<Object> oldest = std::move(known.objects_.front());
        known.objects_.pop_front();
        return oldest;
    }

    /// Keeps the memory of an object in the state of a destroyed one.
    static void keep(Object* object) noexcept {
        std::unique_ptr<Object> ended(object);
        try {
            Retired& known = all();
            const std::lock_guard lock(known.mutex_);
            known.objects_.push_back(std::move(ended));
        } catch (...) {
            // There is no memory for the list, so the object is freed at once.
        }
    }

  private:
    static constexpr std::size_t most = 1000;

    /// Never destroyed, because a program may destroy its objects in a function of `atexit`, or in
    /// the destructor of a global variable.
    static Retired& all() {
        static Retired& known = *new Retired;
        return known;
    }

    std::mutex mutex_;
    std::deque<std::unique_ptr<Object>> objects_;
};

/// What a pointer refers to; throws Failure if it is null or destroyed. `name`: for the message.
template <class Object>
Object& existing(const char* name, Object* pointer) {
    Object& object = needed(name, pointer);
    if (object.is_destroyed())
        throw Failure{FETTLE_STALE, std::string(name) + ": it was destroyed"};
    return object;
}

}  // namespace fettle::physics_c
