#pragma once
// A stage that shows the effect of an edit: a body at rest on a floor, and measurements of it.

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
    /// Force between the body and the floor, N.
    double load();

    Game game;
    Handle world, floor, body, shape;
    Handle other;           // an instance that a case adds
    bool was_awake = true;  // before the edit
    int hits = 0;
    double fastest_rise = 0;  // m/s, while running
    int turns = 0;            // changes of the sign of its vertical velocity
};

/// The test of one property: the stage is prepared, comes to rest (awake or asleep), the property
/// is written, `then` acts, and the effect must be observed. Without the edit it must not be.
struct Case {
    std::string shape = "Box";
    std::function<void(Stage&)> prepare = [](Stage&) {};
    std::function<Handle(Stage&)> subject;  // instance of the property
    std::function<Value(Stage&)> value;
    std::function<void(Stage&)> then = [](Stage&) {};
    int steps = 1;
    std::function<bool(Stage&)> effect;
};

/// By class and property: "Body.mass".
using Cases = std::map<std::string, Case>;
Cases body_cases();
Cases shape_cases();
Cases form_cases();
Cases world_cases();
Cases joint_cases();
Cases field_cases();
Cases mover_cases();

// Helpers for writing cases.
inline std::function<Value(Stage&)> to(Value value) {
    return [value](Stage&) { return value; };
}

}  // namespace fettle::physics_module::testing
