#include <algorithm>
#include <string>

#include <fettle/property/value.h>
#include <text/command_words.h>
#include <text/words.h>

namespace fettle::script {

namespace {

enum class Argument { none, any, path, number };

struct Command {
    std::string_view words;  // separated by blanks
    std::string_view alone;  // what is written in place of the word
    Argument takes = Argument::none;
    std::string_view with = {};  // the same with an argument, which stands in place of each %
};

/// If a word is in several rows, the first row whose argument fits is used.
constexpr Command commands[] = {
    {"cd goto focus select inspect", "it = world.name to select an instance", Argument::path,
     "it = %"},
    {"goto seek jump", "time:go_to(step)", Argument::number, "time:go_to(%)"},
    {"pwd self this me $0", "it, the selected instance"},
    {"$_", "_, the last result"},
    {"ls dir tree children list", "game to see what is in it", Argument::path,
     "% to see what is in it"},
    {"cat get show print echo p dump view examine console.log console.table console.dir",
     "print(...)", Argument::any, "%"},
    {"rm kill remove delete destroy despawn free queue_free", "path:delete()", Argument::path,
     "%:delete()"},
    {"cp clone duplicate", "world:add(path:clone())", Argument::path, "world:add(%:clone())"},
    {"spawn create make give summon add", "world.name = Body { ... }", Argument::path,
     "world.name = % { ... }"},
    {"stop freeze pause", "time.paused = true"},
    {"resume unpause continue play", "go_on()"},
    {"step next skip advance", "time.step_once = true to make one step"},
    {"slow slowmo slomo timescale time_scale host_timescale speed", "time.scale = 0.5",
     Argument::number, "time.scale = %"},
    {"sv_gravity", "world.gravity = vec(0, -10)", Argument::number, "world.gravity = vec(0, -%)"},
    {"toggle", "path = not path", Argument::path, "% = not %"},
    {"cls clear_log con_clear console.clear", "clear"},
    {"say", "print(\"text\")", Argument::any, "print(\"%\")"},
    {"man info describe doc ?", "help", Argument::any, "help %"},
    {"cvarlist cmdlist commands", "help"},
    {"grep search where locate $ document.querySelector", "find word", Argument::any, "find %"},
    {"watch monitor trace", "pin path", Argument::any, "pin %"},
    {"break breakpoint debugger stop_when pause_when", "break_when condition", Argument::any,
     "break_when %"},
    {"fps stat stats showfps show_fps cl_showfps net_graph", "view.show.timings = true"},
    {"reload map changelevel", "restart()"},
    {"q exit :q :quit :wq", "quit()"},
};

/// Functions whose arguments are texts, and how many of them there are.
constexpr std::string_view of_one_text = "exec share save_game load_game require bookmark";
constexpr std::string_view of_two_texts = "bind alias";

std::string_view without_quotes(std::string_view text) {
    text = trimmed(text);
    const bool quoted = text.size() >= 2 && text.front() == text.back() &&
                        (text.front() == '"' || text.front() == '\'');
    return quoted ? text.substr(1, text.size() - 2) : text;
}

std::string in_quotes(std::string_view text) {
    return property::value_text(property::Value(std::string(without_quotes(text))));
}

/// What follows the first word, without the brackets and quotes around all of it.
std::string_view argument_of(std::string_view command) {
    std::string_view rest = trimmed(command.substr(first_word(command).size()));
    if (rest.starts_with('(') && rest.ends_with(')')) rest = rest.substr(1, rest.size() - 2);
    return without_quotes(rest);
}

bool is_number(std::string_view text) {
    return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) {
        return (c >= '0' && c <= '9') || c == '.' || c == '-';
    });
}

bool is_path(std::string_view text) {
    return !text.empty() && std::isalpha(static_cast<unsigned char>(text.front())) != 0 &&
           std::all_of(text.begin(), text.end(), [](char c) { return is_word(c) || c == '.'; });
}

bool fits(Argument takes, std::string_view argument) {
    switch (takes) {
        case Argument::none:
            return false;
        case Argument::any:
            return !argument.empty();
        case Argument::path:
            return is_path(argument);
        case Argument::number:
            return is_number(argument);
    }
    return false;
}

/// The text with the argument in place of each %.
std::string filled(std::string_view text, std::string_view argument) {
    std::string result;
    for (const char c : text)
        if (c == '%')
            result += argument;
        else
            result += c;
    return result;
}

/// `world.ball.mass 5`, `world.ball.mass: 5`, and the same after `set`.
std::string assignment(std::string_view text) {
    std::string_view path = first_word(text);
    std::string_view value = trimmed(text.substr(path.size()));
    if (path.ends_with(':')) path.remove_suffix(1);
    if (value.starts_with("to ")) value = trimmed(value.substr(3));
    if (!is_path(path) || value.empty() || first_word(value) == "is") return {};
    if (!is_word(value.front()) &&
        std::string_view("\"'({-#").find(value.front()) == std::string_view::npos)
        return {};  // an operator
    return std::string(path) + " = " + std::string(value);
}

/// The call of `ab` for `ab world.ball.mass = 3`, whose argument this is.
std::string compared(std::string_view argument) {
    const std::size_t equals = argument.find('=');
    const std::string_view path = trimmed(argument.substr(0, equals));
    if (equals == std::string_view::npos || !is_path(path)) return {};
    return hint_to_write("ab(\"" + std::string(path) + "\", " +
                         std::string(trimmed(argument.substr(equals + 1))) + ")");
}

/// `world.brick_*` and `world.brick_*.mass = 3`: the instances of a pattern.
std::string of_pattern(std::string_view command) {
    const std::size_t star = command.find('*');
    const std::string_view before = command.substr(0, std::min(star, command.size()));
    if (star == std::string_view::npos || before.find('.') == std::string_view::npos ||
        !is_path(before))
        return {};
    const std::size_t equals = command.find('=');
    const std::string_view pattern = trimmed(command.substr(0, equals));
    const bool plain = std::all_of(pattern.begin(), pattern.end(),
                                   [](char c) { return is_word(c) || c == '.' || c == '*'; });
    if (!plain) return {};
    if (equals == std::string_view::npos) return "query(\"" + std::string(pattern) + "\")";
    const std::size_t dot = pattern.rfind('.');
    const std::string_view value = trimmed(command.substr(equals + 1));
    if (dot < star || dot == std::string_view::npos || value.empty() || value.front() == '=')
        return {};
    return "query(\"" + std::string(pattern.substr(0, dot)) + "\"):set(\"" +
           std::string(pattern.substr(dot + 1)) + "\", " + std::string(value) + ")";
}

/// `/world/ball`: a path as shells and trees of nodes write it.
std::string with_dots(std::string_view command) {
    if (!command.starts_with('/')) return {};
    std::string path(command.substr(1));
    std::replace(path.begin(), path.end(), '/', '.');
    if (path.ends_with('.')) path.pop_back();
    return is_path(path) ? path : std::string();
}

}  // namespace

std::string_view first_word(std::string_view command) {
    return command.substr(0, command.find_first_of(" \t\n("));
}

std::string hint_for_command(std::string_view command) {
    command = trimmed(command);
    if (command.find('\n') != std::string_view::npos) return {};  // a piece of a program
    if (const std::string path = with_dots(command); !path.empty()) return hint_to_write(path);
    if (const std::string query = of_pattern(command); !query.empty()) return hint_to_write(query);
    const std::string_view word = first_word(command);
    const std::string argument = one_line(argument_of(command));
    if (word == "set")
        if (const std::string here = assignment(argument); !here.empty())
            return hint_to_write(here);
    const Command* known = nullptr;
    for (const Command& each : commands) {
        if (!holds_word(each.words, word)) continue;
        if (fits(each.takes, argument)) return hint_to_write(filled(each.with, argument));
        if (known == nullptr) known = &each;
    }
    if (known != nullptr) return hint_to_write(known->alone);
    if (word == "ab") return compared(argument);
    if (word.find('.') != std::string_view::npos)
        if (const std::string here = assignment(command); !here.empty()) return hint_to_write(here);
    return {};
}

std::string call_with_arguments(std::string_view command) {
    command = trimmed(command);
    const std::string name(first_word(command));
    const std::string_view rest = trimmed(command.substr(name.size()));
    if (rest.empty() || rest.front() == '(') return {};
    if (holds_word(of_one_text, name)) return name + "(" + in_quotes(rest) + ")";
    if (holds_word(of_two_texts, name)) {
        const std::string_view key = rest.substr(0, rest.find_first_of(" ,="));
        std::string_view action = rest.substr(key.size());
        while (!action.empty() &&
               (action.front() == ' ' || action.front() == ',' || action.front() == '='))
            action.remove_prefix(1);
        if (action.empty()) return {};
        return name + "(" + in_quotes(key) + ", " + in_quotes(action) + ")";
    }
    const bool unambiguous = is_number(rest) || is_path(rest);
    return unambiguous ? name + "(" + std::string(rest) + ")" : std::string();
}

}  // namespace fettle::script
