#include "stand_in.h"

#include "class_in_c.h"

namespace fettle::module {

using property::Binding;
using property::BindingKind;
using property::Class;
using property::Handle;
using property::Property;
using property::Row;
using property::Tree;
using property::Value;

namespace {

Binding binding_of(const BindingDescription& from, StandInValues& context) {
    Binding to;
    to.kind = from.kind;
    to.context = &context;
    if (from.kind == BindingKind::node) {
        to.node_get = [](void* c, const Tree&, Handle self) {
            return StandInValues::in(c).at(self.key());
        };
        if (from.set)
            to.node_set = [](void* c, Tree&, Handle self, const Value& value) {
                StandInValues::in(c).set(self.key(), value);
            };
        return to;
    }
    to.get = [](void* c, Row row) { return StandInValues::in(c).at(row); };
    if (from.set)
        to.set = [](void* c, Row row, const Value& value) { StandInValues::in(c).set(row, value); };
    if (from.reset) to.reset = [](void* c, Row row) { StandInValues::in(c).reset(row); };
    if (from.overridden)
        to.overridden = [](void* c, Row row) {
            return StandInValues::in(c).overridden.contains(row);
        };
    return to;
}

property::Lifecycle lifecycle_of(const ClassDescription& from, StandInRows& context) {
    property::Lifecycle to;
    to.context = &context;
    if (from.create)
        to.create = [](void* c, Tree&, Handle) { return ++static_cast<StandInRows*>(c)->last; };
    if (from.place) to.place = [](void*, Tree&, Handle, Row row) { return row; };
    if (from.destroy) to.destroy = [](void*, Tree&, Handle, Row) {};
    if (from.draw) to.draw = [](void*, const Tree&, Handle, Row, property::Painter&, double) {};
    if (from.draw_over)
        to.draw_over = [](void*, const Tree&, Handle, Row, property::Painter&, double) {};
    if (from.pose)
        to.pose = [](void*, const Tree&, Handle, Row, double) { return property::Transform{}; };
    return to;
}

}  // namespace

StandIn::StandIn(Tree& tree, const TreeDescription& from, HostTable& host,
                 std::vector<std::unique_ptr<BridgedClass>>& reloaded)
    : tree_(tree) {
    tree.set_step(from.step);
    for (const ClassDescription& each : from.classes) {
        if (each.reloaded)
            reloaded.push_back(bridge(each, host));
        else
            define(each);
    }
    make_instances(from.instances);
}

void StandIn::define(const ClassDescription& from) {
    property::ClassDescriptor descriptor = from.descriptor;
    for (std::size_t i = 0; i < descriptor.properties.size(); ++i) {
        Property& property = descriptor.properties[i];
        const BindingDescription& binding = from.bindings[i];
        if (binding.is_inherited) {
            property = {.name = property.name,
                        .type = property.type,
                        .default_value = property.default_value,
                        .doc = property.doc};
        } else if (binding.kind != BindingKind::stored) {
            StandInValues& kept = values_.emplace_back();
            property.binding = binding_of(binding, kept);
            by_context_[&kept] = &kept;
        }
    }
    for (property::Method& method : descriptor.methods) {
        StandInAnswer& answer = answers_.emplace_back();
        answer.returns = method.returns;
        answer.many = method.many;
        method.context = &answer;
        method.call = [](void* context, Tree& tree, Handle, Row, std::span<const Value>) {
            return static_cast<const StandInAnswer*>(context)->get(tree);
        };
    }
    descriptor.lifecycle = lifecycle_of(from, rows_);
    descriptor.makes_base_rows = descriptor.lifecycle.any();
    const Class& made = tree_.define(std::move(descriptor));
    for (std::size_t i = 0; i < from.bindings.size(); ++i) {
        if (from.bindings[i].is_inherited) continue;
        const Property& property = *made.property(from.descriptor.properties[i].name);
        if (const auto kept = by_context_.find(property.binding.context); kept != by_context_.end())
            kept->second->default_value = property.default_value;
    }
}

std::unique_ptr<BridgedClass> StandIn::bridge(const ClassDescription& from, HostTable& host) {
    const std::size_t before = values_.size();
    const ClassInC in_c(from, rows_, values_);
    auto made = std::make_unique<BridgedClass>(host, in_c.get());
    for (std::size_t i = 0; i < from.bindings.size(); ++i) {
        const Property& property = *made->declared().property(from.descriptor.properties[i].name);
        if (made->find(property) == nullptr || from.bindings[i].is_inherited) continue;
        StandInValues& kept = values_[before + i];
        kept.default_value = property.default_value;
        by_context_[property.binding.context] = &kept;
    }
    return made;
}

void StandIn::make_instances(const std::vector<InstanceDescription>& from) {
    const std::vector<const Class*> classes = tree_.classes();
    std::vector<Handle> made;
    for (const InstanceDescription& each : from) {
        Handle instance = tree_.root();
        if (!made.empty()) {
            const Class& of = *classes.at(each.of);
            const bool below = each.parent != InstanceDescription::none;
            instance = tree_.create(of, below ? made.at(each.parent) : Handle{}, each.name);
            if (of.lifecycle().create == nullptr) tree_.set_row(instance, ++rows_.last);
        }
        made.push_back(instance);
        handles_[each.handle.key()] = instance;
    }
    for (std::size_t i = 0; i < from.size(); ++i) set_values(from[i], made[i]);
}

void StandIn::set_values(const InstanceDescription& from, Handle to) {
    const auto& properties = tree_.class_of(to).properties();
    for (const ValueDescription& each : from.values)
        set_value(to, *properties.at(each.property), translated(each.value), each.overridden);
    for (const auto& [name, value] : from.ad_hoc) {
        try {
            tree_.set_or_add(to, name, translated(value));
        } catch (const property::Error&) {  // a name that only another tree allows
        }
    }
    for (const std::string& name : from.listened)
        if (const property::Event* event = tree_.class_of(to).event(name))
            tree_.on(to, *event, [](const property::Occurrence&) {});
}

void StandIn::set_value(Handle to, const Property& property, const Value& value, bool overridden) {
    const auto found = by_context_.find(property.binding.context);
    if (property.binding.kind == BindingKind::stored || found == by_context_.end()) {
        try {
            tree_.set(to, property, value);
        } catch (const property::Error&) {  // only its owner writes it
        }
        return;
    }
    StandInValues& kept = *found->second;
    if (kept.cell_size != 0)
        return property.binding.set(property.binding.context, tree_.row(to), value);
    const std::uint64_t key =
        property.binding.kind == BindingKind::node ? to.key() : std::uint64_t{tree_.row(to)};
    kept.all[key] = value;
    if (overridden) kept.overridden.insert(key);
}

Value StandIn::translated(const Value& value) const {
    if (value.is(property::Type::list)) {
        property::List list;
        for (const Value& each : value.list()) list.push_back(translated(each));
        return list;
    }
    if (!value.is(property::Type::reference)) return value;
    const auto found = handles_.find(value.reference().key());
    return found == handles_.end() ? Handle{} : found->second;
}

}  // namespace fettle::module
