// Adding ad-hoc properties to single instances, and removing them.

#include <algorithm>
#include <optional>

#include <fettle/property/added_rules.h>
#include <fettle/property/path.h>
#include <fettle/property/spelling.h>

#include <values/weight.h>

#include <tree/state.h>

namespace fettle::property {

const Property& Tree::State::ad_hoc_property(Symbol name) {
    const auto known = instances.ad_hoc.descriptors.find(name);
    if (known != instances.ad_hoc.descriptors.end()) return *known->second;
    const Property& made = instances.ad_hoc.declare(name);
    changes.weight.add(weight_of_own_descriptor);
    made.shortcut.set_interest(changes.watchers.interest(made));
    return made;
}

void Tree::State::put_ad_hoc(Handle instance, const Property& added, const Value& value) {
    Node& node = instances.require(instance);
    changes.weight.add(weight_of_own_property + weight_beside(value));
    instances.ad_hoc.of_instance[instance.index].emplace(added.name, std::pair(&added, value));
    node.has_ad_hoc = true;
    formulas.written(instance, node, added, Value());
}

const Property& Tree::State::add_ad_hoc(Handle instance, std::string_view name,
                                        const Value& value) {
    require_changeable("write");
    const Class& of = tree.class_of(instance);
    const auto refuse = [&](ErrorKind kind, const std::string& reason) {
        throw Error(kind, tree.path(instance) + ": " + reason);
    };
    const std::string quoted = "\"" + std::string(name) + "\"";
    if (name.empty()) refuse(ErrorKind::bad_name, "the name of a property cannot be empty");
    check_name_length(name);
    if (name.find('\0') != std::string_view::npos)
        refuse(ErrorKind::bad_name, "the name " + quoted + " holds a zero byte");
    if (of.method(name) != nullptr)
        refuse(ErrorKind::bad_name, quoted + " is a method of " + of.name());
    if (tree.child(instance, name)) refuse(ErrorKind::bad_name, quoted + " is a child here");
    const std::vector<std::string> members = of.member_names();
    const auto near = std::ranges::find_if(members, [&](const std::string& declared) {
        const Property* const property = of.property(declared);
        return misspells(name, value.type(), declared, property ? property->type : Type::nil);
    });
    if (near != members.end())
        refuse(ErrorKind::near_miss,
               of.name() + " has no property " + quoted + " (did you mean \"" + *near + "\"?)");
    // Classes without snapshots (input, for example) could not restore an ad-hoc property.
    if (of.snapshots() == Snapshots::never)
        refuse(ErrorKind::unknown_name, of.name() + " has no property " + quoted +
                                            ", and none can be added to it" +
                                            suggestion(name, members));
    const Property& added = ad_hoc_property(Symbol(name));
    const Value next = instances.coerce(instance, added, value);
    AddedRules* const rules = rules_of(instance);
    if (rules != nullptr) rules->check(instance, name, next);
    put_ad_hoc(instance, added, next);
    changes.notify([&](Observer& o) { o.wrote(instance, added, next); });
    if (changes.recording()) history.edited(instance, added, {});
    if (rules != nullptr) rules->changed(instance, added.name);
    return added;
}

void Tree::set_or_add(Handle instance, std::string_view name, const Value& value) {
    if (const Property* found = find(instance, name)) return set(instance, *found, value);
    if (value.is_nil() && !name.empty() && class_of(instance).method(name) == nullptr &&
        !child(instance, name))
        return;
    state_->add_ad_hoc(instance, name, value);
}

void Tree::remove_ad_hoc(Handle instance, std::string_view name) {
    State& s = *state_;
    Node& node = s.instances.require(instance);
    if (!node.has_ad_hoc) return;
    auto& own = s.instances.ad_hoc.of_instance.at(instance.index);
    const auto found = own.find(std::string(name));
    if (found == own.end()) return;
    s.require_changeable("write");
    const Property* const property = found->second.first;
    const Value old = found->second.second;
    std::optional<CellState> before = s.history.before_edit(instance, *property);
    if (node.has_formula) s.formulas.remove({instance.index, property->symbol});
    own.erase(found);
    s.changes.weight.add(-weight_of_own_property - weight_beside(old));
    if (own.empty()) {
        s.instances.ad_hoc.of_instance.erase(instance.index);
        node.has_ad_hoc = false;
    }
    s.formulas.written(instance, node, *property, old);
    s.changes.notify([&](Observer& o) { o.removed(instance, *property); });
    if (before) s.history.edited(instance, *property, std::move(*before));
    if (AddedRules* rules = s.rules_of(instance)) rules->changed(instance, property->name);
}

}  // namespace fettle::property
