#pragma once
// A stage on which the effect of an edit shows: a body at rest on a floor, and what it is watched
// by.

#include <functional>
#include <map>
#include <string>

#include "game.h"
#include "picture.h"

namespace fettle::physics_module::testing {

class Stage {
  public:
    explicit Stage(std::string_view shape_class);

    void run(int steps);
    Picture draw() const;
    /// What presses the body onto the floor, N.
    double load();

    Game game;
    Handle world, floor, body, shape;
    Handle other;           // whatever a case adds
    bool was_awake = true;  // before the edit
    int hits = 0;
    double fastest_rise = 0;  // m/s, while running
    int turns = 0;            // of its vertical velocity
};

/// How one property is tried: the stage is prepared, comes to rest (awake or asleep), the property
/// is written, something happens, and the effect must show. Without the edit it must not.
struct Case {
    std::string shape = "Box";
    std::function<void(Stage&)> prepare = [](Stage&) {};
    std::function<Handle(Stage&)> subject;  // whose property it is
    std::function<Value(Stage&)> value;
    std::function<void(Stage&)> then = [](Stage&) {};
    int steps = 1;
    std::function<bool(Stage&)> effect;
};

/// By owner and name: "Body.mass".
using Cases = std::map<std::string, Case>;
Cases body_cases();
Cases shape_cases();
Cases form_cases();
Cases world_cases();
Cases joint_cases();
Cases field_cases();

// To write cases with.
inline std::function<Value(Stage&)> to(Value value) {
    return [value](Stage&) { return value; };
}

}  // namespace fettle::physics_module::testing
