#pragma once

#include <fettle/property/storage/game_saves.h>
#include <fettle/property/storage/store.h>
#include <fettle/property/storage/tweaks.h>
#include <fettle_host.h>

#include <functional>
#include <memory>
#include <string>

namespace fettle::host {

/// The saved games and the store of the player, and the tweaks. Each is null unless the definition
/// names its place.
struct PlayerFiles {
    using Warn = std::function<void(const std::string&)>;
    PlayerFiles(property::Tree& tree, const fettle_hosted_def& def, const Warn& warn);

    std::unique_ptr<property::GameSaves> saves;
    std::unique_ptr<property::Store> store;
    std::unique_ptr<property::Tweaks> tweaks;

    void after_barrier();
    void between_frames();
    /// A note about edits of earlier runs; "" if there are none.
    std::string game_loaded();
};

}  // namespace fettle::host
