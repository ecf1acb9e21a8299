#pragma once
// Edits of a JSON text that leave everything else of it as it is: comments, order, white space.

#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <json/document.h>

namespace fettle::property {

/// A text that stood at `node`, or stands there, as if it began in column 1: so must what is added.
std::string without_indent(std::string text, const Document& document, const Document::Node& node);

class JsonEdit {
  public:
    /// Throws SceneError for a text that is not JSON.
    JsonEdit(std::string text, std::string file_name);

    /// Of the text as it is now; its nodes are those of another text after an edit.
    const Document& document() const { return document_; }
    const std::string& text() const { return document_.source(); }

    using Node = Document::Node;
    void replace(const Node& node, std::string_view value);
    /// Behind `after`, a member of the object, as the first one (the object itself), or as the last
    /// one (null). `value` may have several
    /// lines, indented as if it began in column 1.
    void add_member(const Node& object, std::string_view key, std::string_view value,
                    const Node* after = nullptr);
    void add_element(const Node& array, std::string_view value, const Node* after = nullptr);

    // Many at once, for the price of one.
    void replace(const std::vector<std::pair<const Node*, std::string>>& values);
    /// Where an object or an array is in the text as it is then.
    using Find = std::function<const Node*(const Document&)>;
    /// As the last ones, in this order; of an array the keys do not count.
    void add_last(const Find& container,
                  const std::vector<std::pair<std::string, std::string>>& items);
    /// All members or elements `which` is true of.
    void remove(const Find& container,
                const std::function<bool(const Document&, const Node&)>& which);
    /// Removes a member of an object, or an element of an array, with its line and the comment
    /// behind it.
    void remove(const Node& container, const Node& child);

  private:
    void add(const Node& container, const std::string& item, const Node* after);
    std::size_t comma_behind(std::size_t at) const;
    bool alone_on_its_lines(const Node& child) const;
    void add_first(const Node& container, const std::string& item);
    void set(std::string text);
    /// Behind white space, comments and commas on the same line.
    std::size_t line_end(std::size_t at) const;
    bool begins_line(std::size_t at) const;
    std::string indent(std::size_t at) const;
    std::string indented(std::string_view lines, const std::string& indent) const;
    std::size_t start(const Node& child) const;
    const Node* last(const Node& container) const;

    std::string newline_;
    Document document_;
};

}  // namespace fettle::property
