// Overlap tests of two buckets. Compiled for the instruction set of the including file: see
// simd/vector.h.
#pragma once

#include <broad_phase/bucket.h>
#include <simd/vector.h>

namespace fettle::physics::detail {
namespace {

void find_overlaps(const BucketBoxes& a, uint32_t count, const BucketBoxes& b, uint32_t* rows) {
    for (uint32_t i = 0; i < count; ++i) rows[i] = 0;
    for (int at = 0; at < int(BucketBoxes::capacity); at += width) {
        const Wide low_x = load(b.low_x + at), low_y = load(b.low_y + at);
        const Wide high_x = load(b.high_x + at), high_y = load(b.high_y + at);
        for (uint32_t i = 0; i < count; ++i) {
            const WideInt meet = (splat(a.low_x[i]) <= high_x) & (low_x <= splat(a.high_x[i])) &
                                 (splat(a.low_y[i]) <= high_y) & (low_y <= splat(a.high_y[i]));
            rows[i] |= bits(meet) << at;
        }
    }
}

}  // namespace
}  // namespace fettle::physics::detail
