// Valid names of instances.

#include <algorithm>

#include <fettle/property/error.h>
#include <fettle/property/path.h>

#include "instances.h"

namespace fettle::property {
namespace {

constexpr std::string_view name_of_root = "game";

}  // namespace

void Instances::check_child_name(Handle parent, std::string_view name) const {
    check_name_length(name);
    const std::string quoted = "\"" + std::string(name) + "\"";
    if (name.empty()) throw Error(ErrorKind::bad_name, "the name of an instance cannot be empty");
    if (name.find('\0') != std::string_view::npos)
        throw Error(ErrorKind::bad_name, (parent ? tree.path(parent) + ": " : std::string()) +
                                             "the name " + quoted + " holds a zero byte");
    if (!parent) return;
    if (parent == root && name == name_of_root)
        throw Error(ErrorKind::bad_name, "\"game\" is the root itself, not a child of it");
    const Class& above = tree.class_of(parent);
    if (above.property(name) != nullptr)
        throw Error(ErrorKind::bad_name, tree.path(parent) + ": a child cannot be called " +
                                             quoted + ", which is a property of " + above.name());
    if (above.method(name) != nullptr)
        throw Error(ErrorKind::bad_name, tree.path(parent) + ": a child cannot be called " +
                                             quoted + ", which is a method of " + above.name());
    if (is_reserved(Symbol::find(name)))
        throw Error(ErrorKind::bad_name, tree.path(parent) + ": a child cannot be called " +
                                             quoted + ", which is a method of every instance");
    if (tree.child(parent, name))
        throw Error(ErrorKind::bad_name, tree.path(parent) + " has a child " + quoted + " already");
    if (tree.find(parent, name) != nullptr)
        throw Error(ErrorKind::bad_name,
                    tree.path(parent) + ": " + quoted + " is a property there; remove it first");
}

bool Instances::is_reserved(Symbol name) const {
    return std::ranges::find(reserved_names, name) != reserved_names.end();
}

bool Instances::is_taken(std::uint32_t parent, const NodeName& name) const {
    if (nodes.child(parent, name) != 0) return true;
    if (parent == root.index && name.number == 0 && name.base.text() == name_of_root) return true;
    const Symbol symbol = Symbol::find(name.text());
    if (!symbol) return false;  // a name without a symbol belongs to no property and no method
    return is_reserved(symbol) || tree.find(nodes.handle(parent), symbol) != nullptr ||
           classes[nodes[parent].class_id].method(symbol) != nullptr;
}

NodeName Instances::plain_name(std::uint32_t parent, std::string_view stem,
                               PlainNames& given) const {
    std::uint32_t& next = given[std::string(stem)];
    NodeName name{Symbol(stem), next};
    while (is_taken(parent, name)) name.number = name.number == 0 ? 2 : name.number + 1;
    next = name.number;
    return name;
}

}  // namespace fettle::property
