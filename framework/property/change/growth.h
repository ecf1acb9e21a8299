#pragma once
// About how much memory a tree has come to take (weight.h).

#include <cstdint>
#include <functional>

#include "errors.h"

namespace fettle::property {

struct Growth {
    Lifetime& lifetime;
    const HandlerErrors& errors;
    std::int64_t bytes = 0;
    std::int64_t mark = INT64_MAX;
    std::function<void()> mark_passed{};  // told once

    void add(std::int64_t more) {
        bytes += more;
        if (bytes > mark) [[unlikely]]
            pass_mark();
    }

  private:
    void pass_mark();
};

}  // namespace fettle::property
