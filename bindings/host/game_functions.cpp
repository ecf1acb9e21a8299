
#include "../c/calls/retired.h"
#include "calls.h"

// Games: their life, their scripts, their frames.

using namespace fettle::host;
namespace property = fettle::property;
namespace script = fettle::script;

namespace {

const fettle_hosted_def defaults{.size = sizeof(fettle_hosted_def),
                                 .console = true,
                                 .seed = 0,
                                 .lua_memory = std::uint64_t{512} << 20,
                                 .call_seconds = 10,
                                 .assets = nullptr,
                                 .history_file = nullptr,
                                 .name = nullptr,
                                 .saves = nullptr,
                                 .store_file = nullptr,
                                 .tweaks_of = nullptr};

void check(const fettle_hosted_def& def) {
    check_size(def);
    if (!(def.call_seconds >= 0 && def.call_seconds <= 1e6))
        throw Failure{FETTLE_INVALID, "call_seconds = " + property::number_text(def.call_seconds) +
                                          ": expected 0 to 1e6 seconds"};
    constexpr std::uint64_t least = std::uint64_t{16} << 20, most = std::uint64_t{1} << 46;
    if (def.lua_memory < least || def.lua_memory > most)
        throw Failure{FETTLE_INVALID, "lua_memory = " + std::to_string(def.lua_memory) +
                                          ": expected 16 MiB to 64 TiB, in bytes"};
}

/// A function of the caller, called by scripts.
property::Value call_function(Game& game, const Callback<fettle_function_callback>& called,
                              std::span<const property::Value> arguments) {
    return answer_of(game, arguments, [&](auto passed, auto count, auto result) {
        return called.function(called.user, passed, count, result);
    });
}

}  // namespace

fettle_code fettle_hosted_def_init(fettle_hosted_def* def, size_t size) {
    return init(__func__, def, size, defaults);
}

fettle_code fettle_hosted_create(const fettle_hosted_def* def, fettle_hosted** game) {
    try {
        fettle_hosted*& made = needed("game", game);
        const fettle_hosted_def& wanted = def == nullptr ? defaults : *def;
        check(wanted);
        auto parts = std::make_unique<Game>(wanted);
        std::unique_ptr<fettle_hosted> hosted =
            fettle::physics_c::Retired<fettle_hosted>::allocate();
        hosted->game = std::move(parts);
        made = hosted.release();
        return FETTLE_DONE;
    } catch (...) {
        return code_of_exception(__func__);
    }
}

fettle_code fettle_hosted_destroy(fettle_hosted* hosted) {
    if (hosted == nullptr) return FETTLE_DONE;
    return outside(__func__, hosted, "be destroyed", [&](Game& game) {
        if (game.files.store) game.files.store->flush();
        hosted->game.reset();
        fettle::physics_c::Retired<fettle_hosted>::keep(hosted);
    });
}

fettle_code fettle_hosted_on_print(fettle_hosted* hosted, fettle_print_callback print, void* user) {
    return with(__func__, hosted, [&](Game& game) { game.callbacks.print = {print, user}; });
}

fettle_code fettle_hosted_on_problem(fettle_hosted* hosted, fettle_problem_callback problem,
                                     void* user) {
    return with(__func__, hosted, [&](Game& game) {
        game.callbacks.problem = {problem, user};
        if (problem != nullptr) game.deliver_early_notes();
    });
}

fettle_code fettle_hosted_load(fettle_hosted* hosted, const char* path) {
    return outside(__func__, hosted, "load", [&](Game& game) {
        const char* const file = text_of("path", path);
        game.run_scripts([&] {
            (void)game.lua.load(file);
            if (const std::string note = game.files.game_loaded(); !note.empty()) game.note(note);
        });
    });
}

fettle_code fettle_hosted_reload(fettle_hosted* hosted) {
    return outside(__func__, hosted, "reload", [&](Game& game) {
        game.run_scripts([&] {
            const script::Reloaded reloaded = game.lua.reload({});
            if (reloaded.error) game.report(*reloaded.error);
            if (!game.console) return;
            for (const std::string& note : reloaded.notes) game.console->note(note);
        });
    });
}

fettle_code fettle_hosted_run(fettle_hosted* hosted, const char* lua, const char* name) {
    return with(__func__, hosted, [&](Game& game) {
        const char* const chunk = text_of("lua", lua);
        game.run_scripts([&] { (void)game.lua.run(chunk, name == nullptr ? "host" : name); });
    });
}

fettle_code fettle_hosted_call(fettle_hosted* hosted, const char* function,
                               const fettle_hosted_value* arguments, uint32_t count) {
    return with(__func__, hosted, [&](Game& game) {
        const char* const name = text_of("function", function);
        const std::vector<property::Value> values = values_of("arguments", arguments, count);
        game.run_scripts([&] { (void)game.lua.call(name, values); });
    });
}

fettle_code fettle_hosted_evaluate(fettle_hosted* hosted, const char* command,
                                   fettle_hosted_value* result, const char** output) {
    return with(__func__, hosted, [&](Game& game) {
        const char* const text = text_of("command", command);
        std::optional<script::Evaluation> found;
        game.run_scripts([&] { found = game.lua.evaluate(text); });
        if (found->incomplete)
            throw Failure{FETTLE_INVALID, "the command is not complete: " + std::string(text)};
        if (!found->ok)
            throw Failure{FETTLE_FAILED, found->error ? found->error->message : "it failed"};
        game.given.clear();
        if (result != nullptr) *result = game.given.value(found->result);
        if (output == nullptr) return;
        std::string lines;
        for (const std::string& line : found->lines) lines += (lines.empty() ? "" : "\n") + line;
        *output = game.given.text(lines);
    });
}

fettle_code fettle_hosted_add_function(fettle_hosted* hosted, const char* name,
                                       fettle_function_callback function, void* user) {
    return with(__func__, hosted, [&](Game& game) {
        const char* const global = text_of("name", name);
        if (function == nullptr)
            throw Failure{FETTLE_INVALID, "function: expected a pointer, got null"};
        if (!property::is_identifier(global))
            throw Failure{FETTLE_INVALID,
                          "\"" + std::string(global) + "\": expected a name as in Lua"};
        const Callback<fettle_function_callback> called{function, user};
        game.lua.add_function(global, [&game, called](std::span<const property::Value> arguments) {
            return call_function(game, called, arguments);
        });
    });
}

fettle_code fettle_hosted_frame(fettle_hosted* hosted, double seconds, uint32_t* steps) {
    return outside(__func__, hosted, "begin a frame", [&](Game& game) {
        if (!(seconds >= 0 && seconds <= 3600))
            throw Failure{FETTLE_INVALID,
                          "seconds = " + property::number_text(seconds) + ": expected 0 to 3600"};
        const std::uint64_t before = game.loop.steps_made();
        game.run_scripts([&] {
            game.loop.frame(seconds);
            if (steps != nullptr) *steps = static_cast<uint32_t>(game.loop.steps_made() - before);
        });
    });
}

fettle_code fettle_hosted_step(fettle_hosted* hosted) {
    return outside(__func__, hosted, "make a step",
                   [](Game& game) { game.run_scripts([&] { game.loop.turn(); }); });
}

fettle_code fettle_hosted_barrier(fettle_hosted* hosted) {
    return outside(__func__, hosted, "deliver changes",
                   [](Game& game) { game.run_scripts([&] { game.tree.barrier(); }); });
}

fettle_code fettle_hosted_hash(fettle_hosted* hosted, uint64_t* hash) {
    return with(__func__, hosted, [&](Game& game) { needed("hash", hash) = game.loop.hash(); });
}
