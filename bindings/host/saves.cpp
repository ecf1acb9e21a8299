#include "calls.h"

// Saved games in slots.

using namespace fettle::host;
namespace property = fettle::property;

namespace {

property::GameSaves& saves_of(Game& game) {
    if (game.files.saves) return *game.files.saves;
    throw Failure{FETTLE_INVALID, "this game was created without a folder for saved games"};
}

}  // namespace

fettle_code fettle_hosted_save(fettle_hosted* hosted, const char* slot) {
    return outside(__func__, hosted, "be saved", [&](Game& game) {
        const property::GameSaves& saves = saves_of(game);
        const std::string name = text_of("slot", slot);
        const std::vector<std::byte> state = game.tree.snapshot().to_bytes();
        // A state that cannot be loaded must not replace a save.
        game.tree.check(property::Snapshot::from_bytes(state));
        saves.slots().save(name, game.tree.step(), state);
    });
}

fettle_code fettle_hosted_load_save(fettle_hosted* hosted, const char* slot) {
    return outside(__func__, hosted, "be loaded", [&](Game& game) {
        const property::GameSaves& saves = saves_of(game);
        const std::string name = text_of("slot", slot);
        const property::SavedGame saved = saves.slots().load(name);
        const property::Snapshot state = property::Snapshot::from_bytes(saved.state);
        game.tree.check(state);
        game.run_scripts([&] { game.tree.restore(state); });
        game.note_remarks("the saved game \"" + name + "\"");
    });
}

fettle_code fettle_hosted_delete_save(fettle_hosted* hosted, const char* slot) {
    return with(__func__, hosted, [&](Game& game) {
        property::GameSaves& saves = saves_of(game);
        saves.remove(text_of("slot", slot));
    });
}

fettle_code fettle_hosted_saves(fettle_hosted* hosted, fettle_hosted_saved* out, uint32_t room,
                                uint32_t* count) {
    return outside(__func__, hosted, "list its saved games", [&](Game& game) {
        const std::vector<property::SaveInfo> found = saves_of(game).list();
        game.given.clear();
        const auto make_saved = [&](std::size_t place) {
            const property::SaveInfo& save = found[place];
            return fettle_hosted_saved{.slot = game.given.text(save.slot),
                                       .problem = game.given.text(save.problem),
                                       .step = static_cast<int64_t>(save.step),
                                       .time = save.time};
        };
        write_list(found.size(), make_saved, out, room, count);
    });
}
