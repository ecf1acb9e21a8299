#pragma once

#include <geometry/vector.h>

// A bucket: a subtree of a tree of boxes with up to sixteen leaves that are near each other. All
// pairs of two buckets are tested many at a time, which is faster than walking the levels below
// them.

namespace fettle::physics::detail {

struct alignas(64) BucketBoxes {
    static constexpr uint32_t capacity = 16;

    float low_x[capacity], low_y[capacity], high_x[capacity], high_y[capacity];

    void set(uint32_t i, const Box4& box) {
        low_x[i] = box.low.x, low_y[i] = box.low.y;
        high_x[i] = box.high.x, high_y[i] = box.high.y;
    }
};

struct BoxBucket {
    static constexpr uint32_t capacity = BucketBoxes::capacity;

    BucketBoxes now;
    BucketBoxes before;  ///< valid in that epoch: the boxes when all their pairs were known
    uint32_t item[capacity];
    uint32_t count = 0;
    uint32_t moved = 0;  ///< one bit for each box that moved in that epoch
    uint32_t epoch = 0;
};

/// For each of the first `count` boxes of a, writes which boxes of b overlap it, one bit each.
/// Unused boxes of b are `no_box`.
using FindOverlaps = void (*)(const BucketBoxes& a, uint32_t count, const BucketBoxes& b,
                              uint32_t* rows);

}  // namespace fettle::physics::detail
