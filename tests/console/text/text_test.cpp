// The coloring of lines, and the log.

#include <algorithm>

#include <text/highlight.h>
#include <text/log.h>
#include "catch.h"

namespace text_test {

using namespace fettle::console;
using fettle::script::Evaluation;
using fettle::script::ScriptError;

namespace {

std::string_view piece(std::string_view line, const Span& span) {
    return line.substr(span.begin, span.end - span.begin);
}

bool has(std::string_view line, const std::vector<Span>& spans, std::string_view text,
         Token token) {
    return std::any_of(spans.begin(), spans.end(), [&](const Span& span) {
        return piece(line, span) == text && span.token == token;
    });
}

}  // namespace

TEST_CASE("the parts of a command are colored by their kind") {
    std::string_view line = "if world[\"my ball\"].mass >= 0x1F then x = 'a' -- why";
    auto spans = highlight_command(line);
    CHECK(has(line, spans, "if", Token::keyword));
    CHECK(has(line, spans, "world[\"my ball\"].mass", Token::path));
    CHECK(has(line, spans, "0x1F", Token::number));
    CHECK(has(line, spans, "'a'", Token::string));
    CHECK(has(line, spans, "-- why", Token::comment));
}

TEST_CASE("each word of Lua is colored as a keyword or a constant") {
    for (const std::string_view word :
         {"and",      "break",  "do",   "else", "elseif", "end",  "false", "for",
          "function", "goto",   "if",   "in",   "local",  "nil",  "not",   "or",
          "repeat",   "return", "then", "true", "until",  "while"}) {
        INFO(word);
        const auto spans = highlight_command(word);
        REQUIRE(spans.size() == 1);
        CHECK((spans[0].token == Token::keyword || spans[0].token == Token::constant));
    }
}

TEST_CASE("an echo is colored and other text is not") {
    std::string_view line = "world.ball.mass: 2 → 5.5e-3 kg, don't \"stop\" here";
    auto spans = highlight_output(line);
    CHECK(has(line, spans, "world.ball.mass", Token::path));
    CHECK(has(line, spans, "→", Token::arrow));
    CHECK(has(line, spans, "5.5e-3", Token::number));
    CHECK(has(line, spans, "\"stop\"", Token::string));
    CHECK(has(line, spans, "here", Token::plain));
}

TEST_CASE("the path of a file is one piece without colors") {
    for (const std::string_view line :
         {"recording in /tmp/1/game-58.x/run-1.recording, from step 4",
          "fettle run --replay /tmp/1/game-58.x/run-1.recording",
          "/tmp/1/game-58.x/run-1.recording: it ends"}) {
        INFO(line);
        CHECK(has(line, highlight_output(line), "/tmp/1/game-58.x/run-1.recording", Token::plain));
    }
    CHECK(has("~/.a/b", highlight_output("~/.a/b"), "~/.a/b", Token::plain));
    CHECK(has("6 / 2 /", highlight_output("6 / 2 /"), "2", Token::number));
}

TEST_CASE("the reason why a formula has no value has the color of errors") {
    const std::string line =
        "world.a.mass: is world.b.heat * 2, in error: world.b.heat: no such name";
    const auto spans = highlight_output(line);
    CHECK(has(line, spans, "world.a.mass", Token::path));
    CHECK(has(line, spans, "in error: world.b.heat: no such name", Token::problem));
    CHECK(spans.back().end == line.size());
}

TEST_CASE("coloring accepts any bytes") {
    for (std::string_view line : {"\"unclosed", "world[", "world[\"", "a.", "\\", "\xff\xfe", "[[",
                                  "world[\"x\\", "1e+", "'\\"})
        for (auto& spans : {highlight_command(line), highlight_output(line)})
            for (const Span& span : spans) {
                CHECK(span.begin < span.end);
                CHECK(span.end <= line.size());
            }
}

TEST_CASE("the caret is below the name in the message") {
    auto marked = [](std::string_view line, std::string_view message) {
        return piece(line, error_span(line, message));
    };
    CHECK(marked("world.bal.mass = 5", "world has no \"bal\" (did you mean \"ball\"?)") == "bal");
    CHECK(marked("  x = )", "unexpected symbol near ')'") == ")");
    CHECK(marked("it.mass = it.massive", "world.ball.massive: no such name") == "massive");
    CHECK(marked("  nothing named ", "something failed") == "nothing");
    CHECK(marked("x = scene.load()", "main.lua:9: scene is not available") == "scene");
    CHECK(marked("a.color = b.velocity.z", "main.lua:8: a vec has no z") == "z");
    CHECK(marked("f(\"in handler\", handler)", "main.lua:8: in handler") == "handler");
    CHECK(marked("f(\"in handler\")", "main.lua:8: in handler") == "f");
    CHECK(marked("", "something failed").empty());
}

TEST_CASE("an error in the log shows message and line and caret") {
    Log log;
    ScriptError error;
    error.message = "console:1: no \"bal\" in world";
    error.source_line = "world.bal = 1";
    log.error(error);
    REQUIRE(log.lines().size() == 3);
    CHECK(log.lines()[1].text == "world.bal = 1");
    CHECK(log.lines()[2].text == "      ^^^");
    error.column = 1;
    log.error(error);
    CHECK(log.lines()[5].text == "^^^^^");
}

TEST_CASE("an error without a place in a script says in the log what failed") {
    Log log;
    ScriptError error;
    error.message = "world.ball: no such name";
    error.context = "formula of world.crate.mass";
    log.error(error);
    CHECK(log.lines().back().text == "in formula of world.crate.mass: world.ball: no such name");
    error.context = "console";
    log.error(error);
    CHECK(log.lines().back().text == "world.ball: no such name");
}

TEST_CASE("a traceback is shown if it contains another place") {
    Log log;
    ScriptError error;
    error.message = "console:1: oh no";
    error.traceback = "in metamethod index\nconsole:1: in main chunk";
    log.error(error);
    CHECK(log.lines().size() == 1);
    error.traceback = "main.lua:7: in function hit\nconsole:1: in main chunk";
    log.error(error);
    CHECK(log.lines().size() == 4);
    CHECK(log.lines().back().kind == LineKind::trace);
}

TEST_CASE("the log drops its oldest lines and cuts very long ones") {
    Log log;
    for (std::size_t i = 0; i < Log::max_lines + 10; ++i) log.output("line " + std::to_string(i));
    CHECK(log.lines().size() == Log::max_lines);
    CHECK(log.dropped() == 10);
    CHECK(log.lines().front().text == "line 10");
    log.output(std::string(1'000'000, 'x'));
    CHECK(log.lines().back().text.size() < Log::max_line_bytes + 100);
    CHECK(log.lines().back().text.find("1000000 bytes") != std::string::npos);
    log.clear();
    CHECK(log.lines().empty());
}

TEST_CASE("output that a command has caused stands below it") {
    Log log;
    log.note("before");
    const std::uint64_t begin = log.end();
    log.note("it = world.ball");
    log.game("printed");
    log.command("selection { world.ball }", begin);
    REQUIRE(log.lines().size() == 4);
    CHECK(log.lines()[0].text == "before");
    CHECK(log.lines()[1].text == "selection { world.ball }");
    CHECK(log.lines()[2].text == "it = world.ball");
    CHECK(log.lines()[3].text == "printed");
    log.command("2", log.end());
    CHECK(log.lines().back().text == "2");
    // A command that clears the log leaves nothing above itself.
    const std::uint64_t again = log.end();
    log.clear();
    log.command("3", again);
    CHECK(log.lines().size() == 1);
}

TEST_CASE("a repeated line is stored once with its number") {
    Log log;
    for (int i = 0; i < 5; ++i) log.output("beep");
    log.output("boop");
    log.output("beep");
    REQUIRE(log.lines().size() == 3);
    CHECK(log.lines()[0].count == 5);
    CHECK(log.lines()[2].count == 1);
    log.command("beep");
    log.command("beep");
    CHECK(log.lines().size() == 5);  // what was typed stays as it is
}

TEST_CASE("long output of a command is folded and can be opened") {
    Log log;
    Evaluation evaluation;
    for (int i = 0; i < 100; ++i) evaluation.lines.push_back("line " + std::to_string(i));
    log.output(evaluation);
    log.note("after it");
    REQUIRE(log.lines().size() == Log::shown_of_folded + 2);
    CHECK(log.lines()[Log::shown_of_folded].text == "… 60 more lines");
    const auto before = log.rearranged();
    log.unfold(0);  // not a fold
    CHECK(log.rearranged() == before);
    log.unfold(Log::shown_of_folded);
    REQUIRE(log.lines().size() == 101);
    CHECK(log.lines()[99].text == "line 99");
    CHECK(log.lines()[100].text == "after it");
    CHECK(log.rearranged() != before);
    CHECK_FALSE(log.unfold_last());
    log.output(evaluation);
    CHECK(log.unfold_last() == 101 + Log::shown_of_folded);
    CHECK(log.lines().size() == 201);
    log.clear();
    evaluation.lines.resize(Log::max_unfolded);
    log.output(evaluation);
    CHECK(log.lines().size() == Log::max_unfolded);
}

TEST_CASE("a printed text with several lines makes several lines") {
    Log log;
    log.output("a\nb\n");
    log.output("");
    log.command("for\nend");
    REQUIRE(log.lines().size() == 5);
    CHECK(log.lines()[1].text == "b");
    CHECK(log.lines()[2].text.empty());
    CHECK(log.lines()[4].kind == LineKind::continuation);
}

}  // namespace text_test
