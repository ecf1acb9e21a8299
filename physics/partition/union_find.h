#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace fettle::physics::detail {

/// Union by index with path halving: the lowest index is the root, so the result does not depend on
/// the order of unions.
struct UnionFind {
    std::vector<uint32_t> parent;

    void reset(std::size_t size) {
        parent.resize(size);
        std::iota(parent.begin(), parent.end(), 0u);
    }
    uint32_t find(uint32_t i) {
        while (parent[i] != i) i = parent[i] = parent[parent[i]];
        return i;
    }
    void unite(uint32_t a, uint32_t b) {
        a = find(a);
        b = find(b);
        if (a < b)
            parent[b] = a;
        else
            parent[a] = b;
    }
};

}  // namespace fettle::physics::detail
