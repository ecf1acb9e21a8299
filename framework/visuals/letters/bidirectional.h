#pragma once
// In which order the letters of a line stand: texts in Arabic or Hebrew run from right to left,
// and numbers and Latin words in them from left to right (Unicode's UAX #9).

#include <cstddef>
#include <string_view>
#include <vector>

namespace fettle::visuals {

class BidirectionalOrder {
  public:
    /// A paragraph, which has no line breaks in it. Its first letter with a direction decides that
    /// of the whole.
    explicit BidirectionalOrder(std::u32string_view paragraph);

    bool right_to_left() const { return right_to_left_; }
    /// The depth to which directions are nested at a letter: odd from right to left.
    int level(std::size_t letter) const { return levels_[letter]; }
    /// The letters of a line of the paragraph from left to right, as indices of the paragraph.
    std::vector<std::size_t> line(std::size_t begin, std::size_t end) const;

  private:
    std::vector<unsigned> types_;  // what kind of letter each is, in the numbers of FriBidi
    std::vector<signed char> levels_;
    unsigned direction_;
    bool right_to_left_ = false;
};

}  // namespace fettle::visuals
