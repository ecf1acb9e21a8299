#include <editing/mixed_values.h>

#include <algorithm>

#include <look/fields.h>
#include <text/short_numbers.h>

namespace fettle::console {

using property::Handle;
using property::Property;
using property::Value;

namespace {

// Instances whose values of one property are compared in a frame. More numbers are compared,
// because they are read without making values.
constexpr std::size_t compared_in_a_frame = 50, numbers_in_a_frame = 1000;

}  // namespace

void MixedValues::compare_with(const std::vector<Handle>& others, std::uint64_t revision) {
    if (revision == revision_) return;
    revision_ = revision;
    others_ = others;
    rows_.clear();
}

const Property* MixedValues::same(const property::Tree& tree, Handle other,
                                  const Property& property) {
    if (!tree.alive(other)) return nullptr;
    const Property* found = tree.find(other, property.name);
    return found != nullptr && found->type == property.type ? found : nullptr;
}

std::string MixedValues::text(const property::Tree& tree, const Property& property,
                              const Value& value) {
    if (others_.empty()) return {};
    Comparison& row = rows_[&property];
    const bool number = value.is_numeric();
    if (row.next == 0) {
        row.differ = false;
        row.low = row.high = number ? value.as_double() : 0;
    }
    const std::size_t end =
        std::min(row.next + (number ? numbers_in_a_frame : compared_in_a_frame), others_.size());
    for (; row.next < end; ++row.next) {
        const Handle other = others_[row.next];
        if (!tree.alive(other)) continue;
        const property::Class& of = tree.class_of(other);
        if (row.of != &of) {
            const Property* found = same(tree, other, property);
            // What a class does not declare differs from instance to instance.
            row.of = found != nullptr && found->owner != nullptr ? &of : nullptr;
            row.found = found;
        }
        if (row.found == nullptr) continue;
        double theirs = 0;
        if (number && tree.read(other, *row.found, theirs)) {
            row.differ = row.differ || theirs != value.as_double();
        } else {
            const Value read = tree.peek(other, *row.found);
            row.differ = row.differ || read != value;
            if (!number || !read.is_numeric()) continue;
            theirs = read.as_double();
        }
        row.low = std::min(row.low, theirs);
        row.high = std::max(row.high, theirs);
    }
    if (row.next == others_.size()) {
        row.next = 0;
        row.differed = row.differ;
        row.lowest = row.low;
        row.highest = row.high;
    }
    if (!row.differ && !row.differed) return {};
    if (!number || !(row.lowest < row.highest)) return "mixed";
    const std::string unit = property.unit.empty() ? "" : " " + property.unit;
    return "mixed: " + short_number(row.lowest) + " to " + short_number(row.highest) + unit;
}

}  // namespace fettle::console
