#include <fettle/property/storage/saves.h>

#include <algorithm>
#include <cctype>
#include <chrono>

#include <fettle/property/spelling.h>

#include "database.h"
#include "durable_file.h"

namespace fettle::property {

namespace fs = std::filesystem;

namespace {

const FileFormat format{
    .application = 0x46534156,  // "FSAV"
    .version = 1,
    .tables = {"CREATE TABLE save (game TEXT, program TEXT, step INTEGER, time INTEGER, checksum "
               "INTEGER, width INTEGER, height INTEGER, thumbnail BLOB, state BLOB)"}};
constexpr std::string_view ending = ".sqlite";
constexpr std::size_t largest_thumbnail = std::size_t{16} << 20;  // bytes

/// FNV-1a with 64 bits, over everything a save holds: it finds damage, not forgery.
class Checksum {
  public:
    Checksum& add(std::string_view bytes) {
        for (const char c : bytes) add_byte(static_cast<unsigned char>(c));
        return add_byte(0xff);  // so that bytes cannot wander from one part into the next
    }
    std::int64_t value() const { return static_cast<std::int64_t>(hash_); }

  private:
    Checksum& add_byte(unsigned char byte) {
        hash_ = (hash_ ^ byte) * 1099511628211u;
        return *this;
    }
    std::uint64_t hash_ = 14695981039346656037u;
};

template <class Bytes>
std::string_view view_of(const Bytes& bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::int64_t checksum_of(const SaveInfo& info, const std::string& game, std::string_view state,
                         const Thumbnail& thumbnail) {
    return Checksum()
        .add(game)
        .add(info.program)
        .add(std::to_string(info.step) + " " + std::to_string(info.time))
        .add(std::to_string(thumbnail.width) + " " + std::to_string(thumbnail.height))
        .add(view_of(thumbnail.pixels))
        .add(state)
        .value();
}

}  // namespace

Thumbnail scaled_down(const Thumbnail& picture, std::uint32_t widest) {
    if (picture.empty() || picture.width <= widest || widest == 0) return picture;
    Thumbnail small;
    small.width = widest;
    small.height = std::max<std::uint32_t>(
        1, static_cast<std::uint32_t>(std::uint64_t{picture.height} * widest / picture.width));
    small.pixels.resize(std::size_t{small.width} * small.height * 4);
    const auto edge = [](std::uint32_t at, std::uint32_t from, std::uint32_t to) {
        return static_cast<std::uint32_t>(std::uint64_t{at} * from / to);
    };
    for (std::uint32_t y = 0; y < small.height; ++y) {
        const std::uint32_t top = edge(y, picture.height, small.height);
        const std::uint32_t bottom = std::max(top + 1, edge(y + 1, picture.height, small.height));
        for (std::uint32_t x = 0; x < small.width; ++x) {
            const std::uint32_t left = edge(x, picture.width, small.width);
            const std::uint32_t right = std::max(left + 1, edge(x + 1, picture.width, small.width));
            std::uint32_t sum[4] = {};
            for (std::uint32_t v = top; v < bottom; ++v)
                for (std::uint32_t u = left; u < right; ++u)
                    for (std::size_t c = 0; c < 4; ++c)
                        sum[c] += picture.pixels[(std::size_t{v} * picture.width + u) * 4 + c];
            const std::uint32_t count = (bottom - top) * (right - left);
            for (std::size_t c = 0; c < 4; ++c)
                small.pixels[(std::size_t{y} * small.width + x) * 4 + c] =
                    static_cast<std::uint8_t>(sum[c] / count);
        }
    }
    return small;
}

Saves::Saves(fs::path folder, std::string game, std::string program)
    : folder_(std::move(folder)), game_(std::move(game)), program_(std::move(program)) {}

void Saves::check_slot(std::string_view slot) {
    const auto fits = [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_' || c == ' ';
    };
    if (!slot.empty() && slot.size() <= 64 && slot.front() != ' ' && slot.back() != ' ' &&
        std::all_of(slot.begin(), slot.end(), fits))
        return;
    throw Error(ErrorKind::bad_name, value_text(Value(slot.substr(0, 80))) +
                                         " is no name of a slot: it takes 1 to 64 letters, digits, "
                                         "spaces, - and _");
}

fs::path Saves::file(const std::string& slot) const {
    check_slot(slot);
    return folder_ / (slot + std::string(ending));
}

// --- Writing -------------------------------------------------------------------------------------

void Saves::save(const std::string& slot, std::uint64_t step, std::span<const std::byte> state,
                 const Thumbnail& thumbnail) const {
    const fs::path target = file(slot);
    if (folder_.empty()) throw FileError(target, "there is no folder for saved games");
    std::error_code error;
    fs::create_directories(folder_, error);
    if (error) throw FileError(folder_, "could not be made: " + error.message());
    SaveInfo info;
    info.step = step;
    info.program = program_;
    info.time = std::chrono::duration_cast<std::chrono::seconds>(
                    std::chrono::system_clock::now().time_since_epoch())
                    .count();
    std::string bytes;
    try {
        // Made in memory and put into place whole, so that there is never half a save.
        Database database = Database::in_memory();
        set_format(database, format);
        database.statement("INSERT INTO save VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)")
            .bind(1, game_)
            .bind(2, program_)
            .bind(3, static_cast<std::int64_t>(step))
            .bind(4, info.time)
            .bind(5, checksum_of(info, game_, view_of(state), thumbnail))
            .bind(6, std::int64_t{thumbnail.width})
            .bind(7, std::int64_t{thumbnail.height})
            .bind_bytes(8, view_of(thumbnail.pixels))
            .bind_bytes(9, view_of(state))
            .run();
        bytes = database.serialized();
    } catch (const DatabaseError& problem) {
        throw FileError(target, std::string("could not be made: ") + problem.what());
    }
    replace_file(target, bytes);
}

// --- Reading -------------------------------------------------------------------------------------

SavedGame Saves::read(const fs::path& file) const {
    SavedGame saved;
    saved.info.slot = file.stem().string();
    std::error_code ignored;
    saved.info.bytes = static_cast<std::size_t>(fs::file_size(file, ignored));
    try {
        Database database(file, Access::reading);
        if (!check_format(database, format)) throw std::runtime_error("it is empty");
        Statement row = database.statement(
            "SELECT game, program, step, time, checksum, width, height, thumbnail, state FROM "
            "save");
        if (!row.step()) throw std::runtime_error("it is empty");
        const std::string game = row.text(0);
        saved.info.program = row.text(1);
        saved.info.step = static_cast<std::uint64_t>(row.integer(2));
        saved.info.time = row.integer(3);
        const std::int64_t width = row.integer(5), height = row.integer(6);
        const std::string pixels = row.text(7), state = row.text(8);
        const bool fits = width >= 0 && height >= 0 && width < 65536 && height < 65536 &&
                          pixels.size() <= largest_thumbnail &&
                          pixels.size() == static_cast<std::size_t>(width * height * 4);
        if (!fits) throw std::runtime_error("it is damaged (its picture)");
        saved.thumbnail = {static_cast<std::uint32_t>(width),
                           static_cast<std::uint32_t>(height),
                           {pixels.begin(), pixels.end()}};
        saved.info.thumbnail = !saved.thumbnail.empty();
        if (checksum_of(saved.info, game, state, saved.thumbnail) != row.integer(4))
            throw std::runtime_error("it is damaged (its checksum does not fit)");
        if (game != game_) throw std::runtime_error("it is of another game, " + game);
        const auto bytes = std::as_bytes(std::span(state));
        saved.state.assign(bytes.begin(), bytes.end());
    } catch (const std::runtime_error& problem) {
        saved.info.problem = problem.what();
    }
    return saved;
}

fs::path Saves::existing(const std::string& slot) const {
    fs::path path = file(slot);
    std::error_code ignored;
    if (fs::exists(path, ignored)) return path;
    std::vector<std::string> slots;
    for (const SaveInfo& each : list()) slots.push_back(each.slot);
    throw Error(ErrorKind::unknown_name,
                "there is no saved game \"" + slot + "\"" + suggestion(slot, slots));
}

SavedGame Saves::load(const std::string& slot) const {
    const fs::path path = existing(slot);
    SavedGame saved = read(path);
    if (!saved.info.problem.empty())
        throw FileError(path, "cannot be loaded: " + saved.info.problem);
    return saved;
}

std::vector<SaveInfo> Saves::list() const {
    std::vector<SaveInfo> all;
    std::error_code error;
    for (fs::directory_iterator it(folder_, error), end; !error && it != end; it.increment(error)) {
        const fs::path& path = it->path();
        if (path.extension() != ending || path.filename().string().starts_with('.')) continue;
        all.push_back(read(path).info);
    }
    std::sort(all.begin(), all.end(),
              [](const SaveInfo& a, const SaveInfo& b) { return a.slot < b.slot; });
    return all;
}

void Saves::remove(const std::string& slot) const {
    const fs::path path = existing(slot);
    std::error_code error;
    if (!fs::remove(path, error) || error)
        throw FileError(path, "could not be removed: " + error.message());
}

}  // namespace fettle::property
