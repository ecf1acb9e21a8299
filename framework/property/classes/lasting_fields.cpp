#include "lasting_fields.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <mutex>
#include <set>
#include <tuple>

#include <values/process_data.h>

namespace fettle::property {
namespace {

bool comes_before(const Field& a, const Field& b) {
    const auto key = [](const Field& f) {
        // Compares the bits of the numbers, because NaN is neither less nor greater than others.
        return std::tuple(
            std::tie(f.name, f.type, f.unit, f.doc, f.reference_class, f.element, f.nullable),
            std::bit_cast<std::uint64_t>(f.range.min), std::bit_cast<std::uint64_t>(f.range.max));
    };
    return key(a) < key(b);
}

struct Order {
    bool operator()(const std::vector<Field>& a, const std::vector<Field>& b) const {
        return std::ranges::lexicographical_compare(a, b, comes_before);
    }
};

struct Lists {
    std::mutex mutex;  // each tree has a thread of its own
    std::set<std::vector<Field>, Order> lists;

    void free() { lists.clear(); }
};

}  // namespace

const std::vector<Field>& lasting(const std::vector<Field>& fields) {
    Lists& all = process_data<Lists>();
    const std::scoped_lock lock(all.mutex);
    return *all.lists.insert(fields).first;
}

}  // namespace fettle::property
