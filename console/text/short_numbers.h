#pragma once
// Numbers with few digits for people, and the whole numbers that they stand for.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace fettle::console {

/// A number for people: `digits` significant digits, but all digits before the point; 0 below 1e-6.
std::string short_number(double value, int digits = 4);

/// The same for a narrow place: 0.0001235 becomes 1.235e-4.
std::string narrow_number(double value, int digits = 4);

/// A short number for a place whose width stays the same while the number changes: blanks stand
/// before it. The place has room for numbers up to the size of `largest` with a sign; a number that
/// is far smaller has fewer digits.
std::string aligned_number(double value, double largest, int digits = 4);

/// A number that a text shows with fewer digits.
struct ShortNumber {
    std::size_t begin, end;  // bytes of the text
    std::string whole;
    friend bool operator==(const ShortNumber&, const ShortNumber&) = default;
};

/// A line with short numbers, in the order of their places.
struct ShortLine {
    std::string text;
    std::vector<ShortNumber> numbers{};
};

/// A printed line with four significant digits in each number. An old and a new value that differ
/// get as many digits as show it. Texts in quotes, paths and the source of a formula stay as they
/// are.
ShortLine with_short_numbers(std::string_view line);

/// The part of the text from `begin` to `end` with whole numbers, also those that it cuts.
std::string whole_text(std::string_view text, const std::vector<ShortNumber>& numbers,
                       std::size_t begin, std::size_t end);

}  // namespace fettle::console
