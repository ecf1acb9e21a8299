#include "class_in_c.h"

#include <fettle/property/native.h>

namespace fettle::module {

using property::Property;

namespace {

/// The functions of the class.
struct Functions {
    static fettle_status get(void* context, fettle_row row, fettle_value* value) {
        StandInValues& from = StandInValues::in(context);
        from.outgoing.clear();
        *value = from.outgoing.put(from.at(row));
        return FETTLE_OK;
    }

    static fettle_status set(void* context, fettle_row row, const fettle_value* value) {
        StandInValues::in(context).set(row, received(*value));
        return FETTLE_OK;
    }

    static fettle_status reset(void* context, fettle_row row) {
        StandInValues::in(context).reset(row);
        return FETTLE_OK;
    }

    static std::uint32_t overridden(void* context, fettle_row row) {
        return StandInValues::in(context).overridden.contains(row) ? 1 : 0;
    }

    static void* base(void* context) { return StandInValues::in(context).column(); }

    static fettle_status create(void* context, fettle_handle, fettle_row* row) {
        *row = ++static_cast<StandInRows*>(context)->last;
        return FETTLE_OK;
    }

    /// A method does nothing: the module that is replaced is not called any more.
    static fettle_status call(void*, fettle_handle, fettle_row, const fettle_value*, std::uint32_t,
                              fettle_result*) {
        return FETTLE_OK;
    }
};

template <class Element>
fettle_array array_of(const std::vector<Element>& elements) {
    return {elements.data(), static_cast<std::uint32_t>(elements.size()), sizeof(Element)};
}

}  // namespace

ClassInC::ClassInC(const ClassDescription& from, StandInRows& rows,
                   std::deque<StandInValues>& values) {
    const property::ClassDescriptor& d = from.descriptor;
    for (std::size_t i = 0; i < d.properties.size(); ++i) {
        StandInValues& of = values.emplace_back();
        of.rows = &rows;
        properties_.push_back(in_c(d.properties[i], from.bindings[i], of));
    }
    for (const property::Method& method : d.methods) {
        fettle_method& each = methods_.emplace_back();
        each.name = method.name.c_str();
        each.parameters = in_c(method.parameters);
        each.returns = in_c(method.returns);
        each.required = static_cast<std::uint32_t>(method.required);
        each.many = method.many ? 1 : 0;
        each.call = Functions::call;
    }
    for (const property::Event& event : d.events)
        events_.push_back({.name = event.name.c_str(),
                           .doc = nullptr,
                           .fields = in_c(event.fields),
                           .tag = nullptr});
    class_.struct_size = sizeof class_;
    if (!d.creatable) class_.flags |= FETTLE_NOT_CREATABLE;
    if (d.snapshots == property::Snapshots::natively) class_.flags |= FETTLE_SAVED_NATIVELY;
    class_.name = d.name.c_str();
    class_.base = d.base.c_str();
    class_.stem = d.stem.c_str();
    class_.properties = array_of(properties_);
    class_.methods = array_of(methods_);
    class_.events = array_of(events_);
    class_.context = &rows;
    if (!from.create && !from.place && !from.destroy && !from.draw && !from.draw_over && !from.pose)
        return;
    class_.create = Functions::create;
    if (from.draw)
        class_.draw = [](void*, fettle_handle, fettle_row, const fettle_painter*, double) {};
    if (from.draw_over)
        class_.draw_over = [](void*, fettle_handle, fettle_row, const fettle_painter*, double) {};
    if (from.pose) class_.pose = [](void*, fettle_handle, fettle_row, double, double*) {};
}

fettle_property ClassInC::in_c(const Property& property, const BindingDescription& binding,
                               StandInValues& values) {
    fettle_property to{};
    to.name = property.name.c_str();
    to.type = static_cast<std::uint32_t>(property.type);
    to.default_value = outgoing_.put(property.default_value);
    if (binding.is_inherited) return to;
    to.flags = flags_of(property);
    to.unit = property.unit.c_str();
    if (property.range.bounded()) {
        to.min = property.range.min;
        to.max = property.range.max;
    }
    to.enumerators = in_c(property.enumerators);
    to.derives_from = in_c(property.derives_from);
    to.reference_class = property.reference_class.c_str();
    to.element = static_cast<std::uint32_t>(property.element);
    to.binding = binding.declared_binding;
    to.native = binding.declared_native;
    if (to.binding == FETTLE_STORED) return to;
    to.context = &values;
    if (to.binding == FETTLE_COLUMN) {
        values.cell_size = size_of(static_cast<property::Native>(to.native));
        to.base = Functions::base;
    } else {
        to.get = Functions::get;
        if (binding.set) to.set = Functions::set;
    }
    if (binding.reset) to.reset = Functions::reset;
    if (binding.overridden) to.overridden = Functions::overridden;
    return to;
}

fettle_array ClassInC::in_c(const std::vector<property::Field>& fields) {
    std::vector<fettle_field>& to = fields_.emplace_back();
    for (const property::Field& field : fields) {
        fettle_field& each = to.emplace_back();
        each.name = field.name.c_str();
        each.type = static_cast<std::uint32_t>(field.type);
        if (field.nullable) each.flags = FETTLE_NULLABLE;
        each.reference_class = field.reference_class.c_str();
        each.element = static_cast<std::uint32_t>(field.element);
    }
    return array_of(to);
}

const char* const* ClassInC::in_c(const std::vector<std::string>& texts) {
    std::vector<const char*>& to = texts_.emplace_back();
    for (const std::string& text : texts) to.push_back(text.c_str());
    to.push_back(nullptr);
    return to.data();
}

}  // namespace fettle::module
