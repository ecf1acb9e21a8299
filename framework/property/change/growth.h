#pragma once
// An estimate of the memory that a tree takes (see weight.h).

#include <cstdint>
#include <functional>

#include "errors.h"

namespace fettle::property {

struct Growth {
    Tree& tree;
    Lifetime& lifetime;
    const HandlerErrors& errors;
    std::int64_t bytes = 0;
    std::int64_t mark = INT64_MAX;
    std::function<void()> mark_passed{};  // called once

    void add(std::int64_t more) {
        bytes += more;
        if (bytes > mark) [[unlikely]]
            pass_mark();
    }

  private:
    void pass_mark();
};

}  // namespace fettle::property
