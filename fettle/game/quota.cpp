#include <game/quota.h>

#include <game/run_options.h>

namespace fettle::program {

namespace {

constexpr std::size_t megabyte = std::size_t{1} << 20;
constexpr std::size_t default_tree = 2048 * megabyte;  // of a trusted game: over a million bodies

}  // namespace

GameQuota quota_of(const RunOptions& options, const property::GameSettings& settings) {
    GameQuota quota{.lua = script::Options().memory_limit};
    const std::optional<std::uint64_t> given =
        options.memory || options.sandbox ? options.memory : settings.memory;
    if (given) quota.lua = *given * megabyte;
    if (!options.sandbox) {
        quota.scripts.tree = given ? quota.lua : default_tree;
        quota.scripts.tree_setting = "\"memory\" in game.json, or --memory,";
        return quota;
    }
    quota.files = 64 * megabyte;
    quota.saves = 256 * megabyte;
    quota.scripts = {.instructions = 100'000'000,  // about a second
                     .memory = quota.lua,
                     .text = 64 * megabyte,
                     .instances = 100'000,
                     .handlers = 100'000,
                     .timers = 100'000,
                     .output = 16 * megabyte};
    return quota;
}

}  // namespace fettle::program
