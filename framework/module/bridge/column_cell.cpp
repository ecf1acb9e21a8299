#include "column_cell.h"

#include <algorithm>
#include <cstring>
#include <stdexcept>

#include <fettle/property/native.h>
#include <fettle/property/spelling.h>

namespace fettle::module {

using property::Binding;
using property::Native;
using property::Row;
using property::Value;
using property::Vec2;

namespace {

std::byte* cell(const BridgedProperty& p, Row row) {
    const std::size_t stride =
        p.native.stride != 0 ? p.native.stride : size_of(static_cast<Native>(p.native.native));
    const Running running(p.named, "base");
    auto* const base = static_cast<std::byte*>(p.native.base(p.native.context));
    if (base == nullptr) [[unlikely]] {
        const std::string reason = p.host->take_reason();
        throw property::Error(property::ErrorKind::rejected,
                              p.declared->owner->name() + "." + p.declared->name + ": " +
                                  (reason.empty() ? "it has no memory: the `base` of its column "
                                                    "gave a null pointer"
                                                  : reason));
    }
    return base + row * stride;
}

template <class Element>
Element load(const std::byte* from) {
    Element element;
    std::memcpy(&element, from, sizeof element);
    return element;
}

template <class Element>
void store(std::byte* to, const Element& element) {
    std::memcpy(to, &element, sizeof element);
}

template <class Number>
struct Pair {
    Number x, y;
};

Value read(const BridgedProperty& p, const std::byte* from) {
    switch (static_cast<Native>(p.native.native)) {
        case Native::f32:
            return load<float>(from);
        case Native::f64:
            return load<double>(from);
        case Native::i32:
            return load<std::int32_t>(from);
        case Native::i64:
            return load<std::int64_t>(from);
        case Native::boolean:
            return load<std::uint8_t>(from) != 0;
        case Native::vec2f: {
            const auto v = load<Pair<float>>(from);
            return Vec2(v.x, v.y);
        }
        case Native::vec2d: {
            const auto v = load<Pair<double>>(from);
            return Vec2(v.x, v.y);
        }
        case Native::color:
            return load<property::Color>(from);
        case Native::enumeration: {
            const auto& names = p.declared->enumerator_values;
            const std::size_t index = load<std::uint8_t>(from);
            return index < names.size() ? names[index] : p.declared->default_value;
        }
    }
    return {};
}

void write(const BridgedProperty& p, std::byte* to, const Value& value) {
    switch (static_cast<Native>(p.native.native)) {
        case Native::f32:
            return store(to, static_cast<float>(value.as_double()));
        case Native::f64:
            return store(to, value.as_double());
        case Native::i32:
            return store(to, static_cast<std::int32_t>(value.integer()));
        case Native::i64:
            return store(to, value.integer());
        case Native::boolean:
            return store(to, static_cast<std::uint8_t>(value.boolean()));
        case Native::vec2f:
            return store(to, Pair<float>{static_cast<float>(value.vec2().x),
                                         static_cast<float>(value.vec2().y)});
        case Native::vec2d:
            return store(to, Pair<double>{value.vec2().x, value.vec2().y});
        case Native::color:
            return store(to, value.color());
        case Native::enumeration:
            return store(to, static_cast<std::uint8_t>(
                                 std::max(0, p.declared->enumerator_index(value.text()))));
    }
}

Value get_cell(void* context, Row row) {
    const auto& p = *static_cast<BridgedProperty*>(context);
    return p.removed ? p.declared->default_value : read(p, cell(p, row));
}

void set_cell(void* context, Row row, const Value& value) {
    const auto& p = *static_cast<BridgedProperty*>(context);
    if (p.removed) throw std::invalid_argument("the module that is loaded now does not have it");
    write(p, cell(p, row), value);
}

}  // namespace

void bind_column(property::Property& property, BridgedProperty& kept) {
    const auto wrong = [&](const std::string& what) {
        return property::Error(property::ErrorKind::bad_structure, property.name + ": " + what);
    };
    if (kept.native.base == nullptr) throw wrong("a column needs a base");
    if (kept.native.native > FETTLE_ENUM8)
        throw wrong("there is no native type number " + std::to_string(kept.native.native));
    const auto native = static_cast<Native>(kept.native.native);
    if (type_of(native) != property.type ||
        (native == Native::enumeration && property.enumerators.empty()))
        throw wrong(property::with_article(property::type_name(property.type)) +
                    " does not lie in a column of that native type");
    const std::size_t stride = kept.native.stride;
    if (stride != 0 && (stride < size_of(native) || stride > property::largest_stride))
        throw wrong("its column has a stride of " + std::to_string(stride) + " bytes, expected " +
                    std::to_string(size_of(native)) + " to " +
                    std::to_string(property::largest_stride));
    property.single_precision |= native == Native::f32 || native == Native::vec2f;
    if (native == Native::i32) {  // values outside its range are refused, not wrapped
        property.range.min = std::max(property.range.min, -0x1p31);
        property.range.max = std::min(property.range.max, 0x1p31 - 1);
    }
    Binding& binding = property.binding;
    binding.kind = property::BindingKind::accessor;
    binding.context = &kept;
    binding.get = get_cell;
    binding.set = set_cell;
}

}  // namespace fettle::module
