// Stacks of boxes of any size: none sinks into the box below it.

#include <fettle/physics/physics.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "catch.h"

namespace small_stack_family_test {

using namespace fettle::physics;

TEST_CASE("boxes of a few millimeters to a hundred meters keep their places in a stack") {
    for (const float size : {0.003f, 0.005f, 0.01f, 0.02f, 1.0f, 10.0f, 100.0f})
        for (const int count : {5, 10})
            for (const bool sleeping : {false, true}) {
                World world({.gravity = {0, -9.8f}, .sleeping = sleeping});
                Body ground = world.create_body({.type = BodyType::static_body});
                ground.add(Box{.width = 100 * size, .height = size, .center = {0, -0.5f * size}});
                std::vector<Body> boxes;
                for (int i = 0; i < count; ++i) {
                    const float y = (float(i) + 0.5f) * size;
                    boxes.push_back(world.create_body({.position = {0, y}}));
                    boxes.back().add(Box{.width = size, .height = size});
                }
                for (int i = 0; i < 600; ++i) world.step(1.0f / 60);
                float worst = 0;
                for (int i = 0; i < count; ++i) {
                    const Vec2 place = {0, (float(i) + 0.5f) * size};
                    worst = std::max(
                        worst, (boxes[size_t(i)].position() - Position(place)).length() / size);
                }
                INFO(count << " boxes of " << size << " m, sleeping: " << sleeping);
                CHECK(worst < 0.02f);
            }
}

}  // namespace small_stack_family_test
