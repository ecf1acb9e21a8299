#include <prompt/history.h>

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <utility>

#include <fettle/console/console.h>
#include <fettle/property/spelling.h>
#include <fettle/property/storage/replaced_file.h>
#include <fettle/property/storage/scene.h>

#include <text/utf8.h>

namespace fettle::console {

namespace {

std::string escaped(std::string_view command) {
    std::string out;
    for (char c : command) {
        if (c == '\\')
            out += "\\\\";
        else if (c == '\n')
            out += "\\n";
        else
            out.push_back(c);
    }
    out.push_back('\n');
    return out;
}

std::string unescaped(std::string_view line) {
    std::string out;
    for (std::size_t i = 0; i < line.size(); ++i) {
        bool escape = line[i] == '\\' && i + 1 < line.size();
        if (escape) ++i;
        out.push_back(escape && line[i] == 'n' ? '\n' : line[i]);
    }
    return out;
}

bool write_all(int fd, std::string_view bytes) {
    while (!bytes.empty()) {
        ssize_t written = ::write(fd, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) return false;
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    return true;
}

/// Writes at the end of the file. False with errno set.
bool append_to(const std::filesystem::path& file, std::string_view bytes) {
    const int fd = ::open(file.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC | O_APPEND, 0600);
    if (fd < 0) return false;
    const bool written = write_all(fd, bytes);
    return ::close(fd) == 0 && written;
}

}  // namespace

History::History(std::filesystem::path file) : file_(std::move(file)) {
    if (!file_.empty()) load();
}

void History::fail(const std::string& what) {
    writable_ = false;
    problem_ = "history is not kept: " + file_.string() + ": " + what;
}

void History::load() {
    std::error_code error;
    auto status = std::filesystem::status(file_, error);
    if (status.type() == std::filesystem::file_type::not_found) return;
    if (!std::filesystem::is_regular_file(status)) return fail("not a regular file");
    std::ifstream in(file_, std::ios::binary);
    if (!in) return fail(std::strerror(errno));
    // Only the end of a very large file is read.
    in.seekg(0, std::ios::end);
    auto size = static_cast<std::size_t>(std::max<std::streamoff>(0, in.tellg()));
    std::size_t skipped = size > max_file_bytes ? size - max_file_bytes : 0;
    in.seekg(static_cast<std::streamoff>(skipped));
    std::string line;
    if (skipped > 0) std::getline(in, line);
    while (std::getline(in, line)) {
        ++lines_in_file_;
        std::string command = clean_text(unescaped(line));
        if (!command.empty() && command.size() <= max_entry_bytes)
            entries_.push_back(std::move(command));
    }
    if (in.bad()) return fail("cannot be read");
    // Of repeated commands only the last is kept. One pass from the end avoids a search per line.
    std::vector<std::string> sorted;
    std::vector<std::string> kept;
    std::reverse(entries_.begin(), entries_.end());
    for (std::string& entry : entries_) {
        if (kept.size() == max_entries) break;
        auto place = std::lower_bound(sorted.begin(), sorted.end(), entry);
        if (place != sorted.end() && *place == entry) continue;
        sorted.insert(place, entry);
        kept.push_back(std::move(entry));
    }
    std::reverse(kept.begin(), kept.end());
    entries_ = std::move(kept);
    if (skipped > 0 || lines_in_file_ > 2 * max_entries) rewrite();
}

void History::add_entry(std::string_view command) {
    auto same = std::find(entries_.begin(), entries_.end(), command);
    if (same != entries_.end()) entries_.erase(same);
    entries_.emplace_back(command);
    if (entries_.size() > max_entries) entries_.erase(entries_.begin());
}

void History::add(std::string_view command) {
    while (!command.empty() && (command.back() == '\n' || command.back() == ' '))
        command.remove_suffix(1);
    if (command.empty() || command.size() > max_entry_bytes) return;
    bool repeated = !entries_.empty() && entries_.back() == command;
    std::string kept(command);
    add_entry(kept);
    if (!repeated && !file_.empty() && writable_) append(kept);
}

void History::append(std::string_view command) {
    std::error_code error;
    if (file_.has_parent_path()) std::filesystem::create_directories(file_.parent_path(), error);
    if (error) return fail(error.message());
    if (!append_to(file_, escaped(command))) return fail(std::strerror(errno));
    if (++lines_in_file_ > 2 * max_entries) rewrite();
}

void History::rewrite() {
    std::string all;
    for (const std::string& entry : entries_) all += escaped(entry);
    try {
        property::replace_file(file_, all);
    } catch (const property::FileError& error) {
        writable_ = false;
        problem_ = std::string("history is not kept: ") + error.what();
        return;
    }
    lines_in_file_ = entries_.size();
}

std::optional<std::size_t> History::older(std::string_view prefix, std::size_t from,
                                          std::string_view except) const {
    for (std::size_t i = std::min(from, entries_.size()); i-- > 0;)
        if (entries_[i].starts_with(prefix) && entries_[i] != except) return i;
    return std::nullopt;
}

std::optional<std::size_t> History::newer(std::string_view prefix, std::size_t from) const {
    for (std::size_t i = from + 1; i < entries_.size(); ++i)
        if (entries_[i].starts_with(prefix)) return i;
    return std::nullopt;
}

std::optional<std::size_t> History::containing(std::string_view part, std::size_t from) const {
    const bool exact = std::ranges::any_of(part, [](char c) { return c >= 'A' && c <= 'Z'; });
    for (std::size_t i = std::min(from, entries_.size()); i-- > 0;)
        if (exact ? entries_[i].find(part) != std::string::npos
                  : property::contains_ignoring_case(entries_[i], part))
            return i;
    return std::nullopt;
}

std::string History::consume_problem() {
    return std::exchange(problem_, {});
}

namespace {

/// The folder that the variable names, or `otherwise` in the home of the user; empty without both.
std::filesystem::path folder_of_user(const char* variable, const char* otherwise) {
    auto set = [](const char* name) -> const char* {
        const char* value = std::getenv(name);
        return value != nullptr && *value == '/' ? value : nullptr;
    };
    if (const char* given = set(variable)) return std::filesystem::path(given) / "fettle";
    if (const char* home = set("HOME")) return std::filesystem::path(home) / otherwise / "fettle";
    return {};
}

}  // namespace

std::filesystem::path default_history_file() {
    const auto folder = folder_of_user("XDG_STATE_HOME", ".local/state");
    return folder.empty() ? folder : folder / "console_history";
}

std::filesystem::path default_autoexec_file() {
    const auto folder = folder_of_user("XDG_CONFIG_HOME", ".config");
    return folder.empty() ? folder : folder / "autoexec.lua";
}

}  // namespace fettle::console
