#pragma once
// Writes the outcomes of tests as a report that build servers read (JUnit XML).

#include <filesystem>
#include <vector>

#include <testing/test_run.h>

namespace fettle::program {

/// Throws FileError if the file cannot be written.
void write_junit(const std::filesystem::path& file, const std::vector<TestOutcome>& outcomes);

}  // namespace fettle::program
