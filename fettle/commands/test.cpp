#include <algorithm>
#include <filesystem>
#include <set>
#include <string>
#include <system_error>
#include <vector>

#include <fettle/property/storage/scene.h>

#include <command_line/for_shell.h>
#include <command_line/subcommand.h>
#include <commands/commands.h>
#include <ending/end_request.h>
#include <ending/exit_guard.h>
#include <ending/exit_status.h>
#include <files/game_path.h>
#include <terminal/terminal.h>
#include <testing/junit.h>
#include <testing/test_run.h>

namespace fettle::program {

namespace fs = std::filesystem;

namespace {

/// The files of tests, relative to the folder of the game.
std::vector<std::string> test_files(const fs::path& game) {
    std::vector<std::string> files;
    std::error_code error;
    for (fs::directory_iterator it(folder_of(game) / "tests", error), end; !error && it != end;
         it.increment(error))
        if (it->path().extension() == ".lua")
            files.push_back((fs::path("tests") / it->path().filename()).generic_string());
    std::ranges::sort(files);
    std::set<std::string> folders;
    for (fs::recursive_directory_iterator it(folder_of(game) / "tests", error), end;
         !error && it != end; it.increment(error))
        if (it.depth() > 0 && it->path().extension() == ".lua")
            folders.insert(
                it->path().parent_path().lexically_relative(folder_of(game)).generic_string());
    for (const std::string& folder : folders)
        print_line("note  " + folder +
                   ": only the files in tests itself are run, not those of its folders");
    if (files.empty())
        throw FileError(folder_of(game).string() +
                        ": this game has no tests; they are in files tests/NAME.lua");
    return files;
}

void print_indented(const std::string& lines, const char* indent) {
    for (std::size_t start = 0; start < lines.size();) {
        const std::size_t end = std::min(lines.find('\n', start), lines.size());
        print_line(indent + lines.substr(start, end - start));
        start = end + 1;
    }
}

void print_outcome(const TestOutcome& outcome, bool always_output) {
    const std::string name = outcome.file + (outcome.name.empty() ? "" : ": " + outcome.name);
    print_line((outcome.passed ? "ok    " : "FAIL  ") + name);
    for (const std::string& picture : outcome.skipped)
        print_line("      the picture " + picture + " was not compared: there is no display");
    print_indented(outcome.message, "      ");
    print_indented(outcome.details, "      ");
    if (!outcome.output.empty() && (always_output || !outcome.passed)) {
        print_line("      it printed");
        print_indented(outcome.output, "        ");
    }
    if (!outcome.recording.empty())
        print_line("      fettle run --replay " + for_shell(outcome.recording.string()));
}

class Suite {
  public:
    explicit Suite(const TestOptions& options) : options_(options) {}

    int run() {
        for (const std::string& file : test_files(options_.game))
            if (EndRequest::signal() == 0) run(file);
        if (!options_.junit.empty()) write_junit(options_.junit, outcomes_);
        if (EndRequest::signal() != 0) return status_of_signal(EndRequest::signal());
        const auto failed = std::ranges::count(outcomes_, false, &TestOutcome::passed);
        if (outcomes_.empty()) {
            print_line(options_.filter.empty()
                           ? "there is no test in the files of tests"
                           : "no test has \"" + options_.filter + "\" in its file or its name");
            return script_error;
        }
        print_line(std::to_string(outcomes_.size()) +
                   (outcomes_.size() == 1 ? " test, " : " tests, ") + std::to_string(failed) +
                   " failed");
        return failed == 0 ? success : script_error;
    }

  private:
    void run(const std::string& file) {
        TestList list;
        try {
            const ExitGuard guard(file);
            list = list_tests(options_, file);
        } catch (const property::FileError& error) {  // a pipe, a folder
            list.outcome = {.file = file, .name = {}, .message = error.what()};
        }
        // Nothing can be tested if the game or the file cannot be loaded.
        if (!list.outcome.passed) return add(list.outcome);
        if (list.names.empty()) print_line("note  " + file + ": it has no test");
        for (const std::string& name : list.names) {
            if (EndRequest::signal() != 0) return;
            const bool wanted = file.find(options_.filter) != std::string::npos ||
                                name.find(options_.filter) != std::string::npos;
            if (!wanted) continue;
            const ExitGuard guard(file + ": " + name);
            add(run_test(options_, {.file = file, .name = name}));
        }
    }
    void add(TestOutcome outcome) {
        print_outcome(outcome, options_.output);
        (void)all_printed();  // shown while the next test runs
        outcomes_.push_back(std::move(outcome));
    }

    const TestOptions& options_;
    std::vector<TestOutcome> outcomes_;
};

constexpr std::uint64_t longest_test = 86'400;  // s

int test(const TestOptions& given) {
    const EndRequest end_request;
    TestOptions options = given;
    options.game = found_game(given.game);
    return Suite(options).run();
}

}  // namespace

Command add_test(CLI::App& app) {
    Subcommand<TestOptions> command(app, "test",
                                    "Run the tests of a game: tests/*.lua beside main.lua.");
    command.text("path", &TestOptions::game, path_of_game,
                 "A folder with main.lua, or one .lua file; without it, this folder");
    command.text("--filter", &TestOptions::filter, "a part of a name",
                 "Only tests with this text in the name of their file or in their own");
    command.text("--junit", &TestOptions::junit, "a file",
                 "Write a report in the format JUnit XML there");
    command.flag("--update", &TestOptions::update,
                 "Write the pictures of t:screenshot instead of comparing them");
    command.flag("--output", &TestOptions::output,
                 "Show what the game printed in each test, also in one that passes");
    command.number("--timeout", &TestOptions::timeout, 1, longest_test,
                   "Stop a test that takes longer than this number of seconds of processor time; "
                   "60 by default");
    command.text("--module", &TestOptions::modules, "a file or a name",
                 "Plug in a module: a shared object, or the name of an installed one (repeatable)");
    return command.runs(test);
}

}  // namespace fettle::program
