#pragma once
// The words of a condition: numbers, texts, names and signs.

#include <charconv>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include <fettle/property/error.h>

namespace fettle::property {

enum class Token : std::uint8_t { end, number, text, name, sign };

inline bool begins_name(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' ||
           static_cast<unsigned char>(c) >= 0x80;
}
inline bool is_digit(char c) {
    return c >= '0' && c <= '9';
}
inline bool is_space(char c) {
    return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

/// The words of a condition, one after another.
class Words {
  public:
    explicit Words(std::string_view text) : text_(text) { next(); }

    Token kind = Token::end;
    std::string_view word;  // as written
    std::string value;      // of a text

    void next() {
        while (at_ < text_.size() && is_space(text_[at_])) ++at_;
        begin_ = at_;
        if (at_ == text_.size()) {
            kind = Token::end;
        } else if (begins_name(text_[at_])) {
            kind = Token::name;
            while (at_ < text_.size() && (begins_name(text_[at_]) || is_digit(text_[at_]))) ++at_;
        } else if (is_digit(text_[at_]) ||
                   (text_[at_] == '.' && at_ + 1 < text_.size() && is_digit(text_[at_ + 1]))) {
            kind = Token::number;
            take_number();
        } else if (text_[at_] == '"' || text_[at_] == '\'') {
            kind = Token::text;
            take_text();
        } else {
            kind = Token::sign;
            take_sign();
        }
        word = text_.substr(begin_, at_ - begin_);
    }
    bool is(std::string_view sign) const {
        return (kind == Token::sign || kind == Token::name) && word == sign;
    }
    [[noreturn]] void fail(const std::string& reason) const {
        throw Error(ErrorKind::rejected, "condition \"" + std::string(text_.substr(0, 200)) +
                                             "\", character " + std::to_string(begin_ + 1) + ": " +
                                             reason);
    }
    std::string found() const {
        return kind == Token::end ? "the end" : "\"" + std::string(word) + "\"";
    }

  private:
    void take_number() {
        double number = 0;
        const auto end = std::from_chars(text_.data() + at_, text_.data() + text_.size(), number);
        at_ = static_cast<std::size_t>(end.ptr - text_.data());
        if (end.ec != std::errc()) fail("this number is too large or too small");
        if (at_ < text_.size() && begins_name(text_[at_])) fail("a number has no letters");
    }
    void take_text() {
        const char quote = text_[at_++];
        value.clear();
        for (; at_ < text_.size() && text_[at_] != quote; ++at_) {
            if (text_[at_] == '\\' && at_ + 1 < text_.size()) ++at_;
            value += text_[at_];
        }
        if (at_ == text_.size()) fail("this text has no end");
        ++at_;
    }
    void take_sign() {
        const std::string_view rest = text_.substr(at_);
        for (const std::string_view two : {"<=", ">=", "==", "~="})
            if (rest.starts_with(two)) {
                at_ += 2;
                return;
            }
        if (rest.starts_with("!=")) fail("\"not equal\" is written ~=");
        if (rest.starts_with("&&")) fail("\"and\" is a word here");
        if (rest.starts_with("||")) fail("\"or\" is a word here");
        if (rest[0] == '!') fail("\"not\" is a word here");
        if (rest[0] == '=') fail("two values are compared by ==");
        if (std::string_view("<>+-*/()[].").find(rest[0]) == std::string_view::npos)
            fail("\"" + std::string(1, rest[0]) + "\" means nothing in a condition");
        ++at_;
    }

    std::string_view text_;
    std::size_t at_ = 0, begin_ = 0;
};

}  // namespace fettle::property
