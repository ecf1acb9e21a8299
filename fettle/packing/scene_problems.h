#pragma once
// Scenes of a game that cannot be loaded.

#include <filesystem>
#include <string>
#include <vector>

#include <files/packed_game.h>

namespace fettle::program {

/// Why scenes of the package cannot be loaded, one line each. If there are scenes, the game is
/// loaded without a window, since its scripts make the classes of its scenes; it keeps nothing of
/// what it writes. So an error that it has then is found, too.
std::vector<std::string> scene_problems(const std::filesystem::path& game,
                                        const PackedGame& packed);

}  // namespace fettle::program
