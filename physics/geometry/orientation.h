#pragma once

#include <geometry/vector.h>

#include <vector>

namespace fettle::physics::detail {

/// Twice the signed area of the triangle o, a, b: positive if the path o, a, b turns left.
/// Differences of floats are exact in double precision unless their magnitudes differ strongly, so
/// the sign is correct except very near 0.
inline double orientation(Vec2 o, Vec2 a, Vec2 b) {
    const double ax = double(a.x) - double(o.x), ay = double(a.y) - double(o.y);
    const double bx = double(b.x) - double(o.x), by = double(b.y) - double(o.y);
    return ax * by - ay * bx;
}

/// The convex hull, counter-clockwise, of items that are sorted by x, then y, and of which no two
/// are in one place; `place(item)` is the point of an item. Monotone chain (A. M. Andrew, "Another
/// efficient algorithm for convex hulls in two dimensions", 1979).
template <class Item, class Place>
std::vector<Item> monotone_chain(const std::vector<Item>& sorted, Place&& place) {
    std::vector<Item> chain;
    const auto extend = [&](const Item& next, size_t base) {
        while (chain.size() >= base + 2 &&
               orientation(place(chain[chain.size() - 2]), place(chain.back()), place(next)) <= 0.0)
            chain.pop_back();
        chain.push_back(next);
    };
    for (const Item& item : sorted) extend(item, 0);
    const size_t upper = chain.size() - 1;
    for (size_t i = sorted.size() - 1; i-- > 0;) extend(sorted[i], upper);
    if (chain.size() > 1) chain.pop_back();
    return chain;
}

}  // namespace fettle::physics::detail
