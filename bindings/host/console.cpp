#include <cmath>

#include "calls.h"

// Input, and the console as triangles.

using namespace fettle::host;
namespace app = fettle::app;
namespace property = fettle::property;

namespace {

app::InputEvent input_event(const fettle_hosted_input& input) {
    check_size(input);
    if (input.kind < 0 || input.kind > FETTLE_INPUT_GAMEPAD_DISCONNECTED)
        throw Failure{FETTLE_INVALID, "kind = " + std::to_string(input.kind) +
                                          ": expected one of fettle_input_kind"};
    for (const float number : {input.x, input.y, input.delta})
        if (!std::isfinite(number))
            throw Failure{FETTLE_INVALID, "x, y and delta: expected finite numbers"};
    const bool surrogate = input.character >= 0xd800 && input.character <= 0xdfff;
    if (input.character > 0x10ffff || surrogate)
        throw Failure{FETTLE_INVALID, "character = " + std::to_string(input.character) +
                                          ": expected a Unicode character"};
    return {.kind = static_cast<app::EventKind>(input.kind),
            .name = input.name == nullptr ? "" : input.name,
            .character = static_cast<char32_t>(input.character),
            .x = input.x,
            .y = input.y,
            .delta = input.delta,
            .gamepad = input.gamepad,
            .control = flag(input.control),
            .shift = flag(input.shift),
            .alt = flag(input.alt),
            .repeated = flag(input.repeated),
            .focused = flag(input.focused)};
}

}  // namespace

fettle_code fettle_hosted_input_init(fettle_hosted_input* input, size_t size) {
    return init(__func__, input, size, fettle_hosted_input{});
}

fettle_code fettle_hosted_handle(fettle_hosted* hosted, const fettle_hosted_input* input,
                                 bool* used) {
    return outside(__func__, hosted, "get input", [&](Game& game) {
        const app::InputEvent event = input_event(needed("input", input));
        bool is_used = false;
        game.run_scripts([&] {
            is_used = game.console && game.console->handle(event);
            game.loop.feed(event, is_used);
        });
        if (used != nullptr) *used = is_used;
    });
}

fettle_code fettle_console_draw(fettle_hosted* hosted, float width, float height, double seconds,
                                fettle_console_picture* picture) {
    return outside(__func__, hosted, "draw", [&](Game& game) {
        fettle_console_picture& result = needed("picture", picture);
        fettle::console::Console& console = game.needed_console();
        if (!(width >= 1 && width <= 32768 && height >= 1 && height <= 32768))
            throw Failure{FETTLE_INVALID, "width = " + property::number_text(width) +
                                              ", height = " + property::number_text(height) +
                                              ": expected 1 to 32768 pixels"};
        if (!(seconds >= 0 && seconds <= 3600))
            throw Failure{FETTLE_INVALID,
                          "seconds = " + property::number_text(seconds) + ": expected 0 to 3600"};
        game.services.view.screen = property::Vec2(width, height);
        game.surface.begin(width, height);
        game.run_scripts([&] { console.draw(game.surface, seconds); });
        result = game.surface.picture();
    });
}

fettle_code fettle_console_open(fettle_hosted* hosted, bool open) {
    return with(__func__, hosted, [&](Game& game) { game.needed_console().open(flag(open)); });
}

fettle_code fettle_console_is_open(fettle_hosted* hosted, bool* is_open) {
    return with(__func__, hosted,
                [&](Game& game) { needed("is_open", is_open) = game.needed_console().is_open(); });
}

fettle_code fettle_console_select(fettle_hosted* hosted, fettle_instance instance) {
    return outside(__func__, hosted, "select", [&](Game& game) {
        fettle::console::Console& console = game.needed_console();
        console.select(instance == 0 ? property::Handle() : living(game, instance));
    });
}

fettle_code fettle_console_selected(fettle_hosted* hosted, fettle_instance* instance) {
    return with(__func__, hosted, [&](Game& game) {
        needed("instance", instance) = converted(game.needed_console().selected());
    });
}

fettle_code fettle_console_print(fettle_hosted* hosted, const char* line) {
    return with(__func__, hosted,
                [&](Game& game) { game.needed_console().print(text_of("line", line)); });
}

fettle_code fettle_console_set_view(fettle_hosted* hosted, const double* map) {
    return with(__func__, hosted, [&](Game& game) {
        (void)game.needed_console();
        if (map == nullptr) {
            game.view.reset();
            return;
        }
        const property::Transform made{property::Vec2(map[0], map[2]),
                                       property::Vec2(map[1], map[3]),
                                       property::Vec2(map[4], map[5])};
        for (int i = 0; i < 6; ++i)
            if (!std::isfinite(map[i]) || std::abs(map[i]) > 1e9)
                throw Failure{FETTLE_INVALID, "map: expected six numbers up to 1e9"};
        if (std::abs(made.area()) < 1e-12)
            throw Failure{FETTLE_INVALID, "map: expected one that has an inverse"};
        game.view = made;
    });
}

fettle_code fettle_console_set_clipboard(fettle_hosted* hosted, fettle_clipboard_read read,
                                         fettle_clipboard_write write, void* user) {
    return with(__func__, hosted, [&](Game& game) {
        (void)game.needed_console();
        game.callbacks.read_clipboard = {read, user};
        game.callbacks.write_clipboard = {write, user};
    });
}
