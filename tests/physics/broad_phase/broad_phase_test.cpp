#include <broad_phase/pair_set.h>
#include <broad_phase/tree.h>
#include <geometry/trigonometry.h>
#include <saving/archive.h>
#include <wide/kernels.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>
#include <span>
#include <vector>

#include "catch.h"
#include "thorough.h"

namespace broad_phase_test {

using namespace fettle::physics::detail;
using fettle::physics::Vec2;

TEST_CASE("the pair set agrees with a map through random insertions and deletions") {
    std::mt19937 random(3);
    PairSet set;
    std::map<std::pair<uint32_t, uint32_t>, uint32_t> model;
    for (int i = 0; i < 20000; ++i) {
        const uint32_t a = random() % 60, b = 60 + random() % 60;
        const auto key = std::make_pair(a, b);
        if (model.count(key) && random() % 2 == 0) {
            set.erase(b, a);
            model.erase(key);
        } else if (!model.count(key)) {
            set.insert(a, b, uint32_t(i));
            model[key] = uint32_t(i);
        }
        REQUIRE(set.size() == model.size());
    }
    for (uint32_t a = 0; a < 60; ++a) {
        for (uint32_t b = 60; b < 120; ++b) {
            const auto it = model.find({a, b});
            REQUIRE(set.find(a, b) == (it == model.end() ? PairSet::absent : it->second));
            REQUIRE(set.find(b, a) == set.find(a, b));
        }
    }
}

TEST_CASE("the tree finds the same boxes as brute force while they come and move and go") {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> place(-20.0f, 20.0f), size(0.1f, 2.0f);
    auto random_box = [&] {
        const Vec2 low = {place(random), place(random)};
        return Box4{low, {low.x + size(random), low.y + size(random)}};
    };
    Tree tree;
    std::map<uint32_t, std::pair<int32_t, Box4>> model;
    for (uint32_t i = 0; i < 3000; ++i) {
        const uint32_t action = random() % 5;
        if (action < 2 || model.empty()) {
            const Box4 box = random_box();
            model[i] = {tree.insert(box, i), box};
        } else {
            auto it = std::next(model.begin(), std::ptrdiff_t(random() % model.size()));
            if (action == 2) {
                tree.remove(it->second.first);
                model.erase(it);
            } else {
                it->second.second = random_box();
                tree.move(it->second.first, it->second.second);
            }
        }
        if (i % 50 != 0) continue;
        REQUIRE(tree.is_consistent());
        const Box4 query = random_box();
        std::set<uint32_t> found, expected;
        tree.query(query, [&](uint32_t item) { REQUIRE(found.insert(item).second); });
        REQUIRE(tree.meets(query) == !found.empty());
        for (const auto& [item, entry] : model) {
            if (overlap(entry.second, query)) expected.insert(item);
        }
        REQUIRE(found == expected);
    }
}

TEST_CASE("the trees find the same moved pairs as brute force while boxes come and move and go") {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> place(-20.0f, 20.0f), size(0.1f, 3.0f);
    auto random_box = [&] {
        const Vec2 low = {place(random), place(random)};
        return Box4{low, {low.x + size(random), low.y + size(random)}};
    };
    struct Leaf {
        int32_t node;
        Box4 box;
        bool moved;
    };
    // Boxes when moves were last cleared; pairs that overlapped then may be left out.
    std::vector<Box4> before[2];
    for (auto& boxes : before) boxes.assign(100 * 240, no_box);
    Tree trees[2];
    std::map<uint32_t, Leaf> models[2];
    using Pairs = std::set<std::pair<uint32_t, uint32_t>>;
    for (uint32_t round = 0; round < (thorough() ? 240 : 72); ++round) {
        const FindOverlaps overlaps = wide_kernels(4 << round % 3).overlaps;
        for (uint32_t side = 0; side < 2; ++side) {
            Tree& tree = trees[side];
            auto& model = models[side];
            // In every second round many boxes move at once before the single edits.
            if (round % 2 == 0) {
                for (auto& [item, leaf] : model) {
                    if (random() % 3 != 0) continue;
                    leaf.box = random_box();
                    leaf.moved = true;
                    tree.place(leaf.node, leaf.box);
                }
                tree.refit(nullptr, before[side]);
                REQUIRE(tree.is_consistent());
            }
            const bool same = round % 4 == 0;  // no box is added or removed: buckets are kept
            for (uint32_t i = 0; i < 30; ++i) {
                const uint32_t action = same ? 3 + random() % 5 : random() % 8;
                const uint32_t item = 100 * round + i;
                if (action < 2 || (model.empty() && !same)) {
                    const Box4 box = random_box();
                    model[item] = {tree.insert(box, item), box, true};
                    continue;
                }
                if (model.empty()) continue;
                auto it = std::next(model.begin(), std::ptrdiff_t(random() % model.size()));
                Leaf& leaf = it->second;
                if (action == 2) {
                    tree.remove(leaf.node);
                    model.erase(it);
                } else if (action == 3) {
                    tree.clear_pairs(leaf.node);
                    leaf.moved = true;
                    before[side][it->first] = no_box;
                } else {
                    leaf.box = random_box();
                    leaf.moved = true;
                    tree.move(leaf.node, leaf.box);
                }
                INFO("action " << action);
                REQUIRE(tree.is_consistent());
            }
            if (round % 3 != 0) tree.rebuild(nullptr, before[side]);
            REQUIRE(tree.is_consistent());
        }
        Pairs expected_own, expected_cross, new_own, new_cross, own, cross;
        const auto is_new = [&](uint32_t a, uint32_t side, uint32_t b) {
            return !overlap(before[0][a], before[side][b]);
        };
        const auto own_is_right = [&] {
            return std::includes(expected_own.begin(), expected_own.end(), own.begin(),
                                 own.end()) &&
                   std::includes(own.begin(), own.end(), new_own.begin(), new_own.end());
        };
        const auto cross_is_right = [&] {
            return std::includes(expected_cross.begin(), expected_cross.end(), cross.begin(),
                                 cross.end()) &&
                   std::includes(cross.begin(), cross.end(), new_cross.begin(), new_cross.end());
        };
        for (const auto& [a, u] : models[0]) {
            for (const auto& [b, v] : models[0]) {
                if (a >= b || !(u.moved || v.moved) || !overlap(u.box, v.box)) continue;
                expected_own.insert({a, b});
                if (is_new(a, 0, b)) new_own.insert({a, b});
            }
            for (const auto& [b, v] : models[1]) {
                if (!(u.moved || v.moved) || !overlap(u.box, v.box)) continue;
                expected_cross.insert({a, b});
                if (is_new(a, 1, b)) new_cross.insert({a, b});
            }
        }
        trees[0].pairs(trees[0], overlaps, [&](uint32_t a, uint32_t b) {
            REQUIRE(own.insert({std::min(a, b), std::max(a, b)}).second);
        });
        trees[0].pairs(trees[1], overlaps, [&](uint32_t a, uint32_t b) {
            REQUIRE(cross.insert({a, b}).second);
        });
        REQUIRE(own_is_right());
        REQUIRE(cross_is_right());
        // In parts, as several threads do it.
        std::vector<Tree::NodePair> parts;
        for (const size_t enough : {2, 7, 1000}) {
            own.clear(), cross.clear();
            parts.clear();
            trees[0].begin_walk(trees[0], enough, parts);
            for (const auto part : parts) {
                trees[0].pairs(trees[0], part, overlaps, [&](uint32_t a, uint32_t b) {
                    REQUIRE(own.insert({std::min(a, b), std::max(a, b)}).second);
                });
            }
            parts.clear();
            trees[0].begin_walk(trees[1], enough, parts);
            for (const auto part : parts) {
                trees[0].pairs(trees[1], part, overlaps, [&](uint32_t a, uint32_t b) {
                    REQUIRE(cross.insert({a, b}).second);
                });
            }
            REQUIRE(own_is_right());
            REQUIRE(cross_is_right());
        }
        // Leaf by leaf, as when few boxes have moved.
        own.clear();
        for (const auto& [a, u] : models[0]) {
            if (!u.moved) continue;
            trees[0].pairs_of_leaf(u.node, before[0][a], overlaps, [&, item = a](uint32_t b) {
                REQUIRE(own.insert({std::min(item, b), std::max(item, b)}).second);
            });
        }
        REQUIRE(own_is_right());
        for (uint32_t side = 0; side < 2; ++side) {
            trees[side].clear_moves();
            std::fill(before[side].begin(), before[side].end(), no_box);
            for (auto& [item, leaf] : models[side]) {
                leaf.moved = false;
                before[side][item] = leaf.box;
            }
        }
    }
}

TEST_CASE("a tree built of boxes whose places double is shallow") {
    Tree tree;
    for (uint32_t i = 0; i < 4000; ++i) {
        const float x = std::exp2(float(i) / 40.0f);
        tree.insert({{x, 0.0f}, {x, 1.0f}}, i);
    }
    tree.rebuild();
    REQUIRE(tree.is_consistent());
    REQUIRE(tree.height() < 120);
}

TEST_CASE("a tree of boxes in a row is shallow") {
    Tree tree;
    for (uint32_t i = 0; i < 4096; ++i) {
        const float x = float(i);
        tree.insert({{x, 0.0f}, {x + 1.0f, 1.0f}}, i);
    }
    REQUIRE(tree.height() < 40);
}

TEST_CASE("our own sine and cosine and arc tangent agree with the library's") {
    double worst = 0.0;
    for (int i = -100000; i <= 100000; ++i) {
        const double angle = i * 0.0007;
        const Rotation q = rotation_of(angle);
        worst = std::max({worst, std::fabs(double(q.s) - std::sin(angle)),
                          std::fabs(double(q.c) - std::cos(angle))});
        const double y = std::sin(angle) * 3.0, x = std::cos(angle) * 3.0;
        worst = std::max(worst, std::fabs(angle_of(y, x) - std::atan2(y, x)));
    }
    REQUIRE(worst < 1e-7);
    REQUIRE(angle_of(0.0, 0.0) == 0.0);
    REQUIRE(rotation_of(INFINITY).c == 1.0f);
}

TEST_CASE("bytes of a tree whose flag is not a bool are refused") {
    Tree tree;
    tree.insert({{0, 0}, {1, 1}}, 0);
    std::vector<std::byte> bytes;
    ArchiveWriter write(bytes);
    write(tree);
    const auto read = [](std::span<const std::byte> from) {
        Tree made;
        ArchiveReader reader(from);
        reader(made);
        return made.is_walkable(1);
    };
    REQUIRE(read(bytes));
    // Two numbers come after the flag.
    bytes.end()[-1 - std::ptrdiff_t(2 * sizeof(uint32_t))] = std::byte{4};
    REQUIRE_THROWS_AS(read(bytes), std::invalid_argument);
}

}  // namespace broad_phase_test
