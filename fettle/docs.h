#pragma once
// `fettle docs`: writes the reference and the annotations for editors.

#include <filesystem>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace fettle::program {

struct DocsOptions {
    std::filesystem::path folder{};
    std::filesystem::path game{};        // its classes are described too; empty: Fettle's own only
    std::vector<std::string> modules{};  // to be plugged in: files, or names of installed ones
};

/// Adds the subcommand; when it is given, it runs and leaves its exit status in `status`.
void add_docs(CLI::App& app, int& status);

/// Throws FileError for what cannot be written.
int docs(const DocsOptions& options);

}  // namespace fettle::program
