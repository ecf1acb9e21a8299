#include <command_line/answer.h>

#include <utility>

namespace fettle::program {

std::vector<std::string> lines_of(const script::Evaluation& answer) {
    std::vector<std::string> lines;
    if (answer.incomplete) lines.emplace_back("✗ the command ends too early");
    for (const std::string& line : answer.lines) lines.push_back("  " + line);
    if (!answer.error) return lines;
    std::string mark = "✗ ";
    for (const std::string& line : script::error_lines(*answer.error))
        lines.push_back(std::exchange(mark, "  ") + line);
    return lines;
}

}  // namespace fettle::program
