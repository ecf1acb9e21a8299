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

namespace fettle::script {

enum class Member : std::uint8_t {
    none,
    property,     // declared by the class
    number,       // a declared number that may be read and written without a Value in between
    kept_number,  // the same, of a property that the tree keeps
    vec2,         // a declared vector, of either kind
    function,     // a method of the class or of every instance: `reference` is in the registry
    dynamic       // not declared: a child, an ad-hoc property, or nothing
};

/// An entry. Its size is a power of two, for the sake of `DispatchTable::offset`.
struct alignas(32) Dispatch {
    static const property::Property no_property;

    const void* key = &no_property;  // of no name
    /// Never null: one that is none can be neither read nor written the short way.
    const property::Property* property = &no_property;
    int reference = LUA_NOREF;
    Member member = Member::none;
    bool is_property() const { return property != &no_property; }
};

/// What a class has under the names that scripts have used with it.
class DispatchTable {
  public:
    DispatchTable(property::Tree& in, const property::Class& its_class, bool is_open);
    DispatchTable(const DispatchTable&) = delete;

    property::Tree& tree;
    const property::Class& of;

    /// Where the name stands, unless another stands there (then its `key` is another): nearly
    /// always it has its place to itself.
    const Dispatch& at(const void* key) const {
        // Offsets in bytes: nothing has to be multiplied on the shortest way of all.
        const auto* const bytes = reinterpret_cast<const std::byte*>(open_);
        return *reinterpret_cast<const Dispatch*>(bytes + (offset(key) & open_mask_));
    }
    /// nullptr when nobody has looked for the name yet.
    const Dispatch* find(const void* key) const;
    const Dispatch& add(const Dispatch& entry);
    /// In a table that is closed every name is said to stand elsewhere.
    void open(bool whether);

  private:
    // The places of two names, 16 bytes or more apart as all that Lua allocates, are an entry
    // apart.
    static std::size_t offset(const void* key) {
        return reinterpret_cast<std::uintptr_t>(key) * (sizeof(Dispatch) / 16);
    }
    std::size_t mask() const { return (size_ - 1) * sizeof(Dispatch); }
    Dispatch& free_or_of(const void* key) const;

    const Dispatch* open_ = nullptr;
    std::size_t open_mask_ = 0;  // 0: closed
    std::size_t size_ = 64;      // a power of two
    std::size_t count_ = 0;
    std::unique_ptr<Dispatch[]> entries_ = std::make_unique<Dispatch[]>(size_);
};

/// What the classes of a tree have under names, and the functions of Lua that call their methods.
class MemberTables {
  public:
    explicit MemberTables(property::Tree& tree) : tree_(tree) {}

    DispatchTable& of(const property::Class& of);
    /// While the reads and writes of a console command are noted, all tables are closed.
    void open(bool whether);
    /// The method a function of Lua stands for, nullptr for any other function.
    const property::Method* method_of(lua_State* L, int index) const;

    int anchors = 0;                // table in the registry: names in the dispatch tables
    std::size_t dynamic_names = 0;  // in them, of things that no class declares
    // References in the registry.
    std::unordered_map<const property::Method*, int> methods;
    std::unordered_map<std::string, int> generic;

  private:
    property::Tree& tree_;
    bool open_ = true;
    std::vector<std::unique_ptr<DispatchTable>> tables_;  // by the number of the class
};

}  // namespace fettle::script
