#pragma once
// What the program of a trial needs of a game's tree, as plain data: its classes without
// their functions, and its instances with their values.

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <fettle/property/bytes.h>
#include <fettle/property/class.h>
#include <fettle/property/tree.h>

namespace fettle::module {

class BridgedClass;

/// The parts of a binding that classes are checked by.
struct BindingDescription {
    property::BindingKind kind = property::BindingKind::stored;  ///< a column counts as an accessor
    bool set = false, reset = false, overridden = false;         ///< whether it has the function
    bool is_inherited = false;  ///< a base class declares it, this one gives another default
    /// As the module has declared it (`fettle_property`); only for the module that is reloaded.
    std::uint32_t declared_binding = 0, declared_native = 0;
};

struct ClassDescription {
    property::ClassDescriptor descriptor;      // without functions
    std::vector<BindingDescription> bindings;  // of `descriptor.properties`
    bool reloaded = false;                     // of the module that is reloaded
    /// Whether its lifecycle has the function. All false: it has that of its base class.
    bool create = false, place = false, destroy = false, draw = false, draw_over = false,
         pose = false;
};

struct ValueDescription {
    std::uint32_t property = 0;  // index in `Class::properties`
    bool overridden = false;
    property::Value value;
};

struct InstanceDescription {
    static constexpr std::uint32_t none = UINT32_MAX;
    property::Handle handle;      // in the game's tree
    std::uint32_t parent = none;  // index in `TreeDescription::instances`
    std::uint32_t of = 0;         // index in `Tree::classes`
    std::string name;
    std::vector<ValueDescription> values;                         // that differ from the defaults
    std::vector<std::pair<std::string, property::Value>> ad_hoc;  // properties of its own
    std::vector<std::string> listened;                            // events with a handler
};

/// The first classes are those that every tree has; they are not described. The first instance is
/// the root.
struct TreeDescription {
    std::uint64_t step = 0;
    std::vector<ClassDescription> classes;
    std::vector<InstanceDescription> instances;  // parents before children
};

/// Describes the classes, all instances below the root, and all instances of `reloaded`.
TreeDescription described(const property::Tree& tree,
                          const std::vector<const BridgedClass*>& reloaded);

void write(property::ByteWriter& to, const TreeDescription& tree);
/// Throws Error(damaged).
TreeDescription read_tree(property::ByteReader& from);

}  // namespace fettle::module
