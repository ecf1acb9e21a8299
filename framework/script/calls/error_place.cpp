#include <algorithm>
#include <cctype>
#include <charconv>
#include <string>
#include <string_view>
#include <vector>

#include <fettle/property/utf8.h>
#include <fettle/script/runtime.h>

#include <calls/error_place.h>
#include <text/columns.h>
#include <text/lua_code.h>
#include <text/words.h>

namespace fettle::script {

void place_from_message(ScriptError& error) {
    const std::string& text = error.message;
    for (std::size_t colon = text.find(':'); colon != std::string::npos;
         colon = text.find(':', colon + 1)) {
        std::size_t end = colon + 1;
        while (end < text.size() && std::isdigit(static_cast<unsigned char>(text[end]))) ++end;
        if (end == colon + 1 || end >= text.size() || text[end] != ':') continue;
        error.file = text.substr(0, colon);
        std::from_chars(text.data() + colon + 1, text.data() + end, error.line);
        return;
    }
}

namespace {

std::vector<std::size_t> places_of(std::string_view code, std::string_view word) {
    std::vector<std::size_t> all;
    for (std::size_t at = find_word(code, word); at != std::string_view::npos;
         at = find_word(code, word, at + 1))
        all.push_back(at);
    return all;
}

int column_at(const std::string& line, std::size_t at) {
    return static_cast<int>(shown_width(std::string_view(line).substr(0, at))) + 1;
}

/// The column of a name that Lua quotes. Of several places, the first one where it is indexed or
/// called.
int column_of_quoted(const std::string& line, std::string_view code, std::string_view name) {
    const std::vector<std::size_t> places = places_of(code, name);
    if (places.empty()) return 0;
    const auto used = std::ranges::find_if(places, [&](std::size_t at) {
        const std::size_t end = code.find_first_not_of(' ', at + name.size());
        return end != std::string_view::npos &&
               std::string_view(".:[(").find(code[end]) != std::string_view::npos;
    });
    return column_at(line, used == places.end() ? places.front() : *used);
}

/// The column of the last name of a path, such as `world.ball.mas`: where the line contains the
/// path, or as much of its end as it contains. 0 if the line has several such places, and it is not
/// clear which is meant.
int column_of_path(const std::string& line, std::string_view code, std::string_view path,
                   bool unknown) {
    constexpr std::string_view separators = ".:[]\" ";
    const std::size_t separator = path.find_last_of(separators);
    const std::size_t last = separator == std::string_view::npos ? 0 : separator + 1;
    for (std::size_t begin = 0;; begin = path.find_first_of(separators, begin) + 1) {
        const std::vector<std::size_t> places = places_of(code, path.substr(begin));
        const bool clear = places.size() == 1 || begin < last || unknown;
        if (!places.empty()) return clear ? column_at(line, places.front() + last - begin) : 0;
        if (begin >= last) return 0;
    }
}

/// The call of `error` in the line; 0 if there is none, or more than one.
int column_of_raise(const std::string& line, std::string_view code) {
    const std::vector<std::size_t> places = places_of(code, "error");
    return places.size() == 1 ? column_at(line, places.front()) : 0;
}

/// Whether the message is one that the line contains, as `error("no ball")` does.
bool is_written_in(const std::string& line, std::string_view message) {
    return !message.empty() && (line.find('"' + std::string(message) + '"') != line.npos ||
                                line.find('\'' + std::string(message) + '\'') != line.npos);
}

}  // namespace

int guess_column(const ScriptError& error, const Sources::Stop& stop) {
    const std::string& text = error.message;
    if (text == stop.message && stop.column < error.source_line.size())
        return static_cast<int>(shown_width(error.source_line.substr(0, stop.column))) + 1;
    const std::string code = code_of(error.source_line);
    const std::string place = error.file + ":" + std::to_string(error.line) + ": ";
    if (is_written_in(error.source_line,
                      std::string_view(text).substr(text.starts_with(place) ? place.size() : 0)))
        if (const int column = column_of_raise(error.source_line, code)) return column;
    for (std::size_t open = text.find('\''); open != std::string::npos;) {
        const std::size_t close = text.find('\'', open + 1);
        if (close == std::string::npos) break;
        const std::string_view name = std::string_view(text).substr(open + 1, close - open - 1);
        if (const int column = column_of_quoted(error.source_line, code, name)) return column;
        open = text.find('\'', close + 1);
    }
    // The message has the form "main.lua:12: world.ball.mas: no such name".
    std::size_t start = error.file.size();
    start = text.find(": ", start);
    const std::size_t end = start == std::string::npos ? start : text.find(": ", start += 2);
    if (end == std::string::npos) return column_of_raise(error.source_line, code);
    const std::string_view path = std::string_view(text).substr(start, end - start);
    const bool unknown = std::string_view(text).substr(end + 2).starts_with("no such name");
    const int column =
        column_of_path(error.source_line, code, path, unknown && path.find('.') == path.npos);
    return column > 0 || unknown ? column : column_of_raise(error.source_line, code);
}

void shorten_source(ScriptError& error) {
    constexpr std::size_t most = 400, before = 150;  // bytes
    std::string& line = error.source_line;
    if (line.size() <= most) return;
    // Programs make lines of this length; a byte counts as a column.
    const auto column = static_cast<std::size_t>(std::max(error.column, 0));
    std::size_t begin = column > before ? std::min(column - before, line.size()) : 0;
    std::size_t end = std::min(begin + most, line.size());
    const auto inside = [&](std::size_t at) {
        return at < line.size() && property::is_continuation(line[at]);
    };
    while (inside(begin)) ++begin;
    while (end > begin && inside(end)) --end;
    if (column > 0 && begin > 0) error.column -= static_cast<int>(begin) - 1;
    line =
        (begin > 0 ? "…" : "") + line.substr(begin, end - begin) + (end < line.size() ? "…" : "");
}

std::vector<std::string> error_lines(const ScriptError& error) {
    constexpr std::size_t widest_message = 1000;
    std::vector<std::string> lines = {cut(error.message, widest_message)};
    if (!error.source_line.empty()) {
        std::string line = error.source_line;
        for (char& c : line)
            if (c == '\t') c = ' ';
        lines.push_back("  " + line);
        if (error.column > 0)
            lines.push_back("  " + std::string(static_cast<std::size_t>(error.column) - 1, ' ') +
                            "^");
    }
    return lines;
}

}  // namespace fettle::script
