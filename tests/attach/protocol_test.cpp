#include <catch.h>

#include <attach/protocol.h>

namespace protocol_test {

using namespace fettle;
using namespace fettle::program;

namespace {

std::string without_end(std::string line) {
    REQUIRE(!line.empty());
    REQUIRE(line.back() == '\n');
    line.pop_back();
    CHECK(line.find('\n') == std::string::npos);
    return line;
}

}  // namespace

TEST_CASE("a greeting has exactly the token") {
    const std::string line = without_end(greeting("0123abcd"));
    CHECK(is_greeting(line, "0123abcd"));
    CHECK(!is_greeting(line, "0123abce"));
    CHECK(!is_greeting(line + "0", "0123abcd"));
    CHECK(!is_greeting(line.substr(0, line.size() - 1), "0123abcd"));
    CHECK(!is_greeting("fettle 2 0123abcd", "0123abcd"));
    CHECK(!is_greeting("", ""));
    CHECK(!is_greeting("fettle 1 ", ""));
}

TEST_CASE("requests come back as they were") {
    const std::string text = "x = \"ü\\n\"\nreturn x\t\x01";
    const auto run = read_request(without_end(text_of({.text = text})));
    REQUIRE(run);
    CHECK(run->kind == Request::Kind::run);
    CHECK(run->text == text);
    const auto complete = read_request(
        without_end(text_of({.kind = Request::Kind::complete, .text = "wor", .cursor = 2})));
    REQUIRE(complete);
    CHECK(complete->kind == Request::Kind::complete);
    CHECK(complete->text == "wor");
    CHECK(complete->cursor == 2);
}

TEST_CASE("a line that is not a request is refused") {
    for (const char* const line :
         {"", "{", "{}", "[]", "3", "null", R"({"run": 3})", R"({"run": ["x"]})",
          R"({"run": {"run": "x"}})", R"({"walk": "x"})", "\xff\xfe", R"({"run": "x"} y)"}) {
        INFO(line);
        CHECK(!read_request(line));
    }
    CHECK(!read_request(std::string(longest_request, '[')));
    CHECK(!read_request(R"({"run": )" + std::string(20000, '[') + std::string(20000, ']') + "}"));
    // Reading ends at the first value that no request has, so such values take no memory.
    CHECK(!read_request(R"({"run": "x", "more": []})"));
    CHECK(!read_request(R"({"run": "x", "more": {}})"));
    const auto with_members = [](std::size_t count) {
        std::string line = "{";
        for (std::size_t i = 1; i < count; ++i) line += "\"" + std::to_string(i) + "\": 1, ";
        return read_request(line + R"("run": "x"})");
    };
    CHECK(with_members(most_members));
    CHECK(!with_members(most_members + 1));
    const auto beyond = read_request(R"({"complete": "ab", "cursor": 99})");
    REQUIRE(beyond);
    CHECK(beyond->cursor == 2);
    CHECK(read_request(R"({"complete": "ab", "cursor": -1})")->cursor == 0);
}

TEST_CASE("messages come back as they were") {
    CHECK(read_message(without_end(welcome_text("/games/drop")))->text == "/games/drop");
    CHECK(read_message(without_end(refusal_text("full")))->kind == Message::Kind::refusal);
    CHECK(read_message(without_end(print_text("a\nb")))->text == "a\nb");
    CHECK(read_message(without_end(lost_text(12)))->count == 12);
    const auto unfinished = read_message(
        without_end(answer_text({.incomplete = true, .lines = {}, .error = {}, .result = {}})));
    CHECK(unfinished->incomplete);
    CHECK(unfinished->lines.empty());
    script::Evaluation evaluation{.lines = {"3 kg"}, .error = {}, .result = {}};
    evaluation.error.emplace();
    evaluation.error->message = "console:1: no";
    const auto answer = read_message(without_end(answer_text(evaluation)));
    CHECK(answer->lines == std::vector<std::string>{"  3 kg", "✗ console:1: no"});
    CHECK(!answer->incomplete);
    const script::Evaluation signs{
        .lines = {"\"x\\y\"", "ü \x7f", "\x01\t", ""}, .error = {}, .result = {}};
    CHECK(read_message(without_end(answer_text(signs)))->lines ==
          std::vector<std::string>{"  \"x\\y\"", "  ü \x7f", "  \x01\t", "  "});
    const auto found = read_message(without_end(candidates_text(
        {{.text = "mass", .label = "mass", .detail = "3 kg", .doc = "", .replace_from = 6},
         {.text = "\"ü\\", .label = "\n", .detail = "", .doc = ""}})));
    REQUIRE(found->found.size() == 2);
    CHECK(found->found[1].text == "\"ü\\");
    CHECK(found->found[1].label == "\n");
    CHECK(found->found[0].text == "mass");
    CHECK(found->found[0].detail == "3 kg");
    CHECK(found->found[0].replace_from == 6);
}

TEST_CASE("long answers are cut and say so and bytes that are not text are replaced") {
    const script::Evaluation evaluation{
        .lines = std::vector<std::string>(5000, std::string(100, 'x')), .error = {}, .result = {}};
    const std::string text = answer_text(evaluation);
    CHECK(text.size() < 2 * longest_answer);
    const auto answer = read_message(without_end(text));
    REQUIRE(answer);
    const std::string cut = "  … " + std::to_string(5001 - answer->lines.size()) + " more lines";
    CHECK(answer->lines.back() == cut);
    CHECK(print_text(std::string(1 << 20, 'y')).size() < longest_answer + 100);
    CHECK(read_message(without_end(print_text("a\xff")))->text == "a\xef\xbf\xbd");
    CHECK(candidates_text(std::vector<script::Completion>(10000)).size() < longest_answer);
}

}  // namespace protocol_test
