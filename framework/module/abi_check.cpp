#include "abi_check.h"

#include <string>

#include <fettle/module/abi.h>
#include <fettle/module/plugin.h>

namespace fettle::module {
namespace {

std::string version_text(std::uint32_t abi) {
    return std::to_string(abi >> 16) + "." + std::to_string(abi & 0xffff);
}

bool is_supported(std::uint32_t abi) {
    return abi >> 16 == FETTLE_ABI_MAJOR && (abi & 0xffff) <= FETTLE_ABI_MINOR;
}

}  // namespace

void require_supported_abi(const std::filesystem::path& file, std::uint32_t abi) {
    if (abi == 0 || is_supported(abi)) return;
    throw LoadError(file, "expected a module for version " + version_text(FETTLE_ABI) +
                              " of the module interface or an older " +
                              std::to_string(FETTLE_ABI_MAJOR) + ".x, found one for " +
                              version_text(abi));
}

}  // namespace fettle::module
