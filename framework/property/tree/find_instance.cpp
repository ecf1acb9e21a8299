#include <fettle/property/find_instance.h>

#include <string>
#include <vector>

#include <fettle/property/error.h>
#include <fettle/property/path.h>
#include <fettle/property/spelling.h>
#include <fettle/property/tree.h>

namespace fettle::property {

namespace {

/// The error of a path, one of whose names is neither a child nor a property.
[[noreturn]] void refuse_missing(const Tree& tree, std::string_view path) {
    Handle at = tree.root();
    for (const Segment& segment : parse_path(path)) {
        const auto* const name = std::get_if<std::string>(&segment.key);
        if (name == nullptr) break;
        if (const Handle child = tree.child(at, *name)) {
            at = child;
            continue;
        }
        std::vector<std::string> names;
        for (const Handle each : tree.children(at)) names.push_back(tree.name(each));
        throw Error(ErrorKind::unknown_name, std::string(path) + ": " + tree.path(at) +
                                                 " has no child \"" + *name + "\"" +
                                                 suggestion(*name, names));
    }
    throw Error(ErrorKind::unknown_name, std::string(path) + ": there is no such instance");
}

}  // namespace

Handle find_instance(const Tree& tree, std::string_view path) {
    Place place;
    try {
        place = resolve(tree, path);
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::unknown_name && error.kind() != ErrorKind::near_miss) throw;
        refuse_missing(tree, path);
    }
    if (place.property != nullptr)
        throw Error(ErrorKind::wrong_type,
                    std::string(path) + ": expected an instance, got a property");
    return place.instance;
}

}  // namespace fettle::property
