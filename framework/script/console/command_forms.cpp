#include <console/command_forms.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include <text/lua_code.h>
#include <text/words.h>

namespace fettle::script {

bool is_bare_command(std::string_view command) {
    return command == "undo" || command == "redo" || command == "history" || command == "tweaks" ||
           command == "clear" || command == "help";
}

std::vector<std::string_view> arguments_of(std::string_view text) {
    std::vector<std::string_view> all;
    std::size_t begin = 0;
    int depth = 0;
    char quote = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (quote != 0) {
            if (c == '\\') ++i;
            if (c == quote) quote = 0;
        } else if (c == '"' || c == '\'') {
            quote = c;
        } else if (c == '(' || c == '[' || c == '{') {
            ++depth;
        } else if (c == ')' || c == ']' || c == '}') {
            --depth;
        } else if (c == ',' && depth == 0) {
            all.push_back(trimmed(text.substr(begin, i - begin)));
            begin = i + 1;
        }
    }
    all.push_back(trimmed(text.substr(begin)));
    return all;
}

bool takes_words(std::string_view function) {
    constexpr std::string_view functions[] = {
        "who",        "why",        "pin",          "unpin",          "plot",
        "break_when", "unbreak",    "last_time",    "find",           "query",
        "help",       "keep",       "keep_for_all", "reapply_tweaks", "drop_tweaks",
        "bookmark",   "unbookmark", "wait",         "compare_branch"};
    return std::find(std::begin(functions), std::end(functions), function) != std::end(functions);
}

std::vector<std::string> separate_commands(std::string_view line) {
    const std::string code = code_of(line);
    std::vector<std::string> all;
    std::size_t begin = 0;
    int depth = 0;
    for (std::size_t i = 0; i <= code.size(); ++i) {
        const char c = i < code.size() ? code[i] : ';';
        if (c == '(' || c == '[' || c == '{') ++depth;
        if (c == ')' || c == ']' || c == '}') --depth;
        if ((c != ';' && c != '\n') || (depth > 0 && i < code.size())) continue;
        if (const std::string_view text = trimmed(line.substr(begin, i - begin)); !text.empty())
            all.emplace_back(text);
        begin = i + 1;
    }
    return all;
}

void append(Evaluation& all, Evaluation next) {
    const std::size_t first = all.lines.size();
    for (TableLines& table : next.tables) table.first += first;
    for (FoldedLines& folded : next.folded) folded.line += first;
    for (std::size_t& line : next.printed) line += first;
    const auto move_to = [](auto& to, auto& from) {
        to.insert(to.end(), std::make_move_iterator(from.begin()),
                  std::make_move_iterator(from.end()));
    };
    move_to(all.lines, next.lines);
    move_to(all.tables, next.tables);
    move_to(all.folded, next.folded);
    move_to(all.printed, next.printed);
    all.ok = next.ok;
    all.incomplete = next.incomplete;
    all.error = std::move(next.error);
    all.result = std::move(next.result);
}

}  // namespace fettle::script
