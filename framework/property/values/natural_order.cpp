#include <fettle/property/natural_order.h>

#include <algorithm>

#include "condition_words.h"

namespace fettle::property {
namespace {

/// The digits at `at`, without zeros in front.
std::string_view number_at(std::string_view text, std::size_t at) {
    std::size_t end = at;
    while (end < text.size() && is_digit(text[end])) ++end;
    while (at + 1 < end && text[at] == '0') ++at;
    return text.substr(at, end - at);
}

}  // namespace

bool NaturalOrder::operator()(std::string_view a, std::string_view b) const {
    std::size_t i = 0, j = 0;
    while (i < a.size() && j < b.size()) {
        if (is_digit(a[i]) && is_digit(b[j])) {
            const std::string_view one = number_at(a, i), other = number_at(b, j);
            if (one.size() != other.size()) return one.size() < other.size();
            if (one != other) return one < other;
            i = static_cast<std::size_t>(one.end() - a.begin());
            j = static_cast<std::size_t>(other.end() - b.begin());
        } else if (a[i] != b[j]) {
            return static_cast<unsigned char>(a[i]) < static_cast<unsigned char>(b[j]);
        } else {
            ++i, ++j;
        }
    }
    const bool same = i == a.size() && j == b.size();  // but for zeros in front of numbers
    return same ? a < b : i == a.size();
}

bool NaturalOrder::operator()(const std::vector<std::string>& a,
                              const std::vector<std::string>& b) const {
    return std::lexicographical_compare(
        a.begin(), a.end(), b.begin(), b.end(),
        [this](const std::string& x, const std::string& y) { return (*this)(x, y); });
}

}  // namespace fettle::property
