#include <files/archive.h>

#include <minizip/unzip.h>
#include <minizip/zip.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <memory>
#include <set>
#include <system_error>
#include <utility>

#include <fettle/property/storage/game_files.h>
#include <fettle/property/value.h>

#include <files/draft.h>
#include <files/game_path.h>

namespace fettle::program {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t largest_sum = std::size_t{1} << 30;  // bytes, of all files
constexpr std::size_t most_files = 50'000;
constexpr std::size_t longest_name = 1000;

[[noreturn]] void refuse(const fs::path& file, const std::string& why) {
    throw FileError(file.string() + ": " + why);
}

/// In quotes, with control characters escaped.
std::string shown(const std::string& name) {
    return property::value_text(property::Value(name.substr(0, 100)));
}

bool is_valid_name(const std::string& name) {
    if (name.empty() || name.size() > longest_name || name.find('\\') != std::string::npos ||
        name.find('\0') != std::string::npos)
        return false;
    const fs::path path(name);
    if (path.is_absolute() || path.lexically_normal().generic_string() != name) return false;
    for (const fs::path& part : path)
        if (part == "..") return false;
    return true;
}

struct CloseUnzip {
    void operator()(void* archive) const { unzClose(archive); }
};

/// The name of a method of compression that the library cannot unpack.
std::string method_name(unsigned long method) {
    switch (method) {
        case 9:
            return "deflate64";
        case 12:
            return "bzip2";
        case 14:
            return "LZMA";
        case 93:
            return "Zstandard";
        case 95:
            return "XZ";
        default:
            return "method " + std::to_string(method);
    }
}

/// Reads the current file of the archive.
std::string read_current(void* archive, const fs::path& file, const std::string& name,
                         std::size_t size) {
    if (unzOpenCurrentFile(archive) != UNZ_OK) refuse(file, "\"" + name + "\" cannot be unpacked");
    std::string content(size, '\0');
    std::size_t filled = 0;
    while (filled < size) {
        const int count = unzReadCurrentFile(archive, content.data() + filled,
                                             static_cast<unsigned>(size - filled));
        if (count <= 0) break;
        filled += static_cast<std::size_t>(count);
    }
    if (unzCloseCurrentFile(archive) != UNZ_OK || filled != size)
        refuse(file, "\"" + name + "\" is damaged");
    return content;
}

}  // namespace

bool is_archive(const fs::path& file) {
    std::error_code error;
    return file.extension() == archive_ending && fs::is_regular_file(file, error);
}

fs::path archive_of(const fs::path& game) {
    return is_archive(game.parent_path()) ? game.parent_path() : fs::path();
}

ArchiveFiles read_archive(const fs::path& file, const std::string& only) {
    const std::unique_ptr<void, CloseUnzip> archive(unzOpen64(file.c_str()));
    if (archive == nullptr) refuse(file, "is not an archive of a game, or it is damaged");
    ArchiveFiles files;
    std::set<std::string> seen;
    std::size_t sum = 0;
    for (int status = unzGoToFirstFile(archive.get()); status != UNZ_END_OF_LIST_OF_FILE;
         status = unzGoToNextFile(archive.get())) {
        unz_file_info64 info{};
        std::string name(longest_name + 2, '\0');
        if (status != UNZ_OK ||
            unzGetCurrentFileInfo64(archive.get(), &info, name.data(), name.size(), nullptr, 0,
                                    nullptr, 0) != UNZ_OK)
            refuse(file, "is damaged");
        name.resize(std::min<std::size_t>(info.size_filename, name.size()));
        if (name.ends_with('/')) continue;  // a folder
        if (!is_valid_name(name))
            refuse(file, "has a file " + shown(name) +
                             ", a name that no game may have: expected the path of a file in the "
                             "game's folder, as in \"art/hero.png\"");
        if (!seen.insert(name).second) refuse(file, "has two files " + shown(name));
        if (info.uncompressed_size > property::GameFiles::size_limit)
            refuse(file, "is too large: " + shown(name) + " has " +
                             std::to_string(info.uncompressed_size) +
                             " bytes, and a file of a game has at most 64 MiB");
        if ((sum += info.uncompressed_size) > largest_sum || seen.size() > most_files)
            refuse(file, "is too large: a game has at most 1 GiB in " + std::to_string(most_files) +
                             " files");
        if (!only.empty() && name != only) continue;
        if (info.compression_method != 0 && info.compression_method != Z_DEFLATED)
            refuse(file, "\"" + name + "\" is compressed by " +
                             method_name(info.compression_method) +
                             ", expected deflate, or no compression");
        if ((info.flag & 1) != 0)
            refuse(file, "\"" + name + "\" is encrypted, expected a file without a password");
        files[name] = read_current(archive.get(), file, name, info.uncompressed_size);
    }
    return files;
}

namespace {

struct CloseZip {
    void operator()(void* archive) const { zipClose(archive, nullptr); }
};

void add_file(void* archive, const fs::path& file, const std::string& name,
              const std::string& content) {
    zip_fileinfo info{};
    info.tmz_date.tm_year = 1980;  // the same in every archive
    info.tmz_date.tm_mday = 1;
    constexpr uLong names_are_utf8 = 1 << 11;
    constexpr uLong made_by_unix = 3 << 8;
    const bool ok = zipOpenNewFileInZip4_64(archive, name.c_str(), &info, nullptr, 0, nullptr, 0,
                                            nullptr, Z_DEFLATED, Z_BEST_COMPRESSION, 0, -MAX_WBITS,
                                            DEF_MEM_LEVEL, Z_DEFAULT_STRATEGY, nullptr, 0,
                                            made_by_unix, names_are_utf8, 0) == ZIP_OK &&
                    zipWriteInFileInZip(archive, content.data(),
                                        static_cast<unsigned>(content.size())) == ZIP_OK &&
                    zipCloseFileInZip(archive) == ZIP_OK;
    if (!ok)
        refuse(file, "cannot be written: " +
                         reason_of_write(fs::absolute(file).parent_path(),
                                         std::error_code(errno, std::generic_category())));
}

}  // namespace

void write_archive(const fs::path& file, const ArchiveFiles& files) {
    for (const auto& [name, content] : files)
        if (!is_valid_name(name))
            refuse(file, "cannot be made: no file of a game may be called " + shown(name) +
                             "; rename it, or leave it out (package.exclude of game.json)");
    const Draft folder(file);
    const fs::path draft = folder.path / "archive";
    const auto refuse_now = [&] {
        refuse(file,
               "cannot be written: " +
                   reason_of_write(folder.path, std::error_code(errno, std::generic_category())));
    };
    errno = 0;
    try {
        std::unique_ptr<void, CloseZip> archive(zipOpen64(draft.c_str(), APPEND_STATUS_CREATE));
        if (archive == nullptr) refuse_now();
        for (const auto& [name, content] : files) add_file(archive.get(), file, name, content);
        if (zipClose(archive.release(), nullptr) != ZIP_OK) refuse_now();
        fs::rename(draft, file);
    } catch (const fs::filesystem_error& error) {
        refuse(file, "cannot be written: " + reason_of_write(folder.path, error.code()));
    }
}

void mount_archive(const fs::path& game, property::GameFiles& files) {
    const fs::path archive = archive_of(game);
    if (archive.empty()) return;
    for (auto& [name, content] : read_archive(archive))
        files.put(archive / name, std::move(content));
    files.stay_in_memory();
}

}  // namespace fettle::program
