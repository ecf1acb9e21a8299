#include <packing/literal_names.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <optional>

namespace fettle::program {

namespace {

bool is_file_name(const std::string& text) {
    constexpr std::array<std::string_view, 20> endings = {
        ".png", ".jpg", ".jpeg", ".bmp", ".tga", ".wav", ".ogg", ".flac", ".mp3", ".ttf",
        ".otf", ".ttc", ".json", ".tmj", ".tmx", ".tsj", ".tsx", ".tj",   ".tx",  ".frag"};
    if (text.size() > 300 || text.find_first_of("*?%\n\t") != std::string::npos ||
        text.find("://") != std::string::npos)
        return false;
    const std::filesystem::path path(text);
    std::string ending = path.extension().string();
    for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return !path.stem().empty() && std::ranges::find(endings, ending) != endings.end();
}

/// Reads a script from left to right.
class Reader {
  public:
    explicit Reader(std::string_view text) : text_(text) {}

    std::vector<LiteralName> read() {
        while (at_ < text_.size()) {
            const char c = text_[at_];
            if (text_.substr(at_).starts_with("--")) {
                skip_comment();
            } else if (c == '"' || c == '\'') {
                const int line = line_;
                const std::size_t begin = at_;
                const std::string content = quoted();
                add(content, begin, line);
            } else if (const std::size_t begin = at_; const auto long_text = bracketed()) {
                add(*long_text, begin, line_);
            } else if (std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_') {
                read_word();
            } else {
                // Only a bracket or a space may stand between a function and its argument.
                if (c != '(' && std::isspace(static_cast<unsigned char>(c)) == 0) before_.clear();
                advance();
            }
        }
        return std::move(names_);
    }

  private:
    void advance() {
        if (text_[at_++] == '\n') ++line_;
    }
    void skip_comment() {
        at_ += 2;
        if (bracketed()) return;
        while (at_ < text_.size() && text_[at_] != '\n') advance();
    }
    void read_word() {
        const std::size_t from = at_;
        while (at_ < text_.size() && (std::isalnum(static_cast<unsigned char>(text_[at_])) != 0 ||
                                      text_[at_] == '_' || text_[at_] == '.' || text_[at_] == ':'))
            ++at_;
        before_ = text_.substr(from, at_ - from);
    }
    /// A text in quotes, without its escapes.
    std::string quoted() {
        const char quote = text_[at_];
        advance();
        std::string content;
        while (at_ < text_.size() && text_[at_] != quote && text_[at_] != '\n') {
            if (text_[at_] == '\\') {
                advance();
                if (at_ < text_.size() && text_[at_] == 'z') {  // skips the white space behind it
                    advance();
                    while (at_ < text_.size() &&
                           std::isspace(static_cast<unsigned char>(text_[at_])) != 0)
                        advance();
                    continue;
                }
            }
            if (at_ < text_.size()) {
                content += text_[at_];
                advance();
            }
        }
        if (at_ < text_.size()) advance();
        return content;
    }
    /// The text in long brackets that begin here; they may contain equal signs.
    std::optional<std::string> bracketed() {
        if (at_ >= text_.size() || text_[at_] != '[') return std::nullopt;
        std::size_t level = 0;
        while (at_ + 1 + level < text_.size() && text_[at_ + 1 + level] == '=') ++level;
        const std::size_t inside = at_ + level + 2;
        if (inside > text_.size() || text_[inside - 1] != '[') return std::nullopt;
        const std::string end = "]" + std::string(level, '=') + "]";
        const std::size_t close = std::min(text_.find(end, inside), text_.size());
        std::string content(text_.substr(inside, close - inside));
        while (at_ < std::min(close + end.size(), text_.size())) advance();
        return content;
    }
    /// True if the text from `begin` to here is a part of a longer one, as in "art/" .. name, or
    /// the key of a table, as in t["a.png"]: neither names a file.
    bool is_part_or_key(std::size_t begin) const {
        constexpr std::string_view spaces = " \t\r\n";
        const std::size_t last =
            begin == 0 ? text_.npos : text_.find_last_not_of(spaces, begin - 1);
        const std::size_t next = text_.find_first_not_of(spaces, at_);
        const std::string_view before = last == text_.npos ? "" : text_.substr(0, last + 1);
        const std::string_view after = next == text_.npos ? "" : text_.substr(next);
        return before.ends_with("..") || after.starts_with("..") ||
               (before.ends_with('[') && after.starts_with(']'));
    }
    void add(const std::string& text, std::size_t begin, int line) {
        const bool module = before_ == "require";
        if (!is_part_or_key(begin) && (module || is_file_name(text)))
            names_.push_back(
                {.name = text, .line = line, .module = module, .written = before_ == "scene.save"});
        before_.clear();
    }

    std::string_view text_;
    std::size_t at_ = 0;
    int line_ = 1;
    std::string before_;  // the last word
    std::vector<LiteralName> names_;
};

}  // namespace

std::vector<LiteralName> names_in_script(std::string_view text) {
    return Reader(text).read();
}

std::vector<LiteralName> names_in_data(std::string_view text) {
    std::vector<LiteralName> names;
    int line = 1;
    for (std::size_t at = 0; at < text.size(); ++at) {
        if (text[at] == '\n') ++line;
        if (text[at] != '"') continue;
        std::string content;
        for (++at; at < text.size() && text[at] != '"' && text[at] != '\n'; ++at) {
            if (text[at] == '\\' && at + 1 < text.size()) ++at;
            content += text[at];
        }
        if (is_file_name(content)) names.push_back({.name = content, .line = line});
    }
    return names;
}

}  // namespace fettle::program
