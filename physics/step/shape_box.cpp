#include <distance/distance.h>
#include <step/shape_box.h>

namespace fettle::physics::detail {

Aabb box_of_shape(const ObjectState& objects, const Columns& columns, std::span<const Box4> boxes,
                  uint32_t shape) {
    if (!double_positions || objects.forms[shape].kind == FormKind::border)
        return {boxes[shape].low, boxes[shape].high};
    const Solid solid = solid_of(objects, columns, shape);
    const auto side = [&](float x, float y) { return reach(solid, {x, y}); };
    const Position& center = objects.forms[shape].center;
    return {center - Vec2(side(-1, 0), side(0, -1)), center + Vec2(side(1, 0), side(0, 1))};
}

}  // namespace fettle::physics::detail
