#include <prompt/text_edit.h>

#include <algorithm>

#include <text/utf8.h>

namespace fettle::console {

namespace {

constexpr std::size_t undo_steps = 200;

/// Letters of any script, digits and underscores are parts of words.
bool word_byte(char c) {
    auto u = static_cast<unsigned char>(c);
    return u >= 0x80 || (u >= '0' && u <= '9') || (u >= 'a' && u <= 'z') ||
           (u >= 'A' && u <= 'Z') || u == '_';
}

}  // namespace

std::pair<std::size_t, std::size_t> TextEdit::selection() const {
    return std::minmax(cursor_, anchor_);
}

std::string_view TextEdit::selected() const {
    auto [from, to] = selection();
    return std::string_view(text_).substr(from, to - from);
}

void TextEdit::save_for_undo(bool typing) {
    redo_.clear();
    if (typing && typing_ && !undo_.empty()) return;
    typing_ = typing;
    undo_.push_back({text_, cursor_, anchor_});
    if (undo_.size() > undo_steps) undo_.erase(undo_.begin());
}

void TextEdit::replace(std::size_t from, std::size_t to, std::string_view text) {
    from = code_point_boundary(text_, std::min(from, to));
    to = code_point_boundary(text_, std::max(from, to));
    std::size_t room = max_bytes - (text_.size() - (to - from));
    text = text.substr(0, code_point_boundary(text, std::min(text.size(), room)));
    bool typing = from == to && code_point_count(text) == 1 && text != "\n" && text != " ";
    save_for_undo(typing);
    text_.replace(from, to - from, text);
    cursor_ = anchor_ = from + text.size();
}

void TextEdit::assign(std::string_view text) {
    replace(0, text_.size(), text);
}

void TextEdit::insert(std::string_view text) {
    auto [from, to] = selection();
    replace(from, to, text);
}

void TextEdit::move(Motion motion, bool select) {
    typing_ = false;
    auto [from, to] = selection();
    if (!select && from != to && (motion == Motion::left || motion == Motion::right))
        cursor_ = motion == Motion::left ? from : to;
    else
        cursor_ = target(motion);
    if (!select) anchor_ = cursor_;
}

void TextEdit::erase(Motion motion) {
    auto [from, to] = selection();
    if (from == to) {
        std::size_t other = target(motion);
        from = std::min(cursor_, other);
        to = std::max(cursor_, other);
    }
    if (from != to) replace(from, to, "");
}

void TextEdit::place(std::size_t offset, bool select) {
    typing_ = false;
    cursor_ = code_point_boundary(text_, offset);
    if (!select) anchor_ = cursor_;
}

void TextEdit::select(std::size_t from, std::size_t to) {
    typing_ = false;
    anchor_ = code_point_boundary(text_, from);
    cursor_ = code_point_boundary(text_, to);
}

void TextEdit::select_word(std::size_t offset) {
    std::size_t from = code_point_boundary(text_, offset), to = from;
    while (from > 0 && word_byte(text_[from - 1])) --from;
    while (to < text_.size() && word_byte(text_[to])) ++to;
    if (from == to) to = next_code_point(text_, to);
    select(from, to);
}

void TextEdit::restore(std::vector<State>& from, std::vector<State>& to) {
    to.push_back({text_, cursor_, anchor_});
    text_ = std::move(from.back().text);
    cursor_ = from.back().cursor;
    anchor_ = from.back().anchor;
    from.pop_back();
    typing_ = false;
}

bool TextEdit::undo() {
    if (undo_.empty()) return false;
    restore(undo_, redo_);
    return true;
}

bool TextEdit::redo() {
    if (redo_.empty()) return false;
    restore(redo_, undo_);
    return true;
}

std::size_t TextEdit::target(Motion motion) const {
    std::size_t at = cursor_;
    switch (motion) {
        case Motion::left:
            return previous_code_point(text_, at);
        case Motion::right:
            return next_code_point(text_, at);
        case Motion::word_left:
            while (at > 0 && !word_byte(text_[at - 1])) --at;
            while (at > 0 && word_byte(text_[at - 1])) --at;
            return at;
        case Motion::word_right:
            while (at < text_.size() && !word_byte(text_[at])) ++at;
            while (at < text_.size() && word_byte(text_[at])) ++at;
            return at;
        case Motion::line_start:
            return line_begin(at);
        case Motion::line_end:
            return line_finish(at);
        case Motion::line_up: {
            std::size_t line = line_of(at);
            return line == 0 ? 0 : offset_at(line - 1, column_of(at));
        }
        case Motion::line_down: {
            std::size_t line = line_of(at);
            return line + 1 >= line_count() ? text_.size() : offset_at(line + 1, column_of(at));
        }
        case Motion::text_start:
            return 0;
        case Motion::text_end:
            return text_.size();
    }
    return at;
}

std::size_t TextEdit::line_begin(std::size_t offset) const {
    if (offset == 0) return 0;
    std::size_t end = text_.rfind('\n', offset - 1);
    return end == std::string::npos ? 0 : end + 1;
}

std::size_t TextEdit::line_finish(std::size_t offset) const {
    std::size_t end = text_.find('\n', offset);
    return end == std::string::npos ? text_.size() : end;
}

std::size_t TextEdit::line_count() const {
    return 1 + static_cast<std::size_t>(std::count(text_.begin(), text_.end(), '\n'));
}

std::size_t TextEdit::line_of(std::size_t offset) const {
    auto end = text_.begin() + static_cast<std::ptrdiff_t>(std::min(offset, text_.size()));
    return static_cast<std::size_t>(std::count(text_.begin(), end, '\n'));
}

std::size_t TextEdit::column_of(std::size_t offset) const {
    std::size_t begin = line_begin(offset);
    return cell_count(std::string_view(text_).substr(begin, offset - begin));
}

std::string_view TextEdit::line(std::size_t index) const {
    std::size_t begin = 0;
    for (; index > 0; --index) {
        std::size_t end = text_.find('\n', begin);
        if (end == std::string::npos) return {};
        begin = end + 1;
    }
    return std::string_view(text_).substr(begin, line_finish(begin) - begin);
}

std::size_t TextEdit::offset_at(std::size_t index, std::size_t column) const {
    std::string_view found = line(std::min(index, line_count() - 1));
    return static_cast<std::size_t>(found.data() - text_.data()) + cell_offset(found, column);
}

}  // namespace fettle::console
