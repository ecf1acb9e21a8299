#include <fettle/property/pose.h>

#include <fettle/property/between_steps.h>
#include <fettle/property/class.h>

#include <tree/state.h>

namespace fettle::property {

namespace {

Value value_of(const Tree& tree, Handle instance, Symbol name) {
    const Property* const property = tree.find(instance, name);
    return property == nullptr ? Value() : tree.peek(instance, *property);
}

/// Finds where instances are within their parents.
class Finder {
  public:
    Finder(const Tree& tree, bool on_screen, double alpha)
        : tree_(tree),
          all_(tree.state().instances),
          alpha_(alpha),
          far_(on_screen ? tree.state().noted.far.screen : tree.state().noted.far.world) {}

    /// Nothing if the instance has no position.
    std::optional<Placement> find(std::uint32_t index, const Node& node) const {
        const Handle self = all_.nodes.handle(index);
        const StoredColumns* const columns = all_.stored[node.class_id].get();
        if (columns == nullptr || !columns->places.any()) return elsewhere(self, node);
        const Places& places = columns->places;
        Placement found = places.drawn(*columns, node.stored_row, alpha_, far_);
        add_angle_and_scale(self, !places.has_angle(), !places.has_scale(), found);
        return found;
    }

  private:
    /// In ad-hoc properties, or in the memory of a module.
    std::optional<Placement> elsewhere(Handle self, const Node& node) const {
        static const Symbol position("position");
        const Value there = value_of(tree_, self, position);
        if (!there.is(Type::vec2)) return {};
        Placement found{.position = there.vec2()};
        add_angle_and_scale(self, true, true, found);
        const auto track = all_.ad_hoc.tracks.find(self.index);
        if (alpha_ == 1 || !node.has_ad_hoc || track == all_.ad_hoc.tracks.end()) return found;
        return track->second.drawn(found, alpha_, far_);
    }

    void add_angle_and_scale(Handle self, bool with_angle, bool with_scale, Placement& to) const {
        static const Symbol angle("angle"), scale("scale");
        const auto add = [&](Symbol name, double& number) {
            const Value found = value_of(tree_, self, name);
            if (found.is_numeric()) number = found.as_double();
        };
        if (with_angle) add(angle, to.angle);
        if (with_scale) add(scale, to.scale);
    }

    const Tree& tree_;
    const Instances& all_;
    const double alpha_, far_;
};

/// The map of an instance that is placed in this way.
Transform local_pose(const Placement& at, bool on_screen) {
    Transform pose =
        at.angle == 0 ? Transform() : Transform::turned(on_screen ? -at.angle : at.angle);
    pose.x *= at.scale;
    pose.y *= at.scale;
    pose.origin = at.position;
    return pose;
}

}  // namespace

std::optional<Transform> place_below(const Tree& tree, Handle instance, bool on_screen,
                                     double alpha) {
    if (!instance) return {};
    const Instances& all = tree.state().instances;
    all.require(instance);
    all.reads.note_structure();
    std::optional<Transform> place;
    const auto add = [&](const Transform& pose) { place = place ? pose * *place : pose; };
    const Finder finder(tree, on_screen, alpha);
    for (std::uint32_t i = instance.index; i != 0 && i != all.root.index; i = all.nodes[i].parent) {
        const Node& node = all.nodes[i];
        const Lifecycle& lifecycle = all.class_of(node).lifecycle();
        if (lifecycle.pose) {
            add(lifecycle.pose(lifecycle.context, tree, all.nodes.handle(i), node.row, alpha));
            break;
        }
        if (const auto placed = finder.find(i, node)) add(local_pose(*placed, on_screen));
    }
    return place;
}

}  // namespace fettle::property
