#pragma once
// An estimate of the memory that a tree takes (see weight.h).

#include <cstdint>
#include <functional>
#include <unordered_map>

#include "errors.h"

namespace fettle::property {

struct TreeWeight {
    Tree& tree;
    Lifetime& lifetime;
    const HandlerErrors& errors;
    std::int64_t bytes = 0;
    std::int64_t mark = INT64_MAX;
    std::function<void()> mark_passed{};  // called once
    /// Of the texts and lists that were written to an instance, by the index of its node: ends with
    /// the instance.
    std::unordered_map<std::uint32_t, std::int64_t> content{};

    void add(std::int64_t more) {
        bytes += more;
        if (bytes > mark) [[unlikely]]
            pass_mark();
    }
    void add_content(std::uint32_t instance, std::int64_t more);
    void remove_content(std::uint32_t instance);

  private:
    void pass_mark();
};

}  // namespace fettle::property
