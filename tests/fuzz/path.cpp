// Paths: parsing, resolving, reading and writing them gives either a result or an error with a
// reason.

#include <cstdlib>

#include <fettle/property/error.h>
#include <fettle/property/path.h>

#include "game.h"

using namespace fettle;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static fuzz::Game game;
    const std::string_view path = fuzz::text_of(data, size);
    try {
        const property::Place place = property::resolve(game.tree, path);
        // The path of the result leads to the same place.
        if (place.property != nullptr) {
            const std::string name = game.tree.path(place.instance, *place.property);
            const property::Place again = property::resolve(game.tree, name);
            if (again.instance != place.instance || again.property != place.property) std::abort();
        } else if (property::resolve(game.tree, game.tree.path(place.instance)).instance !=
                   place.instance) {
            std::abort();
        }
        const property::Value value = property::get(game.tree, path);
        property::set(game.tree, path, value);
    } catch (const property::Error&) {
        // refused with a reason
    }
    game.tree.barrier();
    return 0;
}
