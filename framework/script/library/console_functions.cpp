// Functions that need a console:
//   pin(...)  unpin(text)  pins()  plot(...)  break_when(condition)  unbreak(text)  breaks()
//   last_time(condition)
//   selection(instances)  bind(key, command)  binds()  alias(word, command)  aliases()  exec(file)
//   clear()
//   export_plot(kind)  ab(path, value)  share(file)  record(on)  go_on()  restart()
//   compare_branch(name)  bookmark(name, step)  unbookmark(name)  bookmarks()  play_back(seconds)

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string_view>
#include <utility>

#include <fettle/property/path.h>
#include <fettle/property/storage/assets.h>
#include <fettle/script/observed.h>
#include <fettle/script/runtime.h>

#include <handlers/observed.h>
#include <library/library.h>
#include <lua/environment.h>
#include <lua/exception_guard.h>
#include <lua/host.h>
#include <lua/machine.h>
#include <lua/stack.h>
#include <objects/instance_set.h>
#include <reference/language.h>
#include <sandbox/sandbox.h>
#include <sources/sources.h>
#include <text/words.h>
#include <values/short_text.h>
#include <values/values.h>

namespace fettle::script {

namespace {

/// The console's function `member`. A replay may not have it: then nullptr. Throws in another run
/// without a console.
template <class Function, class Part>
const Function* served(const Machine& machine, Function Part::*member, const char* what) {
    const Function& function = (*machine.host.console).*member;
    if (function) return &function;
    if (!machine.options.replay.empty()) return nullptr;
    throw Error(ErrorKind::rejected, std::string(what) + ": this run has no console");
}

/// Calls that function, if there is one.
template <auto member, class... Arguments>
void call_console(lua_State* L, const char* what, Arguments&&... arguments) {
    if (const auto* function = served(machine_of(L), member, what))
        (*function)(std::forward<Arguments>(arguments)...);
}

/// Calls that function, if there is one, and prints its answer. A script gets no answer.
template <auto member, class... Arguments>
void ask_console(lua_State* L, const char* what, Arguments&&... arguments) {
    Machine& machine = machine_of(L);
    if (const auto* function = served(machine, member, what))
        if (const std::string answer = (*function)(std::forward<Arguments>(arguments)...);
            !answer.empty() && machine.recording.active)
            print_line(machine, answer);
}

/// The text at `index`, which may be left out; `needs` is the error for another value.
std::string text_or_nothing(lua_State* L, int index, std::string_view needs) {
    return lua_isnoneornil(L, index) ? std::string() : check_text(L, index, needs);
}

int pin(lua_State* L) {
    if (lua_gettop(L) == 0) refuse_type(L, 1, "pin: needs a path or an expression as text");
    for (int i = 1; i <= lua_gettop(L); ++i)
        ask_console<&ConsoleFunctions::pin>(L, "pin", observe(L, i, "pin"));
    return 0;
}

int unpin(lua_State* L) {
    const std::string text = text_or_nothing(L, 1, "unpin: needs the text that was pinned");
    ask_console<&ConsoleFunctions::unpin>(L, "unpin",
                                          text.empty() ? text : with_selected(machine_of(L), text));
    return 0;
}

/// The table of the names and values that the console gives.
template <auto member>
int push_named(lua_State* L, const char* what) {
    const auto* function = served(machine_of(L), member, what);
    lua_newtable(L);
    if (function == nullptr) return 1;
    for (const auto& [name, value] : (*function)()) {
        push_text(L, name);
        push_value(L, property::Value(value));
        lua_rawset(L, -3);
    }
    return 1;
}

int pins(lua_State* L) {
    return push_named<&ConsoleFunctions::pins>(L, "pins");
}

int plot(lua_State* L) {
    std::vector<Observed> all;
    for (int i = 1; i <= lua_gettop(L); ++i) all.push_back(observe(L, i, "plot"));
    ask_console<&ConsoleFunctions::plot>(L, "plot", std::move(all));
    return 0;
}

int break_when(lua_State* L) {
    Observed condition;
    if (!lua_isnoneornil(L, 1)) condition = observe(L, 1, "break_when");
    Machine& machine = machine_of(L);
    if (const auto* function = served(machine, &ConsoleFunctions::break_when, "break_when"))
        if (const std::string message = (*function)(std::move(condition)); !message.empty())
            print_line(machine, message);
    return 0;
}

int unbreak(lua_State* L) {
    Machine& machine = machine_of(L);
    const std::string text = text_or_nothing(L, 1, "unbreak: needs the text of the condition");
    const auto* function = served(machine, &ConsoleFunctions::unbreak, "unbreak");
    if (function == nullptr) return 0;
    const bool removed = (*function)(text.empty() ? text : with_selected(machine, text)) > 0;
    if (!removed)
        print_line(machine, text.empty() ? "no break is set" : "no break has that condition");
    else
        print_line(machine, text.empty() ? "no break is set any more" : "that break is removed");
    return 0;
}

int breaks(lua_State* L) {
    const auto* function = served(machine_of(L), &ConsoleFunctions::breaks, "breaks");
    lua_newtable(L);
    if (function == nullptr) return 1;
    lua_Integer count = 0;
    for (const std::string& text : (*function)()) {
        push_text(L, text);
        lua_rawseti(L, -2, ++count);
    }
    return 1;
}

int last_time(lua_State* L) {
    call_console<&ConsoleFunctions::last_time>(L, "last_time", observe(L, 1, "last_time"));
    return 0;
}

int ab(lua_State* L) {
    Machine& machine = machine_of(L);
    if (lua_isnoneornil(L, 1)) {
        ask_console<&ConsoleFunctions::ab>(L, "ab", std::string(), property::Value(), 0.0);
        return 0;
    }
    const std::string path =
        with_selected(machine, check_text(L, 1, "ab: needs the path of a property as text"));
    if (lua_isnone(L, 2))
        throw Error(
            ErrorKind::wrong_type,
            "ab: needs the other value after the path, as in ab(\"world.gravity\", vec(0, -2))");
    const property::Value value = to_value(L, 2);
    const double seconds = lua_isnoneornil(L, 3) ? 4 : check_number(L, 3, "ab: seconds");
    ask_console<&ConsoleFunctions::ab>(L, "ab", path, value, seconds);
    return 0;
}

int compare_branch(lua_State* L) {
    call_console<&ConsoleFunctions::compare_branch>(
        L, "compare_branch", text_or_nothing(L, 1, "compare_branch: needs the name of a branch"));
    return 0;
}

int bookmark(lua_State* L) {
    const std::string name = text_or_nothing(L, 1, "bookmark: the name is a text");
    std::optional<std::int64_t> step;
    if (!lua_isnoneornil(L, 2)) {
        int whole = 0;
        step = lua_tointegerx(L, 2, &whole);
        if (whole == 0 && lua_type(L, 2) == LUA_TNUMBER)
            throw Error(ErrorKind::out_of_range,
                        "bookmark: a step is a whole number, not " + short_text(L, 2));
        if (whole == 0) refuse_type(L, 2, "bookmark: expected the number of a step");
    }
    ask_console<&ConsoleFunctions::bookmark>(L, "bookmark", name, step);
    return 0;
}

int unbookmark(lua_State* L) {
    ask_console<&ConsoleFunctions::unbookmark>(
        L, "unbookmark", text_or_nothing(L, 1, "unbookmark: needs the name of a bookmark"));
    return 0;
}

int bookmarks(lua_State* L) {
    const auto* function = served(machine_of(L), &ConsoleFunctions::bookmarks, "bookmarks");
    lua_newtable(L);
    if (function == nullptr) return 1;
    for (const auto& [name, step] : (*function)()) {
        push_text(L, name);
        lua_pushinteger(L, step);
        lua_rawset(L, -3);
    }
    return 1;
}

int play_back(lua_State* L) {
    const double seconds =
        lua_isnoneornil(L, 1) ? HUGE_VAL : check_number(L, 1, "play_back: seconds");
    if (!(seconds > 0))
        throw Error(ErrorKind::out_of_range, "play_back: expected a time in seconds, more than 0");
    ask_console<&ConsoleFunctions::play_back>(L, "play_back", seconds);
    return 0;
}

int share(lua_State* L) {
    Machine& machine = machine_of(L);
    const std::string file = check_text(L, 1, "share: needs the name of a file");
    if (const auto* function = served(machine, &ConsoleFunctions::share, "share"))
        print_line(machine, (*function)(file));
    return 0;
}

int record(lua_State* L) {
    Machine& machine = machine_of(L);
    if (!lua_isnoneornil(L, 1) && !lua_isboolean(L, 1))
        refuse_type(L, 1, "record: expected true or false");
    const bool on = lua_isnoneornil(L, 1) || lua_toboolean(L, 1) != 0;
    if (const auto* function = served(machine, &ConsoleFunctions::record, "record"))
        print_line(machine, (*function)(on));
    return 0;
}

int go_on(lua_State* L) {
    ask_console<&ConsoleFunctions::go_on>(L, "go_on");
    return 0;
}

int restart(lua_State* L) {
    call_console<&ConsoleFunctions::restart>(L, "restart");
    return 0;
}

int bind(lua_State* L) {
    const std::string key = check_text(L, 1, "bind: needs the name of a key like \"f5\"");
    ask_console<&ConsoleFunctions::bind>(L, "bind", key,
                                         text_or_nothing(L, 2, "bind: the command is a text"));
    return 0;
}

int binds(lua_State* L) {
    return push_named<&ConsoleFunctions::binds>(L, "binds");
}

int aliases(lua_State* L) {
    return push_named<&ConsoleFunctions::aliases>(L, "aliases");
}

int alias(lua_State* L) {
    const std::string word = check_text(L, 1, "alias: needs a word");
    if (is_word_of_lua(word))
        throw Error(ErrorKind::bad_name, "alias: \"" + word + "\" is a word of Lua");
    if (!property::is_identifier(word))
        throw Error(ErrorKind::bad_name,
                    "alias: \"" + word + "\" is not a word of letters, digits and underscores");
    const std::string command = text_or_nothing(L, 2, "alias: the command is a text");
    ask_console<&ConsoleFunctions::alias>(L, "alias", word, command);
    if (!command.empty() && global_doc(word) != nullptr)
        print_line(machine_of(L), "alias: typed commands that begin with " + word +
                                      " run the alias now; alias(\"" + word + "\") ends that");
    return 0;
}

int exec(lua_State* L) {
    constexpr std::string_view endings[] = {".lua"};
    Machine& machine = machine_of(L);
    const std::string file = check_text(L, 1, "exec: needs a file of commands");
    const std::string text = machine.sources.files.read(
        property::Assets(machine.sources.files, machine.sources.folder, machine.options.assets)
            .find("exec", file, endings));
    call_console<&ConsoleFunctions::exec>(L, "exec", file, text);
    return 0;
}

int clear(lua_State* L) {
    call_console<&ConsoleFunctions::clear>(L, "clear");
    return 0;
}

int export_plot(lua_State* L) {
    const std::string kind = lua_isnoneornil(L, 1)
                                 ? std::string("csv")
                                 : check_text(L, 1, "export_plot: needs \"csv\" or \"png\"");
    if (kind != "csv" && kind != "png")
        throw Error(ErrorKind::rejected,
                    "export_plot: expected \"csv\" or \"png\", got \"" + kind + "\"");
    call_console<&ConsoleFunctions::export_plot>(L, "export_plot", kind);
    return 0;
}

/// selection() returns the selected instances, selection(list) selects them.
int selection(lua_State* L) {
    Machine& machine = machine_of(L);
    std::vector<property::Handle> all;
    if (lua_isnoneornil(L, 1)) {
        const auto* get = served(machine, &ConsoleFunctions::selection, "selection");
        if (get != nullptr) all = (*get)();
        push_set(L, all);
        return 1;
    }
    if (instance_at(L, 1) != nullptr) {
        all.push_back(check_instance(L, 1, "selection"));
    } else {
        const bool table = lua_istable(L, 1);
        lua_pushnil(L);
        if (!table || (lua_rawlen(L, 1) == 0 && lua_next(L, 1) != 0))
            refuse_type(L, 1, "selection: expected a list of instances");
        lua_settop(L, 1);
        const auto length = static_cast<lua_Integer>(lua_rawlen(L, 1));
        for (lua_Integer i = 1; i <= length; ++i) {
            lua_rawgeti(L, 1, i);
            all.push_back(check_instance(L, -1, "selection"));
            lua_pop(L, 1);
        }
    }
    ask_console<&ConsoleFunctions::select>(L, "selection", all);
    return 0;
}

}  // namespace

void assign_it(lua_State* L, int index) {
    Machine& machine = machine_of(L);
    std::vector<property::Handle> all;
    if (instance_at(L, index) != nullptr)
        all.push_back(check_instance(L, index, "it"));
    else if (!lua_isnil(L, index))
        refuse_type(L, index, "`it` is the selected instance: expected an instance or nil");
    if (const auto& select = (*machine.host.console).select) {
        if (const std::string answer = select(all); !answer.empty() && machine.recording.active)
            print_line(machine, answer);
    } else {
        machine.globals.it = all.empty() ? property::Handle() : all.front();
    }
}

bool list_by_word(lua_State* L, std::string_view word, std::vector<std::string>& lines) {
    constexpr std::pair<std::string_view, Listed> words[] = {{"pin", Listed::pins},
                                                             {"pins", Listed::pins},
                                                             {"plot", Listed::plots},
                                                             {"break_when", Listed::breaks},
                                                             {"breaks", Listed::breaks},
                                                             {"bookmark", Listed::bookmarks},
                                                             {"bookmarks", Listed::bookmarks},
                                                             {"bind", Listed::binds},
                                                             {"binds", Listed::binds},
                                                             {"alias", Listed::aliases},
                                                             {"aliases", Listed::aliases}};
    const auto* const found =
        std::ranges::find(words, word, &std::pair<std::string_view, Listed>::first);
    if (found == std::end(words)) return false;
    lua_getglobal(L, found->first.data());
    const bool own = lua_iscfunction(L, -1) != 0;  // and not a variable of the game
    lua_pop(L, 1);
    if (!own) return false;
    Machine& machine = machine_of(L);
    if (const auto* function = served(machine, &ConsoleFunctions::listed, found->first.data()))
        lines = (*function)(found->second);
    return true;
}

void open_console_functions(lua_State* L) {
    add_function<pin>(L, "pin");
    add_function<unpin>(L, "unpin");
    add_function<pins>(L, "pins");
    add_function<plot>(L, "plot");
    add_function<break_when>(L, "break_when");
    add_function<unbreak>(L, "unbreak");
    add_function<breaks>(L, "breaks");
    add_function<last_time>(L, "last_time");
    add_function<bind>(L, "bind");
    add_function<alias>(L, "alias");
    add_function<binds>(L, "binds");
    add_function<aliases>(L, "aliases");
    add_function<exec>(L, "exec");
    add_function<clear>(L, "clear");
    add_function<export_plot>(L, "export_plot");
    add_function<selection>(L, "selection");
    add_function<ab>(L, "ab");
    add_function<share>(L, "share");
    add_function<record>(L, "record");
    add_function<go_on>(L, "go_on");
    add_function<restart>(L, "restart");
    add_function<compare_branch>(L, "compare_branch");
    add_function<bookmark>(L, "bookmark");
    add_function<unbookmark>(L, "unbookmark");
    add_function<bookmarks>(L, "bookmarks");
    add_function<play_back>(L, "play_back");
}

}  // namespace fettle::script
