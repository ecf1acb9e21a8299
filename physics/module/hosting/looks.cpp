#include <hosting/looks.h>

#include <hosting/hosting.h>

namespace fettle::physics_module {

property::Color default_fill(physics::BodyType type) {
    if (type == physics::BodyType::static_body) return {0.45f, 0.50f, 0.57f, 1.0f};
    if (type == physics::BodyType::kinematic_body) return {0.85f, 0.62f, 0.30f, 1.0f};
    return {0.38f, 0.62f, 0.92f, 1.0f};
}

property::Color default_border(property::Color fill) {
    constexpr float shade = 0.45f;
    return {shade * fill.r, shade * fill.g, shade * fill.b, fill.a};
}

property::Color Hosting::fill_of(Row row) {
    HostedWorld& in = hosted(row);
    if (const Look look = in.looks.get(slot_of(row)); look.fill) return *look.fill;
    const physics::Body owner = shape(row).body();
    if (!owner) return default_fill(physics::BodyType::dynamic_body);
    if (const auto color = in.body_colors.get(owner.index())) return *color;
    return default_fill(owner.type());
}

property::Color Hosting::border_of(Row row) {
    const Look look = hosted(row).looks.get(slot_of(row));
    return look.border ? *look.border : default_border(fill_of(row));
}

}  // namespace fettle::physics_module
