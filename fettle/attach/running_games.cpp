#include <attach/running_games.h>

#include <fcntl.h>
#include <sys/random.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>

#include <attach/socket_address.h>
#include <command_line/joined.h>
#include <files/game_path.h>

namespace fettle::program {

namespace fs = std::filesystem;

namespace {

std::string random_digits(std::size_t bytes) {
    std::array<unsigned char, 32> random{};
    std::size_t have = 0;
    while (have < bytes) {
        const ssize_t count = ::getrandom(random.data() + have, bytes - have, 0);
        if (count < 0 && errno != EINTR)
            throw FileError(std::string("random numbers: ") + std::strerror(errno));
        if (count > 0) have += static_cast<std::size_t>(count);
    }
    constexpr char digits[] = "0123456789abcdef";
    std::string text;
    for (std::size_t i = 0; i < bytes; ++i) {
        text += digits[random[i] >> 4];
        text += digits[random[i] & 15];
    }
    return text;
}

std::string name_of(const fs::path& game) {
    return game.extension() == ".lua" ? game.stem().string() : game.filename().string();
}

/// Absolute and without links, so that two paths of one game are equal.
fs::path real_path(const fs::path& path) {
    std::error_code error;
    const fs::path real = fs::canonical(path, error);
    return error ? fs::path() : real;
}

/// The name of a game's folder or file stands for the game.
bool is_meant(const RunningGame& running, const std::string& wanted) {
    if (wanted.empty() || wanted == std::to_string(running.process)) return true;
    if (wanted == name_of(running.game)) return true;
    const fs::path path = real_path(wanted);
    return !path.empty() && (path == running.game || path / "main.lua" == running.game);
}

/// Reads the file of a game; its token is "" if the file is not complete.
RunningGame read(const fs::path& file) {
    RunningGame running{.file = file, .socket = fs::path(file).replace_extension(".socket")};
    std::ifstream in(file);
    std::string game, process;
    if (!std::getline(in, running.token) || !std::getline(in, process) || !std::getline(in, game))
        running.token.clear();
    running.game = game;
    running.process = static_cast<pid_t>(std::strtol(process.c_str(), nullptr, 10));
    return running;
}

std::string list_of(const std::vector<RunningGame>& all) {
    std::vector<std::string> names;
    names.reserve(all.size());
    for (const RunningGame& each : all)
        names.push_back(name_of(each.game) + " (" + std::to_string(each.process) + ")");
    return joined(names);
}

}  // namespace

fs::path runtime_folder() {
    const char* const given = std::getenv("XDG_RUNTIME_DIR");
    const bool usable = given != nullptr && given[0] == '/';
    fs::path folder = usable
                          ? fs::path(given) / "fettle"
                          : fs::temp_directory_path() / ("fettle-" + std::to_string(::geteuid()));
    if (::mkdir(folder.c_str(), 0700) != 0 && errno != EEXIST)
        throw FileError(folder.string() + ": " + std::strerror(errno));
    struct stat info {};
    if (::lstat(folder.c_str(), &info) != 0 || !S_ISDIR(info.st_mode) ||
        info.st_uid != ::geteuid() || (info.st_mode & 077) != 0)
        throw FileError(folder.string() +
                        ": expected a folder that only you can enter (mode 0700)");
    return folder;
}

RunningGame named_for(const fs::path& game) {
    const std::string name = std::to_string(::getpid()) + "-" + random_digits(4);
    const fs::path folder = runtime_folder();
    fs::path real = real_path(game);
    if (real.empty()) real = fs::absolute(game);
    return {.file = folder / (name + ".game"),
            .socket = folder / (name + ".socket"),
            .token = random_digits(32),
            .game = real,
            .process = ::getpid()};
}

void announce(const RunningGame& running) {
    const int file =
        ::open(running.file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0600);
    if (file < 0) throw FileError(running.file.string() + ": " + std::strerror(errno));
    const std::string text = running.token + "\n" + std::to_string(running.process) + "\n" +
                             running.game.string() + "\n";
    const bool written = ::write(file, text.data(), text.size()) == ssize_t(text.size());
    const bool closed = ::close(file) == 0;
    if (!written || !closed) throw FileError(running.file.string() + ": it cannot be written");
}

void withdraw(const RunningGame& running) {
    ::unlink(running.file.c_str());
    ::unlink(running.socket.c_str());
}

std::vector<RunningGame> running_games() {
    std::vector<RunningGame> all;
    for (const fs::directory_entry& entry : fs::directory_iterator(runtime_folder())) {
        if (entry.path().extension() != ".game") continue;
        const RunningGame running = read(entry.path());
        const int socket = connected_to(running.socket);
        const bool gone = socket < 0 && (errno == ECONNREFUSED || errno == ENOENT);
        if (socket >= 0) ::close(socket);
        if (gone)
            withdraw(running);
        else if (!running.token.empty())
            all.push_back(running);
    }
    std::ranges::sort(all, {}, &RunningGame::file);
    return all;
}

RunningGame running_game(const std::string& wanted) {
    const std::vector<RunningGame> all = running_games();
    if (all.empty())
        throw FileError(
            "--attach: no game listens; start one with \"fettle run GAME --listen\", "
            "or set console.listen = true in its console");
    std::vector<RunningGame> meant;
    std::ranges::copy_if(all, std::back_inserter(meant),
                         [&](const RunningGame& each) { return is_meant(each, wanted); });
    if (meant.size() == 1) return meant.front();
    if (meant.empty())
        throw FileError("--attach: \"" + wanted + "\" does not listen; there are " + list_of(all));
    throw FileError("--attach: several games listen: " + list_of(meant) +
                    "; name one by the number in brackets");
}

int connected_to(const fs::path& socket) {
    const std::optional<SocketAddress> address = SocketAddress::of(socket);
    if (!address) {
        errno = ENAMETOOLONG;
        return -1;
    }
    const int made = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
    if (made < 0) return -1;
    // A game that is busy takes no connections for a while.
    const timeval patience{.tv_sec = 10, .tv_usec = 0};
    ::setsockopt(made, SOL_SOCKET, SO_SNDTIMEO, &patience, sizeof patience);
    if (::connect(made, address->any(), address->size()) == 0) return made;
    const int problem = errno;
    ::close(made);
    errno = problem;
    return -1;
}

}  // namespace fettle::program
