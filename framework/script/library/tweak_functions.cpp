// Functions for tweaks:
//   tweaks()  keep(pattern)  keep_for_all(pattern)  reapply_tweaks(pattern)  drop_tweaks(pattern)

#include <ctime>
#include <filesystem>

#include <fettle/property/path.h>
#include <fettle/property/storage/tweaks.h>
#include <fettle/script/runtime.h>

#include <library/library.h>
#include <lua/exception_guard.h>
#include <lua/machine.h>
#include <sandbox/sandbox.h>
#include <values/values.h>

namespace fettle::script {

using property::Tweak;
using property::TweakReport;

namespace {

property::Tweaks& tweaks_of(Machine& machine, const char* what) {
    if (machine.options.tweaks != nullptr) return *machine.options.tweaks;
    throw Error(ErrorKind::rejected, std::string(what) + ": this game has no journal of tweaks");
}

std::string pattern_at(lua_State* L, const char* what) {
    return property::Pattern(
               check_text(L, 1, std::string(what) + ": needs a pattern like \"world.ball.*\""))
        .text();
}

std::string clock_text(std::int64_t seconds, const char* form) {
    const auto time = static_cast<std::time_t>(seconds);
    std::tm parts{};
    if (localtime_r(&time, &parts) == nullptr) return "?";
    char text[32];
    return {text, std::strftime(text, sizeof text, form, &parts)};
}

std::string line_of(const Tweak& tweak) {
    std::string line = "  " + tweak.path + ": ";
    if (tweak.value) line += tweak.was + " → ";
    line += tweak.now + "   step " + std::to_string(tweak.step) + ", " +
            clock_text(tweak.time, tweak.earlier ? "%F %R" : "%T");
    if (tweak.kept) line += "   kept in " + tweak.kept_in;
    if (!tweak.committed) line += "   not journaled yet";
    return line;
}

int tweaks(lua_State* L) {
    Machine& machine = machine_of(L);
    const std::vector<Tweak> all = tweaks_of(machine, "tweaks").list();
    if (all.empty()) {
        print_line(machine, "nothing was tweaked");
        return 0;
    }
    const char* heading = "";
    for (const Tweak& tweak : all) {
        const char* its = tweak.earlier
                              ? "earlier, and not kept: keep, reapply_tweaks or drop_tweaks"
                              : "in this run";
        if (its != heading) print_line(machine, its);
        heading = its;
        print_line(machine, line_of(tweak));
    }
    return 0;
}

void log_result(
    Machine& machine, const char* done, const std::string& pattern, const TweakReport& report,
    std::string (*behind)(std::size_t count) = [](std::size_t) { return std::string(); }) {
    std::string line = std::string(done) + " " + std::to_string(report.count) +
                       (report.count == 1 ? " tweak" : " tweaks");
    if (report.count == 0 && report.problems.empty())
        line = property::message_text("no open tweak matches \"" + pattern + "\"");
    for (std::size_t i = 0; i < report.files.size(); ++i)
        line +=
            (i == 0 ? " in " : ", ") + std::filesystem::path(report.files[i]).filename().string();
    print_line(machine, report.count > 0 ? line + behind(report.count) : line);
    for (const std::string& note : report.notes) print_line(machine, "  " + note);
    for (const std::string& problem : report.problems) print_line(machine, "  " + problem);
}

int keep(lua_State* L) {
    Machine& machine = machine_of(L);
    const std::string pattern = pattern_at(L, "keep");
    note_replay(machine, "keep");
    log_result(machine, "kept", pattern, tweaks_of(machine, "keep").keep(pattern));
    return 0;
}

int keep_for_all(lua_State* L) {
    Machine& machine = machine_of(L);
    const std::string pattern = pattern_at(L, "keep_for_all");
    note_replay(machine, "keep_for_all");
    log_result(machine, "kept", pattern, tweaks_of(machine, "keep_for_all").keep_for_all(pattern));
    return 0;
}

int reapply_tweaks(lua_State* L) {
    Machine& machine = machine_of(L);
    const std::string pattern = pattern_at(L, "reapply_tweaks");
    log_result(machine, "made again", pattern,
               tweaks_of(machine, "reapply_tweaks").reapply(pattern));
    return 0;
}

int drop_tweaks(lua_State* L) {
    Machine& machine = machine_of(L);
    const std::string pattern = pattern_at(L, "drop_tweaks");
    log_result(machine, "dropped", pattern, tweaks_of(machine, "drop_tweaks").drop(pattern),
               [](std::size_t count) -> std::string {
                   return count == 1 ? "; its value stays as it is"
                                     : "; their values stay as they are";
               });
    return 0;
}

}  // namespace

void open_tweaks(lua_State* L) {
    add_function<tweaks>(L, "tweaks");
    add_function<keep>(L, "keep");
    add_function<keep_for_all>(L, "keep_for_all");
    add_function<reapply_tweaks>(L, "reapply_tweaks");
    add_function<drop_tweaks>(L, "drop_tweaks");
}

}  // namespace fettle::script
