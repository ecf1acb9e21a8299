#include "costs/love.h"

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <stdexcept>

#include <sys/wait.h>
#include <unistd.h>

namespace fettle::bench {
namespace {

// Physics and the clock only; no display is necessary.
constexpr const char* configuration = R"(
function love.conf(t)
  t.window = nil
  t.console = false
  for name in pairs(t.modules) do t.modules[name] = false end
  t.modules.event, t.modules.physics, t.modules.timer = true, true, true
end
)";

// Processor time, as in our own measurements.
constexpr const char* game = R"(
world = love.physics.newWorld(0, 0, true)
ball = love.physics.newBody(world, 0, 8, "dynamic")
love.physics.newFixture(ball, love.physics.newCircleShape(0.5))
for i = 1, 10 do world:update(1 / 60) end
require("functions")
print("ready") io.stdout:flush()
for line in io.lines() do
  local name, rounds = line:match("^(%S+) (%d+)$")
  local run, n = _G[name], tonumber(rounds)
  local start = os.clock()
  run(n)
  print(string.format("%.9f", os.clock() - start)) io.stdout:flush()
end
love.event.quit()
function love.run() return function() return 0 end end
)";

void write(const std::filesystem::path& file, const std::string& text) {
    std::ofstream(file) << text;
}

std::string line_from(std::FILE* stream) {
    char line[256];
    return std::fgets(line, sizeof line, stream) ? line : "";
}

}  // namespace

Love::Love(const std::string& functions)
    : folder_(std::filesystem::temp_directory_path() /
              ("fettle-bench-love-" + std::to_string(getpid()))) {
    write_game(functions);
    start();
    if (line_from(answers_) != "ready\n") stop();
}

Love::~Love() {
    stop();
}

void Love::write_game(const std::string& functions) const {
    std::filesystem::create_directories(folder_);
    write(folder_ / "conf.lua", configuration);
    write(folder_ / "main.lua", game);
    write(folder_ / "functions.lua", functions);
}

void Love::start() {
    int in[2], out[2];
    if (pipe(in) != 0 || pipe(out) != 0) throw std::runtime_error("no pipe for LÖVE");
    process_ = fork();
    if (process_ < 0) throw std::runtime_error("no process for LÖVE");
    if (process_ == 0) {
        dup2(in[0], STDIN_FILENO);
        dup2(out[1], STDOUT_FILENO);
        for (const int end : {in[0], in[1], out[0], out[1]}) close(end);
        setenv("SDL_VIDEODRIVER", "dummy", 1);
        execlp("love", "love", folder_.c_str(), static_cast<char*>(nullptr));
        _exit(127);
    }
    close(in[0]);
    close(out[1]);
    requests_ = fdopen(in[1], "w");
    answers_ = fdopen(out[0], "r");
    std::signal(SIGPIPE, SIG_IGN);  // if LÖVE ends, the error shows in its missing answer
}

void Love::stop() {
    if (requests_) std::fclose(requests_);
    if (answers_) std::fclose(answers_);
    requests_ = answers_ = nullptr;
    if (process_ > 0) waitpid(process_, nullptr, 0);
    process_ = -1;
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
}

double Love::seconds(const std::string& function, long long rounds) {
    if (!running()) throw std::runtime_error("LÖVE is not running");
    std::fprintf(requests_, "%s %lld\n", function.c_str(), rounds);
    std::fflush(requests_);
    const std::string answer = line_from(answers_);
    if (answer.empty()) throw std::runtime_error("LÖVE did not answer to " + function);
    return std::strtod(answer.c_str(), nullptr);
}

}  // namespace fettle::bench
