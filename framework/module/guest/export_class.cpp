// Converts a C++ class descriptor to its C form.

#include <algorithm>
#include <iterator>

#include "guest_tree.h"

namespace fettle::module {
namespace {

using property::Binding;
using property::BindingKind;
using property::Property;
using property::Row;
using property::Tree;

fettle_status get(void* context, fettle_row row, fettle_value* value) {
    auto& p = *static_cast<GuestProperty*>(context);
    return p.tree->answer([&] {
        p.tree->outgoing.clear();
        *value = p.tree->outgoing.put(p.binding.get(p.binding.context, row));
    });
}

fettle_status set(void* context, fettle_row row, const fettle_value* value) {
    auto& p = *static_cast<GuestProperty*>(context);
    return p.tree->answer([&] { p.binding.set(p.binding.context, row, received(*value)); });
}

fettle_status reset(void* context, fettle_row row) {
    auto& p = *static_cast<GuestProperty*>(context);
    return p.tree->answer([&] { p.binding.reset(p.binding.context, row); });
}

std::uint32_t overridden(void* context, fettle_row row) {
    auto& p = *static_cast<GuestProperty*>(context);
    bool is = false;
    p.tree->run([&] { is = p.binding.overridden(p.binding.context, row); });
    return is ? 1 : 0;
}

void invalidate(void* context, fettle_row row) {
    auto& p = *static_cast<GuestProperty*>(context);
    p.tree->run([&] { p.binding.invalidate(p.binding.context, row); });
}

void* base(void* context) {
    auto& p = *static_cast<GuestProperty*>(context);
    void* memory = nullptr;
    p.tree->answer([&] { memory = p.binding.base(p.binding.context); });
    return memory;
}

fettle_status call(void* context, fettle_handle self, fettle_row row, const fettle_value* arguments,
                   std::uint32_t count, fettle_result* result) {
    auto& m = *static_cast<GuestMethod*>(context);
    return m.tree->answer([&] {
        const property::List given = received(arguments, count);
        const property::Result answer =
            m.method.call(m.method.context, *m.tree->self, received(self), row, given);
        m.tree->outgoing.clear();
        *result = m.tree->outgoing.put(answer);
    });
}

fettle_status create(void* context, fettle_handle self, fettle_row* row) {
    auto& c = *static_cast<GuestClass*>(context);
    return c.tree->answer(
        [&] { *row = c.lifecycle.create(c.lifecycle.context, *c.tree->self, received(self)); });
}

fettle_status place(void* context, fettle_handle self, fettle_row* row) {
    auto& c = *static_cast<GuestClass*>(context);
    return c.tree->answer([&] {
        *row = c.lifecycle.place(c.lifecycle.context, *c.tree->self, received(self), *row);
    });
}

void destroy(void* context, fettle_handle self, fettle_row row) {
    auto& c = *static_cast<GuestClass*>(context);
    c.tree->run(
        [&] { c.lifecycle.destroy(c.lifecycle.context, *c.tree->self, received(self), row); });
}

template <auto Draw>
void draw(void* context, fettle_handle self, fettle_row row, const fettle_painter* table,
          double alpha) {
    auto& c = *static_cast<GuestClass*>(context);
    c.tree->run([&] {
        GuestPainter painter(*table);
        (c.lifecycle.*Draw)(c.lifecycle.context, *c.tree->self, received(self), row, painter,
                            alpha);
    });
}

void pose(void* context, fettle_handle self, fettle_row row, double alpha, double* matrix) {
    auto& c = *static_cast<GuestClass*>(context);
    c.tree->run([&] {
        const property::Transform at =
            c.lifecycle.pose(c.lifecycle.context, *c.tree->self, received(self), row, alpha);
        const double values[] = {at.x.x, at.x.y, at.y.x, at.y.y, at.origin.x, at.origin.y};
        std::copy(std::begin(values), std::end(values), matrix);
    });
}

std::uint32_t flag(bool set, std::uint32_t bit) {
    return set ? bit : 0u;
}

/// Keeps the data that C descriptors point to until the program has copied it.
struct Texts {
    std::deque<std::vector<const char*>> lists;
    std::deque<std::vector<fettle_field>> fields;
    Outgoing values;

    const char* const* list(const std::vector<std::string>& texts) {
        if (texts.empty()) return nullptr;
        auto& made = lists.emplace_back();
        for (const std::string& text : texts) made.push_back(text.c_str());
        made.push_back(nullptr);
        return made.data();
    }
    fettle_array array(const std::vector<property::Field>& from) {
        auto& made = fields.emplace_back();
        for (const property::Field& field : from)
            made.push_back({.name = field.name.c_str(),
                            .type = static_cast<std::uint32_t>(field.type),
                            .flags = flag(field.nullable, FETTLE_NULLABLE),
                            .unit = field.unit.c_str(),
                            .doc = field.doc.c_str(),
                            .reference_class = field.reference_class.empty()
                                                   ? nullptr
                                                   : field.reference_class.c_str(),
                            .element = static_cast<std::uint32_t>(field.element),
                            .reserved = 0,
                            .min = field.range.bounded() ? field.range.min : 0,
                            .max = field.range.bounded() ? field.range.max : 0});
        return array_of(made);
    }
    template <class Element>
    static fettle_array array_of(const std::vector<Element>& all) {
        return {all.data(), static_cast<std::uint32_t>(all.size()), sizeof(Element)};
    }
};

fettle_property described(Tree::State& tree, const Property& p, Texts& texts) {
    fettle_property c{};
    c.name = p.name.c_str();
    c.type = static_cast<std::uint32_t>(p.type);
    c.flags = module::flags_of(p);
    c.unit = p.unit.c_str();
    c.doc = p.doc.c_str();
    c.default_value = texts.values.put(p.default_value);
    if (p.range.bounded()) c.min = p.range.min, c.max = p.range.max;
    c.enumerators = texts.list(p.enumerators);
    c.derives_from = texts.list(p.derives_from);
    c.reference_class = p.reference_class.empty() ? nullptr : p.reference_class.c_str();
    c.element = static_cast<std::uint32_t>(p.element);
    c.element_weight = p.element_weight;
    const Binding& binding = p.binding;
    if (binding.kind == BindingKind::stored) return c;
    GuestProperty& kept = tree.properties.emplace_back();
    kept.tree = &tree;
    kept.binding = binding;
    c.context = &kept;
    if (binding.kind == BindingKind::column) {
        c.binding = FETTLE_COLUMN;
        c.native = static_cast<std::uint32_t>(binding.native);
        c.stride = static_cast<std::uint32_t>(binding.stride);
        c.base = base;
    } else if (binding.kind == BindingKind::accessor) {
        c.binding = FETTLE_ACCESSOR;
        c.get = get;
        if (binding.set) c.set = set;
    } else {
        throw property::Error(property::ErrorKind::bad_structure,
                              p.name +
                                  ": a value of the tree's own structure cannot be a plugged "
                                  "in module's");
    }
    if (binding.reset) c.reset = reset;
    if (binding.overridden) c.overridden = overridden;
    if (binding.invalidate) c.invalidate = invalidate;
    return c;
}

fettle_method described(Tree::State& tree, const property::Method& method, Texts& texts) {
    GuestMethod& kept = tree.methods.emplace_back();
    kept.tree = &tree;
    kept.method = method;
    return {.name = method.name.c_str(),
            .doc = method.doc.c_str(),
            .parameters = texts.array(method.parameters),
            .returns = texts.array(method.returns),
            .required = static_cast<std::uint32_t>(method.required),
            .effect = method.effect == property::Effect::nothing ? FETTLE_CHANGES_NOTHING
                      : method.effect == property::Effect::tree  ? FETTLE_CHANGES_TREE
                                                                 : FETTLE_CHANGES_MEMORY,
            .many = method.many ? 1u : 0u,
            .reserved = 0,
            .context = &kept,
            .call = call};
}

}  // namespace

void export_class(Tree::State& tree, const property::ClassDescriptor& descriptor,
                  const property::Class& made) {
    Texts texts;
    std::vector<fettle_property> properties;
    std::vector<fettle_method> methods;
    std::vector<fettle_event> events;
    for (const Property& p : descriptor.properties) properties.push_back(described(tree, p, texts));
    for (const property::Method& m : descriptor.methods)
        methods.push_back(described(tree, m, texts));
    for (const property::Event& e : descriptor.events) {
        GuestEvent& kept = tree.events.emplace_back();
        kept.event = made.event(e.name);
        events.push_back({.name = e.name.c_str(),
                          .doc = e.doc.c_str(),
                          .fields = texts.array(e.fields),
                          .tag = &kept.tag});
    }
    GuestClass& kept = tree.lifecycles.emplace_back();
    kept.tree = &tree;
    kept.lifecycle = descriptor.lifecycle;

    fettle_class c{};
    c.struct_size = sizeof c;
    c.flags = (descriptor.creatable ? 0 : FETTLE_NOT_CREATABLE) |
              (descriptor.snapshots == property::Snapshots::natively ? FETTLE_SAVED_NATIVELY : 0);
    c.name = descriptor.name.c_str();
    c.base = descriptor.base.c_str();
    c.doc = descriptor.doc.c_str();
    c.stem = descriptor.stem.empty() ? nullptr : descriptor.stem.c_str();
    c.properties = Texts::array_of(properties);
    c.methods = Texts::array_of(methods);
    c.events = Texts::array_of(events);
    c.context = &kept;
    c.weight = descriptor.weight;
    const property::Lifecycle& lifecycle = descriptor.lifecycle;
    if (lifecycle.create) c.create = create;
    if (lifecycle.place) c.place = place;
    if (lifecycle.destroy) c.destroy = destroy;
    if (lifecycle.draw) c.draw = draw<&property::Lifecycle::draw>;
    if (lifecycle.pose) c.pose = pose;
    if (lifecycle.draw_over) c.draw_over = draw<&property::Lifecycle::draw_over>;
    tree.require(tree.host->define_class(tree.host->self, &c));
}

}  // namespace fettle::module
