#include <command_line/arguments.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <filesystem>
#include <functional>
#include <vector>

#include <fettle/property/spelling.h>

#include <command_line/joined.h>
#include <terminal/terminal.h>

namespace fettle::program {

namespace {

/// Returns at most the first 60 bytes of an argument, in quotes, for a message.
std::string quoted_start(std::string_view text) {
    constexpr std::size_t max = 60;
    std::string whole = on_one_line(text.substr(0, max));
    return "\"" + whole + (text.size() > max ? "...\"" : "\"");
}

}  // namespace

std::uint64_t whole_number(const std::string& option, std::string_view text, std::uint64_t min,
                           std::uint64_t max) {
    std::uint64_t number = 0;
    const char* const end = text.data() + text.size();
    const auto [stopped, error] = std::from_chars(text.data(), end, number);
    if (!text.empty() && error == std::errc() && stopped == end && number >= min && number <= max)
        return number;
    throw CLI::ValidationError(option, "expected a whole number from " + std::to_string(min) +
                                           " to " + std::to_string(max) + ", got " +
                                           quoted_start(text));
}

std::string checked_text(const std::string& option, const std::string& text, const char* expected) {
    if (!text.empty()) return text;
    throw CLI::ValidationError(option, std::string("expected ") + expected + ", got an empty text");
}

std::string command_problem(const CLI::App& app, std::string_view first) {
    if (first.starts_with('-')) return {};
    std::vector<std::string> names;
    const std::function<bool(const CLI::App*)> every;
    for (const CLI::App* command : app.get_subcommands(every)) {
        if (command->get_name() == first) return {};
        names.push_back(command->get_name());
    }
    const std::string wrong = quoted_start(first) + " is not a command; ";
    const std::filesystem::path path(first);
    std::error_code none;
    if (path.extension() == ".lua" || std::filesystem::exists(path / "main.lua", none))
        return wrong + "fettle run " + on_one_line(first) + " plays a game";
    return wrong + "there are " + joined(names) + property::suggestion(first, names);
}

std::string left_over_problem(const CLI::App& command) {
    const std::vector<std::string> left = command.remaining();
    if (left.empty()) return {};
    const std::string& first = left.front();
    if (!first.starts_with("-") || first.size() == 1)
        return quoted_start(first) + " is one argument too many";
    const std::string name = first.substr(0, first.find('='));
    std::vector<std::string> names;
    for (const CLI::Option* option : command.get_options())
        for (const std::string& each : option->get_lnames()) names.push_back("--" + each);
    return quoted_start(name) + " is not an option of " + command.get_name() +
           property::suggestion(name, names);
}

}  // namespace fettle::program
