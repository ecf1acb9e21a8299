#pragma once
// The instances of a tree: their classes, where they hang, and the values of their properties,
// wherever these are.

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <fettle/property/tree.h>

#include <classes/class_registry.h>

#include "ad_hoc.h"
#include "graves.h"
#include "nodes.h"
#include "reads.h"
#include "stored_columns.h"

namespace fettle::property {

struct Instances {
    explicit Instances(Tree& owner) : tree(owner) {}

    Tree& tree;  // for what modules are called with
    ClassRegistry classes;
    Nodes nodes;
    std::vector<std::unique_ptr<StoredColumns>>
        stored;  // by class id; null where a class stores nothing
    AdHoc ad_hoc;
    Graves graves;
    Reads reads;
    Handle root;
    bool keep_slots = false;  // of what is deleted now, so that undo can bring it back

    const Class& class_of(const Node& node) const { return classes[node.class_id]; }
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

    // membership.cpp: what is handed in belongs to this tree, and to that instance. Throw Error.
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
    /// Of an instance of this tree.
    void require_event(Handle instance, const Event& event) const;
    void require_values(Handle instance, const Event& event,
                        const std::vector<Value>& values) const;
    void require_method(Handle handle, const Method& method) const;
    /// Throws where the instance has the place that it was made for.
    void require_movable(Handle instance) const;
    /// What is to hang below has `levels` levels.
    void require_room_below(Handle parent, std::size_t levels) const;

    // cells.cpp: the memory of values, without checks
    Value read(std::uint32_t index, const Node& node, const Property& property) const;
    void write(std::uint32_t index, const Node& node, const Property& property, const Value& value);
    /// What the value becomes as one of that property. Throws as `Tree::set`.
    Value coerce(Handle instance, const Property& property, const Value& value) const;
    /// The setter threw: the write did not happen. Called while the exception is caught.
    [[noreturn]] void refused(Handle instance, const Property& property) const;

    // names.cpp
    void check_child_name(Handle parent, std::string_view name) const;
    /// Throws Error(bad_name). A name of an instance, or of a property that is added to one, is
    /// read by a person.
    static void check_length(std::string_view name);
    /// Whether something of that name is below `parent`: a child, a property or a method.
    bool is_taken(std::uint32_t parent, const NodeName& name) const;
    /// `stem`, `stem_2` ...: the first that is free.
    NodeName plain_name(std::uint32_t parent, std::string_view stem) const;

  private:
    [[noreturn]] void throw_deleted(Handle handle) const;
    bool has_otherwise(const Node& node, const Property& property) const;
    [[noreturn]] void refuse_foreign(Handle handle, const Property& property) const;
};

}  // namespace fettle::property
