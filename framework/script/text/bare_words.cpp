#include <fettle/property/spelling.h>

#include <text/bare_words.h>
#include <text/words.h>

namespace fettle::script {

namespace {

/// The texts that properties of that name take, names of colors among them;
/// those of all properties for "", without colors.
std::vector<std::string> texts_for(const property::Tree& tree, std::string_view name) {
    std::vector<std::string> texts;
    bool colors = false;
    for (const property::Class* of : tree.classes())
        for (const property::Property* property : of->properties())
            if (name.empty() || property->name == name) {
                for (const std::string& text : property->enumerators)
                    if (!among(texts, text)) texts.push_back(text);
                if (property->type == property::Type::color && !name.empty()) colors = true;
            }
    if (colors)
        texts.insert(texts.end(), property::color_names().begin(), property::color_names().end());
    return texts;
}

std::string quotes_hint(const std::string& meant) {
    return " (a text needs quotes: did you mean " + meant + "?)";
}

/// The name in `name =` at the end of the text, with `sign` in place of `=`; "" if it does not end
/// so.
std::string_view name_before(std::string_view sign, std::string_view before) {
    if (!before.ends_with(sign)) return {};
    before = trimmed(before.substr(0, before.size() - sign.size()));
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

/// Whether `word`, which is used as a value after `before`, is a text that a property takes. One
/// letter is the name of a variable, as in print(i), unless it is compared with a property that
/// takes it, as in key == i.
bool is_meant_as_text(const property::Tree& tree, std::string_view before, std::string_view word) {
    if (word.size() > 1) return among(texts_for(tree, {}), word);
    std::string_view compared = name_before("==", before);
    if (compared.empty()) compared = name_before("~=", before);
    return !compared.empty() && among(texts_for(tree, compared), word);
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
        const std::string_view name = name_before("=", before);
        if (!name.empty()) {
            const std::vector<std::string> texts = texts_for(tree, name);
            const std::string meant =
                among(texts, word) ? std::string(word) : property::nearest(word, texts);
            if (!meant.empty()) return quotes_hint(std::string(name) + " = \"" + meant + "\"");
        } else if (is_used_as_value(before, after) && is_meant_as_text(tree, before, word)) {
            return quotes_hint("\"" + std::string(word) + "\"");
        }
    }
    return {};
}

}  // namespace fettle::script
