#include <letters/bidirectional.h>

#include <new>
#include <numeric>
#include <type_traits>

#include <fribidi.h>

namespace fettle::visuals {

static_assert(std::is_same_v<FriBidiLevel, signed char>);

BidirectionalOrder::BidirectionalOrder(std::u32string_view paragraph)
    : types_(paragraph.size()), levels_(paragraph.size()), direction_(FRIBIDI_PAR_ON) {
    const std::vector<FriBidiChar> letters(paragraph.begin(), paragraph.end());
    const auto size = static_cast<FriBidiStrIndex>(letters.size());
    std::vector<FriBidiBracketType> brackets(letters.size());
    fribidi_get_bidi_types(letters.data(), size, types_.data());
    fribidi_get_bracket_types(letters.data(), size, types_.data(), brackets.data());
    if (fribidi_get_par_embedding_levels_ex(types_.data(), brackets.data(), size, &direction_,
                                            levels_.data()) == 0 &&
        size > 0)
        throw std::bad_alloc();
    right_to_left_ = FRIBIDI_IS_RTL(direction_) != 0;
}

std::vector<std::size_t> BidirectionalOrder::line(std::size_t begin, std::size_t end) const {
    if (begin >= end) return {};
    // The levels of a line are its own: spaces at its end are as the paragraph.
    std::vector<FriBidiLevel> levels(levels_.begin() + static_cast<std::ptrdiff_t>(begin),
                                     levels_.begin() + static_cast<std::ptrdiff_t>(end));
    std::vector<FriBidiStrIndex> places(end - begin);
    std::iota(places.begin(), places.end(), static_cast<FriBidiStrIndex>(begin));
    if (fribidi_reorder_line(0, types_.data() + begin, static_cast<FriBidiStrIndex>(end - begin), 0,
                             direction_, levels.data(), nullptr, places.data()) == 0)
        throw std::bad_alloc();
    return {places.begin(), places.end()};
}

}  // namespace fettle::visuals
