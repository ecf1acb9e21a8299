#pragma once
// Limits for the memory and the files that a game may use.

#include <cstddef>
#include <cstdint>

#include <fettle/property/storage/game_settings.h>
#include <fettle/script/runtime.h>

namespace fettle::program {

struct RunOptions;

/// Bytes. 0: no limit.
struct GameQuota {
    std::size_t lua = 0;    // memory of the Lua machine; always limited
    std::size_t files = 0;  // written to the game's folder
    std::uintmax_t saves = 0;
    script::GameLimits scripts{};
};

/// The limits of a run. `settings`: of the game; they count only if the game is trusted.
GameQuota quota_of(const RunOptions& options, const property::GameSettings& settings);

}  // namespace fettle::program
