// The rows of the log: where lines, paths and tables break.

#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "catch.h"
#include "rig.h"

#include <look/imgui_compat.h>

namespace log_rows_test {

using namespace fettle;
using console::test::Rig;

TEST_CASE("wrapped rows of a table begin below its last column") {
    Rig rig;
    rig.key("grave");
    rig.draw(3);
    rig.console.print("  :apply_force   " + std::string(40, 'a') + " " + std::string(60, 'b'));
    rig.draw(3);
    const auto rows = rig.state().views.log_view.shown_rows();
    CHECK(rows.back().find("bbb") == rows[rows.size() - 2].find("aaa"));
}

TEST_CASE(
    "wrapped rows of a command are indented like the command even if it contains runs of blanks") {
    Rig rig;
    rig.key("grave");
    rig.draw(3);
    rig.state().log.command("x = 1" + std::string(40, ' ') + std::string(100, 'b'));
    rig.draw(3);
    CHECK(rig.state().views.log_view.shown_rows().back().starts_with("bbb"));
}

TEST_CASE("the log is seen in the first frame after a change of the size of the text") {
    Rig rig;
    rig.key("grave");
    rig.draw(3);
    for (int i = 0; i < 200; ++i) rig.console.print("line " + std::to_string(i) + " of the game");
    const auto scale = [&](double factor) {
        property::set(rig.tree, "console.scale", property::Value(factor));
    };
    const auto letters = [&] {
        rig.surface.clear();
        rig.draw();
        return rig.surface.triangle_count();
    };
    scale(2);
    rig.draw(5);
    const std::uint64_t large = rig.state().views.log_view.top_line();
    scale(1);
    const std::size_t first = letters();
    rig.draw(5);
    CHECK(first > letters() * 9 / 10);
    const std::uint64_t small = rig.state().views.log_view.top_line();
    CHECK(small < large);
    scale(2);
    rig.draw(5);
    CHECK(rig.state().views.log_view.top_line() == large);
    // Away from the end, the topmost line stays.
    scale(1);
    rig.draw(5);
    for (int i = 0; i < 3; ++i) {
        rig.key("page_up");
        rig.draw(2);
    }
    const std::uint64_t top = rig.state().views.log_view.top_line();
    CHECK(top < small);
    for (const double factor : {2.0, 1.0, 1.5, 1.0}) {
        scale(factor);
        rig.draw();
        CHECK(rig.state().views.log_view.top_line() == top);
        rig.draw(4);
        CHECK(rig.state().views.log_view.top_line() == top);
    }
}

TEST_CASE("a column that begins beyond the middle of the log is shown in rows of its own") {
    Rig rig;
    rig.key("grave");
    rig.draw(3);
    rig.console.print("  " + std::string(70, 'n') + "   " + std::string(60, 'a') + " " +
                      std::string(60, 'b'));
    rig.draw(3);
    const auto rows = rig.state().views.log_view.shown_rows();
    CHECK(rows[rows.size() - 3] == "  " + std::string(70, 'n') + "   ");
    CHECK(rows[rows.size() - 2] == "    " + std::string(60, 'a') + " ");
    CHECK(rows.back() == "    " + std::string(60, 'b'));
}

TEST_CASE("the rows of a table that is wider than the log break before the same column") {
    Rig rig;
    rig.key("grave");
    rig.draw(3);
    script::TableLines table{1, true, {}};
    std::vector<std::string> lines = {"printed before the table"};
    for (const std::string word : {"head", "x", "longer"}) {
        std::string line;
        table.cells.emplace_back();
        for (const char column : {'1', '2', '3', '4'}) {
            table.cells.back().push_back(line.size());
            const std::string wide(word == "longer" ? 33 : 0, '~');
            const std::string cell = word + column + wide;
            line += cell + (column == '4' ? "" : std::string(42 - cell.size(), ' '));
        }
        lines.push_back(line);
    }
    script::Evaluation evaluation;
    evaluation.lines = lines;
    evaluation.tables = {table};
    rig.state().log.output(evaluation);
    rig.draw(3);
    const auto rows = rig.state().views.log_view.shown_rows();
    REQUIRE(rows.size() >= 6);
    for (const std::size_t row : {rows.size() - 6, rows.size() - 4, rows.size() - 2}) {
        INFO(rows[row] << '\n' << rows[row + 1]);
        CHECK(rows[row].find('2') != std::string::npos);
        CHECK(rows[row].find('3') == std::string::npos);
        CHECK(rows[row + 1].find_first_not_of(' ') == 4);
        CHECK(rows[row + 1].find('4') > 42);
        CHECK(rows[row + 1].find(' ', rows[row + 1].find('4')) == std::string::npos);
    }
    CHECK(rows.back().find("longer4") == rows[rows.size() - 5].find("head4"));
}

TEST_CASE("a long path breaks before one of its names and a vector stays whole") {
    Rig rig;
    rig.key("grave");
    rig.draw(3);
    std::string path = "world";
    for (int i = 0; i < 12; ++i) path += ".a_rather_long_name_" + std::to_string(i);
    rig.console.print(path);
    rig.draw(3);
    const auto& view = rig.state().views.log_view;
    const std::vector<std::string> rows = view.shown_rows();
    CHECK(rows.back().starts_with(".a_rather_long_name_"));
    const auto columns = static_cast<std::size_t>(
        (rig.state().screen.panel_rect.high.x - view.text_end().x) / view.cell());
    rig.console.print(std::string(columns - 20, 'x') + " impulse vec(-0.18891177, 3.119492) N s");
    rig.draw(3);
    CHECK(view.shown_rows().back() == "vec(-0.18891177, 3.119492) N s");
}

TEST_CASE("the caret is below the place that it marks where the source line is wrapped") {
    Rig rig;
    rig.key("grave");
    rig.draw(3);
    script::ScriptError error;
    error.message = "main.lua:1: world.boll: no such name";
    error.file = "main.lua";
    error.line = 1;
    error.source_line = "local sum = " + std::string(200, '1') + " + world.boll";
    error.column = static_cast<int>(error.source_line.find("boll")) + 1;
    rig.console.report(error);
    rig.draw(3);
    const auto rows = rig.state().views.log_view.shown_rows();
    std::string above, marked;
    for (std::size_t i = 1; i < rows.size(); ++i)
        if (rows[i].find('^') != std::string::npos) {
            above = rows[i - 1];
            marked = rows[i];
        }
    INFO(above << '\n' << marked);
    REQUIRE(marked.find("^^^^") != std::string::npos);
    CHECK(above.substr(marked.find('^'), 4) == "boll");
}

TEST_CASE("the message of an error that is higher than the log stays in sight") {
    Rig rig;
    rig.key("grave");
    const console::LogView& view = rig.state().views.log_view;
    for (int i = 0; i < 50; ++i) rig.console.print("line " + std::to_string(i));
    rig.draw(3);
    const float height = view.text_end().y;  // of the lower edge of the log
    const auto y_of = [&](std::string_view text) {
        const auto rows = view.shown_rows();
        float y = view.text_end().y;
        for (std::size_t i = rows.size(); i > 0; --i) {
            y -= view.line_height();
            if (rows[i - 1].find(text) != std::string::npos) return y;
        }
        return -1.0f;
    };
    const ImGuiWindow* log = nullptr;
    for (const ImGuiWindow* each : ImGui::GetCurrentContext()->Windows)
        if (std::string_view(each->Name).find("/log_") != std::string_view::npos) log = each;
    REQUIRE(log != nullptr);
    script::ScriptError error;
    error.message = "no such name";
    error.line = 1;
    error.source_line = std::string(6000, 'x');
    error.column = 5900;
    rig.console.report(error);
    rig.draw(4);
    CHECK(y_of("no such name") == Approx(log->Pos.y));
    rig.console.print("the next line");  // the view follows it
    rig.draw(4);
    CHECK(y_of("the next line") + view.line_height() == Approx(height));
}

TEST_CASE("the topmost row of the log is whole") {
    Rig rig;
    rig.key("grave");
    for (int i = 0; i < 100; ++i) rig.console.print("line " + std::to_string(i));
    for (const double height : {0.4, 0.41, 0.42, 0.43}) {
        property::set(rig.tree, "console.height", property::Value(height));
        rig.draw(4);
        const auto& view = rig.state().views.log_view;
        const ImGuiWindow* log = nullptr;
        for (const ImGuiWindow* each : ImGui::GetCurrentContext()->Windows)
            if (std::string_view(each->Name).find("/log_") != std::string_view::npos) log = each;
        REQUIRE(log != nullptr);
        const float rows = log->Size.y / view.line_height();
        CHECK(rows == Approx(std::round(rows)));
        CHECK(view.text_end().y == Approx(log->Pos.y + log->Size.y));
    }
}

TEST_CASE("the rows of a long table that are left out are below a fold") {
    script::Evaluation evaluation;
    script::TableLines table{0, true, {}};
    script::FoldedLines folded{3, {}, {}};
    for (const char* row : {"path  mass", "a     1.23456789", "b     2"}) {
        evaluation.lines.emplace_back(row);
        table.cells.push_back({0, 6});
    }
    evaluation.lines.emplace_back("… 2 more (4 instances)");
    for (const char* row : {"long  3.23456789", "d     4"}) {
        folded.lines.emplace_back(row);
        folded.cells.push_back({0, 6});
    }
    folded.lines.emplace_back("… 7 more");  // more than are folded
    evaluation.tables = {table};
    evaluation.folded = {folded};
    console::Log log;
    log.output(evaluation);
    REQUIRE(log.lines().size() == 4);
    CHECK(log.lines().back().kind == console::LineKind::fold);
    CHECK(log.lines().back().text == "… 2 more (4 instances)");
    log.unfold(3);
    REQUIRE(log.lines().size() == 6);
    CHECK(log.lines()[1].text == "a     1.235");
    CHECK(log.lines()[3].text == "long  3.235");
    CHECK(log.lines()[3].table == log.lines()[1].table);
    CHECK(log.lines()[5].text == "… 7 more");
}

}  // namespace log_rows_test
