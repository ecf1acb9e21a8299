// Files of saved games.

#include <fettle/property/storage/saves.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <chrono>
#include <cstring>
#include <stdexcept>
#include <utility>

#include <fettle/property/bytes.h>
#include <fettle/property/spelling.h>

#include <database/database.h>
#include <files/durable_file.h>

namespace fettle::property {

namespace fs = std::filesystem;

namespace {

const FileFormat format{
    .application = 0x46534156,  // "FSAV"
    .version = 2,
    .tables = {"CREATE TABLE save (game TEXT, program TEXT, step INTEGER, time INTEGER, width "
               "INTEGER, height INTEGER, thumbnail BLOB, state BLOB)"}};
constexpr std::string_view save_ending = ".sqlite";
constexpr std::size_t largest_thumbnail = std::size_t{16} << 20;  // bytes
constexpr std::size_t largest_file = std::size_t{Database::size_limit};

/// Follows the database in the file, which SQLite ignores: the checksum of all bytes before it.
struct Seal {
    std::array<char, 8> magic = {'F', 'e', 't', 't', 'l', 'e', 'S', '2'};
    std::uint64_t checksum = 0;
};

std::string_view view_of(std::span<const std::byte> bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::string sealed(std::string database) {
    const Seal seal{.checksum = checksum(std::as_bytes(std::span(database)))};
    database.append(reinterpret_cast<const char*>(&seal), sizeof seal);
    return database;
}

/// The database inside a complete file. Throws std::runtime_error with the reason. The format and
/// version are checked first, because a newer version may use another checksum.
std::string_view unsealed(std::string_view file) {
    check_header(file, format);
    Seal seal;
    const auto bytes = file.substr(0, file.size() - std::min(file.size(), sizeof seal));
    std::string_view end = file.substr(bytes.size());
    if (end.size() == sizeof seal) std::memcpy(&seal, end.data(), sizeof seal);
    if (end.size() != sizeof seal || seal.magic != Seal{}.magic ||
        seal.checksum != checksum(std::as_bytes(std::span(bytes))))
        throw std::runtime_error("it is damaged (its checksum differs)");
    return bytes;
}

bool fits(std::int64_t width, std::int64_t height, std::size_t bytes) {
    return width >= 0 && height >= 0 && width < 65536 && height < 65536 &&
           bytes <= largest_thumbnail && bytes == static_cast<std::size_t>(width * height * 4);
}

void require_picture(const Thumbnail& picture) {
    if (!fits(picture.width, picture.height, picture.pixels.size()))
        throw Error(ErrorKind::out_of_range,
                    "a picture of " + std::to_string(picture.width) + " × " +
                        std::to_string(picture.height) + " px and " +
                        std::to_string(picture.pixels.size()) +
                        " bytes: expected four bytes a pixel, and at most " +
                        std::to_string(largest_thumbnail));
}

}  // namespace

Thumbnail scaled_down(const Thumbnail& picture, std::uint32_t widest) {
    if (picture.pixels.size() / 4 / std::max(1u, picture.width) < picture.height ||
        picture.pixels.size() != std::size_t{4} * picture.width * picture.height)
        throw Error(ErrorKind::out_of_range,
                    "a picture of " + std::to_string(picture.width) + " × " +
                        std::to_string(picture.height) + " px has " +
                        std::to_string(picture.pixels.size()) + " bytes: expected four a pixel");
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
            std::uint64_t sum[4] = {};
            for (std::uint32_t v = top; v < bottom; ++v)
                for (std::uint32_t u = left; u < right; ++u)
                    for (std::size_t c = 0; c < 4; ++c)
                        sum[c] += picture.pixels[(std::size_t{v} * picture.width + u) * 4 + c];
            const std::uint64_t count = std::uint64_t{bottom - top} * (right - left);
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
    throw Error(ErrorKind::bad_name,
                value_text(Value(slot.substr(0, 80))) +
                    " is not a name of a slot: it takes 1 to 64 letters, digits, "
                    "spaces, - and _");
}

fs::path Saves::file(const std::string& slot) const {
    check_slot(slot);
    return folder_ / (slot + std::string(save_ending));
}

// --- Writing -------------------------------------------------------------------------------------

void Saves::save(const std::string& slot, std::uint64_t step, std::span<const std::byte> state,
                 const Thumbnail& thumbnail) const {
    const fs::path target = file(slot);
    if (folder_.empty()) throw FileError(target, "there is no folder for saved games");
    require_picture(thumbnail);
    if (step > std::uint64_t{INT64_MAX})
        throw Error(ErrorKind::out_of_range, target.string() + ": step " + std::to_string(step) +
                                                 ": expected at most " + std::to_string(INT64_MAX));
    std::error_code error;
    fs::create_directories(folder_, error);
    if (error) throw FileError(folder_, "could not be made: " + error.message());
    const std::int64_t now = std::chrono::duration_cast<std::chrono::seconds>(
                                 std::chrono::system_clock::now().time_since_epoch())
                                 .count();
    std::string bytes;
    try {
        // The file is built in memory and replaced at once, so a save is never incomplete.
        Database database = Database::in_memory();
        set_format(database, format);
        database.statement("INSERT INTO save VALUES (?, ?, ?, ?, ?, ?, ?, ?)")
            .bind(1, game_)
            .bind(2, program_)
            .bind(3, static_cast<std::int64_t>(step))
            .bind(4, now)
            .bind(5, std::int64_t{thumbnail.width})
            .bind(6, std::int64_t{thumbnail.height})
            .bind_bytes(7, view_of(std::as_bytes(std::span(thumbnail.pixels))))
            .bind_bytes(8, view_of(state))
            .run();
        bytes = sealed(database.serialized());
        // The result is loaded as a test, so that an unreadable save replaces nothing.
        Database again = Database::of_bytes(unsealed(bytes));
        SavedGame read_back;
        read(again, read_back);
        if (!std::ranges::equal(read_back.state, state))
            throw std::runtime_error(
                "the state that was read back differs from the state that was written");
    } catch (const std::runtime_error& problem) {
        throw FileError(target, std::string("could not be made: ") + problem.what());
    }
    replace_file(target, bytes);
}

// --- Reading -------------------------------------------------------------------------------------

SavedGame Saves::read(const fs::path& file) const {
    SavedGame saved;
    saved.info.slot = file.stem().string();
    try {
        const std::string bytes = read_file(file, largest_file);
        saved.info.bytes = bytes.size();
        Database database = Database::of_bytes(unsealed(bytes));
        if (!check_format(database, format)) throw std::runtime_error("it is empty");
        read(database, saved);
    } catch (const FileError& problem) {  // the message begins with the file, as in `load`
        saved.info.problem = std::string(problem.what()).substr(file.string().size() + 2);
    } catch (const std::runtime_error& problem) {
        saved.info.problem = problem.what();
    }
    return saved;
}

void Saves::read(Database& database, SavedGame& into) const {
    Statement row = database.statement(
        "SELECT game, program, step, time, width, height, thumbnail, state FROM save");
    if (!row.step()) throw std::runtime_error("it is empty");
    const std::string game = row.text(0);
    into.info.program = row.text(1);
    const std::int64_t step = row.integer(2);
    into.info.time = row.integer(3);
    if (step < 0) throw std::runtime_error("it is damaged (its step)");
    into.info.step = static_cast<std::uint64_t>(step);
    const std::int64_t width = row.integer(4), height = row.integer(5);
    const std::string pixels = row.text(6), state = row.text(7);
    if (!fits(width, height, pixels.size()))
        throw std::runtime_error("it is damaged (its picture)");
    into.thumbnail = {static_cast<std::uint32_t>(width),
                      static_cast<std::uint32_t>(height),
                      {pixels.begin(), pixels.end()}};
    into.info.thumbnail = !into.thumbnail.empty();
    if (game != game_) throw std::runtime_error("it belongs to another game, " + game);
    const auto bytes = std::as_bytes(std::span(state));
    into.state.assign(bytes.begin(), bytes.end());
}

bool Saves::exists(const std::string& slot) const {
    // A link without a target counts as existing; reading it reports the error.
    std::error_code ignored;
    return fs::exists(fs::symlink_status(file(slot), ignored));
}

fs::path Saves::existing(const std::string& slot) const {
    if (exists(slot)) return file(slot);
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

std::vector<SaveInfo> Saves::list(const Check& problem_of) const {
    std::vector<SaveInfo> all;
    std::error_code error;
    for (fs::directory_iterator it(folder_, error), end; !error && it != end; it.increment(error)) {
        const fs::path& path = it->path();
        if (path.extension() != save_ending || path.filename().string().starts_with('.')) continue;
        SavedGame saved = read(path);
        try {
            check_slot(saved.info.slot);
        } catch (const Error& refused) {
            saved.info.problem = refused.what();  // the slot cannot be loaded
        }
        if (problem_of && saved.info.problem.empty()) saved.info.problem = problem_of(saved);
        all.push_back(std::move(saved.info));
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
