#pragma once
// Values for the framework, which goes on while a formula is in error.

#include <string_view>

#include <fettle/property/error.h>
#include <fettle/property/export.h>
#include <fettle/property/tree.h>

FETTLE_PROPERTY_BEGIN

namespace fettle::property {

/// The value of a property; while its formula is in error, the last value that it had. Throws
/// Error(deleted).
inline Value last_value(const Tree& tree, Handle instance, const Property& property) {
    try {
        return tree.get(instance, property);
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::formula) throw;
        return tree.peek(instance, property);
    }
}

/// The same by name. Throws Error(unknown_name), too.
inline Value last_value(const Tree& tree, Handle instance, std::string_view name) {
    return last_value(tree, instance, tree.property(instance, name));
}

}  // namespace fettle::property

FETTLE_PROPERTY_END
