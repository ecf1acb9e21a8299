#include <commands/run_arguments.h>

#include <CLI/CLI.hpp>

#include <command_line/arguments.h>
#include <terminal/terminal.h>

namespace fettle::program {

std::pair<std::uint64_t, std::string> parse_at(const char* option, const std::string& text) {
    const std::size_t colon = text.find(':');
    if (colon == std::string::npos || colon + 1 == text.size())
        throw CLI::ValidationError(
            option, "expected a step and a command, as in 60:print(time.now), got \"" +
                        on_one_line(text.substr(0, 60)) + "\"");
    return {whole_number(option, text.substr(0, colon), 1, max_steps), text.substr(colon + 1)};
}

std::filesystem::path parse_picture(const std::string& text) {
    std::filesystem::path file = checked_text("--screenshot", text, "a file");
    for (const char* const known : {".png", ".jpg", ".jpeg", ".bmp", ".tga"})
        if (file.extension() == known) return file;
    throw CLI::ValidationError("--screenshot",
                               "expected a file that ends in .png, .jpg, .bmp or "
                               ".tga, got \"" +
                                   on_one_line(text.substr(0, 60)) + "\"");
}

}  // namespace fettle::program
