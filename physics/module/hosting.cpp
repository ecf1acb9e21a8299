#include "hosting.h"

#include <stdexcept>

namespace fettle::physics_module {

Hosting::Hosting(property::Tree& in, property::SnapshotPart& part)
    : tree(in), joints(*this), part_(part) {
    worlds_[limbo] = make_world(limbo);
    const physics::Geometry geometries[] = {
        physics::Circle{},
        physics::Box{},
        physics::Segment{},
        physics::Segment{.from = {-0.25f, 0.0f}, .to = {0.25f, 0.0f}, .rounding = 0.25f},
        physics::Polygon{.vertices = {{-0.5f, -0.5f}, {0.5f, -0.5f}, {0.0f, 0.5f}}},
        physics::Ellipse{},
        physics::Concave{{{-0.5f, -0.5f},
                          {0.5f, -0.5f},
                          {0.5f, 0.0f},
                          {0.0f, 0.0f},
                          {0.0f, 0.5f},
                          {-0.5f, 0.5f}}},
        physics::Chain{.points = {{-0.5f, 0.0f}, {0.5f, 0.0f}}}};
    for (std::size_t i = 0; i < kinds.size(); ++i) kinds[i] = {this, geometries[i]};
    owner_.on_unlocked([this] { destroy_postponed(); });
    type_names = {"static", "kinematic", "dynamic"};
}

std::uint32_t Hosting::world_above(Handle instance) const {
    for (Handle at = tree.parent(instance); at; at = tree.parent(at))
        if (tree.class_of(at).is_a(*world_class)) return world_number(tree.row(at));
    return limbo;
}

Handle Hosting::body_above(Handle instance) const {
    for (Handle at = tree.parent(instance); at; at = tree.parent(at))
        if (tree.class_of(at).is_a(*body_class)) return at;
    return {};
}

}  // namespace fettle::physics_module
