#include <text/highlight.h>

#include <algorithm>
#include <array>
#include <string>

namespace fettle::console {

bool is_keyword(std::string_view word) {
    static constexpr std::array<std::string_view, 20> keywords = {
        "and", "break", "do", "else", "elseif", "end",    "for",    "function", "goto",  "if",
        "in",  "local", "is", "not",  "or",     "repeat", "return", "then",     "until", "while"};
    return std::ranges::find(keywords, word) != keywords.end();
}

namespace {

bool digit(char c) {
    return c >= '0' && c <= '9';
}
bool letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}
bool blank(char c) {
    return c == ' ' || c == '\t' || c == '\n';
}

class Lexer {
  public:
    Lexer(std::string_view line, bool output) : line_(line), output_(output) {}

    std::vector<Span> run() {
        while (at_ < line_.size()) {
            if (blank(line_[at_])) {
                ++at_;
                continue;
            }
            std::size_t begin = at_;
            Token token = next();
            spans_.push_back({begin, at_, token});
        }
        return std::move(spans_);
    }

  private:
    char peek(std::size_t ahead = 0) const {
        return at_ + ahead < line_.size() ? line_[at_ + ahead] : '\0';
    }

    Token next() {
        if (line_.substr(at_).starts_with("→")) {
            at_ += std::string_view("→").size();
            return Token::arrow;
        }
        if (!output_ && peek() == '-' && peek(1) == '-') {
            at_ = line_.size();
            return Token::comment;
        }
        if (output_ && begins_file()) return file();
        if (output_ && line_.substr(at_).starts_with("in error: ")) {
            at_ = line_.size();
            return Token::problem;
        }
        if (peek() == '"' || (!output_ && peek() == '\'')) return quoted();
        if (digit(peek()) || (peek() == '.' && digit(peek(1)))) return number();
        if (letter(peek())) return word();
        if (static_cast<unsigned char>(peek()) >= 0x80) {
            while (static_cast<unsigned char>(peek()) >= 0x80) ++at_;
            return Token::plain;
        }
        ++at_;
        return Token::symbol;
    }

    /// `/home/…` or `~/…`.
    bool begins_file() const {
        const std::size_t slash = peek() == '~' ? 1 : 0;
        return (at_ == 0 || blank(line_[at_ - 1])) && peek(slash) == '/' &&
               (letter(peek(slash + 1)) || digit(peek(slash + 1)) || peek(slash + 1) == '.');
    }

    /// The numbers and names in the path of a file have no colors. A mark after it is not in it.
    Token file() {
        while (at_ < line_.size() && !blank(line_[at_])) ++at_;
        while (std::string_view(",;:").find(line_[at_ - 1]) != std::string_view::npos) --at_;
        return Token::plain;
    }

    Token quoted() {
        char quote = line_[at_];
        std::size_t i = at_ + 1;
        while (i < line_.size() && line_[i] != quote) i += line_[i] == '\\' ? 2 : 1;
        if (i >= line_.size() && output_) {  // a quotation mark without a second one
            ++at_;
            return Token::symbol;
        }
        at_ = std::min(i + 1, line_.size());
        return Token::string;
    }

    Token number() {
        bool hexadecimal = peek() == '0' && (peek(1) == 'x' || peek(1) == 'X');
        auto exponent = [&](char c) {
            return hexadecimal ? c == 'p' || c == 'P' : c == 'e' || c == 'E';
        };
        while (digit(peek()) || letter(peek()) || peek() == '.') {
            bool sign_follows = exponent(peek()) && (peek(1) == '+' || peek(1) == '-');
            at_ += sign_follows ? 2 : 1;
        }
        return Token::number;
    }

    Token word() {
        std::size_t begin = at_;
        take_name();
        std::string_view first = line_.substr(begin, at_ - begin);
        if (first == "true" || first == "false" || first == "nil" || first == "inf")
            return Token::constant;
        bool simple = true;
        while (take_path_part()) simple = false;
        if (simple && is_keyword(first)) return output_ ? Token::plain : Token::keyword;
        return output_ && simple ? Token::plain : Token::path;
    }

    void take_name() {
        while (letter(peek()) || digit(peek())) ++at_;
    }

    /// Reads `.name`, `["odd name"]` or `[2]` after a path.
    bool take_path_part() {
        if (peek() == '.' && letter(peek(1))) {
            ++at_;
            take_name();
            return true;
        }
        if (peek() != '[') return false;
        std::size_t i = at_ + 1;
        if (i < line_.size() && line_[i] == '"') {
            ++i;
            while (i < line_.size() && line_[i] != '"') i += line_[i] == '\\' ? 2 : 1;
            ++i;
        } else {
            std::size_t digits = i;
            while (i < line_.size() && digit(line_[i])) ++i;
            if (i == digits) return false;
        }
        if (i >= line_.size() || line_[i] != ']') return false;
        at_ = i + 1;
        return true;
    }

    std::string_view line_;
    bool output_;
    std::size_t at_ = 0;
    std::vector<Span> spans_;
};

/// Finds `name` in `line` as a whole word.
std::size_t find_word(std::string_view line, std::string_view name) {
    auto inside = [](char c) { return letter(c) || digit(c); };
    for (std::size_t at = line.find(name); at != std::string_view::npos;
         at = line.find(name, at + 1)) {
        std::size_t end = at + name.size();
        bool left = at > 0 && inside(line[at - 1]) && inside(name.front());
        bool right = end < line.size() && inside(line[end]) && inside(name.back());
        if (!left && !right) return at;
    }
    return std::string_view::npos;
}

/// Names that the message may refer to, the most probable first: quoted ones such as `near 'x'`,
/// then each path and its last name. Names in a suggestion are left out.
std::vector<std::string> names_in_message(std::string_view message) {
    if (std::size_t hint = message.find("(did you mean"); hint != std::string_view::npos)
        message = message.substr(0, hint);
    std::vector<std::string> found;
    for (char quote : {'\'', '"'}) {
        std::size_t at = 0;
        while ((at = message.find(quote, at)) != std::string_view::npos) {
            std::size_t end = message.find(quote, at + 1);
            if (end == std::string_view::npos) break;
            if (end > at + 1) found.emplace_back(message.substr(at + 1, end - at - 1));
            at = end + 1;
        }
    }
    for (const Span& span : highlight_output(message)) {
        if (span.token != Token::path) continue;
        std::string_view path = message.substr(span.begin, span.end - span.begin);
        found.emplace_back(path);
        std::size_t dot = path.rfind('.');
        if (dot != std::string_view::npos) found.emplace_back(path.substr(dot + 1));
    }
    return found;
}

}  // namespace

std::vector<Span> highlight_command(std::string_view line) {
    return Lexer(line, false).run();
}
std::vector<Span> highlight_output(std::string_view line) {
    return Lexer(line, true).run();
}

Span error_span(std::string_view source, std::string_view message) {
    // The texts in quotes have the same words as a message without being its place.
    std::string line(source);
    for (const Span& span : highlight_command(source))
        if (span.token == Token::string)
            std::fill(line.begin() + static_cast<std::ptrdiff_t>(span.begin),
                      line.begin() + static_cast<std::ptrdiff_t>(span.end), ' ');
    for (const std::string& name : names_in_message(message)) {
        std::size_t at = find_word(line, name);
        if (at == std::string_view::npos) continue;
        std::size_t dot = name.rfind('.');  // for a path, only its last name
        std::size_t skip = dot == std::string::npos || dot + 1 == name.size() ? 0 : dot + 1;
        return {at + skip, at + name.size(), Token::plain};
    }
    // The message has no quotes or paths: use its last word that is a member in the line, as in
    // "a vec has no z", or its first word that occurs there.
    std::vector<Span> words = highlight_output(message);
    for (auto word = words.rbegin(); word != words.rend(); ++word) {
        const std::string_view name = message.substr(word->begin, word->end - word->begin);
        if (word->token != Token::plain || !letter(name.front())) continue;
        const std::string member = "." + std::string(name);
        const std::size_t at = find_word(line, member);
        if (at != std::string_view::npos) return {at + 1, at + member.size(), Token::plain};
    }
    for (const Span& word : words) {
        std::string_view name = message.substr(word.begin, word.end - word.begin);
        if (word.token != Token::plain || name.size() < 3 || !letter(name.front())) continue;
        std::size_t at = find_word(line, name);
        if (at != std::string_view::npos) return {at, at + name.size(), Token::plain};
    }
    std::vector<Span> spans = highlight_command(line);
    if (spans.empty()) return {0, 0, Token::plain};
    return {spans.front().begin, spans.front().end, Token::plain};
}

}  // namespace fettle::console
