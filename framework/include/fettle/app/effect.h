#pragma once
// A program in GLSL that changes the finished picture of a game, `view.effect`.

#include <string>
#include <vector>

#include <fettle/app/export.h>
#include <fettle/property/value.h>

FETTLE_APP_BEGIN

namespace fettle::app {

struct Effect {
    std::string name{};  // of the file, for messages
    /// The fragment shader. Before it, the screen declares `size` (px), `time` (s), `point` (px,
    /// from the top left corner) and `picture(point)`, the color of the picture there.
    std::string code{};
    double time = 0;  // s
    struct Uniform {
        std::string name{};
        property::Value value{};
        std::string type{};  // float, int, bool, vec2, vec3 or vec4, which the value can be
    };
    std::vector<Uniform> uniforms{};
};

}  // namespace fettle::app

FETTLE_APP_END
