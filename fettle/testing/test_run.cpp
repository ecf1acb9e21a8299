#include <testing/test_run.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <system_error>

#include <fettle/app/screen.h>
#include <fettle/property/exception_text.h>
#include <fettle/property/text_hash.h>

#include <ending/crash_report.h>
#include <ending/end_request.h>
#include <files/game_path.h>
#include <session/session.h>
#include <testing/test_limit.h>

namespace fettle::program {

namespace fs = std::filesystem;

namespace {

/// The longest test: 28 minutes of a game with 60 steps a second.
constexpr std::uint64_t most_steps = 100'000;

/// The traceback without the frames of the functions of tests.
std::string without_library(const std::string& traceback) {
    std::string text;
    for (std::size_t start = 0; start < traceback.size();) {
        const std::size_t end = std::min(traceback.find('\n', start), traceback.size() - 1) + 1;
        const std::string_view line = std::string_view(traceback).substr(start, end - start);
        start = end;
        // After this line there are only frames of the library, which resumes the coroutine of the
        // test.
        if (line.starts_with("  (coroutine started from)") &&
            traceback.find("  testing.lua:", start) != std::string::npos)
            break;
        if (!line.starts_with("  testing.lua:")) text += line;
    }
    return text;
}

std::string lines_of(const script::ScriptError& error) {
    std::string text;
    const std::vector<std::string> lines = script::error_lines(error);
    for (std::size_t i = 1; i < lines.size(); ++i) text += lines[i] + "\n";
    return text + without_library(error.traceback);
}

/// The name of a recording of a test: letters and digits of the names of the file and of the test,
/// and what is not ASCII; other characters as dashes. If another test could have the same name, a
/// hash of file and test follows.
std::string file_name_of(const TestChoice& choice) {
    constexpr std::size_t longest = 100;
    const fs::path file = choice.file;
    const std::string stem = file.stem().string();
    bool unique = file.parent_path() == "tests";
    std::string name;
    for (const char c : stem + " " + choice.name) {
        const auto byte = static_cast<unsigned char>(c);
        const bool plain = std::isalnum(byte) != 0 || byte >= 0x80 || c == '_';
        const bool parts = !plain && !name.empty() && name.back() != '-';
        unique = unique && (plain || (c == ' ' && parts && name.size() >= stem.size()));
        if (plain || parts) name += plain ? c : '-';
    }
    if (unique && name.size() <= longest) return name;
    return name.substr(0, longest) + "-" +
           property::text_hash_digits(file.string() + "\n" + choice.name);
}

/// The folder for files of failed tests: beside the game, or one for temporary files.
fs::path folder_for_failures(const fs::path& game) {
    std::error_code error;
    for (const fs::path& above : {folder_of(game), fs::temp_directory_path(error) / "fettle"}) {
        fs::path folder = above / ".fettle" / "tests";
        fs::create_directories(folder, error);
        if (!error) return folder;
    }
    return ".";
}

/// The share of the pixels that differ visibly in a channel, 0 to 1.
double difference(const app::Pixels& a, const app::Pixels& b) {
    constexpr int visible = 16;  // of 255
    if (a.width != b.width || a.height != b.height) return 1;
    std::size_t count = 0;
    for (std::size_t i = 0; i + 3 < a.rgba.size(); i += 4) {
        bool differs = false;
        for (std::size_t k = i; k < i + 4; ++k)
            differs = differs || std::abs(int{a.rgba[k]} - int{b.rgba[k]}) > visible;
        count += differs ? 1 : 0;
    }
    return static_cast<double>(count) / std::max<double>(1, static_cast<double>(a.rgba.size()) / 4);
}

class TestRun {
  public:
    TestRun(const TestOptions& options, TestChoice choice)
        : options_(options), failures_(folder_for_failures(options.game)) {
        outcome_.file = choice.file;
        outcome_.name = choice.name;
        run_.game = options.game;
        run_.headless = true;
        run_.modules = options.modules;
        if (!choice.name.empty()) run_.record = failures_ / (file_name_of(choice) + ".recording");
        run_.test = std::move(choice);
    }

    /// Loads the game and the file, and runs the test if it has a name.
    TestOutcome run() {
        const Clock::time_point begun = Clock::now();
        const double begun_processor = processor_seconds();
        const TestLimit limit(options_.timeout);
        CollectedOutput collected;
        {
            Session session(run_, nullptr,
                            [this](const script::ScriptError& error) { fail(error); });
            const EndRequest::Scripts scripts(session.runtime());
            session.on_output([&](std::string_view text) {
                collected.is({});
                outcome_.output += std::string(text) + "\n";
                collected.is(outcome_.output);
            });
            // All calls of the test together have one limit.
            const auto limit_of_all = static_cast<double>(options_.timeout);
            session.runtime().limit_calls(
                std::min(1.0, limit_of_all), [=](const script::LongCall&) {
                    return processor_seconds() - begun_processor <= limit_of_all;
                });
            session.test()->on_picture([&](const std::string& name, double tolerance) {
                return compare(session, name, tolerance);
            });
            session.start();
            names_ = session.test()->names();
            if (session.failed() && outcome_.message.empty()) outcome_.message = "it failed";
            if (!run_.test->name.empty()) go_on(session, begun_processor);
        }
        outcome_.passed = outcome_.message.empty();
        outcome_.seconds = std::chrono::duration<double>(Clock::now() - begun).count();
        if (outcome_.passed) {
            std::error_code error;
            fs::remove(run_.record, error);
        } else {
            outcome_.recording = run_.record;
        }
        return std::move(outcome_);
    }
    const std::vector<std::string>& names() const { return names_; }

  private:
    using Clock = std::chrono::steady_clock;

    void go_on(Session& session, double begun) {
        app::Loop& loop = session.loop();
        while (outcome_.message.empty() && !session.test()->done()) {
            if (EndRequest::signal() != 0) return fail("it was interrupted");
            if (loop.steps_made() >= most_steps)
                return fail("the test did not end within " + std::to_string(most_steps) + " steps");
            // Processor time: a test does not fail because other programs use the machine.
            if (processor_seconds() - begun > static_cast<double>(options_.timeout))
                return fail("the test did not end within " + std::to_string(options_.timeout) +
                            " s of processor time");
            loop.turn();
            if (!loop.stopped() || session.test()->done()) continue;
            if (session.test()->waits_for_quit()) return;
            return fail("the game called quit() before the test ended");
        }
    }

    void fail(const std::string& message) {
        if (outcome_.message.empty()) outcome_.message = message;
    }
    /// Later errors are often caused by the first one.
    void fail(const script::ScriptError& error) {
        if (!outcome_.message.empty()) return;
        outcome_.message = error.message.empty() ? "an error without a message" : error.message;
        outcome_.details = lines_of(error);
    }

    std::string compare(Session& session, const std::string& name, double tolerance) {
        if (!app::display_available()) {
            outcome_.skipped.push_back(name);
            return {};
        }
        try {
            return compare_drawn(session, name, tolerance);
        } catch (const std::exception& error) {
            return property::exception_text(error);
        }
    }

    std::string compare_drawn(Session& session, const std::string& name, double tolerance) {
        const property::Vec2 size = session.services().view.screen;
        const auto picture =
            app::make_picture(static_cast<unsigned>(size.x), static_cast<unsigned>(size.y));
        session.loop().draw(*picture, 0);
        picture->present();
        const fs::path folder = folder_of(options_.game) / "tests" / "pictures";
        const fs::path kept = folder / (name + ".png");
        std::error_code error;
        if (options_.update) {
            fs::create_directories(folder, error);
            picture->save(kept);
            return {};
        }
        const fs::path drawn = failures_ / (name + ".png");
        if (!fs::exists(kept, error)) {
            picture->save(drawn);
            return "there is no picture " + kept.string() + " yet: look at " + drawn.string() +
                   ", and keep it with fettle test --update";
        }
        const double share = difference(picture->pixels(), app::read_picture(kept));
        if (share <= tolerance) return {};
        picture->save(drawn);
        return "the picture " + kept.string() + " differs in " +
               property::number_text(std::round(share * 1e5) / 1e3) + " % of its pixels, and " +
               property::number_text(tolerance * 100) + " % are allowed; what was drawn is " +
               drawn.string();
    }

    const TestOptions& options_;
    fs::path failures_;
    RunOptions run_;
    TestOutcome outcome_;
    std::vector<std::string> names_;
};

}  // namespace

TestList list_tests(const TestOptions& options, const std::string& file) {
    TestRun run(options, {.file = file, .name = {}});
    TestOutcome outcome = run.run();
    return {.names = run.names(), .outcome = std::move(outcome)};
}

TestOutcome run_test(const TestOptions& options, const TestChoice& choice) {
    return TestRun(options, choice).run();
}

}  // namespace fettle::program
