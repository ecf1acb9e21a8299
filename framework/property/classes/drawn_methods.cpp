#include "drawn_methods.h"

#include <cmath>

#include <fettle/property/drawing.h>
#include <fettle/property/pose.h>

namespace fettle::property {

namespace {

/// A formula that asks for a place runs again when a value has changed that is part of the place.
void read_for_formula(const Tree& tree, Handle self) {
    static const Symbol names[] = {Symbol("position"), Symbol("angle"), Symbol("scale")};
    for (Handle at = self; at && at != tree.root(); at = tree.parent(at))
        for (const Symbol name : names)
            if (const Property* const found = tree.find(at, name)) (void)tree.get(at, *found);
}

Transform drawn_place(const Tree& tree, Handle self) {
    if (tree.in_formula()) read_for_formula(tree, self);
    return place_below(tree, self, false, Drawing::alpha()).value_or(Transform());
}

/// `Run`: captureless lambda (const Transform&, arguments) -> Value.
template <class Run>
Method drawn(Method described, Run) {
    described.effect = Effect::nothing;
    described.call = [](void*, Tree& tree, Handle self, Row,
                        std::span<const Value> arguments) -> Result {
        return Run{}(drawn_place(tree, self), arguments);
    };
    return described;
}

}  // namespace

std::vector<Method> drawn_methods() {
    using Arguments = std::span<const Value>;
    return {
        drawn({.name = "drawn_position",
               .returns = {{.name = "position",
                            .type = Type::vec2,
                            .unit = "m",
                            .doc = "The position in the world."}},
               .doc = "Where it is in the picture that is being drawn: pictures are drawn between "
                      "the last two steps. Outside of `draw`: where it is after the last step. "
                      "Without a `position`, it is where its parent is."},
              [](const Transform& place, Arguments) { return Value(place.origin); }),
        drawn({.name = "drawn_angle",
               .returns = {{.name = "angle", .unit = "rad", .doc = "Counter-clockwise."}},
               .doc = "Its angle in the world, in the picture that is being drawn. Outside of "
                      "`draw`: that after the last step."},
              [](const Transform& place, Arguments) {
                  return Value(std::atan2(place.x.y, place.x.x));
              }),
        drawn({.name = "to_drawn",
               .parameters = {{.name = "point",
                               .type = Type::vec2,
                               .unit = "m",
                               .doc = "A point in its own coordinates."}},
               .required = 1,
               .returns = {{.name = "point",
                            .type = Type::vec2,
                            .unit = "m",
                            .doc = "The point in the world."}},
               .doc = "Where a point of it is in the picture that is being drawn. Outside of "
                      "`draw`: where it is after the last step."},
              [](const Transform& place, Arguments a) { return Value(place(a[0].vec2())); })};
}

}  // namespace fettle::property
