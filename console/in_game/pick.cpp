#include <in_game/pick.h>

#include <vector>

namespace fettle::console {

using property::Handle;

property::Handle pick(property::Tree& tree, property::Vec2 point) {
    // The methods are called after the walk, because a method may change the tree.
    std::vector<Handle> worlds;
    tree.each_below(tree.root(), [&](Handle instance) {
        if (tree.class_of(instance).method("at") != nullptr) worlds.push_back(instance);
    });
    for (Handle world : worlds) {
        if (!tree.alive(world)) continue;
        property::Result result = tree.call(world, "at", {property::Value(point)});
        const auto* value = std::get_if<property::Value>(&result);
        if (value != nullptr && value->is(property::Type::reference) &&
            tree.alive(value->reference()))
            return value->reference();
    }
    return {};
}

}  // namespace fettle::console
