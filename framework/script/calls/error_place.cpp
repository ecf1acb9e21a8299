#include <algorithm>
#include <cctype>
#include <charconv>

#include <fettle/property/utf8.h>
#include <fettle/script/runtime.h>

#include <calls/error_place.h>
#include <text/columns.h>
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

int column_of(const std::string& line, const std::string& word) {
    const std::size_t at = find_word(line, word);
    return at == std::string::npos ? 0 : static_cast<int>(shown_width(line.substr(0, at))) + 1;
}

}  // namespace

int guess_column(const ScriptError& error, const Sources::Stop& stop) {
    const std::string& text = error.message;
    if (text == stop.message && stop.column < error.source_line.size())
        return static_cast<int>(shown_width(error.source_line.substr(0, stop.column))) + 1;
    for (std::size_t open = text.find('\''); open != std::string::npos;) {
        const std::size_t close = text.find('\'', open + 1);
        if (close == std::string::npos) break;
        if (const int column =
                column_of(error.source_line, text.substr(open + 1, close - open - 1)))
            return column;
        open = text.find('\'', close + 1);
    }
    // The message has the form "main.lua:12: world.ball.mas: no such name".
    std::size_t start = error.file.size();
    start = text.find(": ", start);
    if (start == std::string::npos) return 0;
    start += 2;
    const std::size_t end = text.find(": ", start);
    if (end == std::string::npos) return 0;
    std::string path = text.substr(start, end - start);
    std::size_t word = path.find_last_of(".:[]\" ");
    return column_of(error.source_line, word == std::string::npos ? path : path.substr(word + 1));
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
