// Tweaks of earlier runs as lists of words. A recording contains them, because they are part of the
// input of a run. Also checks rows that were read from a file.

#include <algorithm>
#include <array>
#include <charconv>

#include <fettle/property/error.h>
#include <fettle/property/utf8.h>

#include <json/document.h>
#include <tweaks/tweaks_state.h>

namespace fettle::property {

namespace {

using Kind = JournalRow::Kind;

constexpr std::array kinds{std::pair{Kind::value, "value"}, std::pair{Kind::created, "created"},
                           std::pair{Kind::deleted, "deleted"}, std::pair{Kind::moved, "moved"},
                           std::pair{Kind::restored, "restored"}};
/// The text members of a row in the order of the words.
constexpr std::array texts{&JournalRow::instance, &JournalRow::property, &JournalRow::was,
                           &JournalRow::now,      &JournalRow::was_text, &JournalRow::now_text,
                           &JournalRow::file,     &JournalRow::inside};

[[noreturn]] void fail(const TweakWords& words) {
    throw Error(ErrorKind::damaged,
                "no tweak: " + (words.empty() ? "it has no words" : "\"" + words.front() + "\""));
}

std::int64_t number(const std::string& word, const TweakWords& words) {
    std::int64_t found = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), found);
    if (error != std::errc() || end != word.data() + word.size()) fail(words);
    return found;
}

}  // namespace

TweakWords words_of(const JournalRow& row) {
    TweakWords words;
    for (const auto& [kind, word] : kinds)
        if (kind == row.kind) words.emplace_back(word);
    words.push_back(std::to_string(row.step));
    words.push_back(std::to_string(row.time));
    for (const auto text : texts) words.push_back(row.*text);
    return words;
}

JournalRow row_of(const TweakWords& words) {
    constexpr std::size_t before_texts = 3;
    if (words.size() != before_texts + texts.size()) fail(words);
    JournalRow row;
    row.run = JournalRow::elsewhere;
    bool known = false;
    for (const auto& [kind, word] : kinds)
        if (words.front() == word) row.kind = kind, known = true;
    if (!known) fail(words);
    row.step = number(words[1], words);
    row.time = number(words[2], words);
    for (std::size_t i = 0; i < texts.size(); ++i) row.*texts[i] = words[before_texts + i];
    return row;
}

namespace {

void require_names(const std::string& path, bool root_too) {
    const std::vector<Segment> segments = parse_path(path);
    const bool names = std::none_of(segments.begin(), segments.end(),
                                    [](const Segment& each) { return each.is_index(); });
    if (!names || (segments.empty() && !root_too))
        throw Error(ErrorKind::bad_path, value_text(Value(path)) + " is not a path of an instance");
}

}  // namespace

std::string shortened(const std::string& text, std::size_t longest) {
    if (text.size() <= longest) return text;
    return text.substr(0, code_point_boundary(text, longest)) + "...";
}

std::string problem_of(const JournalRow& row) {
    // Bytes. Paths may be long, because names may be long and deeply nested. The other texts are
    // shortened.
    constexpr std::size_t longest_path = 5'000'000, longest = 10'000;
    if (row.instance.size() > longest_path || row.property.size() > longest_path)
        return "its path is too long: " + shortened(row.instance, 40);
    for (const auto text : {&JournalRow::was_text, &JournalRow::now_text, &JournalRow::file})
        if ((row.*text).size() > longest)
            return shortened(row.instance, 1000) + ": a text of it is too long";
    try {
        require_names(row.instance, row.kind == Kind::value);
        (void)read_steps(row.inside);
        switch (row.kind) {
            case Kind::value:
                if (row.property.empty()) return row.instance + ": the name of a property is empty";
                (void)read_image(row.was);
                (void)read_image(row.now);
                return {};
            case Kind::restored:
                if (!row.was.empty()) (void)Document(row.was, row.instance);
                [[fallthrough]];
            case Kind::created:
                (void)Document(row.now, row.instance);
                return {};
            case Kind::deleted:
                return {};
            case Kind::moved:
                require_names(row.now, false);
                return {};
        }
        return row.instance + ": the kind of its edit is unknown";
    } catch (const Error& error) {
        return row.instance + ": " + error.what();
    }
}

}  // namespace fettle::property
