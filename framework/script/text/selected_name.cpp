#include <vector>

#include <text/selected_name.h>
#include <text/words.h>

namespace fettle::script {

namespace {

constexpr std::size_t npos = std::string_view::npos;

/// Finds the places of the word `it` in a text of Lua.
class ItFinder {
  public:
    explicit ItFinder(std::string_view text) : text_(text) {}

    std::vector<std::size_t> run() {
        while (at_ < text_.size()) {
            const char c = text_[at_];
            if (text_.substr(at_).starts_with("--"))
                skip_comment();
            else if (c == '"' || c == '\'')
                skip_quoted(c);
            else if (c == '[' && long_bracket(at_) != npos)
                skip_long(long_bracket(at_));
            else if (is_word(c))
                word();
            else
                sign(c);
        }
        return own_ ? std::vector<std::size_t>() : std::move(found_);
    }

  private:
    /// The number of signs in a long bracket such as `[==[`; npos if there is none.
    std::size_t long_bracket(std::size_t at) const {
        std::size_t i = at + 1;
        while (i < text_.size() && text_[i] == '=') ++i;
        return i < text_.size() && text_[i] == '[' ? i - at - 1 : npos;
    }
    void skip_to(std::size_t end) { at_ = end == npos ? text_.size() : end; }
    void skip_long(std::size_t signs) {
        const std::string close = "]" + std::string(signs, '=') + "]";
        const std::size_t end = text_.find(close, at_);
        skip_to(end == npos ? npos : end + close.size());
        before_ = "\"";
    }
    void skip_comment() {
        at_ += 2;
        const std::size_t signs =
            at_ < text_.size() && text_[at_] == '[' ? long_bracket(at_) : npos;
        if (signs == npos)
            skip_to(text_.find('\n', at_));
        else
            skip_long(signs);
    }
    void skip_quoted(char quote) {
        std::size_t i = at_ + 1;
        while (i < text_.size() && text_[i] != quote) i += text_[i] == '\\' ? 2 : 1;
        skip_to(i < text_.size() ? i + 1 : npos);
        before_ = "\"";
    }
    void sign(char c) {
        if (std::isspace(static_cast<unsigned char>(c)) == 0) {
            const bool concatenates = c == '.' && before_ == "." && text_[at_ - 1] == '.';
            if (c == '(' && names_follow_) in_names_ = true;
            if (c == ')' || c == '=' || c == '{') in_names_ = names_follow_ = false;
            before_ = concatenates ? ".." : text_.substr(at_, 1);
        }
        ++at_;
    }
    void word() {
        const std::size_t begin = at_;
        while (at_ < text_.size() && is_word(text_[at_])) ++at_;
        const std::string_view word = text_.substr(begin, at_ - begin);
        if (word == "function") names_follow_ = true;
        if (word == "in") in_names_ = false;
        if (word == "it" && before_ != "." && before_ != ":" && !assigned()) {
            own_ = own_ || in_names_ || before_ == "local" || before_ == "for" ||
                   (before_ == "," && listed_);
            found_.push_back(begin);
        }
        listed_ = before_ == "local" || before_ == "for" || (before_ == "," && listed_);
        before_ = word;
    }
    /// Whether a single `=` follows: a key of a table, or a variable that is written.
    bool assigned() const {
        const std::size_t next = text_.find_first_not_of(" \t\n", at_);
        return next != npos && text_[next] == '=' &&
               (next + 1 >= text_.size() || text_[next + 1] != '=');
    }

    std::string_view text_;
    std::size_t at_ = 0;
    std::string_view before_;                       // the word or sign before the current one
    bool names_follow_ = false, in_names_ = false;  // parameters
    bool listed_ = false;                           // in the names of `local a, b` or `for a, b`
    bool own_ = false;                              // a variable or a parameter is called so
    std::vector<std::size_t> found_;
};

}  // namespace

bool mentions_it(std::string_view source) {
    return !ItFinder(source).run().empty();
}

std::string with_it_named(std::string_view source, std::string_view path) {
    std::string out;
    std::size_t done = 0;
    for (const std::size_t at : ItFinder(source).run()) {
        out += source.substr(done, at - done);
        out += path;
        done = at + 2;
    }
    return out += source.substr(done);
}

}  // namespace fettle::script
