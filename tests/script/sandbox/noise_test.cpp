// math.noise.

#include "stage.h"

namespace noise_test {

using stage::Stage;

TEST_CASE("noise is smooth and within its range and the same everywhere") {
    Stage s;
    s.run(R"(
        local lowest, highest, steepest = 0, 0, 0
        local function look(value, near)
            lowest, highest = math.min(lowest, value), math.max(highest, value)
            steepest = math.max(steepest, math.abs(value - near) / 0.001)
        end
        for i = 1, 4000 do
            local x = i * 0.137 - 270
            look(math.noise(x), math.noise(x + 0.001))
            look(math.noise(x, 0.71 * i), math.noise(x + 0.001, 0.71 * i))
            look(math.noise(0.71 * i, x), math.noise(0.71 * i, x + 0.001))
        end
        print(lowest >= -1, lowest < -0.8, highest <= 1, highest > 0.8, steepest < 8)
        print(math.noise(3), math.noise(-2, 5), math.noise(1e15, -1e15))
        print(math.noise(0.5, 0.5) ~= math.noise(1.5, 0.5), math.noise(0.5) ~= math.noise(0.5, 0))
        print(string.format("%.15g %.15g", math.noise(0.3), math.noise(12.7, -3.1)))
    )");
    CHECK(stage::joined(s.printed) ==
          "true\ttrue\ttrue\ttrue\ttrue|0.0\t0.0\t0.0|true\ttrue|0.213292455264458 "
          "0.234737029119998");
    for (const char* wrong : {"math.noise(1/0)", "math.noise(0/0)", "math.noise(1, 2e15)"})
        CHECK_THAT(s.fails(wrong), contains("math.noise: expected numbers from -1e15 to 1e15"));
    CHECK_THAT(s.fails("math.noise()"), contains("math.noise: needs a number"));
}

}  // namespace noise_test
