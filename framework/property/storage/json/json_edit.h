#pragma once
// Edits of a JSON text that leave the rest unchanged: comments, order, white space.

#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <json/document.h>

namespace fettle::property {

/// Returns the text of `node`, or an edited copy of it, without the indentation that its line has
/// in the document. Values to be added must have this form.
std::string without_indent(std::string text, const Document& document, const Document::Node& node);

class JsonEdit {
  public:
    /// Throws SceneError for a text that is not JSON.
    JsonEdit(std::string text, std::string file_name);

    /// Describes the current text. After an edit, nodes of an older document are invalid.
    const Document& document() const { return document_; }
    const std::string& text() const { return document_.source(); }

    using Node = Document::Node;
    void replace(const Node& node, std::string_view value);
    /// Adds a member to an object: after the member `after`, as the first one (`after` is the
    /// object itself), or as the last one (null). `value` may have several lines; its first column
    /// must be column 1.
    void add_member(const Node& object, std::string_view key, std::string_view value,
                    const Node* after = nullptr);
    void add_element(const Node& array, std::string_view value, const Node* after = nullptr);

    // Many edits in one pass over the text.
    void replace(const std::vector<std::pair<const Node*, std::string>>& values);
    /// Finds an object or an array in a document, also after an edit.
    using Find = std::function<const Node*(const Document&)>;
    /// Adds the items at the end, in this order. For an array the keys are ignored.
    void add_last(const Find& container,
                  const std::vector<std::pair<std::string, std::string>>& items);
    /// Removes all members or elements for which `which` is true.
    void remove(const Find& container,
                const std::function<bool(const Document&, const Node&)>& which);
    /// Removes a member of an object, or an element of an array, together with its line and the
    /// comment after it.
    void remove(const Node& container, const Node& child);

  private:
    void add(const Node& container, const std::string& item, const Node* after);
    std::size_t comma_after(std::size_t at) const;
    bool alone_on_its_lines(const Node& child) const;
    void add_first(const Node& container, const std::string& item);
    void set(std::string text);
    /// The end of the line, if only white space, comments and commas follow on it.
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
