// Tests every rule of the architecture on small source trees that break it or keep it.

#include <string>

#include "catch.h"
#include "rules.h"

using namespace fettle::architecture;

namespace {

const std::string property_tree = "framework/include/fettle/property/tree.h";
const std::string physics_world = "physics/include/fettle/physics/world.h";
const std::string script_runtime = "framework/include/fettle/script/runtime.h";

/// The violations of `rule` in a source tree with a few correct headers and the file `path` with
/// `text`.
Violations of(Violations (*rule)(const SourceTree&), const std::string& path,
              const std::string& text) {
    std::map<std::string, std::string> texts = {
        {property_tree, "#pragma once\n"},
        {physics_world, "#pragma once\n"},
        {script_runtime, "#pragma once\n"},
        {"physics/solver/island.h", "#pragma once\n"},
        {"framework/script/objects/instance.h", "#pragma once\n"}};
    texts[path] = text;
    return rule(SourceTree(texts));
}

}  // namespace

TEST_CASE("a forbidden include of a part is reported with file and line") {
    const Violations found = of(forbidden_includes, "physics/world/world.cpp",
                                "#include <vector>\n#include <fettle/property/tree.h>\n");
    REQUIRE(found.size() == 1);
    CHECK(found[0].find("physics/world/world.cpp:2: physics may not include " + property_tree) ==
          0);
}

TEST_CASE("a forbidden include of a room is reported with file and line") {
    const auto verdict = [](const char* path, const char* header) {
        return of(forbidden_rooms, path, "#include <" + std::string(header) + ">\n");
    };
    CHECK(verdict("physics/geometry/hull.cpp", "fettle/physics/world.h").empty());
    const Violations found = verdict("physics/geometry/hull.cpp", "../solver/island.h");
    CHECK(found == Violations{"physics/geometry/hull.cpp:1: geometry may not include "
                              "physics/solver/island.h"});
    CHECK(verdict("physics/attic/hull.cpp", "vector") ==
          Violations{"physics/attic/hull.cpp: lies in no room of physics"});
    CHECK(verdict("framework/script/limits/budget.cpp", "../objects/instance.h") ==
          Violations{"framework/script/limits/budget.cpp:1: limits may not include "
                     "framework/script/objects/instance.h"});
    CHECK(verdict("framework/script/objects/instance.cpp", "../limits/budget.h").empty());
    CHECK(verdict("console/panel.cpp", "vector").empty());
}

TEST_CASE("property and physics may not include each other") {
    CHECK(of(forbidden_includes, "framework/property/tree.cpp", "#include <fettle/physics/world.h>")
              .size() == 1);
    CHECK(of(forbidden_includes, "physics/module/bodies/body_class.cpp",
             "#include <fettle/physics/world.h>\n#include <fettle/property/tree.h>\n")
              .empty());
    CHECK(of(forbidden_includes, "physics/module/bodies/body_class.cpp",
             "#include <fettle/script/runtime.h>")
              .size() == 1);
}

TEST_CASE("only one part includes Lua and one SFML and one ImGui") {
    const auto verdict = [](const char* path, const char* header) {
        return of(forbidden_includes, path, "#include <" + std::string(header) + ">\n").size();
    };
    CHECK(verdict("framework/script/runtime/runtime.cpp", "lua.h") == 0);
    CHECK(verdict("framework/script/runtime/runtime.cpp", "lua5.4/lauxlib.h") == 0);
    CHECK(verdict("framework/app/window.cpp", "lua.h") == 1);
    CHECK(verdict("console/panel.cpp", "lauxlib.h") == 1);
    CHECK(verdict("framework/app/window.cpp", "SFML/Graphics.hpp") == 0);
    CHECK(verdict("console/panel.cpp", "SFML/Graphics.hpp") == 1);
    CHECK(verdict("fettle/commands/run.cpp", "SFML/Window.hpp") == 1);
    CHECK(verdict("console/panel.cpp", "imgui.h") == 0);
    CHECK(verdict("console/panel.cpp", "imgui/imgui_internal.h") == 0);
    CHECK(verdict("framework/app/window.cpp", "imgui.h") == 1);
    CHECK(verdict("fettle/commands/run.cpp", "CLI/CLI.hpp") == 0);
    CHECK(verdict("physics/world/world.cpp", "nlohmann/json.hpp") == 1);
    CHECK(verdict("physics/world/world.cpp", "boost/any.hpp") == 1);
    CHECK(verdict("physics/world/world.cpp", "Eigen/Core") == 0);
}

TEST_CASE("an include of a file that does not exist is an error") {
    CHECK(of(forbidden_includes, "console/panel.cpp", "#include \"panell.h\"\n").size() == 1);
    CHECK(of(forbidden_includes, "console/panel.cpp", "#include <fettle/app/no.h>\n").size() == 1);
}

TEST_CASE("an include in a comment is ignored") {
    CHECK(of(forbidden_includes, "physics/world/world.cpp", "// #include <lua.h>\n").empty());
}

TEST_CASE("a forbidden link of a part is reported") {
    CHECK(of(forbidden_links, "physics/CMakeLists.txt",
             "target_link_libraries(fettle_physics PUBLIC Eigen3::Eigen)")
              .empty());
    CHECK(of(forbidden_links, "physics/CMakeLists.txt",
             "target_link_libraries(fettle_physics PUBLIC Fettle::property)")
              .size() == 1);
    CHECK(of(forbidden_links, "console/CMakeLists.txt",
             "target_link_libraries(fettle_console PRIVATE fettle_imgui fettle_sfml) # fettle_lua")
              .size() == 1);
    CHECK(of(forbidden_links, "framework/script/CMakeLists.txt",
             "  PUBLIC Fettle::property\n  PRIVATE fettle_lua\n  PRIVATE sfml-graphics)")
              .size() == 1);
}

TEST_CASE("a public header that includes a private or foreign one is reported") {
    const char* path = "physics/include/fettle/physics/body.h";
    CHECK(of(public_header_violations, path, "#include <fettle/physics/world.h>\n").empty());
    CHECK(of(public_header_violations, path, "#include <vector>\n#include <span>\n").empty());
    CHECK(of(public_header_violations, path, "#include <Eigen/Core>\n").size() == 1);
    CHECK(of(public_header_violations, path, "#include <lua.h>\n").size() == 1);
    CHECK(of(public_header_violations, path, "#include <SFML/System.hpp>\n").size() == 1);
    CHECK(of(public_header_violations, path, "#include \"solver/island.h\"\n").size() == 1);
    CHECK(of(public_header_violations, "physics/include/body.h", "").size() == 1);
}

TEST_CASE("a declaration in a public header outside of the marks is reported") {
    const auto verdict = [](const std::string& text) {
        return of(unmarked_declarations, property_tree, "#pragma once\n" + text);
    };
    CHECK(verdict("// a tree\n/* of\n   wood */\n#include <vector>\n").empty());
    CHECK(verdict("FETTLE_PROPERTY_BEGIN\nclass Tree;  // grows\nFETTLE_PROPERTY_END\n").empty());
    CHECK(verdict("namespace sf {\nclass Event;\n}  // namespace sf\n").empty());
    CHECK(verdict("FETTLE_PHYSICS_BEGIN\nint grow();\nFETTLE_PHYSICS_END\n").size() == 1);
    const Violations late = verdict("FETTLE_PROPERTY_BEGIN\nFETTLE_PROPERTY_END\nint grow();\n");
    REQUIRE(late.size() == 1);
    CHECK(late[0].find(property_tree + ":4: ") == 0);
}

TEST_CASE("a private header used by another part is reported") {
    CHECK(of(borrowed_private_headers, "physics/solver/solve.cpp", "#include \"island.h\"\n")
              .empty());
    CHECK(of(borrowed_private_headers, "physics/world/step_order.cpp",
             "#include \"solver/island.h\"\n")
              .empty());
    CHECK(of(borrowed_private_headers, "console/panel.cpp",
             "#include \"../physics/solver/island.h\"\n")
              .size() == 1);
    CHECK(of(borrowed_private_headers, "examples/pong/main.cpp",
             "#include \"../../physics/solver/island.h\"\n")
              .size() == 1);
}

TEST_CASE("a vague file name is reported") {
    CHECK(of(vague_names, "physics/solver/contact_graph.h", "").empty());
    CHECK(of(vague_names, "console/string_utils.h", "").size() == 1);
    CHECK(of(vague_names, "framework/helpers/text.h", "").size() == 1);
    CHECK(of(vague_names, "framework/app/window_manager.cpp", "").size() == 1);
    CHECK(of(vague_names, "framework/app/WindowTitle.cpp", "").size() == 1);
    CHECK(of(vague_names, "framework/app/commonwealth.cpp", "").empty());
}

TEST_CASE("a file of 501 lines is too long") {
    std::string text;
    for (int i = 0; i < 500; ++i) text += "int a;\n";
    CHECK(of(overlong_files, "physics/world/world.cpp", text).empty());
    CHECK(of(overlong_files, "physics/world/world.cpp", text + "int b;\n").size() == 1);
}

TEST_CASE("a function that some standard libraries lack is reported in physics and nowhere else") {
    const char* text = "auto x = std::ranges::find(a, 1);  \n// std::bit_cast is not there\n";
    CHECK(of(unportable_names, "physics/world/world.cpp", text).size() == 1);
    CHECK(of(unportable_names, "bindings/c/body.cpp", text).size() == 1);
    CHECK(of(unportable_names, "physics/module/drawing/forms.cpp", text).empty());
}

TEST_CASE("a header that only Linux has is reported") {
    CHECK(of(headers_of_linux, "framework/module/plugin.cpp", "#include <sys/prctl.h>\n").size() ==
          1);
    CHECK(of(headers_of_linux, "framework/module/plugin.cpp", "#include <sys/wait.h>\n").empty());
}

TEST_CASE("a word of one compiler in a public header is reported unless the header asks for it") {
    const char* path = "physics/include/fettle/physics/export.h";
    const std::string word = "#define HIDDEN __attribute__((visibility(\"hidden\")))\n";
    CHECK(of(words_of_one_compiler, path, word).size() == 1);
    CHECK(of(words_of_one_compiler, path, "[[gnu::cold]] void f();\n").size() == 1);
    const std::string guarded = "#if defined(X) || defined(__GNUC__)\n" + word + "#endif\n";
    CHECK(of(words_of_one_compiler, path, guarded).empty());
    CHECK(of(words_of_one_compiler, "physics/state/records.h", word).empty());
}

TEST_CASE("a cosine of the system in physics is reported") {
    const std::string line = "const float x = std::cos(angle);\n";
    CHECK(of(trigonometry_of_the_system, "physics/step/finish.cpp", line).size() == 1);
    CHECK(of(trigonometry_of_the_system, "physics/module/plugin/plugin.cpp", line).empty());
    CHECK(of(trigonometry_of_the_system, "physics/step/finish.cpp", "sqrt(x)\n").empty());
}

TEST_CASE("a test with a name that only one release of Catch2 has is reported") {
    const std::string name = "Catch::" + std::string("Detail::Approx");
    CHECK(of(names_of_one_catch, "tests/physics/form_test.cpp", name + "(1)\n").size() == 1);
    CHECK(of(names_of_one_catch, "tests/include/catch.h", name + "(1)\n").empty());
    CHECK(of(names_of_one_catch, "tests/physics/form_test.cpp", "Approx(1)\n").empty());
}

TEST_CASE("a public header of physics that includes what compiles slowly is reported") {
    const char* path = "physics/include/fettle/physics/world.h";
    CHECK(of(heavy_headers, path, "#include <functional>\n#include <vector>\n").size() == 1);
    CHECK(of(heavy_headers, path, "#include <memory>  // for one pointer\n").size() == 1);
    CHECK(of(heavy_headers, "physics/world/world_data.h", "#include <memory>\n").empty());
}

TEST_CASE("a header without pragma once or with using namespace is reported") {
    const char* path = "console/panel.h";
    CHECK(of(careless_headers, path, "#pragma once\n    using namespace std;\n").empty());
    CHECK(of(careless_headers, path, "int a;\n").size() == 1);
    CHECK(of(careless_headers, path, "#pragma once\nusing namespace std;\n").size() == 1);
}

TEST_CASE("a second file that tests the version of a library is reported") {
    const std::string check = "#if SFML_VERSION_MAJOR >= 3\n";
    SourceTree once({{"framework/app/window.cpp", check}});
    SourceTree twice({{"framework/app/window.cpp", check}, {"framework/app/sound.cpp", check}});
    CHECK(scattered_version_checks(once).empty());
    CHECK(scattered_version_checks(twice).size() == 1);
}

TEST_CASE("a mark of unfinished work is reported with file and line") {
    const std::string mark = std::string("TO") + "DO";
    CHECK(of(unfinished_marks, "physics/world/world.cpp", "int a;  // " + mark + ": b\n") ==
          Violations{"physics/world/world.cpp:1: unfinished: int a;  // " + mark + ": b"});
    CHECK(of(unfinished_marks, "physics/world/world.cpp", "int " + mark + "s;\n").empty());
}

TEST_CASE("a path in a document that does not exist is reported") {
    const SourceTree tree(std::map<std::string, std::string>{{"physics/world/step_order.cpp", ""}});
    CHECK(lost_paths(tree, "`physics/world/step_order.cpp`, `physics/world`, `std::sort`").empty());
    CHECK(lost_paths(tree, "`physics/world/stop.cpp` and `physics/word`").size() == 2);
    CHECK(rooms_without_line("").size() == folders_of_rooms().size());
}

TEST_CASE("a function in a document that is not in the file named behind it is reported") {
    const SourceTree tree(
        std::map<std::string, std::string>{{"physics/a.cpp", "void World::step();\nint steps;"}});
    CHECK(lost_functions(tree, "`World::step` and `steps` (`physics/a.cpp`)").empty());
    CHECK(lost_functions(tree, "`World::stop` or `step`\n  (`physics/a.cpp`)") ==
          Violations{"physics/a.cpp: stop is not in it"});
    CHECK(lost_functions(tree, "`ste` (`physics/a.cpp`)").size() == 1);
}

TEST_CASE("a member in a document that no file has is reported") {
    const SourceTree tree(std::map<std::string, std::string>{
        {"physics/a.h", "class World {\n    void step();\n};"}, {"physics/b.h", "void stop();"}});
    CHECK(lost_members(tree, "`World::step`, `std::vector` and `Fettle::physics`").empty());
    CHECK(lost_members(tree, "`World::stop`") == Violations{"World::stop: no file has it"});
    CHECK(lost_members(tree, "`Worlds::step`").size() == 1);
}

TEST_CASE("a file outside every part is reported") {
    CHECK(of(unknown_places, "framework/drawing/pen.cpp", "").size() == 1);
    CHECK(of(unknown_places, "tests/physics/friction.cpp", "").empty());
}
