#pragma once
// The rules of the architecture that a compiler cannot enforce. Each function returns the
// violations as "path:line: what is wrong and what the rule says"; an empty list means that the
// rule holds.

#include <string>
#include <vector>

#include "source_tree.h"

namespace fettle::architecture {

using Violations = std::vector<std::string>;

/// Every C++ file is in a folder that the architecture page names.
Violations unknown_places(const SourceTree& tree);

/// A part includes only the parts and the external libraries that the table allows. So only
/// framework/script includes Lua, only framework/app SFML, and only console ImGui.
Violations forbidden_includes(const SourceTree& tree);

/// In a part that is divided into rooms, a room includes only the rooms that its table allows; no
/// two rooms include each other.
Violations forbidden_rooms(const SourceTree& tree);

/// The folders of the rooms of all divided parts, as "physics/geometry".
std::vector<std::string> folders_of_rooms();

/// Every path between backticks in a text exists, as a file or as a folder of files.
Violations lost_paths(const SourceTree& tree, const std::string& text);

/// A function whose file follows in brackets, "`collide` (`physics/collision/collide.cpp`)", is in
/// that file.
Violations lost_functions(const SourceTree& tree, const std::string& text);
/// Names of the form `Type::member` in a document that no file defines.
Violations lost_members(const SourceTree& tree, const std::string& text);

/// Every room has a line in the text.
Violations rooms_without_line(const std::string& text);

/// A part links only the targets of parts and libraries that the table allows.
Violations forbidden_links(const SourceTree& tree);

/// A public header includes only public headers, and the standard library, so that its user needs
/// no SFML, ImGui or Lua. It is in include/fettle/<library>/.
Violations public_header_violations(const SourceTree& tree);

/// The declarations of a public header are between the marks FETTLE_<PART>_BEGIN and _END: a shared
/// library exports nothing else.
Violations unmarked_declarations(const SourceTree& tree);

/// A public header marks a class that it only declares and other code of the library defines as
/// FETTLE_<PART>_PRIVATE: a shared library would export it. A lambda is no value of a member.
Violations exported_by_accident(const SourceTree& tree);

/// A private header is included only by its own part, by tests and by benchmarks.
Violations borrowed_private_headers(const SourceTree& tree);

/// File names are snake_case and name an idea: not utils, helpers, common, misc, manager.
Violations vague_names(const SourceTree& tree);

/// A file contains one idea: at most 500 lines.
Violations overlong_files(const SourceTree& tree);

/// The physics library and its interface in C use nothing that the standard libraries of other
/// systems lack (docs/design/testing.md).
Violations unportable_names(const SourceTree& tree);

/// No part includes a header that only Linux has.
Violations headers_of_linux(const SourceTree& tree);

/// A public header uses words of GCC and clang only if it asks for the compiler.
Violations words_of_one_compiler(const SourceTree& tree);

/// Physics computes with no function of the C library whose results differ between systems.
Violations trigonometry_of_the_system(const SourceTree& tree);

/// Tests use names that Catch2 2 and 3 have, and those that catch.h gives to both.
Violations names_of_one_catch(const SourceTree& tree);

/// The public headers of physics include only those of the standard library that compile fast. So a
/// program that includes <fettle/physics/physics.h> compiles in less than half of the time that
/// <functional>, <memory> and <cmath> would take as well.
Violations heavy_headers(const SourceTree& tree);

/// Headers have `#pragma once`. Headers of a part contain no `using namespace`, which would affect
/// every file that includes them.
Violations careless_headers(const SourceTree& tree);

/// For each library, only one file tests its version.
Violations scattered_version_checks(const SourceTree& tree);

/// No source contains a mark of unfinished work.
Violations unfinished_marks(const SourceTree& tree);

}  // namespace fettle::architecture
