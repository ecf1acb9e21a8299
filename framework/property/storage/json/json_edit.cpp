#include <json/json_edit.h>

#include <algorithm>

namespace fettle::property {

std::string without_indent(std::string text, const Document& document, const Document::Node& node) {
    const std::string& all = document.source();
    const std::size_t line = all.rfind('\n', node.begin) + 1;  // 0 if it is the first line
    const std::size_t indent = all.find_first_not_of(' ', line) - line;
    for (std::size_t i = text.find('\n'); i != std::string::npos; i = text.find('\n', i + 1)) {
        const std::size_t spaces = text.find_first_not_of(' ', i + 1) - i - 1;
        text.erase(i + 1, std::min(spaces, indent));
    }
    return text;
}

JsonEdit::JsonEdit(std::string text, std::string file_name)
    : newline_(text.find("\r\n") != std::string::npos ? "\r\n" : "\n"),
      document_(std::move(text), std::move(file_name)) {}

void JsonEdit::set(std::string text) {
    document_ = Document(std::move(text), document_.file_name());
}

// --- Positions -----------------------------------------------------------------------------------

std::size_t JsonEdit::start(const Node& child) const {
    return document_.has_key(child) ? child.key_begin : child.begin;
}

const JsonEdit::Node* JsonEdit::last(const Node& container) const {
    const Node* found = nullptr;
    for (const Node* node = document_.first(container); node; node = document_.next(*node))
        found = node;
    return found;
}

std::size_t JsonEdit::line_end(std::size_t at) const {
    const std::string& text = document_.source();
    while (at < text.size()) {
        const std::string_view rest = std::string_view(text).substr(at);
        if (rest.starts_with("//")) {
            at = std::min(text.find_first_of("\r\n", at), text.size());
        } else if (rest.starts_with("/*")) {
            const std::size_t close = text.find("*/", at);
            if (text.find('\n', at) < close) return at;
            at = std::min(close, text.size() - 2) + 2;
        } else if (rest[0] == ' ' || rest[0] == '\t' || rest[0] == ',') {
            ++at;
        } else {
            return at;
        }
    }
    return at;
}

bool JsonEdit::begins_line(std::size_t at) const {
    const std::string& text = document_.source();
    while (at > 0 && (text[at - 1] == ' ' || text[at - 1] == '\t')) --at;
    return at == 0 || text[at - 1] == '\n';
}

std::string JsonEdit::indent(std::size_t at) const {
    const std::string& text = document_.source();
    const std::size_t newline = at == 0 ? std::string::npos : text.rfind('\n', at - 1);
    const std::size_t begin = newline == std::string::npos ? 0 : newline + 1;
    const std::size_t end = std::min(text.find_first_not_of(" \t", begin), text.size());
    return text.substr(begin, end - begin);
}

std::string JsonEdit::indented(std::string_view lines, const std::string& indent) const {
    std::string out;
    for (const char c : lines) {
        if (c == '\n')
            out += newline_ + indent;
        else if (c != '\r')
            out += c;
    }
    return out;
}

// --- Edits ---------------------------------------------------------------------------------------

void JsonEdit::replace(const Node& node, std::string_view value) {
    std::string text = document_.source();
    text.replace(node.begin, node.end - node.begin, indented(value, indent(node.begin)));
    set(std::move(text));
}

void JsonEdit::replace(const std::vector<std::pair<const Node*, std::string>>& values) {
    if (values.empty()) return;
    auto in_order = values;
    std::sort(in_order.begin(), in_order.end(),
              [](const auto& a, const auto& b) { return a.first->begin < b.first->begin; });
    const std::string& before = document_.source();
    std::string text;
    std::size_t done = 0;
    for (const auto& [node, value] : in_order) {
        text.append(before, done, node->begin - done);
        text += indented(value, indent(node->begin));
        done = node->end;
    }
    text.append(before, done, std::string::npos);
    set(std::move(text));
}

void JsonEdit::add_member(const Node& object, std::string_view key, std::string_view value,
                          const Node* after) {
    std::string item;
    append_quoted(item, key);
    add(object, item + ": " + std::string(value), after);
}

void JsonEdit::add_element(const Node& array, std::string_view value, const Node* after) {
    add(array, std::string(value), after);
}

/// The layout follows the first element: one per line, or all on the same line.
void JsonEdit::add_last(const Find& container,
                        const std::vector<std::pair<std::string, std::string>>& items) {
    const bool named = container(document_)->kind == Document::Kind::object;
    const auto item = [&](std::size_t i) {
        std::string text;
        if (named) {
            append_quoted(text, items[i].first);
            text += ": ";
        }
        return text + items[i].second;
    };
    if (items.empty()) return;
    add(*container(document_), item(0), nullptr);
    if (items.size() == 1) return;
    const Node& now = *container(document_);
    const bool one_line = document_.source().find('\n', now.begin) > now.end;
    std::string others;
    for (std::size_t i = 1; i < items.size(); ++i)
        others += (i == 1 ? "" : one_line ? ", " : ",\n") + item(i);
    add(now, others, nullptr);
}

void JsonEdit::add_first(const Node& container, const std::string& item) {
    std::string text = document_.source();
    const std::string outer = indent(container.begin), inner = outer + "  ";
    const std::size_t close = container.end - 1;
    if (begins_line(close) && close > container.begin + 1) {  // a comment may be above
        const std::size_t line = text.rfind('\n', close) + 1;
        text.insert(line, inner + indented(item, inner) + newline_);
    } else {
        text.insert(close, newline_ + inner + indented(item, inner) + newline_ + outer);
        // `{ }` keeps its space at the end of the line.
        std::size_t blank = close;
        while (blank > container.begin + 1 && text[blank - 1] == ' ') --blank;
        text.erase(blank, close - blank);
    }
    set(std::move(text));
}

void JsonEdit::add(const Node& container, const std::string& item, const Node* after) {
    const Node* end = last(container);
    if (end == nullptr) return add_first(container, item);
    if (after == nullptr) after = end;
    std::string text = document_.source();
    if (after == &container) {
        const std::size_t first = start(*document_.first(container));
        const std::string inner = indent(first);
        text.insert(first, indented(item, inner) + "," +
                               (begins_line(first) ? newline_ + inner : std::string(" ")));
        return set(std::move(text));
    }
    const std::size_t behind = line_end(after->end);
    const bool own_line = behind >= text.size() || text[behind] == '\n' || text[behind] == '\r';
    const bool one_line = text.find('\n', container.begin) > container.end;
    if (one_line) {
        text.insert(after->end, ", " + indented(item, indent(container.begin)));
    } else {
        const Node* first = document_.first(container);
        const std::string inner =
            begins_line(start(*first)) ? indent(start(*first)) : indent(container.begin) + "  ";
        const std::string line = newline_ + inner + indented(item, inner);
        const bool is_last = after == end;
        const bool comma_on_line =
            text.substr(after->end, behind - after->end).find(',') != std::string::npos;
        if (!own_line || (!is_last && !comma_on_line)) {
            text.insert(after->end, "," + line);
        } else {
            text.insert(behind, is_last ? line : line + ",");
            if (is_last) text.insert(after->end, ",");
        }
    }
    set(std::move(text));
}

/// The first comma after `at` that is not in a comment; the end of the text if there is none.
std::size_t JsonEdit::comma_after(std::size_t at) const {
    const std::string& text = document_.source();
    while (at < text.size() && text[at] != ',') {
        const std::string_view rest = std::string_view(text).substr(at);
        if (rest.starts_with("//"))
            at = std::min(text.find('\n', at), text.size());
        else if (rest.starts_with("/*"))
            at = std::min(text.find("*/", at), text.size() - 2) + 2;
        else
            ++at;
    }
    return at;
}

/// Including a comma after it.
bool JsonEdit::alone_on_its_lines(const Node& child) const {
    const std::string& text = document_.source();
    const std::size_t end = line_end(child.end);
    if (document_.next(child) != nullptr && comma_after(child.end) >= end) return false;
    return begins_line(start(child)) && end < text.size() &&
           (text[end] == '\n' || text[end] == '\r');
}

/// Adjacent whole lines are removed together. The last element, and elements that share a line, are
/// removed one by one, because commas have to be corrected.
void JsonEdit::remove(const Find& container,
                      const std::function<bool(const Document&, const Node&)>& which) {
    const Node* in = container(document_);
    if (in == nullptr) return;
    const std::string& before = document_.source();
    std::string text;
    std::size_t done = 0;
    for (const Node* node = document_.first(*in); node; node = document_.next(*node)) {
        if (document_.next(*node) == nullptr || !which(document_, *node) ||
            !alone_on_its_lines(*node))
            continue;
        const std::size_t begin = start(*node) - indent(start(*node)).size();
        text.append(before, done, begin - done);
        done = before.find('\n', line_end(node->end)) + 1;
    }
    text.append(before, done, std::string::npos);
    if (done > 0) set(std::move(text));
    for (bool found = true; found;) {
        found = false;
        in = container(document_);
        if (in == nullptr) return;
        for (const Node* node = document_.first(*in); node; node = document_.next(*node)) {
            if (!which(document_, *node)) continue;
            remove(*in, *node);
            found = true;
            break;
        }
    }
}

void JsonEdit::remove(const Node& container, const Node& child) {
    std::string text = document_.source();
    const Node* previous = nullptr;
    for (const Node* node = document_.first(container); node && node != &child;
         node = document_.next(*node))
        previous = node;
    const Node* next = document_.next(child);
    std::size_t begin = start(child), end = line_end(child.end);
    if (alone_on_its_lines(child)) {
        begin -= indent(begin).size();
        end = text.find('\n', end) + 1;
        text.erase(begin, end - begin);
    } else if (next != nullptr) {
        text.erase(begin, start(*next) - begin);
    } else {
        begin = previous != nullptr ? previous->end : begin;
        text.erase(begin, child.end - begin);
        return set(std::move(text));
    }
    // A new last element must have no comma. This comma is in front of the erased range.
    if (next == nullptr && previous != nullptr) text.erase(comma_after(previous->end), 1);
    set(std::move(text));
}

}  // namespace fettle::property
