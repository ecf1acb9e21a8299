#pragma once
// From the name a script writes to what an instance has under it. Lua interns short names, so the
// address of a name (lua_topointer, which also tells a name from a number in the same call) and the
// class of the instance find the property in one probe of a small table. Names that are in it are
// anchored in Lua's registry, so an address never comes to mean another name.

#include <array>
#include <cstddef>
#include <cstdint>

#include <fettle/property/class.h>

#include "lua_api.h"

namespace fettle::script {

enum class Member : std::uint8_t {
    none,
    property,  // declared by the class
    number,    // such a one that may be a number read and written the short way
    vec2,      // the same for a vector
    function,  // a method of the class or of every instance: `reference` is in the registry
    dynamic    // not declared: a child, an ad-hoc property, or nothing
};

struct Dispatch {
    const void* key = nullptr;
    const property::Class* instance_class = nullptr;
    const property::Property* property = nullptr;
    int reference = LUA_NOREF;
    Member member = Member::none;
    bool is_property() const { return property != nullptr; }
    /// Another name may hold the slot, but hardly ever does: asked apart, or compilers put that
    /// case in the way.
    bool is_of(const property::Class* of, const void* name) const {
        if (key != name) [[unlikely]]
            return false;
        return instance_class == of;
    }
};

class DispatchCache {
  public:
    Dispatch& slot(const property::Class* instance_class, const void* key) {
        return slots_[place(instance_class, key)];
    }
    const Dispatch& slot(const property::Class* instance_class, const void* key) const {
        return slots_[place(instance_class, key)];
    }
    void clear() { slots_.fill({}); }

  private:
    static constexpr std::size_t size = 2048;
    static std::size_t place(const property::Class* instance_class, const void* key) {
        const auto a = reinterpret_cast<std::uintptr_t>(key);
        const auto b = reinterpret_cast<std::uintptr_t>(instance_class);
        return (a + b) / 16 & (size - 1);
    }

    std::array<Dispatch, size> slots_{};
};

}  // namespace fettle::script
