#include <json/document.h>

#include <algorithm>
#include <array>

#include <fettle/property/storage/scene.h>
#include <fettle/property/utf8.h>
#include <nlohmann/json.hpp>

namespace fettle::property {

namespace {

// The same class as in the other files of this library: it is compiled once for all of them.
using Json = nlohmann::ordered_json;

std::size_t skip_comment(std::string_view text, std::size_t at) {
    if (text.substr(at, 2) == "//") return std::min(text.find_first_of("\r\n", at), text.size());
    const std::size_t close = text.find("*/", at + 2);
    return close == std::string_view::npos ? text.size() : close + 2;
}

/// The start of the next token. `at`: the end of the previous one.
std::size_t token_start(std::string_view text, std::size_t at) {
    if (at == 0 && text.starts_with("\xef\xbb\xbf")) at = 3;
    while (at < text.size()) {
        const char c = text[at];
        if (c == '/') {
            at = skip_comment(text, at);
        } else if (c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == ',' || c == ':') {
            ++at;
        } else {
            break;
        }
    }
    return at;
}

std::size_t string_end(std::string_view text, std::size_t at) {
    for (++at; at < text.size() && text[at] != '"'; ++at) {
        if (text[at] == '\\') ++at;
    }
    return std::min(at + 1, text.size());
}

}  // namespace

/// Receives the tokens of nlohmann's reader and finds each of them in the source to know its place.
/// The reader reports tokens in order, and only white space, comments, commas and colons can be
/// between two of them.
class DocumentReader : public nlohmann::json_sax<Json> {
  public:
    explicit DocumentReader(Document& document) : document_(document) {}

    bool null() override { return add_word(4).kind == Document::Kind::null; }
    bool boolean(bool value) override {
        Document::Node& node = add_word(value ? 4 : 5);
        node.kind = Document::Kind::boolean;
        node.boolean = value;
        return true;
    }
    bool number_integer(std::int64_t value) override {
        Document::Node& node = add_number();
        if (value == 0 && document_.source_[node.begin] == '-') {  // JSON has -0, integers do not
            node.kind = Document::Kind::number;
            node.number = -0.0;
            return true;
        }
        node.kind = Document::Kind::integer;
        node.integer = value;
        return true;
    }
    bool number_unsigned(std::uint64_t value) override {
        Document::Node& node = add_number();
        if (value > static_cast<std::uint64_t>(INT64_MAX)) {
            node.kind = Document::Kind::number;
            node.number = static_cast<double>(value);
        } else {
            node.kind = Document::Kind::integer;
            node.integer = static_cast<std::int64_t>(value);
        }
        return true;
    }
    bool number_float(double value, const std::string&) override {
        Document::Node& node = add_number();
        node.kind = Document::Kind::number;
        node.number = value;
        return true;
    }
    bool string(std::string& value) override {
        const std::size_t begin = token_start(document_.source_, cursor_);
        Document::Node& node = add(begin, string_end(document_.source_, begin));
        node.kind = Document::Kind::text;
        node.string = keep(value);
        return true;
    }
    bool binary(Json::binary_t&) override { return false; }  // does not occur in text

    bool start_object(std::size_t) override { return open(Document::Kind::object); }
    bool start_array(std::size_t) override { return open(Document::Kind::array); }
    bool end_array() override { return close(); }
    bool end_object() override {
        refuse_duplicates(document_.nodes_[open_.back().node]);
        return close();
    }
    bool key(std::string& value) override {
        key_begin_ = token_start(document_.source_, cursor_);
        cursor_ = string_end(document_.source_, key_begin_);
        key_ = keep(value);
        return true;
    }

    bool parse_error(std::size_t position, const std::string&, const Json::exception& e) override {
        // The message begins "[json.exception.parse_error.101] parse error at line 1, column 2:
        // syntax error while ...". The position is replaced: inside a string it is where reading
        // stopped, otherwise the start of the token where reading stopped.
        std::string reason = e.what();
        const std::size_t column = reason.find(", column ");
        if (column != std::string::npos) {
            const std::size_t colon = reason.find(": ", column);
            if (colon != std::string::npos) reason.erase(0, colon + 2);
        } else if (reason.starts_with("[")) {
            reason.erase(0, reason.find("] ") + 2);
        }
        // The error cannot be after `position`, but `token_start` may be, because it skips a
        // superfluous comma.
        const bool in_string = reason.find("invalid string") != std::string::npos;
        const std::size_t last = std::min(position - (position > 0), document_.source_.size());
        const std::size_t at =
            in_string ? last : std::min(last, token_start(document_.source_, cursor_));
        document_.fail(ErrorKind::bad_structure, at, "not JSON: " + reason);
    }

  private:
    struct Open {
        std::uint32_t node;
        std::uint32_t last_child;
    };

    std::uint32_t keep(std::string& value) {
        document_.strings_.push_back(std::move(value));
        return static_cast<std::uint32_t>(document_.strings_.size() - 1);
    }

    Document::Node& add(std::size_t begin, std::size_t end) {
        const auto index = static_cast<std::uint32_t>(document_.nodes_.size());
        if (!open_.empty()) {
            Open& open = open_.back();
            (open.last_child == Document::none ? document_.nodes_[open.node].first
                                               : document_.nodes_[open.last_child].next) = index;
            open.last_child = index;
        }
        Document::Node& node = document_.nodes_.emplace_back();
        node.begin = static_cast<std::uint32_t>(begin);
        node.end = static_cast<std::uint32_t>(end);
        node.key = key_;
        node.key_begin = static_cast<std::uint32_t>(key_begin_);
        key_ = Document::none;
        cursor_ = end;
        return node;
    }
    Document::Node& add_word(std::size_t length) {
        const std::size_t begin = token_start(document_.source_, cursor_);
        return add(begin, begin + length);
    }
    Document::Node& add_number() {
        const std::string_view source = document_.source_;
        const std::size_t begin = token_start(source, cursor_);
        return add(begin,
                   std::min(source.find_first_not_of("+-.0123456789eE", begin), source.size()));
    }

    bool open(Document::Kind kind) {
        const std::size_t begin = token_start(document_.source_, cursor_);
        if (open_.size() >= Document::depth_limit) {
            document_.fail(
                ErrorKind::bad_structure, begin,
                "nested deeper than " + std::to_string(Document::depth_limit) + " levels");
        }
        add(begin, begin + 1).kind = kind;
        open_.push_back({static_cast<std::uint32_t>(document_.nodes_.size() - 1), Document::none});
        return true;
    }
    bool close() {
        cursor_ = token_start(document_.source_, cursor_) + 1;
        document_.nodes_[open_.back().node].end = static_cast<std::uint32_t>(cursor_);
        open_.pop_back();
        return true;
    }

    void refuse_duplicates(const Document::Node& object) const {
        std::vector<const Document::Node*> members;
        for (auto* node = document_.first(object); node; node = document_.next(*node)) {
            members.push_back(node);
        }
        std::stable_sort(members.begin(), members.end(), [this](auto* a, auto* b) {
            return document_.key(*a) < document_.key(*b);
        });
        const auto twice = std::adjacent_find(
            members.begin(), members.end(),
            [this](auto* a, auto* b) { return document_.key(*a) == document_.key(*b); });
        if (twice == members.end()) return;
        const Document::Node& second = **(twice + 1);
        std::string quoted;
        append_quoted(quoted, document_.key(second));
        document_.fail(ErrorKind::bad_structure, second.key_begin,
                       "the key " + quoted + " was given before, on line " +
                           std::to_string(document_.line((*twice)->key_begin)));
    }

    Document& document_;
    std::vector<Open> open_;
    std::size_t cursor_ = 0;
    std::size_t key_begin_ = 0;
    std::uint32_t key_ = Document::none;
};

Document::Document(std::string text, std::string file_name)
    : source_(std::move(text)), file_name_(std::move(file_name)), line_starts_{0} {
    if (source_.size() > size_limit) {
        fail(ErrorKind::bad_structure, 0,
             "larger than " + std::to_string(size_limit >> 20) + " MB");
    }
    for (std::size_t i = 0; i < source_.size(); ++i) {
        if (source_[i] == '\n') line_starts_.push_back(static_cast<std::uint32_t>(i + 1));
    }
    // nlohmann's reader ends at a zero byte and would ignore the rest.
    const std::size_t zero = source_.find('\0');
    if (zero != std::string::npos) {
        fail(ErrorKind::bad_structure, zero, "not JSON: a zero byte");
    }
    DocumentReader reader(*this);
    Json::sax_parse(source_, &reader, Json::input_format_t::json, true, true);
}

std::size_t Document::count(const Node& node) const {
    std::size_t count = 0;
    for (const Node* child = first(node); child; child = next(*child)) ++count;
    return count;
}

const Document::Node* Document::member(const Node& object, std::string_view wanted) const {
    if (object.kind != Kind::object) return nullptr;
    for (const Node* node = first(object); node; node = next(*node)) {
        if (key(*node) == wanted) return node;
    }
    return nullptr;
}

std::size_t Document::line(std::size_t offset) const {
    const auto after = std::upper_bound(line_starts_.begin(), line_starts_.end(), offset);
    return static_cast<std::size_t>(after - line_starts_.begin());
}

std::size_t Document::column(std::size_t offset) const {
    const std::size_t start = line_starts_[line(offset) - 1];
    const std::size_t end = std::min(offset, source_.size());
    return code_point_count(std::string_view(source_).substr(start, end - start)) + 1;
}

std::string Document::place(std::size_t offset) const {
    return file_name_ + ":" + std::to_string(line(offset)) + ":" + std::to_string(column(offset));
}

void Document::fail(ErrorKind kind, std::size_t offset, const std::string& reason) const {
    throw SceneError(kind, file_name_, line(offset), column(offset), reason);
}

std::string_view kind_words(Document::Kind kind) {
    static constexpr std::array<std::string_view, 7> words = {
        "null", "a boolean", "an integer", "a number", "a text", "an array", "an object"};
    return words[static_cast<std::size_t>(kind)];
}

bool append_quoted(std::string& out, std::string_view text) {
    try {
        out += Json(text).dump();
        return true;
    } catch (const Json::type_error&) {
        return false;
    }
}

}  // namespace fettle::property
