#include <testing/junit.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <string>
#include <string_view>

#include <files/game_path.h>
#include <terminal/terminal.h>

namespace fettle::program {

namespace {

std::string in_xml(std::string_view text) {
    std::string out;
    for (const char c : without_controls(text)) {
        switch (c) {
            case '&':
                out += "&amp;";
                break;
            case '<':
                out += "&lt;";
                break;
            case '>':
                out += "&gt;";
                break;
            case '"':
                out += "&quot;";
                break;
            default:
                out += c;
        }
    }
    return out;
}

std::string seconds_text(double seconds) {
    char text[40];
    std::snprintf(text, sizeof text, "%.3f", seconds);
    return text;
}

std::string case_text(const TestOutcome& outcome) {
    std::string text = "    <testcase classname=\"" + in_xml(outcome.file) + "\" name=\"" +
                       in_xml(outcome.name) + "\" time=\"" + seconds_text(outcome.seconds) + "\"";
    if (outcome.passed) return text + "/>\n";
    return text + ">\n      <failure message=\"" + in_xml(on_one_line(outcome.message)) + "\">" +
           in_xml(outcome.details) + "</failure>\n    </testcase>\n";
}

}  // namespace

void write_junit(const std::filesystem::path& file, const std::vector<TestOutcome>& outcomes) {
    std::map<std::string, std::vector<const TestOutcome*>> suites;
    for (const TestOutcome& outcome : outcomes) suites[outcome.file].push_back(&outcome);
    std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n";
    for (const auto& [name, suite] : suites) {
        const auto failed = std::ranges::count_if(
            suite, [](const TestOutcome* outcome) { return !outcome->passed; });
        double seconds = 0;
        for (const TestOutcome* outcome : suite) seconds += outcome->seconds;
        text += "  <testsuite name=\"" + in_xml(name) + "\" tests=\"" +
                std::to_string(suite.size()) + "\" failures=\"" + std::to_string(failed) +
                "\" time=\"" + seconds_text(seconds) + "\">\n";
        for (const TestOutcome* outcome : suite) text += case_text(*outcome);
        text += "  </testsuite>\n";
    }
    text += "</testsuites>\n";
    write_file(file, text);
}

}  // namespace fettle::program
