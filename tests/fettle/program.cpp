#include "program.h"

#include <catch.h>
#include <sys/wait.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>

#include <unistd.h>

namespace program_test {

namespace fs = std::filesystem;

Folder::Folder() {
    setenv("XDG_DATA_HOME", (*this / "user data").c_str(), 1);
}

std::string Folder::write(const std::string& name, const std::string& text) const {
    fs::create_directories((*this / name).parent_path());
    std::ofstream(*this / name) << text;
    return (*this / name).string();
}

std::string Folder::text(const std::string& name) const {
    std::ifstream in(*this / name);
    return {std::istreambuf_iterator<char>(in), {}};
}

std::string quoted(const std::string& text) {
    std::string out = "'";
    for (const char c : text) c == '\'' ? out += "'\\''" : out += c;
    return out + "'";
}

Outcome fettle(const Folder& folder, const std::vector<std::string>& arguments,
               const std::string& before, const std::string& input) {
    std::string command =
        before + "env -u DISPLAY -u WAYLAND_DISPLAY timeout 1800 " + quoted(FETTLE_PROGRAM);
    for (const std::string& argument : arguments) command += " " + quoted(argument);
    command += " >" + quoted((folder / "out").string()) + " 2>" +
               quoted((folder / "err").string()) + " <" + quoted(input);
    const int result = std::system(command.c_str());
    Outcome outcome;
    outcome.status = WIFEXITED(result) ? WEXITSTATUS(result) : -1;
    outcome.out = folder.text("out");
    outcome.err = folder.text("err");
    INFO(command << "\n" << outcome.out << outcome.err);
    return outcome;
}

Outcome run_script(const Folder& folder, const std::string& script, int steps,
                   const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {"run", folder.write("main.lua", script), "--headless",
                                          "--steps", std::to_string(steps)};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return fettle(folder, arguments);
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

std::string without_notes(const std::string& err) {
    std::string rest;
    std::istringstream lines(err);
    for (std::string line; std::getline(lines, line);)
        if (!line.starts_with("fettle: note: ")) rest += line + "\n";
    return rest;
}

}  // namespace program_test
