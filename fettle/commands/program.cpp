#include <CLI/CLI.hpp>
#include <csignal>
#include <exception>
#include <string>
#include <vector>

#include <fettle/property/exception_text.h>

#include <command_line/arguments.h>
#include <command_line/subcommand.h>
#include <command_line/version.h>
#include <commands/commands.h>
#include <ending/crash_report.h>
#include <ending/exit_guard.h>
#include <ending/exit_status.h>
#include <files/file_errors.h>
#include <files/game_path.h>
#include <terminal/terminal.h>

namespace fettle::program {
namespace {

/// The error as one sentence, without CLI11's name of the kind of error.
std::string message_of(const CLI::ParseError& error) {
    const std::string text = error.what();
    if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr)
        return text.substr(0, text.find(':')) + ": it takes one value, once";
    return text.substr(0, text.find('\n'));
}

/// `command`: the subcommand with the wrong arguments; null: none.
int refuse(const std::string& reason, const CLI::App* command = nullptr) {
    const std::string name = command != nullptr ? command->get_name() + " " : "";
    print_error(reason + " (fettle " + name + "--help tells more)");
    return bad_usage;
}

int run_command(int argc, char** argv) {
    // A write beyond the file size limit then fails with an error for that file; the signal would
    // end the process.
    std::signal(SIGXFSZ, SIG_IGN);
    report_crashes();
    CLI::App app("Fettle: 2D games in which every property of every object is live.", "fettle");
    app.set_version_flag("--version", version_text());
    app.allow_extras();
    if (const auto first_page = guide(); !first_page.empty())
        app.footer("The guide: " + first_page.string());
    const Command commands[] = {add_run(app),     add_test(app), add_new_game(app), add_where(app),
                                add_package(app), add_repl(app), add_docs(app)};
    // Without arguments, the program opens the gallery.
    const std::vector<const char*> given(argv, argv + argc), gallery = {"fettle", "run"};
    const std::vector<const char*>& line = given.size() < 2 ? gallery : given;
    if (const std::string wrong = command_problem(app, line[1]); !wrong.empty())
        return refuse(wrong);
    try {
        app.parse(static_cast<int>(line.size()), line.data());
    } catch (const CLI::ParseError& error) {
        // A request for help or the version.
        if (error.get_exit_code() == 0) return app.exit(error);
        const auto named = app.get_subcommands();
        return refuse(message_of(error), named.empty() ? nullptr : named.front());
    }
    if (const std::string wrong = left_over_problem(app); !wrong.empty()) return refuse(wrong);
    for (const Command& command : commands) {
        if (!command.app->parsed()) continue;
        if (const std::string wrong = left_over_problem(*command.app); !wrong.empty())
            return refuse(wrong, command.app);
        const ExitGuard guard(command.app->get_name());
        const int status = with_file_errors(command.run);
        return all_printed() || status != success ? status : file_error;
    }
    return refuse("expected a command, as in fettle run");
}

}  // namespace

int run_program(int argc, char** argv) {
    try {
        return run_command(argc, argv);
    } catch (const std::exception& error) {
        print_error(property::exception_text(error));
        return script_error;
    }
}

}  // namespace fettle::program
