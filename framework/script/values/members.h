#pragma once
// Finds the member of an instance for a name in a script. Lua interns short names, so the address
// of a name (from lua_topointer, which also distinguishes a name from a number) is the key in a
// table of the instance's class. The registry keeps all names in the tables alive, so their
// addresses stay unique.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include <fettle/property/tree.h>

#include <lua/lua_api.h>
#include <values/recording.h>

namespace fettle::script {

struct Recording;

/// The member of a class for a name. Neither property nor function: a child, an ad hoc property, or
/// nothing.
struct Dispatch {
    const void* key = nullptr;
    const property::Property* property = nullptr;  // declared by the class
    int reference = LUA_NOREF;  // registry reference: a method of the class or of every instance

    bool is_function() const { return reference != LUA_NOREF; }
    bool is_dynamic() const { return property == nullptr && !is_function(); }
};

/// A hash table from names that scripts have used to members of a class.
class DispatchTable {
  public:
    DispatchTable(property::Tree& in, const property::Class& its_class, const Recording& noted)
        : tree(in), of(its_class), recording(noted) {}
    DispatchTable(const DispatchTable&) = delete;

    property::Tree& tree;
    const property::Class& of;
    const Recording& recording;

    /// nullptr if the name was not looked up before.
    const Dispatch* find(const void* key) const {
        const Dispatch& found = entries_[place_of(key)];
        return found.key != nullptr && found.key == key ? &found : nullptr;
    }
    const Dispatch& add(const Dispatch& entry);
    /// To be called when the class has got other members.
    void clear();

  private:
    /// Index of the entry, or of the place for a new one. Divided by 16, because Lua's allocations
    /// are multiples of 16 bytes.
    std::size_t place_of(const void* key) const {
        std::size_t i = reinterpret_cast<std::uintptr_t>(key) / 16 & (size_ - 1);
        while (entries_[i].key != nullptr && entries_[i].key != key) i = (i + 1) & (size_ - 1);
        return i;
    }

    std::size_t size_ = 64;  // a power of two
    std::size_t count_ = 0;
    std::unique_ptr<Dispatch[]> entries_ = std::make_unique<Dispatch[]>(size_);
};

/// The dispatch tables of all classes, and the Lua functions that call their methods.
class MemberTables {
  public:
    MemberTables(property::Tree& tree, const Recording& recording)
        : tree_(tree), recording_(recording) {}

    DispatchTable& of(const property::Class& of);
    /// To be called when classes have got other members.
    void clear();
    /// The method that a Lua function calls; nullptr for any other function.
    const property::Method* method_of(lua_State* L, int index) const;

    int anchors = 0;                // table in the registry with the names in the dispatch tables
    std::size_t dynamic_names = 0;  // number of stored names that no class declares
    // References in the registry.
    std::unordered_map<const property::Method*, int> methods;
    std::unordered_map<std::string, int> generic;

  private:
    property::Tree& tree_;
    const Recording& recording_;
    std::vector<std::unique_ptr<DispatchTable>> tables_;  // by number of the class
};

}  // namespace fettle::script
