#include <placing/placing.h>

namespace fettle::visuals {

using property::Handle;
using property::Property;
using property::Symbol;
using property::Transform;
using property::Tree;
using property::Type;
using property::Value;
using property::Vec2;

namespace {

Value value_of(const Tree& tree, Handle instance, Symbol name) {
    const Property* const property = tree.find(instance, name);
    return property == nullptr ? Value() : tree.peek(instance, *property);
}

double number_or(const Value& value, double otherwise) {
    return value.is_numeric() ? value.as_double() : otherwise;
}

Transform pose_of(const Tree& tree, Handle instance, bool on_screen, double alpha) {
    const property::Lifecycle& lifecycle = tree.class_of(instance).lifecycle();
    if (lifecycle.pose)
        return lifecycle.pose(lifecycle.context, tree, instance, tree.row(instance), alpha);
    static const Symbol position("position"), angle("angle"), scale("scale");
    const Value at = value_of(tree, instance, position);
    if (!at.is(Type::vec2)) return {};
    return local_pose(at.vec2(), number_or(value_of(tree, instance, angle), 0),
                      number_or(value_of(tree, instance, scale), 1), on_screen);
}

}  // namespace

Transform local_pose(const Vec2& position, double angle, double scale, bool on_screen) {
    Transform pose = angle == 0 ? Transform() : Transform::turned(on_screen ? -angle : angle);
    pose.x *= scale;
    pose.y *= scale;
    pose.origin = position;
    return pose;
}

Transform placed_below(const Tree& tree, Handle instance, bool on_screen, double alpha) {
    Transform all;
    for (Handle at = instance; at && at != tree.root(); at = tree.parent(at)) {
        const Transform pose = pose_of(tree, at, on_screen, alpha);
        if (!pose.is_identity()) all = pose * all;
    }
    return all;
}

}  // namespace fettle::visuals
