// Vectors and lists that stay connected with the property they were read from.

#include <fettle/property/path.h>

#include <limits/limiters.h>
#include <lua/machine.h>
#include <values/values.h>
#include <writes/declarations.h>
#include <writes/writes.h>

namespace fettle::script {

const Property& origin_property(const property::Tree& tree, const Origin& origin) {
    const Class& of = tree.class_of(origin.instance);
    // After loading a saved game, the instance may have another class.
    if (origin.property && of.is_a(*origin.property->owner)) return *origin.property;
    const property::Symbol name = origin.property ? origin.property->symbol : origin.symbol;
    if (const Property* found = tree.find(origin.instance, name)) return *found;
    throw Error(ErrorKind::unknown_name, tree.path(origin.instance) +
                                             property::path_suffix(name.text()) +
                                             ": no such name any more");
}

namespace {

std::vector<property::Segment> segments(const Origin& origin, const char* component) {
    std::vector<property::Segment> part(origin.depth + (component ? 1 : 0));
    for (std::uint32_t i = 0; i < origin.depth; ++i) part[i].key = std::int64_t{origin.part[i]};
    if (component) part.back().key = std::string(component);
    return part;
}

}  // namespace

std::string origin_path(const property::Tree& tree, const Origin& origin) {
    std::string text =
        tree.path(origin.instance) +
        property::path_suffix(origin.property ? origin.property->name : origin.symbol.text());
    for (std::uint32_t i = 0; i < origin.depth; ++i)
        text += "[" + std::to_string(origin.part[i]) + "]";
    return text;
}

Value origin_read(Machine& machine, const Origin& origin) {
    const Property& property = origin_property(machine.tree, origin);
    const Value* seen = machine.declarations.seen(origin.instance, property.name);
    Value whole = seen != nullptr ? *seen : machine.tree.get(origin.instance, property);
    if (whole.is(Type::list)) machine.limiters.budget.charge_quietly(whole.list().size() / 8);
    if (origin.depth == 0) return whole;
    return property::part_of(whole, segments(origin, nullptr), origin_path(machine.tree, origin));
}

void origin_write(Machine& machine, const Origin& origin, const char* component,
                  const Value& value) {
    const Property& property = origin_property(machine.tree, origin);
    const Value* seen = machine.declarations.seen(origin.instance, property.name);
    const Value whole = seen != nullptr ? *seen : machine.tree.get(origin.instance, property);
    if (whole.is(Type::list)) machine.limiters.budget.charge_quietly(whole.list().size());
    write_property(machine, origin.instance, property,
                   property::with_part(whole, segments(origin, component), value,
                                       origin_path(machine.tree, origin)));
}

}  // namespace fettle::script
