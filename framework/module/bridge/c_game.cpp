// The implementation of fettle/module/host.h: a game without a window for programs in C.

#include <cstdio>
#include <limits>
#include <stdexcept>
#include <string>

#include <fettle/module/host.h>
#include <fettle/module/plugin.h>

#include "host_table.h"

/// Modules must outlive the tree, which calls them when its instances are deleted.
struct fettle_game {
    fettle::module::Plugins plugins;
    fettle::property::Tree tree;
    fettle::module::HostTable host;
    std::uint64_t steps = 0;
};

fettle_game* fettle_game_open() {
    try {
        auto game = std::make_unique<fettle_game>();
        game->host.tree = &game->tree;
        game->host.print = [](std::string_view line) {
            std::fwrite(line.data(), 1, line.size(), stdout);
            std::fputc('\n', stdout);
        };
        return game.release();
    } catch (const std::exception&) {
        return nullptr;
    }
}

void fettle_game_close(fettle_game* game) {
    delete game;
}

const fettle_host* fettle_game_host(fettle_game* game) {
    return game != nullptr ? &game->host.table() : nullptr;
}

fettle_status fettle_game_load(fettle_game* game, const char* file) {
    if (game == nullptr) return FETTLE_ERR_FAILED;
    return game->host.guarded([&](fettle::property::Tree& tree) {
        if (file == nullptr || *file == '\0')
            throw std::invalid_argument(
                "fettle_game_load: expected the path of a shared object, got an empty text");
        game->plugins.open(fettle::module::text_or_empty(file)).attach(tree);
    });
}

fettle_status fettle_game_step(fettle_game* game, double seconds) {
    using fettle::property::Tree;
    using fettle::property::Writer;
    if (game == nullptr) return FETTLE_ERR_FAILED;
    return game->host.guarded([&](Tree& tree) {
        if (!(seconds >= 0) || seconds > std::numeric_limits<float>::max())
            throw std::invalid_argument(
                "fettle_game_step: seconds = " + fettle::property::number_text(seconds) +
                ": expected a time from 0 to 3.4e38 s");
        tree.set_step(++game->steps);
        {
            const Tree::CauseScope cause(tree, Writer::simulation);
            for (const auto& plugin : game->plugins.all()) plugin->step(seconds);
            for (const auto& plugin : game->plugins.all()) plugin->report(tree);
        }
        tree.barrier();
    });
}
