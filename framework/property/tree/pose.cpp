#include <fettle/property/pose.h>

#include <fettle/property/class.h>

namespace fettle::property {

namespace {

Value value_of(const Tree& tree, Handle instance, Symbol name) {
    const Property* const property = tree.find(instance, name);
    return property == nullptr ? Value() : tree.peek(instance, *property);
}

double number_or(const Value& value, double otherwise) {
    return value.is_numeric() ? value.as_double() : otherwise;
}

}  // namespace

Transform local_pose(const Vec2& position, double angle, double scale, bool on_screen) {
    Transform pose = angle == 0 ? Transform() : Transform::turned(on_screen ? -angle : angle);
    pose.x *= scale;
    pose.y *= scale;
    pose.origin = position;
    return pose;
}

std::optional<Transform> place_below(const Tree& tree, Handle instance, bool on_screen,
                                     double alpha) {
    static const Symbol position("position"), angle("angle"), scale("scale");
    std::optional<Transform> all;
    const auto add = [&](const Transform& pose) { all = all ? pose * *all : pose; };
    for (Handle at = instance; at && at != tree.root(); at = tree.parent(at)) {
        const Lifecycle& lifecycle = tree.class_of(at).lifecycle();
        if (lifecycle.pose) {
            add(lifecycle.pose(lifecycle.context, tree, at, tree.row(at), alpha));
            break;
        }
        if (const Value there = value_of(tree, at, position); there.is(Type::vec2))
            add(local_pose(there.vec2(), number_or(value_of(tree, at, angle), 0),
                           number_or(value_of(tree, at, scale), 1), on_screen));
    }
    return all;
}

}  // namespace fettle::property
