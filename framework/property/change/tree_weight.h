#pragma once
// An estimate of the memory that a tree takes (see weight.h).

#include <cstdint>
#include <functional>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

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
    std::unordered_set<std::uint32_t> names{};  // those that were counted
    using Content = std::vector<std::pair<std::uint32_t, std::int64_t>>;

    void add(std::int64_t more) {
        bytes += more;
        if (bytes > mark) [[unlikely]]
            pass_mark();
    }
    /// A name is never freed, so it counts once.
    void add_name(Symbol name);
    void add_content(std::uint32_t instance, std::int64_t more);
    void remove_content(std::uint32_t instance);
    /// For snapshots: `content`, and replacing it.
    Content content_image() const { return {content.begin(), content.end()}; }
    void replace_content(const Content& image);

  private:
    void pass_mark();
};

}  // namespace fettle::property
