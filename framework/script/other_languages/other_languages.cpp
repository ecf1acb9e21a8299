#include <algorithm>
#include <iterator>

#include <other_languages/other_languages.h>
#include <text/words.h>

namespace fettle::script {

namespace {

struct Foreign {
    std::string_view words;  // separated by blanks
    std::string_view here;   // what is written in their place
};

/// Names of variables and functions.
constexpr Foreign foreign_names[] = {
    {"null None undefined nullptr NULL", "nil"},
    {"True TRUE yes on", "true"},
    {"False FALSE no off", "false"},
    {"this", "self"},
    {"super", "Base.name(self, ...), with the class that it is derived from"},
    {"unpack", "table.unpack(list)"},
    {"loadstring", "load(text)"},
    {"len", "#list"},
    {"PI", "math.pi"},
    {"rand randf randi rnd randint", "random(from, to)"},
    {"Vector2 Vec2 vec2 Vector vector Point", "vec(x, y)"},
    {"printf puts echo println warn", "print(...)"},
    {"range", "for i = 1, n do ... end"},
    {"instantiate Instance", "world:add(Body { ... })"},
    {"spawn", "world:add(Body { ... }), or game:run(action) for code that waits"},
    {"new", "Body { ... }"},
    {"get_node", "world.name"},
    {"get_tree", "quit(), time.paused = true or go_to_scene(\"name\")"},
    {"preload ResourceLoader", "scene.load(\"enemy.json\", world), or image = \"enemy.png\""},
    {"emit_signal", "a property and watch(path, action)"},
    {"randomize randomise srand", "\"seed\": \"random\" in game.json"},
    {"typeof", "type(value), or instance:is_a(\"Body\")"},
    {"tick", "time.now"},
    {"json JSON", "store, or a file of Lua that returns a table, for require"},
    {"btn", "input.move, or input.keys.left"},
    {"btnp", "input.jump.pressed, after input.actions.jump = { \"space\" }"},
    {"spr sspr", "Sprite { image = \"hero.png\" }, or pen.image in draw(pen)"},
    {"cls", "view.background = color(\"black\")"},
    {"sfx", "Sound { file = \"hit.ogg\" }, or Synth.coin(), and :play()"},
    {"mget", "map:tile(x, y), of a Tilemap"},
    {"mset", "map:set_tile(x, y, tile), of a Tilemap"},
    {"flr", "math.floor(x)"},
    {"pen", "function draw(pen) ... end"},
    {"requestAnimationFrame", "function update(dt) ... end"},
    {"addEventListener", "function key_pressed(key) ... end"},
    {"workspace", "world"},
    {"camera cam", "view"},
    {"task", "after(seconds, action)"},
    {"setTimeout delay schedule invoke sleep", "after(seconds, action)"},
    {"setInterval", "every(seconds, action)"},
    {"include import using dofile loadfile", "require(\"name\")"},
    {"exit", "quit()"},
    {"pause", "time.paused = true"},
    {"resume unpause play", "time.paused = false"},
    {"save", "save_game(\"name\")"},
    {"fps", "view.show.timings = true"},
    {"try catch", "pcall(action, ...)"},
    {"rgb rgba Color Color3", "color(r, g, b) with numbers from 0 to 1, or \"#ff8000\""},
};

/// Functions in tables of other versions of Lua.
constexpr Foreign foreign_functions[] = {
    {"pow", "a ^ b"},
    {"mod", "a % b"},
    {"getn maxn", "#list"},
    {"insert push append", "table.insert(list, value)"},
    {"foreach foreachi", "for key, value in pairs(t) do ... end"},
    {"gfind", "string.gmatch(text, pattern)"},
    {"log10", "math.log(x, 10)"},
    {"atan2", "math.atan(y, x)"},
    {"round", "math.floor(x + 0.5)"},
    {"clamp", "math.max(lowest, math.min(x, highest))"},
    {"lerp mix", "a + (b - a) * share"},
    {"sign sgn", "x > 0 and 1 or x < 0 and -1 or 0"},
    {"contains includes indexof find", "for index, value in ipairs(list) do ... end"},
    {"split", "for part in text:gmatch(\"[^,]+\") do ... end"},
    {"shuffle",
     "for i = #list, 2, -1 do local j = random(i) list[i], list[j] = list[j], list[i] end"},
    {"exit", "quit()"},
};

/// Methods of texts.
constexpr Foreign foreign_text_methods[] = {
    {"split", "for part in text:gmatch(\"[^,]+\") do ... end"},
    {"contains includes", "text:find(part, 1, true)"},
    {"trim strip", "text:match(\"^%s*(.-)%s*$\")"},
    {"replace", "text:gsub(pattern, by)"},
    {"length size", "#text"},
    {"substring substr slice", "text:sub(from, to)"},
    {"to_upper toUpperCase uppercase", "text:upper()"},
    {"to_lower toLowerCase lowercase", "text:lower()"},
};

constexpr std::string_view in_math =
    "sin cos tan asin acos atan sqrt abs floor ceil exp fmod modf min max pi huge noise";
constexpr std::string_view only_files =
    " (a game reaches its own files only, with store, save_game, scene and require)";

constexpr std::string_view outside = "execute getenv setenv popen open remove rename tmpname";

/// Words at the beginning of a statement.
constexpr Foreign foreign_statements[] = {
    {"var let const auto int float double string bool", "local name = value"},
    {"elif elsif", "elseif"},
    {"continue", "goto continue, and ::continue:: before the end of the loop"},
    {"func def fn void", "function name(...) ... end"},
    {"import include using", "require(\"name\")"},
    {"switch case", "if ... then ... elseif ... then ... end"},
    {"try catch", "pcall(action, ...)"},
    {"new", "Body { ... }"},
    {"extends", "class(\"Name\", Body) { ... }"},
    {"class", "Name = class(\"Name\", Body) { ... }"},
    {"delete remove destroy", "path:delete()"},
    {"set", "path = value"},
    {"select", "selection { path }"},
};

/// The longest come first, because others are parts of them.
constexpr Foreign foreign_signs[] = {
    {"!=", "~= for \"not equal\""},
    {"&&", "and"},
    {"||", "or"},
    {"++", "a = a + 1"},
    {"+=", "a = a + b"},
    {"-=", "a = a - b"},
    {"*=", "a = a * b"},
    {"/=", "a = a / b"},
    {"%=", "a = a % b"},
    {"^=", "a = a ^ b"},
    {"|=", "a = a | b"},
    {"&=", "a = a & b"},
    {"=>", "function(...) ... end"},
    {"->", "a.b or a:b()"},
    {"/* */", "--[[ ... ]] for comments"},
    {"≠", "~= for \"not equal\""},
    {"≤", "<="},
    {"≥", ">="},
    {"× ·", "*"},
    {"÷", "/"},
    {"− –", "- for minus"},
    {"“ ” „ ‘ ’ « »", "\" around a text"},
    {"!", "not"},
    {"?", "a and b or c"},
};

template <std::size_t size>
std::string_view in_place_of(const Foreign (&table)[size], std::string_view word) {
    for (const Foreign& each : table)
        if (holds_word(each.words, word)) return each.here;
    return {};
}

/// The first text between single quotes after `from`.
std::string_view quoted(std::string_view text, std::size_t from) {
    const std::size_t open = text.find('\'', from);
    if (open == std::string_view::npos) return {};
    const std::size_t close = text.find('\'', open + 1);
    return close == std::string_view::npos ? std::string_view()
                                           : text.substr(open + 1, close - open - 1);
}

/// The sign of another language of which the byte at `at` is a part.
std::string_view sign_at(std::string_view line, std::size_t at) {
    for (const Foreign& each : foreign_signs)
        for (std::size_t begin = 0; begin < each.words.size();) {
            const std::size_t end = std::min(each.words.find(' ', begin), each.words.size());
            const std::string_view sign = each.words.substr(begin, end - begin);
            for (std::size_t before = 0; before < sign.size() && before <= at; ++before)
                if (line.substr(at - before).starts_with(sign)) return each.here;
            begin = end + 1;
        }
    return {};
}

/// The word that ends before `at`; blanks between them do not count.
std::string_view word_before(std::string_view line, std::size_t at) {
    std::size_t end = at;
    while (end > 0 && line[end - 1] == ' ') --end;
    std::size_t begin = end;
    while (begin > 0 && is_word(line[begin - 1])) --begin;
    return line.substr(begin, end - begin);
}

std::string_view word_at(std::string_view line, std::size_t at) {
    std::size_t end = at;
    while (end < line.size() && is_word(line[end])) ++end;
    return line.substr(at, end - at);
}

}  // namespace

std::string hint_for_name(std::string_view name) {
    if (name == "love") return " (the guide has a page for those who come from LÖVE)";
    if (name == "io") return std::string(only_files);
    if (name == "self") return " (it exists in methods only: function Ball:name() ... end)";
    if (holds_word(in_math, name)) return " (did you mean \"math." + std::string(name) + "\"?)";
    const std::string_view here = in_place_of(foreign_names, name);
    return hint_to_write(here.empty() ? in_place_of(foreign_functions, name) : here);
}

std::string hint_for_text_method(std::string_view name) {
    return hint_to_write(in_place_of(foreign_text_methods, name));
}

namespace {

std::string hint_for_comparison(std::string_view message) {
    if (message.find("attempt to compare ") == std::string_view::npos) return {};
    const auto says = [&](std::string_view part) {
        return message.find(part) != std::string_view::npos;
    };
    if (says("two vec values")) return hint_to_write("a:length() < b:length(), or a.x < b.x");
    if (says("function")) return hint_to_write("brackets after a function, as in v:length()");
    if (says("number with string") || says("string with number"))
        return hint_to_write("tonumber(text) for a number that is a text");
    return {};
}

/// For a list or a table without an element of that number.
std::string hint_for_element(std::string_view message) {
    if (message.find("on a nil value (field '?')") != std::string_view::npos ||
        message.find("index a nil value (field '?')") != std::string_view::npos ||
        message.find("(field 'integer index')") != std::string_view::npos)
        return " (there is no such element; the first one of a list has the number 1)";
    return {};
}

}  // namespace

std::string hint_for_value(std::string_view message) {
    const auto name_after = [message](std::string_view beginning) {
        const std::size_t at = message.find(beginning);
        return at == std::string_view::npos ? std::string_view() : quoted(message, at);
    };
    if (const auto name = name_after("attempt to call a nil value (field "); !name.empty())
        return holds_word(outside, name) ? std::string(only_files)
                                         : hint_to_write(in_place_of(foreign_functions, name));
    // A callback that the game does not define is nil; other unknown names are errors.
    if (name_after("attempt to call a nil value (global ") == "step")
        return hint_to_write("time.step_once = true to make one step");
    // function(self, other) as a handler
    if (name_after("attempt to index a nil value (local ") == "other")
        return hint_to_write("function(event), whose event.other is the other one");
    if (const auto name = name_after("attempt to get length of a function value ("); !name.empty())
        return hint_to_write("#it:" + std::string(name) + "() if this is a method of it");
    if (const auto name = name_after("attempt to index a function value ("); !name.empty()) {
        const bool global = message.find("(global '") != std::string_view::npos;
        return hint_to_write((global ? "" : "it:") + std::string(name) + "() to call it");
    }
    // color = "red", and then color("blue")
    for (const char* const type : {"string", "number", "boolean"})
        if (message.find(std::string("attempt to call a ") + type + " value (global '") !=
            std::string_view::npos)
            return " (an assignment has replaced what it was)";
    // #008000: the length of the number 8000.
    if (message.find("attempt to get length of a number value") != std::string_view::npos)
        return hint_to_write("a color in quotes, \"#ff8000\"");
    // world.ball:parent() for the property `parent`.
    if (message.find("attempt to call a ") != std::string_view::npos &&
        message.find("attempt to call a nil value") == std::string_view::npos)
        if (const auto name = name_after(" value (method '"); !name.empty())
            return hint_to_write("." + std::string(name) + " without brackets: it is a property");
    // Lua calls the value after `in`.
    if (message.find("(for iterator 'for iterator')") != std::string_view::npos &&
        message.find("attempt to call a nil value") == std::string_view::npos)
        return hint_to_write("for _, each in ipairs(list) do, or pairs(table)");
    if (message.find("attempt to concatenate a vec value") != std::string_view::npos ||
        message.find("attempt to concatenate a instance value") != std::string_view::npos)
        return hint_to_write("tostring(it) to join it to a text");
    if (message.find("attempt to concatenate a boolean value") != std::string_view::npos)
        return hint_to_write("tostring(it) to join it to a text");
    if (std::string hint = hint_for_comparison(message); !hint.empty()) return hint;
    if (std::string hint = hint_for_element(message); !hint.empty()) return hint;
    if (message.find("number has no integer representation") != std::string_view::npos &&
        message.find("'format'") != std::string_view::npos)
        return hint_to_write("%.0f in place of %d, which takes whole numbers only");
    if (message.find("attempt to perform arithmetic on a instance value (local '") !=
        std::string_view::npos)
        return " (a function that is called with a colon gets the instance first; define it with a "
               "colon, too)";
    if (message.find("attempt to add a 'string' with a ") != std::string_view::npos)
        return hint_to_write(".. to join texts");
    return {};
}

std::string hint_for_color(std::string_view line, std::size_t at) {
    if (at == 0 || at >= line.size() || line[at - 1] != '#') return {};
    const std::string_view digits = word_at(line, at);
    const bool hexadecimal = std::all_of(digits.begin(), digits.end(), [](char c) {
        return std::isxdigit(static_cast<unsigned char>(c)) != 0;
    });
    if (!hexadecimal || (digits.size() != 3 && digits.size() != 6 && digits.size() != 8)) return {};
    return hint_to_write("\"#" + std::string(digits) + "\"");
}

bool ends_with_unit(std::string_view text) {
    text = trimmed(text);
    text = text.substr(text.rfind('\n') + 1);  // all of it if there is only one line
    std::size_t word = text.size();
    while (word > 0 && is_word(text[word - 1])) --word;
    if (word == text.size() || (text[word] >= '0' && text[word] <= '9') ||
        is_word_of_lua(text.substr(word)))
        return false;
    const std::string_view before = trimmed(text.substr(0, word));
    std::size_t number = before.size();
    while (number > 0 && (is_word(before[number - 1]) || before[number - 1] == '.')) --number;
    return before.size() < word && number < before.size() && before[number] >= '0' &&
           before[number] <= '9';
}

std::string hint_for_unit() {
    return hint_to_write("the number without its unit");
}

/// For `path is expression`, which only the console takes. In a file it may be any text with "is".
std::string hint_for_is(std::string_view line, std::size_t column, bool in_file) {
    if (!in_file) return hint_to_write("path is expression");
    const std::string_view before = trimmed(line.substr(0, column));
    std::size_t begin = before.size();
    while (begin > 0 && (is_word(before[begin - 1]) || before[begin - 1] == '.')) --begin;
    const std::string_view path = before.substr(begin);
    const std::string_view expression = trimmed(line.substr(std::min(column + 2, line.size())));
    if (path.find('.') == std::string_view::npos || expression.empty()) return {};
    return hint_to_write(std::string(path) + " = formula(function() return " +
                         std::string(expression) + " end)");
}

std::string hint_for_syntax(std::string_view message, std::string_view line, std::size_t column,
                            bool in_file) {
    if (column >= line.size()) return {};
    const std::string_view rest = line.substr(column);
    if (rest.starts_with("//") || (column > 0 && line.substr(column - 1).starts_with("//")))
        return hint_to_write("-- before a comment");
    if (const std::string_view here = sign_at(line, column); !here.empty())
        return hint_to_write(here);
    if (std::string hint = hint_for_color(line, column); !hint.empty()) return hint;
    const auto says = [&](std::string_view part) {
        return message.find(part) != std::string_view::npos;
    };
    if (ends_with_unit(line.substr(0, column))) return hint_for_unit();
    if (word_at(trimmed(line), 0) == "for" &&
        (says("',' expected near ';'") || says("<name> expected near '('") ||
         says("malformed number near")))
        return hint_to_write("for i = 1, n do ... end");
    if (says("malformed number near") && says("..")) return hint_to_write("a .. b with blanks");
    if (says("<name> expected near") && column > 0 &&
        (line[column - 1] == '.' || line[column - 1] == ':') &&
        is_word_of_lua(word_at(line, column)))
        return " (" + std::string(word_at(line, column)) + " is a word of Lua and no name)";
    if (says("')' expected near '='")) return hint_to_write("Body { key = value } with braces");
    if (says("<name> expected near") && trimmed(line.substr(0, column)).ends_with(':') &&
        line.substr(0, column).find('{') != std::string_view::npos)
        return hint_to_write("key = value in a table");
    if (says("')' expected near ','")) return hint_to_write("vec(x, y)");
    if (says("function arguments expected near '='")) return hint_to_write("a.b = value");
    if (says("syntax error near 'is'")) return hint_for_is(line, column, in_file);
    const bool block = message.find("'then' expected") != std::string_view::npos ||
                       message.find("'do' expected") != std::string_view::npos;
    const std::string_view opens =
        message.find("'do' expected") != std::string_view::npos ? "do" : "then";
    if (block && rest.starts_with('=')) return hint_to_write("== to compare");
    if (block && (rest.starts_with('{') || rest.starts_with(':')))
        return hint_to_write(std::string(opens) + " ... end");
    if (rest.starts_with('{') && line.substr(0, column).find(')') != std::string_view::npos)
        return hint_to_write("the lines of a function without { }, and end after them");
    // An entry that follows another one without a comma begins with one of these.
    const bool entry =
        is_word(rest[0]) || std::string_view("{[\"'").find(rest[0]) != std::string_view::npos;
    if (entry && message.find("'}' expected") != std::string_view::npos)
        return hint_to_write(", between the entries of a table");
    if (entry && message.find("')' expected") != std::string_view::npos)
        return hint_to_write(", between the arguments of a function");
    if (const std::string_view here = in_place_of(foreign_statements, word_before(line, column));
        !here.empty())
        return hint_to_write(here);
    if (const std::string_view here = in_place_of(foreign_statements, word_at(line, column));
        !here.empty())
        return hint_to_write(here);
    // path 5
    if (says("syntax error near") && rest[0] >= '0' && rest[0] <= '9' &&
        line.substr(0, column).find('.') != std::string_view::npos)
        return hint_to_write("path = value");
    return {};
}

}  // namespace fettle::script
