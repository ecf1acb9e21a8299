#include <fettle/property/storage/game_files.h>

#include <span>
#include <utility>

#include <fettle/property/bytes.h>

#include "durable_file.h"

namespace fettle::property {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t greatest_module = std::size_t{1} << 30;  // bytes; with what it debugs by

std::uint64_t checksum_of(std::string_view content) {
    return checksum(std::as_bytes(std::span(content)));
}

std::optional<std::string> content_on_disk(const fs::path& file, std::size_t limit) {
    std::error_code error;
    if (!fs::exists(file, error)) return std::nullopt;
    return read_file(file, limit);
}

}  // namespace

std::optional<std::uint64_t> file_checksum(const fs::path& file) {
    const std::optional<std::string> content = content_on_disk(file, greatest_module);
    if (!content) return std::nullopt;
    return checksum_of(*content);
}

/// However it is called: what is overwritten is the same file as what was read.
fs::path GameFiles::key(const fs::path& file) {
    std::error_code error;
    fs::path found = fs::weakly_canonical(file, error);
    return error ? file : found;
}

const std::optional<std::string>* GameFiles::held(const Path& file) const {
    if (held_.empty()) return nullptr;
    const auto found = held_.find(key(file));
    return found == held_.end() ? nullptr : &found->second;
}

std::string GameFiles::read(const Path& file) {
    if (const auto* content = held(file)) {
        if (*content) return **content;
        throw FileError(file, "could not be read: there was no such file then");
    }
    std::string content = read_file(file, size_limit);
    note(file, content);
    return content;
}

bool GameFiles::exists(const Path& file) {
    if (const auto* content = held(file)) return content->has_value();
    std::error_code error;
    const bool there = fs::exists(file, error);
    if (!there) note(file, std::nullopt);
    return there;
}

void GameFiles::write(const Path& file, std::string_view content) {
    if (in_memory_) return put(file, std::string(content));
    note_overwritten(file);
    replace_file(file, content);
}

void GameFiles::put(const Path& file, std::optional<std::string> content) {
    held_[key(file)] = std::move(content);
}

// --- What is told
// --------------------------------------------------------------------------------------------------

void GameFiles::tell(std::function<void(const Finding&)> listener) {
    listener_ = std::move(listener);
    for (Finding& finding : std::exchange(findings_, {})) add(std::move(finding));
}

void GameFiles::add(Finding finding) {
    if (listener_)
        listener_(finding);
    else
        findings_.push_back(std::move(finding));
}

void GameFiles::note(const Path& file, const std::optional<std::string>& content) {
    if (!notes_) return;
    Path path = key(file);
    Known& known = known_[path];
    if (known.looked_at || known.overwritten) return;
    known.looked_at = true;
    add({.file = std::move(path),
         .checksum = content ? std::optional(checksum_of(*content)) : std::nullopt});
}

void GameFiles::looks_at(const Path& file) {
    if (notes_) note(file, content_on_disk(file, greatest_module));
}

void GameFiles::note_overwritten(const Path& file) {
    if (!notes_) return;
    Path path = key(file);
    Known& known = known_[path];
    if (known.overwritten) return;
    known.overwritten = true;
    std::optional<std::string> was = content_on_disk(path, size_limit);
    std::optional<std::uint64_t> its_checksum;
    if (was) its_checksum = checksum_of(*was);
    add({.file = std::move(path),
         .checksum = its_checksum,
         .overwritten = true,
         .content = std::move(was)});
}

}  // namespace fettle::property
