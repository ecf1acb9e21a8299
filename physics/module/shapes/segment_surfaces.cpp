// Chain: surfaces of its segments, as one list for each value.

#include <bindings/bindings.h>
#include <shapes/shape_classes.h>

namespace fettle::physics_module {
namespace {

using physics::SegmentSurface;
using property::List;

/// The library has a number for the material of the shape, which the tree shows as -1.
constexpr std::int64_t material_of_shape = -1;
constexpr std::int64_t last_material = physics::surface_of_shape.material - 1;

template <class Number>
Value to_tree(Number given) {
    if constexpr (std::is_same_v<Number, std::uint16_t>)
        return given == physics::surface_of_shape.material ? material_of_shape
                                                           : static_cast<std::int64_t>(given);
    else
        return static_cast<double>(given);
}

template <class Number>
Number from_tree(const Value& value) {
    if constexpr (std::is_same_v<Number, std::uint16_t>)
        return value.integer() == material_of_shape ? physics::surface_of_shape.material
                                                    : static_cast<Number>(value.integer());
    else
        return static_cast<Number>(value.number());
}

/// One value of the surfaces of all segments. Values after the last own value are left out.
template <auto Member>
Binding of_segments(Hosting& hosting) {
    using Number = std::remove_cvref_t<decltype(physics::surface_of_shape.*Member)>;
    const auto get = [](Hosting& h, Row row) -> Value {
        List list;
        std::size_t own = 0;
        for (const SegmentSurface& surface : h.shape(row).segment_surface_overrides()) {
            list.push_back(to_tree<Number>(surface.*Member));
            if (surface.*Member != physics::surface_of_shape.*Member) own = list.size();
        }
        list.resize(own);
        return list;
    };
    const auto set = [](Hosting& h, Row row, const Value& value) {
        physics::Shape chain = h.shape(row);
        const List& list = value.list();
        const std::size_t count = chain.segment_count();
        if (list.size() > count)
            throw property::Error(property::ErrorKind::out_of_range,
                                  "expected at most " + std::to_string(count) +
                                      " values, one for each segment of the chain, got " +
                                      std::to_string(list.size()));
        std::vector<SegmentSurface> surfaces = chain.segment_surface_overrides();
        surfaces.resize(count, physics::surface_of_shape);
        for (std::size_t i = 0; i < count; ++i)
            surfaces[i].*Member =
                i < list.size() ? from_tree<Number>(list[i]) : physics::surface_of_shape.*Member;
        chain.set_segment_surfaces(surfaces);
    };
    return accessor(hosting, get, set);
}

Property list(std::string name, std::string unit, std::string doc, Binding binding) {
    return {.name = std::move(name),
            .type = Type::list,
            .default_value = List{},
            .unit = std::move(unit),
            .doc = std::move(doc),
            .binding = binding,
            .infinity = true,
            .element = Type::number,
            .single_precision = true};
}

}  // namespace

std::vector<Property> surfaces_of_segments(Hosting& hosting) {
    Property material =
        list("segment_material", "",
             "Material of each segment, from 0 to 65534; -1, or no value: that of the chain.",
             of_segments<&SegmentSurface::material>(hosting));
    material.element = Type::integer;
    material.range = {.min = material_of_shape, .max = static_cast<double>(last_material)};
    material.infinity = material.single_precision = false;
    return {
        within(not_negative,
               list("segment_friction", "",
                    "Friction of each segment, in the order of the points: {0.6, 0} makes the "
                    "second one ice. Infinity, or no value: that of the chain. A value stays with "
                    "the number of its segment when points change.",
                    of_segments<&SegmentSurface::friction>(hosting))),
        within(not_negative,
               list("segment_restitution", "",
                    "Restitution of each segment, from 0 to 1; infinity, or no value: that of the "
                    "chain.",
                    of_segments<&SegmentSurface::restitution>(hosting))),
        within(not_negative,
               list("segment_rolling_resistance", "",
                    "Resistance to rolling of each segment; infinity, or no value: that of the "
                    "chain.",
                    of_segments<&SegmentSurface::rolling_resistance>(hosting))),
        list("segment_surface_speed", "m/s",
             "Speed of the surface of each segment, against the order of the points; infinity, or "
             "no value: that of the chain.",
             of_segments<&SegmentSurface::surface_speed>(hosting)),
        std::move(material)};
}

}  // namespace fettle::physics_module
