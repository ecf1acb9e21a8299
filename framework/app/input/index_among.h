#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string_view>

namespace fettle::app {

/// The index of `name` in a list of names; none if it is not there.
template <class Names>
std::optional<std::size_t> index_among(const Names& names, std::string_view name) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) return std::nullopt;
    return static_cast<std::size_t>(found - names.begin());
}

}  // namespace fettle::app
