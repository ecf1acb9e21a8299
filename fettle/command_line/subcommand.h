#pragma once
// A subcommand of the program, and its options.

#include <CLI/CLI.hpp>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include <command_line/arguments.h>

namespace fettle::program {

/// A subcommand of the program.
struct Command {
    const CLI::App* app;
    /// Runs the command and returns the exit status.
    std::function<int()> run;
};

/// Declares a subcommand. The values on the command line are written into an `Options`.
template <class Options>
class Subcommand {
  public:
    Subcommand(CLI::App& app, const char* name, const char* help)
        : app_(*app.add_subcommand(name, help)) {
        app_.allow_extras();  // `left_over_problem` names the nearest option
    }

    /// An option whose value is passed to `set(options, text)`. A value may contain commas and
    /// brackets, so it is never split.
    template <class Set>
    CLI::Option* option(const char* name, const char* help, Set set) {
        return app_.add_option_function<std::string>(
            name, [to = options_, set](const std::string& text) { set(*to, text); }, help);
    }

    /// A text or a file; repeatable if the member is a list. `expected` describes a valid value.
    template <class Member>
    CLI::Option* text(const char* name, Member Options::*member, const char* expected,
                      const char* help) {
        CLI::Option* const made =
            option(name, help, [name, member, expected](Options& to, const std::string& text) {
                if constexpr (std::is_same_v<Member, std::vector<std::string>>)
                    (to.*member).push_back(checked_text(name, text, expected));
                else
                    to.*member = checked_text(name, text, expected);
            });
        if constexpr (std::is_same_v<Member, std::vector<std::string>>) made->trigger_on_parse();
        return made;
    }

    /// A whole number from `min` to `max`.
    template <class Member>
    CLI::Option* number(const char* name, Member Options::*member, std::uint64_t min,
                        std::uint64_t max, const char* help) {
        return option(name, help, [=](Options& to, const std::string& text) {
            to.*member =
                static_cast<typename Number<Member>::type>(whole_number(name, text, min, max));
        });
    }

    void flag(const char* name, bool Options::*member, const char* help) {
        app_.add_flag(name, (*options_).*member, help);
    }
    /// A flag that calls `set(options)`.
    template <class Set>
    void flag(const char* name, const char* help, Set set) {
        app_.add_flag_callback(
            name, [to = options_, set] { set(*to); }, help);
    }

    Command runs(int (*command)(const Options&)) const {
        return {&app_, [command, options = options_] { return command(*options); }};
    }

  private:
    /// The type of the number in a member, which may be optional.
    template <class Member>
    struct Number : std::type_identity<Member> {};
    template <class Member>
    struct Number<std::optional<Member>> : std::type_identity<Member> {};

    CLI::App& app_;
    std::shared_ptr<Options> options_ = std::make_shared<Options>();
};

/// What `text` expects of the path of a game.
inline constexpr const char* path_of_game = "a folder with main.lua, or a .lua file";

}  // namespace fettle::program
