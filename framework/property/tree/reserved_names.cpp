#include <fettle/property/reserved_names.h>

#include <algorithm>

#include <fettle/property/error.h>
#include <fettle/property/tree.h>

#include "state.h"

namespace fettle::property {

namespace {

/// Throws Error(bad_name) if the member would hide what the name means at every instance.
void require_free(const std::vector<Symbol>& reserved, const std::string& of, const char* kind,
                  const std::string& name) {
    if (std::ranges::find(reserved, Symbol::find(name)) != reserved.end())
        throw Error(ErrorKind::bad_name, of + "." + name + ": is a method of every instance; a " +
                                             kind + " needs another name");
}

}  // namespace

void require_free_names(const std::vector<Symbol>& reserved, const ClassDescriptor& descriptor) {
    if (reserved.empty() || !descriptor.creatable) return;
    for (const Property& property : descriptor.properties)
        require_free(reserved, descriptor.name, "property", property.name);
    for (const Method& method : descriptor.methods)
        require_free(reserved, descriptor.name, "method", method.name);
}

void reserve_names(Tree& tree, const std::vector<std::string>& names) {
    const std::vector<Symbol> wanted(names.begin(), names.end());
    for (const Class* of : tree.classes()) {
        // The members of Object are those of every instance, and those of a service mean its own.
        if (of->base() == nullptr || !of->creatable()) continue;
        for (const Property* property : of->properties())
            if (property->owner == of) require_free(wanted, of->name(), "property", property->name);
        for (const Method* method : of->methods())
            if (method->owner == of) require_free(wanted, of->name(), "method", method->name);
    }
    std::vector<Symbol>& reserved = tree.state().instances.reserved_names;
    reserved = wanted;
}

}  // namespace fettle::property
