#include <terminal/terminal.h>

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include <fettle/property/utf8.h>

#ifdef FETTLE_WITH_CONSOLE
#include <fettle/console/terminal_colors.h>
#endif

namespace fettle::program {

namespace {

std::string escaped(std::string_view text, bool lines) {
    std::string out;
    out.reserve(text.size());
    while (!text.empty()) {
        const auto first = static_cast<unsigned char>(text[0]);
        std::size_t length = property::valid_code_point_size(text);
        // Control characters: 0 to 31, 127, and U+0080 to U+009F, which have two bytes.
        const bool control =
            first < 0x20 || first == 0x7F ||
            (length == 2 && first == 0xC2 && static_cast<unsigned char>(text[1]) < 0xA0);
        const bool wanted = first == '\t' || (lines && first == '\n');
        if (wanted || (length > 0 && !control)) {
            out += text.substr(0, length);
        } else {
            if (length == 0) length = 1;
            for (std::size_t i = 0; i < length; ++i) {
                char escape[5];
                std::snprintf(escape, sizeof escape, "\\x%02x",
                              static_cast<unsigned char>(text[i]));
                out += first == '\n' ? "\\n" : escape;
            }
        }
        text.remove_prefix(length);
    }
    return out;
}

bool is_terminal(std::FILE* file) {
    return ::isatty(::fileno(file)) == 1;
}

}  // namespace

std::string without_controls(std::string_view text) {
    return escaped(text, true);
}

std::string on_one_line(std::string_view text) {
    return escaped(text, false);
}

void print_error(std::string_view message) {
    std::fflush(stdout);
    std::fprintf(stderr, "fettle: %s\n", on_one_line(message).c_str());
}

void print_error_lines(std::string_view text) {
    std::fflush(stdout);
    std::fputs(without_controls(text).c_str(), stderr);
}

void print_line(std::string_view text) {
    static const bool terminal = is_terminal(stdout);
    const std::string shown = terminal ? without_controls(text) : std::string();
    if (terminal) text = shown;
    std::fwrite(text.data(), 1, text.size(), stdout);
    std::fputc('\n', stdout);
}

#ifdef FETTLE_WITH_CONSOLE
namespace {

bool shows_colors() {
    const char* const no_color = std::getenv("NO_COLOR");
    const char* const kind = std::getenv("TERM");
    return is_terminal(stdout) && (no_color == nullptr || *no_color == '\0') && kind != nullptr &&
           std::string_view(kind) != "dumb";
}

}  // namespace
#endif

namespace {

void print_line_of_answer(std::string_view text, bool of_error) {
#ifdef FETTLE_WITH_CONSOLE
    static const bool colors = shows_colors();
    if (colors) {
        const std::string shown = on_one_line(text);
        const std::string colored =
            of_error ? console::colored_error(shown) : console::colored_output(shown);
        std::fwrite(colored.data(), 1, colored.size(), stdout);
        std::fputc('\n', stdout);
        return;
    }
#endif
    (void)of_error;
    print_line(text);
}

bool is_error(std::string_view line_of_answer) {
    return line_of_answer.starts_with("✗");
}

}  // namespace

void print_answer(const std::vector<std::string>& lines) {
    bool of_error = false;
    for (const std::string& line : lines) {
        of_error = of_error || is_error(line);
        print_line_of_answer(line, of_error);
    }
}

std::string line_after_answer(std::string line) {
    if (!is_error(line)) line.insert(0, "  ");
    return line;
}

bool all_printed() {
    const int problem = std::fflush(stdout) != 0 ? errno : 0;
    if (problem == 0 && std::ferror(stdout) == 0) return true;
    print_error("not all of what was printed could be written" +
                (problem != 0 ? std::string(": ") + std::strerror(problem) : std::string()));
    return false;
}

}  // namespace fettle::program
