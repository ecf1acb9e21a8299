// Scene files: any text is either loaded, so that the result can be saved and loaded again
// unchanged, or refused with an error that names a line.

#include <cstdlib>

#include <fettle/property/error.h>
#include <fettle/property/storage/scene.h>

#include "game.h"

using namespace fettle;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::Game game;
    property::Handle loaded;
    const std::size_t before = game.tree.size();
    try {
        loaded = property::load_scene_text(game.tree, fuzz::text_of(data, size), "fuzz.json",
                                           game.world);
    } catch (const property::Error&) {
        if (game.tree.size() != before) std::abort();  // refused, but an instance was left
        return 0;
    }
    game.tree.barrier();
    const std::string saved = property::scene_text(game.tree, loaded);
    const property::Handle again =
        property::load_scene_text(game.tree, saved, "saved.json", game.world);
    // The copy has another name, and references to the first instance may now refer to the copy.
    game.tree.destroy(loaded);
    game.module.step(1.0 / 60);
    game.tree.set_step(1);
    game.tree.stepped();
    game.tree.barrier();
    if (!game.tree.alive(again)) std::abort();
    return 0;
}
