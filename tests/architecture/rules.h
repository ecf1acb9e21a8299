#pragma once
// The rules of the architecture that a compiler cannot enforce. Each returns its violations as
// "path:line: what is wrong and what the rule says"; none means that the rule holds.

#include <string>
#include <vector>

#include "source_tree.h"

namespace fettle::architecture {

using Violations = std::vector<std::string>;

/// Every C++ file lies in a folder that the architecture names.
Violations unknown_places(const SourceTree& tree);

/// A part includes only the parts and the outside libraries that it may know: this makes
/// framework/script the only place with Lua, framework/app with SFML, console with ImGui.
Violations forbidden_includes(const SourceTree& tree);

/// Within a part that is divided into rooms, a room includes only the rooms that it may know, none
/// of which knows it.
Violations forbidden_rooms(const SourceTree& tree);

/// Of all parts that are divided: "physics/geometry".
std::vector<std::string> folders_of_rooms();

/// Every path between backticks in a text exists, as a file or as a folder of files.
Violations lost_paths(const SourceTree& tree, const std::string& text);

/// Every room has a line in the text.
Violations rooms_without_line(const std::string& text);

/// A part links only the targets of parts and libraries that it may know.
Violations forbidden_links(const SourceTree& tree);

/// A public header includes public headers, the standard library and Eigen, nothing else, so that
/// its user needs no SFML, ImGui or Lua; and it lies in include/fettle/<library>/.
Violations public_header_violations(const SourceTree& tree);

/// What a public header declares stands between the marks FETTLE_<PART>_BEGIN and _END: a shared
/// library shows nothing else.
Violations unmarked_declarations(const SourceTree& tree);

/// A private header is included only by its own part and by tests and benchmarks.
Violations borrowed_private_headers(const SourceTree& tree);

/// File names are snake_case and name an idea: no utils, helpers, common, misc, manager.
Violations vague_names(const SourceTree& tree);

/// A file is one idea: at most 500 lines.
Violations overlong_files(const SourceTree& tree);

/// Headers guard themselves with `#pragma once`; those of a part open no namespace for whoever
/// includes them.
Violations careless_headers(const SourceTree& tree);

/// One file a library knows that there are several versions of it.
Violations scattered_version_checks(const SourceTree& tree);

/// Work that its author marked as unfinished.
Violations unfinished_marks(const SourceTree& tree);

}  // namespace fettle::architecture
