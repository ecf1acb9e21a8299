#include "tree_description.h"

#include <algorithm>
#include <unordered_map>
#include <unordered_set>

#include "../bridge/class_bridge.h"

namespace fettle::module {

using property::Binding;
using property::BindingKind;
using property::Class;
using property::Handle;
using property::Lifecycle;
using property::Property;
using property::Tree;
using property::Type;
using property::Value;

namespace {

/// Whether the value may be given as the default of a class: a range does not apply to the value
/// that a property without a default begins with.
bool in_range(const Property& property, const Value& value) {
    if (value.is_numeric()) return property.range.contains(value.as_double());
    if (value.is(Type::vec2)) return property.range.contains(value.vec2());
    return !value.is(Type::reference);
}

BindingDescription described(const Property& property, const Class& of,
                             const BridgedProperty* native) {
    const Binding& binding = property.binding;
    BindingDescription to;
    const Property* inherited =
        of.base() == nullptr ? nullptr : of.base()->property(property.symbol);
    to.is_inherited = inherited != nullptr && inherited->binding.kind == binding.kind &&
                      inherited->binding.context == binding.context;
    to.kind = binding.kind == BindingKind::column ? BindingKind::accessor : binding.kind;
    to.set = binding.set != nullptr || binding.node_set != nullptr ||
             binding.kind == BindingKind::column;
    to.reset = binding.reset != nullptr;
    to.overridden = binding.overridden != nullptr;
    if (native != nullptr) {
        to.declared_binding = native->native.binding;
        to.declared_native = native->native.native;
    }
    return to;
}

ClassDescription described(const Class& of, const BridgedClass* reloaded) {
    ClassDescription to;
    property::ClassDescriptor& d = to.descriptor;
    d.name = of.name();
    d.base = of.base() == nullptr ? "" : of.base()->name();
    d.doc = of.doc();
    d.stem = of.stem();
    d.creatable = of.creatable();
    d.snapshots = of.snapshots();
    to.reloaded = reloaded != nullptr;
    // As the module has declared it: the class may be saved so only because its base is.
    if (reloaded != nullptr && !reloaded->saved_natively())
        d.snapshots = property::Snapshots::by_value;
    for (const Property* property : of.properties()) {
        if (property->owner != &of) continue;
        to.bindings.push_back(
            described(*property, of, reloaded == nullptr ? nullptr : reloaded->find(*property)));
        Property& copy = d.properties.emplace_back(*property);
        copy.single_precision = property->precision() == property::Precision::single_precision;
        if (!in_range(copy, copy.default_value)) copy.default_value = {};
    }
    for (const property::Method* method : of.methods())
        if (method->owner == &of) d.methods.push_back(*method);
    for (const property::Event* event : of.events())
        if (event->owner == &of) d.events.push_back(*event);
    const Lifecycle& life = of.lifecycle();
    if (of.base() != nullptr && &life == &of.base()->lifecycle()) return to;
    to.create = life.create != nullptr;
    to.place = life.place != nullptr;
    to.destroy = life.destroy != nullptr;
    to.draw = life.draw != nullptr || life.begin_below != nullptr;
    to.draw_over = life.draw_over != nullptr;
    to.pose = life.pose != nullptr;
    return to;
}

/// The value in its owner's memory; the default if it cannot be read.
Value value_of(const Tree& tree, Handle instance, const Property& property) {
    try {
        return tree.peek(instance, property);
    } catch (const std::exception&) {
        return property.default_value;
    }
}

class InstanceList {
  public:
    InstanceList(const Tree& tree, std::vector<InstanceDescription>& to) : tree_(tree), to_(to) {}

    void add_below(Handle top) {
        add(top);
        tree_.each_below(top, [&](Handle instance) { add(instance); });
    }

  private:
    void add(Handle instance) {
        if (!numbers_.emplace(instance.key(), static_cast<std::uint32_t>(to_.size())).second)
            return;
        InstanceDescription to;
        const Class& of = tree_.class_of(instance);
        to.handle = instance;
        if (const auto above = numbers_.find(tree_.parent(instance).key()); above != numbers_.end())
            to.parent = above->second;
        to.of = of.id();
        to.name = tree_.name(instance);
        const auto& properties = of.properties();
        for (std::size_t i = 0; i < properties.size(); ++i) {
            const Property& property = *properties[i];
            if (property.owner->base() == nullptr) continue;  // names and places: part of the tree
            const bool overridden =
                property.binding.overridden != nullptr && tree_.overridden(instance, property);
            Value value = value_of(tree_, instance, property);
            if (overridden || !(value == property.default_value))
                to.values.push_back({static_cast<std::uint32_t>(i), overridden, std::move(value)});
        }
        for (const Property* property : tree_.ad_hoc(instance))
            to.ad_hoc.emplace_back(property->name, value_of(tree_, instance, *property));
        for (const property::Event* event : of.events())
            if (event->listeners != 0 && tree_.listens(instance, *event))
                to.listened.push_back(event->name);
        to_.push_back(std::move(to));
    }

    const Tree& tree_;
    std::vector<InstanceDescription>& to_;
    std::unordered_map<std::uint64_t, std::uint32_t> numbers_;  // by `Handle::key`
};

// --- Bytes. One function for each structure passes its fields to a writer or a reader.

class Writer {
  public:
    explicit Writer(property::ByteWriter& to) : to_(to) {}
    template <class T>
    requires std::is_scalar_v<T>
    void operator()(const T& value) { to_.put(value); }
    void operator()(const std::string& text) { to_.put(text); }
    void operator()(const Value& value) { to_.put(value); }
    void operator()(const Handle& handle) { to_.put(handle); }
    template <class T>
    void operator()(const std::vector<T>& list) {
        to_.put(std::uint64_t{list.size()});
        for (const T& each : list) item(each);
    }

  private:
    template <class T>
    void item(const T& each) {
        if constexpr (std::is_same_v<T, std::string>)
            (*this)(each);
        else
            fields(*this, const_cast<T&>(each));  // a writer changes nothing
    }
    property::ByteWriter& to_;
};

class Reader {
  public:
    explicit Reader(property::ByteReader& from) : from_(from) {}
    template <class T>
    requires std::is_scalar_v<T>
    void operator()(T& value) { value = from_.get<T>(); }
    void operator()(std::string& text) { text = from_.text(); }
    void operator()(Value& value) { value = from_.value(); }
    void operator()(Handle& handle) { handle = from_.get<Handle>(); }
    template <class T>
    void operator()(std::vector<T>& list) {
        list.resize(from_.count());
        for (T& each : list) {
            if constexpr (std::is_same_v<T, std::string>)
                (*this)(each);
            else
                fields(*this, each);
        }
    }

  private:
    property::ByteReader& from_;
};

template <class Bytes>
void fields(Bytes& bytes, property::Field& f) {
    bytes(f.name), bytes(f.type), bytes(f.unit), bytes(f.doc), bytes(f.reference_class);
    bytes(f.element), bytes(f.nullable), bytes(f.range.min), bytes(f.range.max);
}

template <class Bytes>
void fields(Bytes& bytes, Property& p) {
    bytes(p.name), bytes(p.type), bytes(p.default_value), bytes(p.unit), bytes(p.range.min);
    bytes(p.range.max), bytes(p.doc), bytes(p.read_only), bytes(p.transient), bytes(p.simulated);
    bytes(p.clamp), bytes(p.infinity), bytes(p.nullable), bytes(p.any_type), bytes(p.hidden);
    bytes(p.sparse), bytes(p.bits), bytes(p.single_precision), bytes(p.enumerators);
    bytes(p.element), bytes(p.reference_class), bytes(p.derives_from);
}

template <class Bytes>
void fields(Bytes& bytes, property::Method& m) {
    bytes(m.name), bytes(m.parameters), bytes(m.required), bytes(m.returns), bytes(m.many);
    bytes(m.doc), bytes(m.effect);
}

template <class Bytes>
void fields(Bytes& bytes, property::Event& e) {
    bytes(e.name), bytes(e.fields), bytes(e.doc);
}

template <class Bytes>
void fields(Bytes& bytes, BindingDescription& b) {
    bytes(b.kind), bytes(b.set), bytes(b.reset), bytes(b.overridden), bytes(b.is_inherited);
    bytes(b.declared_binding), bytes(b.declared_native);
}

template <class Bytes>
void fields(Bytes& bytes, ClassDescription& c) {
    property::ClassDescriptor& d = c.descriptor;
    bytes(d.name), bytes(d.base), bytes(d.doc), bytes(d.creatable), bytes(d.snapshots);
    bytes(d.properties), bytes(d.methods), bytes(d.events), bytes(d.stem);
    bytes(c.bindings), bytes(c.reloaded);
    bytes(c.create), bytes(c.place), bytes(c.destroy), bytes(c.draw), bytes(c.draw_over);
    bytes(c.pose);
}

template <class Bytes>
void fields(Bytes& bytes, ValueDescription& v) {
    bytes(v.property), bytes(v.overridden), bytes(v.value);
}

template <class Bytes>
void fields(Bytes& bytes, std::pair<std::string, Value>& v) {
    bytes(v.first), bytes(v.second);
}

template <class Bytes>
void fields(Bytes& bytes, InstanceDescription& i) {
    bytes(i.handle), bytes(i.parent), bytes(i.of), bytes(i.name), bytes(i.values);
    bytes(i.ad_hoc), bytes(i.listened);
}

template <class Bytes>
void fields(Bytes& bytes, TreeDescription& t) {
    bytes(t.step), bytes(t.classes), bytes(t.instances);
}

}  // namespace

TreeDescription described(const Tree& tree, const std::vector<const BridgedClass*>& reloaded) {
    TreeDescription to;
    to.step = tree.step();
    const Tree empty;
    const std::vector<const Class*> classes = tree.classes();
    for (std::size_t i = empty.classes().size(); i < classes.size(); ++i) {
        const auto own = std::find_if(reloaded.begin(), reloaded.end(),
                                      [&](const auto* c) { return &c->declared() == classes[i]; });
        to.classes.push_back(described(*classes[i], own == reloaded.end() ? nullptr : *own));
    }
    InstanceList list(tree, to.instances);
    list.add_below(tree.root());
    std::unordered_set<std::uint64_t> tops = {tree.root().key()};
    for (const BridgedClass* c : reloaded)
        for (const auto& [index, generation] : c->instances()) {
            Handle top{index, generation};
            while (tree.parent(top)) top = tree.parent(top);
            if (tops.insert(top.key()).second) list.add_below(top);
        }
    return to;
}

void write(property::ByteWriter& to, const TreeDescription& tree) {
    Writer writer(to);
    fields(writer, const_cast<TreeDescription&>(tree));  // a writer changes nothing
}

TreeDescription read_tree(property::ByteReader& from) {
    TreeDescription tree;
    Reader reader(from);
    fields(reader, tree);
    return tree;
}

}  // namespace fettle::module
