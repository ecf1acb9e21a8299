#include <command_line/repl_lines.h>

#include <utility>

#ifdef FETTLE_WITH_CONSOLE
#include <fettle/console/console.h>
#endif

namespace fettle::program {

std::filesystem::path repl_history() {
#ifdef FETTLE_WITH_CONSOLE
    const std::filesystem::path console = console::default_history_file();
    if (!console.empty()) return console.parent_path() / "repl_history";
#endif
    return {};
}

std::vector<LineEditor::Candidate> candidates_of(
    const std::string& before, std::string_view line, std::size_t cursor,
    const std::function<std::vector<script::Completion>(const std::string& all,
                                                        std::size_t cursor)>& complete) {
    const std::size_t earlier = before.empty() ? 0 : before.size() + 1;
    const std::string all = before.empty() ? std::string(line) : before + "\n" + std::string(line);
    std::vector<LineEditor::Candidate> found;
    for (script::Completion& c : complete(all, earlier + cursor))
        if (c.replace_from >= earlier)
            found.push_back({std::move(c.text), std::move(c.label), std::move(c.detail),
                             c.replace_from - earlier});
    return found;
}

}  // namespace fettle::program
