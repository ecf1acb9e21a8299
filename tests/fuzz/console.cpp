// Console commands separated by zero bytes; each is completed first and then run within a budget.
// After any of them, the next step and the next barrier succeed.

#include <algorithm>
#include <cstdlib>

#include <fettle/property/error.h>
#include <fettle/script/runtime.h>

#include "game.h"

using namespace fettle;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::Game game;
    script::Runtime runtime(game.tree, {.memory_limit = std::size_t{64} << 20,
                                        .console_memory = std::size_t{16} << 20,
                                        .console_budget = 100'000,
                                        .assets = {}});
    runtime.on_error([](const script::ScriptError&) {});
    runtime.on_print([](std::string_view) {});
    game.tree.on_handler_error([](const property::HandlerError&) {});
    std::string_view text = fuzz::text_of(data, size);
    double now = 0;
    for (int command = 0; command < 8 && !text.empty(); ++command) {
        const std::size_t end = std::min(text.find('\0'), text.size());
        const std::string line(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
        (void)runtime.complete(line, line.size());
        const script::Evaluation answer = runtime.evaluate(line);
        if (answer.ok && answer.error) std::abort();
        now += 1.0 / 60;
        runtime.step(now, 1.0 / 60);
        try {
            game.tree.barrier();
            game.module.step(1.0 / 60);
            game.tree.set_step(static_cast<std::uint64_t>(command) + 1);
            game.tree.stepped();
            game.tree.barrier();
        } catch (const property::Error&) {
            // handlers that trigger each other without end
        }
    }
    return 0;
}
