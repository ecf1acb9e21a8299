#include <game/quota.h>

#include <game/run_options.h>

namespace fettle::program {

namespace {

constexpr std::size_t megabyte = std::size_t{1} << 20;

}  // namespace

GameQuota quota_of(const RunOptions& options) {
    GameQuota quota{.lua = script::Options().memory_limit};
    if (options.memory) quota.lua = quota.scripts.memory = *options.memory * megabyte;
    if (!options.sandbox) return quota;
    quota.files = 64 * megabyte;
    quota.saves = 256 * megabyte;
    quota.scripts = {.instructions = 100'000'000,  // about a second
                     .memory = quota.lua,
                     .instances = 100'000,
                     .handlers = 100'000,
                     .timers = 100'000,
                     .output = 16 * megabyte};
    return quota;
}

}  // namespace fettle::program
