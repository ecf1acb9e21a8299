// `fettle docs`: annotations and reference pages contain everything, and the committed files equal
// the output of the program.

#include <catch.h>
#include <sys/wait.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

#include <unistd.h>

#include "luacats.h"
#include "temporary_folder.h"

namespace docs_test {

namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

using Folder = TemporaryFolder;

/// Exit status of `fettle ARGUMENTS`, run without a display; its output goes to the files out and
/// err.
int fettle(const Folder& folder, const std::string& arguments) {
    const std::string here = "'" + folder.path.string() + "'";
    const std::string command = "cd " + here +
                                " && env -u DISPLAY -u WAYLAND_DISPLAY timeout 60 '" +
                                FETTLE_PROGRAM + "' " + arguments + " >out 2>err </dev/null";
    const int result = std::system(command.c_str());
    return WIFEXITED(result) ? WEXITSTATUS(result) : -1;
}

std::vector<std::vector<std::string>> table(const std::string& text) {
    std::vector<std::vector<std::string>> rows;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) {
        std::vector<std::string> row;
        std::istringstream cells(line);
        for (std::string cell; std::getline(cells, cell, '\t');) row.push_back(cell);
        rows.push_back(row);
    }
    return rows;
}

/// The cells of the row for `name` in a Markdown table; empty if there is no such row.
std::vector<std::string> row_about(const std::string& page, const std::string& name) {
    const std::size_t start = page.find("\n| `" + name + "` |");
    if (start == std::string::npos) return {};
    std::string line = page.substr(start + 1, page.find('\n', start + 1) - start - 1);
    std::vector<std::string> cells;
    std::string cell;
    for (std::size_t i = 1; i < line.size(); ++i) {
        if (line[i] == '|' && line[i - 1] != '\\') {
            cells.push_back(cell.substr(1, cell.size() - 2));
            cell.clear();
        } else {
            cell += line[i];
        }
    }
    return cells;
}

// Lists the classes and globals of a running game.
const char* walk = R"lua(
local function line(...) print(table.concat({ ... }, "\t")) end
for _, c in ipairs(classes) do
  line("class", c.name, c.base and c.base.name or "-", c.doc)
  for _, p in ipairs(c.properties) do
    if p.owner == c then
      line("property", c.name, p.name, p.unit == "" and "-" or p.unit, p.type,
           p.min and tostring(p.min) or "-", p.max and tostring(p.max) or "-", p.doc)
      for _, word in ipairs(p.enumerators) do line("enumerator", c.name, p.name, word) end
    end
  end
  for _, m in ipairs(c.methods) do
    if m.owner == c then
      line("method", c.name, m.name, m.doc)
      for _, f in ipairs(m.parameters) do
        line("parameter", c.name, m.name, f.name, f.unit == "" and "-" or f.unit, f.doc)
      end
      for _, f in ipairs(m.returns) do
        line("result", c.name, m.name, f.name, f.unit == "" and "-" or f.unit, f.doc)
      end
    end
  end
  for _, e in ipairs(c.events) do
    if e.owner == c then
      line("event", c.name, e.name, e.doc)
      for _, f in ipairs(e.fields) do
        line("reported", c.name, e.name, f.name, f.unit == "" and "-" or f.unit, f.doc)
      end
    end
  end
end
for _, child in ipairs(game:children()) do line("service", child.name, child.class) end
local function look(prefix, t)
  for k, v in pairs(t) do
    if type(v) == "table" and k ~= "_G" then look(prefix .. k .. ".", v)
    elseif type(v) == "function" then line("function", prefix .. k)
    elseif k ~= "line" then line("variable", prefix .. k) end
  end
end
look("", _G)
)lua";

std::vector<std::vector<std::string>> walk_over_everything(const Folder& folder) {
    std::ofstream(folder.path / "walk.lua") << walk;
    REQUIRE(fettle(folder, "run walk.lua --headless --steps 1") == 0);
    return table(text_of(folder.path / "out"));
}

}  // namespace

TEST_CASE("the committed reference equals the output of the program") {
    const Folder folder;
    REQUIRE(fettle(folder, "docs new") == 0);
    const fs::path committed = "docs/reference", written = folder.path / "new";
    std::string differing;
    for (const fs::path& one : {committed, written}) {
        const fs::path& other = one == committed ? written : committed;
        for (const auto& entry : fs::recursive_directory_iterator(one)) {
            const fs::path name = entry.path().lexically_relative(one);
            if (entry.is_regular_file() && text_of(entry.path()) != text_of(other / name))
                differing += name.string() + "\n";
        }
    }
    for (const auto& entry : fs::directory_iterator(folder.path))
        CHECK((entry.path() == written || entry.path().filename() == "out" ||
               entry.path().filename() == "err"));
    INFO("write them anew with: build/release/bin/fettle docs docs/reference");
    CHECK(differing == "");
}

TEST_CASE("every line of the annotations is valid and every type in them is defined") {
    const Folder folder;
    REQUIRE(fettle(folder, "docs new") == 0);
    luacats::File file;
    REQUIRE_NOTHROW(file = luacats::read(text_of(folder.path / "new/fettle.lua")));
    const std::set<std::string> known = {"any",    "boolean", "function", "integer", "nil",
                                         "number", "string",  "table",    "thread",  "false"};
    for (const std::string& type : file.types) {
        INFO(type);
        CHECK((known.contains(type) || file.classes.contains(type)));
    }
    for (const auto& [name, info] : file.classes) {
        INFO(name);
        CHECK((info.base.empty() || file.classes.contains(info.base)));
    }
}

TEST_CASE("invalid annotations are refused") {
    for (const std::string bad :
         {"---@clas Body", "---@class Body", "---@class Body\nlocal b = {}", "---@field x number a",
          "---A\n---@class B\n---@field x number\nlocal b = {}", "function f() end",
          "---F\n---@param end number\nfunction f(end) end",
          "---F\n---@param a number\nfunction f(b) end", "---F\n---@return fun(\nfunction f() end",
          "---F\n---@return Body[\nfunction f() end", "print(1)", "---V\n---@type X|\nx = nil"}) {
        INFO(bad);
        CHECK_THROWS_AS(luacats::read("---@meta fettle\n" + bad + "\n\n"), luacats::Malformed);
    }
    CHECK_NOTHROW(
        luacats::read("---@meta fettle\n---F\n---@param a? table<string, fun(b: X?, ...: any): "
                      "Y[]|\"z\", W>\nfunction f(a) end\n"));
}

namespace {

/// Whether a word of the text is this number, however it is written: 1e8 or 100000000.
bool has_number(const std::string& text, double number) {
    std::istringstream words(text);
    for (std::string word; words >> word;) {
        char* end = nullptr;
        const double found = std::strtod(word.c_str(), &end);
        if (end != word.c_str() && found == number) return true;
    }
    return false;
}

}  // namespace

TEST_CASE("annotations and pages contain everything that a game can use with unit and range") {
    const Folder folder;
    REQUIRE(fettle(folder, "docs new") == 0);
    const fs::path pages = folder.path / "new";
    const luacats::File file = luacats::read(text_of(pages / "fettle.lua"));
    const std::string index = text_of(pages / "README.md"),
                      functions = text_of(pages / "functions.md"),
                      callbacks = text_of(pages / "callbacks.md");
    std::map<std::string, int> counts;
    for (const auto& row : walk_over_everything(folder)) {
        REQUIRE(row.size() >= 2);
        const std::string& kind = row[0];
        ++counts[kind];
        INFO(kind << " " << row[1] << (row.size() > 2 ? " " + row[2] : ""));
        const auto contains = [](const std::string& text, const std::string& part) {
            return text.find(part) != std::string::npos;
        };
        if (kind == "function" || kind == "variable") {
            CHECK((file.functions.contains(row[1]) || file.variables.contains(row[1])));
            CHECK((contains(functions, "### `" + row[1] + "`") ||
                   contains(callbacks, "### `" + row[1] + "`")));
            continue;
        }
        if (kind == "service") {
            REQUIRE(file.variables.contains(row[1]));
            CHECK(file.variables.at(row[1]).type == row[2]);
            CHECK_FALSE(row_about(index, row[1]).empty());
            continue;
        }
        REQUIRE(file.classes.contains(row[1]));
        const luacats::Class& annotated = file.classes.at(row[1]);
        const std::string page = text_of(pages / ("classes/" + row[1] + ".md"));
        if (kind == "class") {
            REQUIRE(row.size() == 4);
            CHECK(annotated.base == (row[2] == "-" ? "" : row[2]));
            CHECK(annotated.doc == row[3]);
            CHECK(contains(page, row[3]));
            CHECK(contains(index, "[" + row[1] + "](classes/" + row[1] + ".md)"));
        } else if (kind == "property") {
            REQUIRE(row.size() == 8);  // fails if a description is empty
            REQUIRE(annotated.fields.contains(row[2]));
            const std::string& reported = annotated.fields.at(row[2]).doc;
            CHECK(reported.starts_with(row[7] + " · "));
            const auto cells = row_about(page, row[2]);
            REQUIRE(cells.size() == 7);
            CHECK(cells[2] == (row[3] == "-" ? "–" : row[3]));
            if (row[3] != "-") CHECK(contains(reported, " · " + row[3]));
            CHECK(cells[3] != "–");
            for (const std::string& bound : {row[5], row[6]}) {
                if (bound == "-" || bound == "inf" || bound == "-inf") continue;
                CHECK(has_number(cells[3], std::stod(bound)));
                CHECK(has_number(reported, std::stod(bound)));
            }
            CHECK(contains(cells[6], row[7].substr(0, row[7].find('|'))));
        } else if (kind == "enumerator") {
            CHECK(contains(annotated.fields.at(row[2]).type, "\"" + row[3] + "\""));
            // The names of keys would fill the page, so it has their number; in lists that name
            // each one, the name is found.
            const std::string taken = row_about(page, row[2])[3];
            CHECK((contains(taken, "\"" + row[3] + "\"") || taken.ends_with(" texts")));
        } else if (kind == "method") {
            REQUIRE(row.size() == 4);
            CHECK(annotated.methods.contains(row[2]));
            CHECK(annotated.methods.at(row[2]).doc == row[3]);
            CHECK(contains(page, "### `:" + row[2] + "("));
        } else if (kind == "event") {
            REQUIRE(row.size() == 4);
            const std::string reported = row[2] == "deleted" ? "Existence" : row[1] + "." + row[2];
            CHECK(file.classes.contains(reported));
            bool typed = false;
            for (const std::string& overload : annotated.methods.at("on").overloads)
                typed |= contains(overload,
                                  "event: \"" + row[2] + "\", handler: fun(record: " + reported);
            CHECK(typed);
            CHECK(contains(page, "### `" + row[2] + "`"));
        } else {  // a parameter, a result, or a field of an event
            REQUIRE(row.size() == 6);
            CHECK(contains(page, "| `" + row[3] + "` |"));
            CHECK(contains(page, "| " + (row[4] == "-" ? "–" : row[4]) + " | " + row[5]));
            if (kind == "parameter") {
                bool found = false;
                for (const auto& parameter : annotated.methods.at(row[2]).parameters)
                    found |= parameter.name == row[3] && contains(parameter.doc, row[5]);
                CHECK(found);
            }
        }
    }
    CHECK(counts["class"] > 20);
    CHECK(counts["property"] > 150);
    CHECK(counts["method"] > 10);
    CHECK(counts["event"] > 8);
    CHECK(counts["function"] > 100);
    CHECK(counts["service"] >= 6);
    CHECK(counts["parameter"] > 10);
    CHECK(counts["enumerator"] > 2);
}

TEST_CASE("the reference of a game describes its classes") {
    const Folder folder;
    fs::create_directories(folder.path / "my game");
    std::ofstream(folder.path / "my game/main.lua")
        << "Ball = class('Ball', Body) { lives = 3, doc = { 'Bounces.', lives = 'Tries left.' } }";
    REQUIRE(fettle(folder, "docs out\\ put 'my game'") == 0);
    const luacats::File file = luacats::read(text_of(folder.path / "out put/fettle.lua"));
    REQUIRE(file.classes.contains("Ball"));
    CHECK(file.classes.at("Ball").base == "Body");
    CHECK(file.classes.at("Ball").fields.at("lives").type == "integer");
    CHECK(row_about(text_of(folder.path / "out put/classes/Ball.md"), "lives").at(6) ==
          "Tries left.");
}

TEST_CASE("a class without a description has no dash in the index") {
    const Folder folder;
    std::ofstream(folder.path / "main.lua") << "class('Bare', Body) {}\n";
    REQUIRE(fettle(folder, "docs out_pages main.lua") == 0);
    const std::string index = text_of(folder.path / "out_pages" / "README.md");
    CHECK(index.find("[Bare](classes/Bare.md)\n") != std::string::npos);
    CHECK(index.find("In a game that plugs in modules there is `modules`") != std::string::npos);
}

TEST_CASE("reference files that cannot be written are reported") {
    const Folder folder;
    std::ofstream(folder.path / "taken") << "a file";
    CHECK(fettle(folder, "docs taken/here") == 3);
    CHECK(text_of(folder.path / "err").find("taken/here") != std::string::npos);
    CHECK(fettle(folder, "docs") == 2);
}

}  // namespace docs_test
