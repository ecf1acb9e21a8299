// Tests every rule of the architecture on the sources of the project.

#include <fstream>
#include <sstream>
#include <string>

#include "catch.h"
#include "rules.h"

using namespace fettle::architecture;

namespace {

const SourceTree& project() {
    static const SourceTree tree = SourceTree::read(FETTLE_SOURCE_DIR);
    return tree;
}

std::string listed(const Violations& violations) {
    std::string text;
    for (const std::string& violation : violations) text += violation + "\n";
    return text;
}

std::string text_of(const std::string& path) {
    std::ifstream file(std::string(FETTLE_SOURCE_DIR) + "/" + path);
    REQUIRE(file);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

}  // namespace

TEST_CASE("the rules read the sources of the project") {
    CHECK(project().contains("framework/include/fettle/property/tree.h"));
    CHECK(project().contains("physics/include/fettle/physics/world.h"));
    CHECK(project().contains("tests/architecture/rules_on_the_project.cpp"));
    const SourceFile& own = project().files().at("tests/architecture/rules_on_the_project.cpp");
    REQUIRE(own.includes().size() == 5);
    CHECK(project().resolve(own, own.includes().back()) == "tests/architecture/rules.h");
}

TEST_CASE("every file is in a part of the project") {
    CHECK(listed(unknown_places(project())) == "");
}

TEST_CASE("a part includes only the parts and libraries that it may include") {
    CHECK(listed(forbidden_includes(project())) == "");
}

TEST_CASE("a room of a part includes only the rooms that it may include") {
    CHECK(listed(forbidden_rooms(project())) == "");
}

TEST_CASE("the map of the project names every room and only existing paths and functions") {
    const std::string map = text_of("docs/design/architecture.md");
    CHECK(listed(lost_paths(project(), map)) == "");
    CHECK(listed(lost_functions(project(), map)) == "");
    CHECK(listed(rooms_without_line(map)) == "");
    for (const char* page :
         {"app", "architecture", "console", "glossary", "hosting-physics", "interface", "maps",
          "modules", "physics", "property-tree", "scenes", "scripting", "solvers", "sound",
          "storage", "testing", "time", "visuals"}) {
        const std::string text = text_of("docs/design/" + std::string(page) + ".md");
        INFO(page);
        CHECK(listed(lost_paths(project(), text)) == "");
        CHECK(listed(lost_functions(project(), text)) == "");
        CHECK(listed(lost_members(project(), text)) == "");
    }
}

TEST_CASE("a part links only the parts and libraries that it may link") {
    CHECK(listed(forbidden_links(project())) == "");
}

TEST_CASE("public headers need no header of SFML or ImGui or Lua") {
    CHECK(listed(public_header_violations(project())) == "");
}

TEST_CASE("public headers mark what a shared library exports") {
    CHECK(listed(unmarked_declarations(project())) == "");
}

TEST_CASE("private headers stay in their part") {
    CHECK(listed(borrowed_private_headers(project())) == "");
}

TEST_CASE("files are named after their contents") {
    CHECK(listed(vague_names(project())) == "");
}

TEST_CASE("no file is longer than the limit") {
    CHECK(listed(overlong_files(project())) == "");
}

TEST_CASE("physics uses only what every standard library has") {
    CHECK(listed(unportable_names(project())) == "");
}

TEST_CASE("no part needs a header of Linux") {
    CHECK(listed(headers_of_linux(project())) == "");
    CHECK(listed(words_of_one_compiler(project())) == "");
}

TEST_CASE("physics does not compute with the trigonometry of the system") {
    CHECK(listed(trigonometry_of_the_system(project())) == "");
}

TEST_CASE("tests compile with each release of Catch2") {
    CHECK(listed(names_of_one_catch(project())) == "");
}

TEST_CASE("public headers of physics include only what compiles fast") {
    CHECK(listed(heavy_headers(project())) == "");
}

TEST_CASE("headers have pragma once and contain no using namespace") {
    CHECK(listed(careless_headers(project())) == "");
}

TEST_CASE("for each library only one file tests its version") {
    CHECK(listed(scattered_version_checks(project())) == "");
}

TEST_CASE("the sources contain no marks of unfinished work") {
    CHECK(listed(unfinished_marks(project())) == "");
}
