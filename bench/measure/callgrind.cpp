#include "measure/callgrind.h"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>

namespace fettle::bench {
namespace {

std::string quoted(const std::string& text) {
    std::string out = "'";
    for (const char c : text) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return out + "'";
}

/// The output of a command on both streams, also if the command fails; empty if no shell starts.
std::string output_of(const std::string& command) {
    struct Close {
        void operator()(std::FILE* pipe) const { pclose(pipe); }
    };
    const std::unique_ptr<std::FILE, Close> pipe(popen((command + " 2>&1").c_str(), "r"));
    std::string text;
    if (!pipe) return text;
    std::array<char, 4096> buffer{};
    while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), pipe.get()))
        text.append(buffer.data(), count);
    return text;
}

}  // namespace

bool callgrind_available() {
    return output_of("valgrind --version").rfind("valgrind-", 0) == 0;
}

std::optional<std::uint64_t> count_instructions(const std::vector<std::string>& arguments) {
    const auto program = std::filesystem::read_symlink("/proc/self/exe");
    std::string command =
        "valgrind --tool=callgrind --callgrind-out-file=/dev/null "
        "--toggle-collect='*measured_steps*' " +
        quoted(program.string());
    for (const std::string& argument : arguments) command += " " + quoted(argument);
    const std::string output = output_of(command);
    // "==4711== Collected : 123456789"
    const std::string label = "Collected : ";
    const std::size_t at = output.find(label);
    if (at == std::string::npos) return std::nullopt;
    const std::uint64_t count = std::strtoull(output.c_str() + at + label.size(), nullptr, 10);
    return count > 0 ? std::optional(count) : std::nullopt;
}

}  // namespace fettle::bench
