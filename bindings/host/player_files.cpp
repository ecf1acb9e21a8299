#include "player_files.h"

namespace fettle::host {

PlayerFiles::PlayerFiles(property::Tree& tree, const fettle_hosted_def& def, const Warn& warn) {
    if (def.tweaks_of != nullptr)
        tweaks = std::make_unique<property::Tweaks>(tree, def.tweaks_of, warn);
    if (def.saves != nullptr)
        saves = std::make_unique<property::GameSaves>(
            tree,
            property::Saves(def.saves, def.name == nullptr ? "game" : def.name, FETTLE_VERSION),
            property::GameSaves::Options{.warn = warn});
    if (def.store_file != nullptr)
        store = std::make_unique<property::Store>(def.store_file,
                                                  property::Store::Options{.warn = warn});
}

void PlayerFiles::after_barrier() {
    if (tweaks) tweaks->barrier();
}

void PlayerFiles::between_frames() {
    if (store) store->tick();
}

std::string PlayerFiles::game_loaded() {
    if (!tweaks) return {};
    tweaks->game_loaded();
    const std::size_t open = tweaks->open_earlier();
    if (open == 0) return {};
    return "edits of earlier runs that were not kept: " + std::to_string(open) +
           "; tweaks() lists them, reapply_tweaks(\"**\") makes them again";
}

}  // namespace fettle::host
