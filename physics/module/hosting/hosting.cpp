#include <hosting/hosting.h>

#include <algorithm>
#include <utility>

namespace fettle::physics_module {
namespace {

/// World, kind and slot in one number, for the log of a timeline.
constexpr std::uint64_t refresh_code(std::uint32_t world, const physics::Refresh& wanted) {
    return std::uint64_t{world} << 40 | static_cast<std::uint64_t>(wanted.of) << 32 | wanted.slot;
}

}  // namespace

Hosting::Hosting(property::Tree& in, property::SnapshotPart& part)
    : tree(in), tree_life(in.lifetime()), joints(*this), part_(part) {
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
        if (tree.class_of(at).is_a(*classes.world)) return world_number(tree.row(at));
    return limbo;
}

Handle Hosting::body_above(Handle instance) const {
    for (Handle at = tree.parent(instance); at; at = tree.parent(at))
        if (tree.class_of(at).is_a(*classes.body)) return at;
    return {};
}

// --- Updates by reads

std::unique_ptr<HostedWorld> Hosting::make_world(std::uint32_t number) {
    auto made = std::make_unique<HostedWorld>(property::noted_steps(tree));
    made->world.set_owner(&owner_);
    physics::HostAccess::on_refresh(made->world, [this, number](const physics::Refresh& wanted) {
        if (edit_depth_ == 0) tree.refreshing(part_, refresh_code(number, wanted));
    });
    return made;
}

void Hosting::refresh(std::uint64_t what) {
    const std::uint64_t number = what >> 40;
    if (number >= max_worlds || worlds_[number] == nullptr) return;
    physics::HostAccess::refresh(worlds_[number]->world,
                                 {.of = static_cast<physics::Refresh::Of>(what >> 32 & 0xff),
                                  .slot = static_cast<std::uint32_t>(what)});
}

void Hosting::weigh_contacts(std::int64_t contacts) {
    // A pair of shapes near each other, and its share of what a step needs; measured for boxes.
    constexpr std::int64_t weight_of_contact = 400;
    const std::int64_t weight = contacts * weight_of_contact;
    const std::int64_t grown = weight - std::exchange(weight_of_contacts_, weight);
    if (grown != 0) tree.add_weight(grown);
}

void Hosting::require_idle() const {
    const auto calls = [](const auto& hosted) { return hosted && hosted->world.locked(); };
    if (edit_depth_ > 0 || std::ranges::any_of(worlds_, calls))
        throw property::Error(property::ErrorKind::bad_structure,
                              "physics is destroyed by a function that a step or a query of a "
                              "world is calling, which must not do so (see physics_module.h)");
}

}  // namespace fettle::physics_module
