// Patterns: matched against all instances of the tree, and watched.

#include <fettle/property/error.h>
#include <fettle/property/path.h>

#include "game.h"

using namespace fettle;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static fuzz::Game game;
    try {
        const property::Pattern pattern(fuzz::text_of(data, size));
        game.tree.each_below(game.tree.root(), [&](property::Handle handle) {
            (void)pattern.matches(game.tree, handle);
            for (const property::Property* each : game.tree.properties(handle))
                (void)pattern.matches(game.tree, handle, *each);
        });
        property::Connection connection =
            game.tree.watch_pattern(pattern.text(), [](const property::Change&) {});
        static double mass = 1;
        property::set(game.tree, "world.ball.mass", mass = mass > 100 ? 1 : mass + 1);
        game.tree.barrier();
        connection.stop();
    } catch (const property::Error&) {
        // refused with a reason
    }
    return 0;
}
