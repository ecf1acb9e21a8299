// What the player types, selects, copies and pastes in a text field.

#include <algorithm>
#include <cmath>
#include <optional>

#include <interaction/player.h>
#include <interaction/words.h>

namespace fettle::interface {

using property::Value;
using property::Vec2;

namespace {

constexpr std::size_t longest_text = 1 << 20;       // bytes
constexpr double next_click = 0.4, same_place = 5;  // s, px: of a double click

/// The caret and the other end of the selection, within the text.
struct Caret {
    std::int64_t length, at, mark;
    explicit Caret(const Widget& field)
        : length(characters(field.content.text)),
          at(std::min(field.content.caret, length)),
          mark(std::min(field.content.mark.value_or(at), length)) {}
    Span selected() const { return {std::min(at, mark), std::max(at, mark)}; }
};

std::string part(const std::string& text, const Span& span) {
    const std::size_t from = byte_of(text, span.from);
    return text.substr(from, byte_of(text, span.to) - from);
}

/// One line: each run of line ends and other control characters becomes a space, none at the ends.
std::string in_one_line(std::string_view text) {
    std::string line;
    bool gap = false;
    for (const char32_t c : property::decode_utf8(text)) {
        const bool control = c < 0x20 || (c >= 0x7f && c < 0xa0) || c == 0x2028 || c == 0x2029;
        if (!control) {
            if (gap && !line.empty()) line += ' ';
            property::append_code_point(line, c);
        }
        gap = control;
    }
    return line;
}

}  // namespace

// --- Changes of the text

void Player::set_text(Widget& field, const std::string& text, std::int64_t caret) {
    const std::string before = field.content.text;
    widgets_.set(field.self, "text", Value(text));
    put_caret(field, caret, {});
    if (!field.content.bind.empty()) binding_.update(field);
    if (field.content.text != before) widgets_.emit(field, "changed", {Value(field.content.text)});
}

void Player::put_caret(Widget& field, std::int64_t caret, std::optional<std::int64_t> mark) {
    if (field.content.caret != caret) widgets_.set(field.self, "caret", Value(caret));
    if (mark == caret) mark.reset();
    if (field.content.mark != mark) widgets_.set(field.self, "mark", mark ? Value(*mark) : Value());
}

void Player::replace(Widget& field, const Span& span, const std::string& by) {
    std::string text = field.content.text;
    const std::size_t from = byte_of(text, span.from);
    text.replace(from, byte_of(text, span.to) - from, by);
    set_text(field, text, span.from + characters(by));
}

/// How many characters may take the place of the selection.
std::int64_t Player::room(const Widget& field) {
    const Caret caret(field);
    const std::int64_t selected = caret.selected().to - caret.selected().from;
    const std::int64_t most = field.content.max_length > 0
                                  ? field.content.max_length
                                  : static_cast<std::int64_t>(longest_text);
    return std::max<std::int64_t>(0, most - (caret.length - selected));
}

void Player::type(Widget& field, const std::string& text) {
    const bool fits =
        characters(text) <= room(field) && field.content.text.size() + text.size() <= longest_text;
    if (fits) replace(field, Caret(field).selected(), text);
}

// --- The clipboard: `input.clipboard`, which the window keeps equal to that of the system

std::string Player::clipboard() const {
    const property::Tree& tree = widgets_.tree();
    const property::Handle input = tree.child(tree.root(), "input");
    const property::Property* const found = input ? tree.find(input, "clipboard") : nullptr;
    return found == nullptr ? std::string() : tree.peek(input, *found).text();
}

void Player::copy(const Widget& field) {
    const Span selected = Caret(field).selected();
    if (selected.empty()) return;
    property::Tree& tree = widgets_.tree();
    const property::Handle input = tree.child(tree.root(), "input");
    if (input && tree.find(input, "clipboard") != nullptr)
        tree.set(input, "clipboard", Value(part(field.content.text, selected)));
}

void Player::paste(Widget& field) {
    std::string line = in_one_line(clipboard());
    line.resize(byte_of(line, room(field)));
    const bool fits = field.content.text.size() + line.size() <= longest_text;
    if (!line.empty() && fits) replace(field, Caret(field).selected(), line);
}

// --- Keys

/// Keys that are held with ctrl. False for a key that has no such meaning.
bool Player::shortcut(Widget& field, const std::string& key) {
    const Caret caret(field);
    if (key == "a") {
        put_caret(field, caret.length, 0);
    } else if (key == "c") {
        copy(field);
    } else if (key == "x") {
        copy(field);
        if (!caret.selected().empty()) replace(field, caret.selected(), "");
    } else if (key == "v") {
        paste(field);
    } else {
        return false;
    }
    return true;
}

/// Where the key moves the caret; nothing for other keys.
std::optional<std::int64_t> Player::caret_after(const Widget& field, const std::string& key,
                                                bool by_words, bool selecting) {
    const Caret caret(field);
    if (key == "home") return 0;
    if (key == "end") return caret.length;
    if (key != "left" && key != "right") return {};
    // In a text that begins at the right, the key with the arrow to the left goes on in it.
    const std::string& text = field.content.text;
    const std::vector<double> carets = Lettering::of(field).carets(layout_.media(), text);
    const bool onward = (key == "left") == (carets.front() > carets.back());
    if (by_words) return onward ? word_after(text, caret.at) : word_before(text, caret.at);
    const Span selected = caret.selected();
    if (!selected.empty() && !selecting) return onward ? selected.to : selected.from;
    return std::clamp<std::int64_t>(caret.at + (onward ? 1 : -1), 0, caret.length);
}

/// Deletes what is selected; otherwise the character, or the word, before or after the caret.
void Player::erase(Widget& field, bool onward, bool by_words) {
    const Caret caret(field);
    Span gone = caret.selected();
    if (gone.empty() && onward)
        gone.to = by_words ? word_after(field.content.text, caret.at)
                           : std::min(caret.at + 1, caret.length);
    else if (gone.empty())
        gone.from = by_words ? word_before(field.content.text, caret.at)
                             : std::max<std::int64_t>(caret.at - 1, 0);
    if (!gone.empty()) replace(field, gone, "");
}

/// False for a key that has no meaning in a text.
bool Player::edit(Widget& field, const std::string& key) {
    const bool control = holds("control"), shift = holds("shift");
    if (control && shortcut(field, key)) return true;
    if (key == "backspace" || key == "delete") {
        erase(field, key == "delete", control);
    } else if (key == "enter") {
        widgets_.emit(field, "submitted", {Value(field.content.text)});
    } else if (const auto to = caret_after(field, key, control, shift)) {
        const Caret caret(field);
        put_caret(field, *to, shift ? std::optional(caret.mark) : std::nullopt);
    } else {
        // A space is typed as text.
        return key == "space";
    }
    return true;
}

// --- The mouse

/// The place of the nearest gap between two letters.
std::int64_t Player::place_near(const Widget& field, const Vec2& point) {
    const double x =
        point.x - field.arranged.box.lower.x - measure::field_x + field.animation.view_left;
    const std::vector<double> carets =
        Lettering::of(field).carets(layout_.media(), field.content.text);
    return std::ranges::min_element(carets, {}, [x](double caret) { return std::abs(caret - x); }) -
           carets.begin();
}

/// A click puts the caret, a second one selects the word, a third one everything.
void Player::press_text(Widget& field, const Vec2& point) {
    const bool again = clicks_.field == field.self && clicks_.since < next_click &&
                       (point - clicks_.at).length() < same_place;
    clicks_ = {.field = field.self,
               .count = again ? clicks_.count % 3 + 1 : 1,
               .since = 0,
               .at = point,
               .word = word_at(field.content.text, place_near(field, point))};
    if (clicks_.count == 3) return put_caret(field, characters(field.content.text), 0);
    if (clicks_.count == 2) return put_caret(field, clicks_.word.to, clicks_.word.from);
    const Caret caret(field);
    put_caret(field, place_near(field, point),
              holds("shift") ? std::optional(caret.mark) : std::nullopt);
}

/// Selects from where the button was pressed; after a double click whole words.
void Player::drag_text(Widget& field, const Vec2& point) {
    const std::int64_t place = place_near(field, point);
    if (clicks_.count == 1) return put_caret(field, place, Caret(field).mark);
    if (clicks_.count == 3) return;
    const Span word = word_at(field.content.text, place);
    if (word.from < clicks_.word.from)
        put_caret(field, word.from, clicks_.word.to);
    else
        put_caret(field, std::max(word.to, clicks_.word.to), clicks_.word.from);
}

}  // namespace fettle::interface
