// Access to the memory of values through the bindings of their properties.

#include <cstring>
#include <stdexcept>

#include <fettle/property/error.h>
#include <fettle/property/exception_text.h>

#include <classes/coerce.h>

#include "instances.h"

namespace fettle::property {
namespace {

template <class T>
T load(const std::byte* at) {
    T value;
    std::memcpy(&value, at, sizeof value);
    return value;
}

template <class T>
void store(std::byte* at, const T& value) {
    std::memcpy(at, &value, sizeof value);
}

Value read_column(const Property& property, const std::byte* at) {
    switch (property.binding.native) {
        case Native::f32:
            return static_cast<double>(load<float>(at));
        case Native::f64:
            return load<double>(at);
        case Native::i32:
            return static_cast<std::int64_t>(load<std::int32_t>(at));
        case Native::i64:
            return load<std::int64_t>(at);
        case Native::boolean:
            return load<bool>(at);
        case Native::vec2f:
            return Vec2(load<float>(at), load<float>(at + sizeof(float)));
        case Native::vec2d:
            return Vec2(load<double>(at), load<double>(at + sizeof(double)));
        case Native::color:
            return load<Color>(at);
        case Native::enumeration: {
            const auto index = load<std::uint8_t>(at);
            return index < property.enumerator_values.size() ? property.enumerator_values[index]
                                                             : Value();
        }
    }
    return {};
}

void write_column(const Property& property, std::byte* at, const Value& value) {
    switch (property.binding.native) {
        case Native::f32:
            return store(at, static_cast<float>(value.number()));
        case Native::f64:
            return store(at, value.number());
        case Native::i32:
            return store(at, static_cast<std::int32_t>(value.integer()));
        case Native::i64:
            return store(at, value.integer());
        case Native::boolean:
            return store(at, value.boolean());
        case Native::vec2f:
            store(at, static_cast<float>(value.vec2().x));
            return store(at + sizeof(float), static_cast<float>(value.vec2().y));
        case Native::vec2d:
            store(at, value.vec2().x);
            return store(at + sizeof(double), value.vec2().y);
        case Native::color:
            return store(at, value.color());
        case Native::enumeration:
            return store(at, static_cast<std::uint8_t>(property.enumerator_index(value.text())));
    }
}

std::byte* cell_of(const Binding& binding, Row row) {
    return binding.base(binding.context) + static_cast<std::size_t>(row) * binding.stride;
}

struct CellName {
    const Tree& tree;
    Handle instance;
    const Property& property;
};

std::string path_of_cell(const void* what) {
    const auto& cell = *static_cast<const CellName*>(what);
    return cell.tree.path(cell.instance, cell.property);
}

}  // namespace

Value Instances::read(std::uint32_t index, const Node& node, const Property& property) const {
    const Binding& binding = property.binding;
    switch (binding.kind) {
        case BindingKind::column:
            return read_column(property, cell_of(binding, node.row));
        case BindingKind::accessor:
            return binding.get(binding.context, node.row);
        case BindingKind::stored:
            return stored[node.class_id]->get(property, node.stored_row);
        case BindingKind::node:
            return binding.node_get(binding.context, tree, nodes.handle(index));
        case BindingKind::ad_hoc: {
            if (!node.has_ad_hoc) return {};
            const AdHoc::Entry* own = ad_hoc.find(index, property.name);
            return own == nullptr ? Value() : own->second;
        }
    }
    return {};
}

void Instances::write(std::uint32_t index, const Node& node, const Property& property,
                      const Value& value) {
    const Binding& binding = property.binding;
    switch (binding.kind) {
        case BindingKind::column:
            // A setter takes precedence over a plain store: it may refuse the value, and it stores
            // the value itself.
            if (binding.set != nullptr)
                binding.set(binding.context, node.row, value);
            else
                write_column(property, cell_of(binding, node.row), value);
            break;
        case BindingKind::accessor:
            binding.set(binding.context, node.row, value);
            break;
        case BindingKind::stored:
            stored[node.class_id]->set(property, node.stored_row, value);
            break;
        case BindingKind::node:
            binding.node_set(binding.context, tree, nodes.handle(index), value);
            break;
        case BindingKind::ad_hoc:
            ad_hoc.of_instance.at(index).at(property.name).second = value;
            break;
    }
    if (binding.invalidate != nullptr) binding.invalidate(binding.context, nodes[index].row);
}

Value Instances::coerce(Handle instance, const Property& property, const Value& value) const {
    const CellName cell{tree, instance, property};
    return coerce_value(property, value, {.tree = &tree, .path = &path_of_cell, .what = &cell});
}

Value Instances::coerce_element(Handle instance, const Property& property, std::size_t index,
                                const Value& value) const {
    const CellName cell{tree, instance, property};
    return property::coerce_element(property, index, value,
                                    {.tree = &tree, .path = &path_of_cell, .what = &cell});
}

Value* Instances::kept_value(std::uint32_t index, const Node& node, const Property& property) {
    if (property.binding.kind == BindingKind::stored)
        return stored[node.class_id]->find<Value>(property, node.stored_row);
    if (property.binding.kind != BindingKind::ad_hoc || !node.has_ad_hoc) return nullptr;
    return ad_hoc.find_value(index, property.name);
}

[[gnu::cold, gnu::noinline]] void Instances::refused(Handle instance,
                                                     const Property& property) const {
    try {
        throw;
    } catch (const std::invalid_argument& refusal) {
        // A library that also works without the tree may name the property itself.
        std::string_view reason = refusal.what();
        const std::string named = property.name + ": ";
        if (reason.starts_with(named)) reason.remove_prefix(named.size());
        throw Error(ErrorKind::rejected,
                    tree.path(instance, property) + ": " + std::string(reason));
    } catch (const std::exception&) {
        throw;
    } catch (...) {
        throw Error(ErrorKind::rejected, tree.path(instance, property) + ": " + exception_text());
    }
}

}  // namespace fettle::property
