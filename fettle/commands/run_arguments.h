#pragma once
// Arguments of `fettle run` that have a form of their own. The functions throw
// CLI::ValidationError.

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>

namespace fettle::program {

constexpr std::uint64_t max_steps = 1'000'000'000'000'000;

/// Parses "N:LUA": a step and a chunk of Lua.
std::pair<std::uint64_t, std::string> parse_at(const char* option, const std::string& text);

/// Parses the name of a picture file; its format must be one that can be written.
std::filesystem::path parse_picture(const std::string& text);

}  // namespace fettle::program
