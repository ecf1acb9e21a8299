#pragma once
// From the name a script writes to what an instance has under it. Lua interns short names, so the
// address of a name (lua_topointer, which also tells a name from a number in the same call) finds
// what it stands for in a table of the instance's class. Names that are in one are anchored in
// Lua's registry, so an address never comes to mean another name.

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

/// What a class has under a name; neither a property nor a function: a child, an ad-hoc property,
/// or nothing.
struct Dispatch {
    const void* key = nullptr;
    const property::Property* property = nullptr;  // declared by the class
    int reference = LUA_NOREF;  // in the registry: a method of the class or of every instance

    bool is_function() const { return reference != LUA_NOREF; }
    bool is_dynamic() const { return property == nullptr && !is_function(); }
};

/// What a class has under the names that scripts have used with it.
class DispatchTable {
  public:
    DispatchTable(property::Tree& in, const property::Class& its_class, const Recording& noted)
        : tree(in), of(its_class), recording(noted) {}
    DispatchTable(const DispatchTable&) = delete;

    property::Tree& tree;
    const property::Class& of;
    const Recording& recording;

    /// nullptr if the name was not looked up yet.
    const Dispatch* find(const void* key) const {
        const Dispatch& found = entries_[place_of(key)];
        return found.key != nullptr && found.key == key ? &found : nullptr;
    }
    const Dispatch& add(const Dispatch& entry);

  private:
    /// Where the name stands, or is to stand. Lua allocates in steps of 16 bytes.
    std::size_t place_of(const void* key) const {
        std::size_t i = reinterpret_cast<std::uintptr_t>(key) / 16 & (size_ - 1);
        while (entries_[i].key != nullptr && entries_[i].key != key) i = (i + 1) & (size_ - 1);
        return i;
    }

    std::size_t size_ = 64;  // a power of two
    std::size_t count_ = 0;
    std::unique_ptr<Dispatch[]> entries_ = std::make_unique<Dispatch[]>(size_);
};

/// What the classes of a tree have under names, and the functions of Lua that call their methods.
class MemberTables {
  public:
    MemberTables(property::Tree& tree, const Recording& recording)
        : tree_(tree), recording_(recording) {}

    DispatchTable& of(const property::Class& of);
    /// The method a function of Lua stands for, nullptr for any other function.
    const property::Method* method_of(lua_State* L, int index) const;

    int anchors = 0;                // table in the registry: names in the dispatch tables
    std::size_t dynamic_names = 0;  // in them, of things that no class declares
    // References in the registry.
    std::unordered_map<const property::Method*, int> methods;
    std::unordered_map<std::string, int> generic;

  private:
    property::Tree& tree_;
    const Recording& recording_;
    std::vector<std::unique_ptr<DispatchTable>> tables_;  // by the number of the class
};

}  // namespace fettle::script
