#include <broad_phase/tree.h>
#include <saving/archive.h>
#include <wide/kernels.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>
#include <set>
#include <vector>

#include "catch.h"

namespace tree_build_test {

using namespace fettle::physics::detail;

namespace {

Box4 square(float x, float y, float half = 0.5f) {
    return {{x - half, y - half}, {x + half, y + half}};
}

std::vector<Box4> scattered(uint32_t count, float width, uint32_t seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> place(0.0f, width);
    std::vector<Box4> boxes;
    for (uint32_t i = 0; i < count; ++i) {
        const float x = place(random);
        boxes.push_back(square(x, place(random)));
    }
    return boxes;
}

/// A tree with its leaves, built and fitted by `count` threads.
struct Grown {
    explicit Grown(int count) : pool(count, count) {}

    void insert(const std::vector<Box4>& boxes) {
        for (const Box4& box : boxes) leaves.push_back(tree.insert(box, uint32_t(leaves.size())));
        tree.rebuild(&pool);
    }
    void place(const std::vector<Box4>& boxes) {
        parallel_for(&pool, boxes.size(), 64, [&](size_t begin, size_t end) {
            for (size_t i = begin; i < end; ++i) tree.place(leaves[i], boxes[i]);
        });
        tree.refit(&pool);
    }
    std::vector<std::byte> bytes() const {
        std::vector<std::byte> made;
        ArchiveWriter write(made);
        write(tree);
        return made;
    }

    Tree tree;
    std::vector<int32_t> leaves;
    ThreadPool pool;
};

using Pairs = std::set<std::pair<uint32_t, uint32_t>>;

Pairs pairs_of(const Tree& tree) {
    Pairs found;
    tree.pairs(tree, wide_kernels(group_size).overlaps, [&](uint32_t a, uint32_t b) {
        REQUIRE(found.insert({std::min(a, b), std::max(a, b)}).second);
    });
    return found;
}

size_t buckets_compared = 0;
void count_buckets(const BucketBoxes&, uint32_t count, const BucketBoxes&, uint32_t* rows) {
    ++buckets_compared;
    std::fill(rows, rows + count, 0u);
}
size_t work_of(const Tree& tree) {
    buckets_compared = 0;
    tree.pairs(tree, &count_buckets, [](uint32_t, uint32_t) {});
    return buckets_compared;
}

}  // namespace

TEST_CASE("a tree is the same node by node whether one thread built it or two or four") {
    const auto row = [](uint32_t count) {
        std::vector<Box4> boxes;
        for (uint32_t i = 0; i < count; ++i) boxes.push_back(square(0.9f * float(i), 0.0f));
        return boxes;
    };
    const auto doubling = [](uint32_t count) {
        std::vector<Box4> boxes;
        for (uint32_t i = 0; i < count; ++i)
            boxes.push_back(square(std::exp2(float(i % 4000) / 40.0f), 0.0f));
        return boxes;
    };
    for (const uint32_t count : {0u, 1u, 2u, 3u, 16u, 17u, 129u, 900u, 20000u}) {
        const float width = 2.0f * std::sqrt(float(count));
        const std::vector<std::vector<Box4>> places = {scattered(count, width, 1),
                                                       std::vector<Box4>(count, square(1, 1)),
                                                       row(count),
                                                       doubling(count),
                                                       scattered(count, width, 2),
                                                       scattered(count, 2 * width, 3)};
        Grown one(1), two(2), four(4);
        for (Grown* grown : {&one, &two, &four}) grown->insert(places.back());
        REQUIRE(one.bytes() == two.bytes());
        REQUIRE(one.bytes() == four.bytes());
        for (const auto& boxes : places) {
            for (Grown* grown : {&one, &two, &four}) {
                grown->place(boxes);
                REQUIRE(grown->tree.is_consistent());
                REQUIRE(grown->tree.is_walkable(count));
                REQUIRE(grown->tree.height() < 130);
            }
            REQUIRE(one.bytes() == two.bytes());
            REQUIRE(one.bytes() == four.bytes());
        }
    }
}

TEST_CASE(
    "a tree whose leaves all went elsewhere finds their pairs with as little work as a new one") {
    const uint32_t count = 3000;
    const auto before = scattered(count, 100, 4), after = scattered(count, 100, 5);
    Grown moved(2), fresh(1);
    moved.insert(before);
    moved.tree.clear_moves();
    moved.place(after);
    fresh.insert(after);
    Pairs expected;
    for (uint32_t a = 0; a < count; ++a)
        for (uint32_t b = a + 1; b < count; ++b)
            if (overlap(after[a], after[b])) expected.insert({a, b});
    REQUIRE(pairs_of(moved.tree) == expected);
    REQUIRE(pairs_of(fresh.tree) == expected);
    REQUIRE(work_of(moved.tree) < work_of(fresh.tree) * 5 / 4);
    REQUIRE(work_of(fresh.tree) > count / 16);
}

TEST_CASE("a search for new pairs does not repeat pairs whose boxes overlapped before") {
    const auto boxes = scattered(1000, 20, 10);
    Grown grown(2);
    grown.insert(boxes);
    grown.place(boxes);
    REQUIRE(pairs_of(grown.tree).size() > 1000);
    grown.tree.clear_moves();
    grown.place(boxes);
    const size_t known = pairs_of(grown.tree).size();
    REQUIRE(known < 100);  // of leaves that are in no bucket
    grown.tree.clear_pairs(grown.leaves[500]);
    const auto meets = std::count_if(boxes.begin(), boxes.end(),
                                     [&](const Box4& box) { return overlap(box, boxes[500]); });
    REQUIRE(meets > 1);
    REQUIRE(pairs_of(grown.tree).size() >= known + size_t(meets) - 1);
    grown.tree.clear_moves();
    grown.tree.move(grown.leaves[500], boxes[501]);
    REQUIRE(pairs_of(grown.tree).count({500, 501}) == 1);
}

TEST_CASE("boxes that move slightly keep their places in the tree") {
    const uint32_t count = 2000;
    const auto rest = scattered(count, 80, 6);
    Grown grown(2);
    grown.insert(rest);
    grown.place(rest);
    grown.tree.clear_moves();
    const auto parents = [&] {
        // Node by node: box (16 bytes), parent, children, epoch.
        std::vector<int32_t> made;
        const auto bytes = grown.bytes();
        for (size_t at = 8 + 16; at + 16 <= bytes.size(); at += 32) {
            made.emplace_back();
            std::memcpy(&made.back(), bytes.data() + at, sizeof(int32_t));
        }
        return made;
    };
    const auto built = parents();
    std::mt19937 random(7);
    std::uniform_real_distribution<float> shift(-0.02f, 0.02f);
    for (int round = 0; round < 30; ++round) {
        auto boxes = rest;
        for (Box4& box : boxes) box = square(box.low.x + 0.5f + shift(random), box.low.y + 0.5f);
        grown.place(boxes);
        REQUIRE(grown.tree.is_consistent());
        uint32_t found = 0;
        grown.tree.query(boxes[17],
                         [&](uint32_t item) { found += overlap(boxes[item], boxes[17]); });
        REQUIRE(found == std::count_if(boxes.begin(), boxes.end(),
                                       [&](const Box4& box) { return overlap(box, boxes[17]); }));
        grown.tree.clear_moves();
    }
    REQUIRE(parents() == built);
}

TEST_CASE("a tree read from bytes goes on node by node like the one that was written") {
    std::mt19937 random(8);
    std::uniform_real_distribution<float> shift(-1.5f, 1.5f);
    Grown grown(2);
    auto boxes = scattered(5000, 150, 9);
    grown.insert(boxes);
    for (int round = 0; round < 40; ++round) {
        const auto bytes = grown.bytes();
        Grown restored(1);
        ArchiveReader read(bytes);
        read(restored.tree);
        restored.leaves = grown.leaves;
        for (Box4& box : boxes) {
            const float x = box.low.x + 0.5f + shift(random), y = box.low.y + 0.5f;
            box = square(x, y + shift(random));
        }
        for (Grown* each : {&grown, &restored}) {
            if (round % 5 == 3) {
                each->tree.remove(each->leaves.back());
                each->leaves.back() = each->tree.insert(boxes.back(), uint32_t(boxes.size() - 1));
                each->tree.rebuild(&each->pool);
            }
            if (round % 4 == 2) {
                for (size_t i = 0; i < 50; ++i) each->tree.move(each->leaves[i], boxes[i]);
            } else {
                each->place(boxes);
            }
            each->tree.clear_moves();
            REQUIRE(each->tree.is_consistent());
        }
        REQUIRE(grown.bytes() == restored.bytes());
    }
}

}  // namespace tree_build_test
