#include <vector>

#include <text/lua_code.h>
#include <text/selected_name.h>
#include <text/words.h>

namespace fettle::script {

namespace {

constexpr std::size_t npos = std::string_view::npos;

/// Finds the places of the word `it` in a text of Lua.
class ItFinder {
  public:
    explicit ItFinder(std::string_view text) : text_(code_of(text)) {}

    std::vector<std::size_t> run() {
        while (at_ < text_.size()) {
            if (is_word(text_[at_]))
                word();
            else
                sign(text_[at_]);
        }
        return own_ ? std::vector<std::size_t>() : std::move(found_);
    }

  private:
    void sign(char c) {
        if (std::isspace(static_cast<unsigned char>(c)) == 0) {
            const bool concatenates = c == '.' && before_ == "." && text_[at_ - 1] == '.';
            if (c == '(' && names_follow_) in_names_ = true;
            if (c == ')' || c == '=' || c == '{') in_names_ = names_follow_ = false;
            before_ = concatenates ? ".." : std::string_view(text_).substr(at_, 1);
        }
        ++at_;
    }
    void word() {
        const std::size_t begin = at_;
        while (at_ < text_.size() && is_word(text_[at_])) ++at_;
        const std::string_view word = std::string_view(text_).substr(begin, at_ - begin);
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

    std::string text_;  // without comments, and without what quotes contain
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
