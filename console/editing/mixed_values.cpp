#include <editing/mixed_values.h>

#include <algorithm>
#include <cmath>

#include <look/fields.h>
#include <text/short_numbers.h>

namespace fettle::console {

using property::Handle;
using property::Property;
using property::Value;
using property::Vec2;

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
    const bool number = value.is_numeric(), vector = value.is(property::Type::vec2);
    const auto parts = [&](const Value& of) {
        return vector ? of.vec2() : number ? Vec2(of.as_double(), 0) : Vec2();
    };
    if (row.next == 0) {
        row.differ = false;
        row.low = row.high = parts(value);
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
        Vec2 theirs;
        if (number && tree.read(other, *row.found, theirs.x)) {
            row.differ = row.differ || theirs.x != value.as_double();
        } else {
            const Value read = tree.peek(other, *row.found);
            row.differ = row.differ || read != value;
            const bool has_range =
                vector ? read.is(property::Type::vec2) : number && read.is_numeric();
            if (!has_range) continue;
            theirs = parts(read);
        }
        row.low = row.low.min(theirs);
        row.high = row.high.max(theirs);
    }
    if (row.next == others_.size()) {
        row.next = 0;
        row.differed = row.differ;
        row.lowest = row.low;
        row.highest = row.high;
    }
    if (!row.differ && !row.differed) return {};
    const std::string range = range_text(row, vector);
    if (range.empty()) return "mixed";
    return "mixed: " + range + (property.unit.empty() ? "" : " " + property.unit);
}

/// "1 to 5", or "x 1 to 5, y 3"; "" if all of them are equal.
std::string MixedValues::range_text(const Comparison& row, bool vector) {
    const auto text = [](double low, double high) {
        // Beside the other end, a tiny one is 0.
        const double tiny = 1e-4 * std::max(std::abs(low), std::abs(high));
        const auto end = [&](double value) {
            return short_number(std::abs(value) < tiny ? 0 : value);
        };
        if (!(low < high)) return end(low);
        return end(low) == end(high) ? "about " + end(low) : end(low) + " to " + end(high);
    };
    const Vec2 &low = row.lowest, &high = row.highest;
    if (!(low.x < high.x) && !(low.y < high.y)) return {};
    if (!vector) return text(low.x, high.x);
    return "x " + text(low.x, high.x) + ", y " + text(low.y, high.y);
}

}  // namespace fettle::console
