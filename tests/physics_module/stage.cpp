#include "stage.h"

#include <algorithm>

namespace fettle::physics_module::testing {

Stage::Stage(std::string_view shape_class) : world(game.world()), floor(game.floor()) {
    const bool flat = shape_class == "Segment";
    const bool low = shape_class == "Capsule" || shape_class == "Ellipse";
    const double height = flat ? 0.0 : low ? 0.25 : 0.5;
    body = game.body(shape_class, Vec2(0, height));
    shape = game.shape_of(body);
}

void Stage::run(int steps) {
    double last = 0;
    for (int i = 0; i < steps; ++i) {
        game.step();
        if (!game.tree.alive(body)) return;
        const double rise = game.vec(body, "velocity").y;
        fastest_rise = std::max(fastest_rise, rise);
        turns += rise * last < 0;
        last = rise;
    }
}

Picture Stage::draw() const {
    Picture picture;
    game.tree.draw(body, picture, 1.0);
    return picture;
}

double Stage::load() {
    double sum = 0;
    const auto contacts = game.tree.call(world, "contacts", {});
    for (const property::Record& contact : std::get<std::vector<property::Record>>(contacts))
        sum += contact.get("force").number();
    return sum;
}

}  // namespace fettle::physics_module::testing
