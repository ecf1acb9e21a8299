#pragma once

#include <fettle_host.h>

#include <memory>
#include <stdexcept>
#include <string>

// A hosted game for tests.

namespace hosted {

inline void require(fettle_code code) {
    if (code != FETTLE_DONE) throw std::runtime_error(fettle_last_error());
}

struct Destroy {
    void operator()(fettle_hosted* game) const { fettle_hosted_destroy(game); }
};
using Game = std::unique_ptr<fettle_hosted, Destroy>;

inline Game make(const std::string& lua = "") {
    fettle_hosted* made = nullptr;
    require(fettle_hosted_create(nullptr, &made));
    Game game(made);
    require(fettle_hosted_run(made, lua.c_str(), "test"));
    return game;
}

inline fettle_hosted_value nil() {
    return fettle_hosted_value{};
}
inline fettle_hosted_value number(double value) {
    fettle_hosted_value made{};
    made.type = FETTLE_VALUE_NUMBER;
    made.as.number = value;
    return made;
}
inline fettle_hosted_value text(const char* value) {
    fettle_hosted_value made{};
    made.type = FETTLE_VALUE_TEXT;
    made.count = static_cast<uint32_t>(std::char_traits<char>::length(value));
    made.as.text = value;
    return made;
}
inline fettle_hosted_value get(fettle_hosted* game, const char* path) {
    fettle_hosted_value value;
    require(fettle_hosted_get(game, path, &value));
    return value;
}
inline double number_at(fettle_hosted* game, const char* path) {
    const fettle_hosted_value value = get(game, path);
    return value.type == FETTLE_VALUE_INTEGER ? double(value.as.integer) : value.as.number;
}

}  // namespace hosted
