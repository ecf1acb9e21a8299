#pragma once

#include "game.h"

// How a function in C calls the game: arguments are checked, results are converted, and every
// exception becomes a code and a message.

namespace fettle::host {

/// Stores the message of the exception that is being handled for `fettle_last_error`, and returns
/// its code.
fettle_code code_of_exception(const char* function) noexcept;

/// The game; throws Failure if it is null or destroyed, and in another thread.
Game& live(const fettle_hosted* hosted);

/// Runs `act(game)`; `function`: the name of the function in C, for messages.
template <class Act>
fettle_code with(const char* function, const fettle_hosted* hosted, Act&& act) noexcept {
    try {
        act(live(hosted));
        return FETTLE_DONE;
    } catch (...) {
        return code_of_exception(function);
    }
}

/// The same for a function that must not be called in a callback. `what`: text for the message.
template <class Act>
fettle_code outside(const char* function, const fettle_hosted* hosted, const char* what,
                    Act&& act) noexcept {
    return with(function, hosted, [&](Game& game) {
        game.require_outside(what);
        act(game);
    });
}

/// Calls a function of the caller: `call(arguments, their count, &result)`. Throws
/// std::invalid_argument with its reason unless its code is FETTLE_DONE.
property::Value answer_of(Game& game, std::span<const property::Value> arguments,
                          const std::function<fettle_code(const fettle_hosted_value*, std::uint32_t,
                                                          fettle_hosted_value*)>& call);

/// Writes the defaults of a definition.
template <class Def>
fettle_code init(const char* function, Def* def, std::size_t size, const Def& defaults) noexcept {
    try {
        Def& result = needed("the definition", def);
        if (size != sizeof(Def))
            throw Failure{FETTLE_INVALID, "size = " + std::to_string(size) + ": expected " +
                                              std::to_string(sizeof(Def))};
        result = defaults;
        result.size = sizeof(Def);
        return FETTLE_DONE;
    } catch (...) {
        return code_of_exception(function);
    }
}
template <class Def>
void check_size(const Def& def) {
    if (def.size != sizeof(Def))
        throw Failure{FETTLE_INVALID, "size = " + std::to_string(def.size) + ": expected " +
                                          std::to_string(sizeof(Def)) +
                                          "; call the init function of the definition"};
}

/// Writes a list: the first `room` elements, which `element(i)` returns, and to `count` how many
/// there are.
template <class Out, class Element>
void write_list(std::size_t size, Element element, Out* out, std::uint32_t room,
                std::uint32_t* count) {
    std::uint32_t& result = needed("count", count);
    if (room > 0) needed("out", out);
    for (std::size_t i = 0; i < size && i < room; ++i) out[i] = element(i);
    result = static_cast<std::uint32_t>(size);
}

/// The property with this handle; null for 0, and for a released handle.
inline const PropertyHandle* property_or_null(const fettle_hosted* hosted, fettle_property_id id) {
    const std::vector<PropertyHandle>& held = hosted->game->held;
    const auto place = static_cast<std::uint32_t>(id);
    if (place >= held.size()) return nullptr;
    const PropertyHandle& found = held[place];
    return found.generation == id >> 32 && found.property != nullptr ? &found : nullptr;
}
/// The instance; throws Error(deleted), or Failure for 0.
property::Handle living(const Game& game, fettle_instance instance);

[[noreturn]] void refuse_property(fettle_property_id id);
/// The property with this handle; throws Failure if there is none.
inline const PropertyHandle& found(const fettle_hosted* hosted, fettle_property_id id) {
    const PropertyHandle* const known = property_or_null(hosted, id);
    if (known == nullptr) refuse_property(id);
    return *known;
}

}  // namespace fettle::host
