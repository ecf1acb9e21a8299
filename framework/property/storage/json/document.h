#pragma once
// A JSON text with the position of everything in it. nlohmann's reader parses it. This class also
// keeps the position of each value (for line and column in errors), the order of keys, duplicates,
// the difference between 2 and 2.0, and the original text of a value (so that unknown values can be
// written back unchanged).

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <fettle/property/error.h>

namespace fettle::property {

class Document {
  public:
    enum class Kind : std::uint8_t { null, boolean, integer, number, text, array, object };

    struct Node {
        std::uint32_t begin = 0;  // bytes of the value; `end` is one past the last
        std::uint32_t end = 0;
        std::uint32_t key_begin = 0;  // position of the opening quote of its key
        std::uint32_t key = none;     // index of the key among the strings; `none` in an array
        std::uint32_t first = none;   // first element or member
        std::uint32_t next = none;    // next sibling in the same array or object
        union {
            bool boolean;
            std::int64_t integer;
            double number;
            std::uint32_t string;
        };
        Kind kind = Kind::null;
        Node() : integer(0) {}
    };

    /// Comments and a byte order mark are skipped. Throws SceneError for a text that is not JSON,
    /// has a key twice in one object, nests deeper than `depth_limit`, or is larger than
    /// `size_limit` bytes.
    Document(std::string text, std::string file_name);

    static constexpr std::size_t depth_limit = 1000;
    static constexpr std::size_t size_limit = std::size_t{64} << 20;

    const Node& root() const { return nodes_.front(); }
    /// nullptr if there are no more.
    const Node* first(const Node& node) const { return at(node.first); }
    const Node* next(const Node& node) const { return at(node.next); }
    std::size_t count(const Node& node) const;
    /// nullptr if the object has no such member.
    const Node* member(const Node& object, std::string_view key) const;

    bool has_key(const Node& node) const { return node.key != none; }
    const std::string& key(const Node& node) const { return strings_[node.key]; }
    const std::string& text(const Node& node) const { return strings_[node.string]; }
    /// The text of the value as it is in the file.
    std::string_view raw(const Node& node) const {
        return std::string_view(source_).substr(node.begin, node.end - node.begin);
    }

    const std::string& source() const { return source_; }
    const std::string& file_name() const { return file_name_; }
    /// Counts from 1.
    std::size_t line(std::size_t offset) const;
    /// "game.json:2:11": file, line and column in characters.
    std::string place(std::size_t offset) const;
    [[noreturn]] void fail(ErrorKind kind, std::size_t offset, const std::string& reason) const;

  private:
    friend class DocumentReader;
    std::size_t column(std::size_t offset) const;
    static constexpr std::uint32_t none = UINT32_MAX;
    const Node* at(std::uint32_t index) const { return index == none ? nullptr : &nodes_[index]; }

    std::string source_;
    std::string file_name_;
    std::vector<std::uint32_t> line_starts_;
    std::vector<Node> nodes_;
    std::vector<std::string> strings_;
};

/// "an object", "a text", ...; used in messages.
std::string_view kind_words(Document::Kind kind);

/// Appends `text` in JSON quotes. Returns false, and leaves `out` unchanged, if it is not UTF-8.
bool append_quoted(std::string& out, std::string_view text);

}  // namespace fettle::property
