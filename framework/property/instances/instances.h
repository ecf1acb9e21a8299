#pragma once
// The instances of a tree: their classes, their places in the tree, and access to the values of
// their properties.

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <fettle/property/symbol.h>
#include <fettle/property/tree.h>

#include <classes/class_registry.h>

#include "ad_hoc.h"
#include "nodes.h"
#include "reads.h"
#include "stored_columns.h"
#include "tombstones.h"

namespace fettle::property {

struct Instances {
    explicit Instances(Tree& owner) : tree(owner) {}

    Tree& tree;  // passed to the functions of modules
    ClassRegistry classes;
    Nodes nodes;
    std::vector<std::unique_ptr<StoredColumns>>
        stored;  // by class id; null if the class stores no values in the tree
    AdHoc ad_hoc;
    Tombstones tombstones;
    Reads reads;
    Handle root;
    bool keep_slots = false;  // deleted instances keep their slots for undo
    std::vector<Symbol> reserved_names;

    const Class& class_of(const Node& node) const { return classes[node.class_id]; }
    /// Estimated memory of an instance with its ad-hoc properties, without its name and without
    /// what is in `TreeWeight::content` (instances.cpp).
    std::int64_t weight_of(std::uint32_t index) const;
    /// Throws Error(deleted).
    Node& require(Handle handle) {
        Node* node = nodes.find(handle);
        if (node == nullptr) throw_deleted(handle);
        return *node;
    }
    const Node& require(Handle handle) const {
        return const_cast<Instances*>(this)->require(handle);
    }
    void visit_below(std::uint32_t top, const std::function<void(std::uint32_t)>& visit) const;

    /// Pictures show the instance where it is, until the next step (between_steps.h).
    void forget_track(std::uint32_t index) {
        const Node& node = nodes[index];
        if (const auto& columns = stored[node.class_id]) columns->places.forget(node.stored_row);
        if (node.has_ad_hoc) ad_hoc.tracks.erase(index);
    }

    // membership.cpp: checks that arguments belong to this tree and this instance. Throw Error.
    bool has(const Node& node, const Property& property) const {
        return property.owner == &class_of(node) || has_otherwise(node, property);
    }
    const Node& require(Handle handle, const Property& property) const {
        const Node& node = require(handle);
        if (!has(node, property)) [[unlikely]]
            refuse_foreign(handle, property);
        return node;
    }
    void require_own(const Class& of) const;
    void require_event(const Class& of, const Event& event) const;
    /// Throws unless the instance, which must be of this tree, has the event.
    void require_event(Handle instance, const Event& event) const;
    void require_values(Handle instance, const Event& event,
                        const std::vector<Value>& values) const;
    void require_method(Handle handle, const Method& method) const;
    /// Throws if the instance must stay in the place where it was made.
    void require_movable(Handle instance) const;
    /// `levels`: the height of the subtree that is going to be below `parent`.
    void require_room_below(Handle parent, std::size_t levels) const;

    // cells.cpp: the memory of values, without checks.
    Value read(std::uint32_t index, const Node& node, const Property& property) const;
    void write(std::uint32_t index, const Node& node, const Property& property, const Value& value);
    /// Converts the value to the type of that property. Throws as `Tree::set` does.
    Value coerce(Handle instance, const Property& property, const Value& value) const;
    Value coerce_element(Handle instance, const Property& property, std::size_t index,
                         const Value& value) const;
    /// Where the tree itself keeps the value of the property; null if a module keeps it, or if it
    /// is not a `Value` in memory.
    Value* kept_value(std::uint32_t index, const Node& node, const Property& property);
    /// Reports that a setter threw, so the write did not happen. Must be called in the `catch`
    /// block.
    [[noreturn]] void refused(Handle instance, const Property& property) const;

    // names.cpp
    void check_child_name(Handle parent, std::string_view name) const;
    /// Whether `parent` has a child, a property or a method of that name. Below the root, "game" is
    /// taken too, because every path may begin with it.
    bool is_taken(std::uint32_t parent, const NodeName& name) const;
    bool is_reserved(Symbol name) const;
    /// The first free name of `stem`, `stem_2` ...
    NodeName plain_name(std::uint32_t parent, std::string_view stem, PlainNames& given) const;

  private:
    [[noreturn]] void throw_deleted(Handle handle) const;
    bool has_otherwise(const Node& node, const Property& property) const;
    [[noreturn]] void refuse_foreign(Handle handle, const Property& property) const;
};

}  // namespace fettle::property
