#include <fettle/property/spelling.h>

#include <text/bare_words.h>
#include <text/words.h>

namespace fettle::script {

namespace {

/// The texts that properties of that name take; those of all properties for "".
std::vector<std::string> texts_for(const property::Tree& tree, std::string_view name) {
    std::vector<std::string> texts;
    for (const property::Class* of : tree.classes())
        for (const property::Property* property : of->properties())
            if (name.empty() || property->name == name)
                for (const std::string& text : property->enumerators)
                    if (!among(texts, text)) texts.push_back(text);
    return texts;
}

std::string quotes_hint(const std::string& meant) {
    return " (a text needs quotes: did you mean " + meant + "?)";
}

/// The name in `name =` at the end of the text; "" if it does not end so.
std::string_view assigned(std::string_view before) {
    if (!before.ends_with('=')) return {};
    before = trimmed(before.substr(0, before.size() - 1));
    std::size_t begin = before.size();
    while (begin > 0 && is_word(before[begin - 1])) --begin;
    return before.substr(begin);
}

/// Whether a value may stand between the two texts that is compared or given to a function.
bool is_used_as_value(std::string_view before, std::string_view after) {
    const bool ends =
        after.empty() || after.front() == ')' || after.front() == ',' || after.front() == '}';
    if (before.ends_with("==") || before.ends_with("~="))
        return ends || is_word(after.front());  // if key == up then
    return ends && (before.ends_with('(') || before.ends_with(','));
}

}  // namespace

std::string bare_word_hint(const property::Tree& tree, std::string_view line,
                           std::string_view word) {
    // Each place takes a look at all properties, and a program may have written the line.
    constexpr int most_places = 16;
    if (word.empty() || !is_word(word.front())) return {};
    std::size_t at = find_word(line, word);
    for (int place = 0; place < most_places && at != std::string_view::npos;
         ++place, at = find_word(line, word, at + 1)) {
        const std::string_view before = trimmed(line.substr(0, at)),
                               after = trimmed(line.substr(at + word.size()));
        const std::string_view name = assigned(before);
        if (!name.empty()) {
            const std::vector<std::string> texts = texts_for(tree, name);
            const std::string meant =
                among(texts, word) ? std::string(word) : property::nearest(word, texts);
            if (!meant.empty()) return quotes_hint(std::string(name) + " = \"" + meant + "\"");
        } else if (is_used_as_value(before, after) && among(texts_for(tree, {}), word)) {
            return quotes_hint("\"" + std::string(word) + "\"");
        }
    }
    return {};
}

}  // namespace fettle::script
