#pragma once
// Checks that the program supports the version of the module interface that a module uses.

#include <cstdint>
#include <filesystem>

namespace fettle::module {

/// Throws LoadError if the version has another major number than that of this program, or a larger
/// minor number. `abi` is 0 if the module did not set it; the caller checks that.
void require_supported_abi(const std::filesystem::path& file, std::uint32_t abi);

}  // namespace fettle::module
