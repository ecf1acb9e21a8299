#pragma once
// SQLite, as far as the journal of tweaks and the saves need it: connections and statements that
// end with their owners, and failures as exceptions. A file may come from anywhere, so none is
// trusted: whatever it defines besides tables is off, and no statement runs for ever.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

struct sqlite3;
struct sqlite3_stmt;

namespace fettle::property {

class DatabaseError : public std::runtime_error {
  public:
    DatabaseError(int code, const std::string& what) : std::runtime_error(what), code_(code) {}
    /// Somebody else is writing: the same may well succeed a moment later.
    bool busy() const;
    /// The file is no database, or a damaged one.
    bool damaged() const;
    /// The same with `where` in front of what it says.
    DatabaseError at(const std::filesystem::path& where) const {
        return {code_, where.string() + ": " + what()};
    }

  private:
    int code_;
};

class Statement {
  public:
    Statement(sqlite3* database, std::string_view sql);
    ~Statement();
    Statement(const Statement&) = delete;
    Statement& operator=(const Statement&) = delete;

    // Parameters count from 1.
    Statement& bind(int parameter, std::int64_t value);
    Statement& bind(int parameter, std::string_view text);
    Statement& bind_bytes(int parameter, std::string_view bytes);
    /// True when there is a row to read.
    bool step();
    /// Runs it to its end, and makes it ready for other parameters.
    void run();
    void reset();

    // Columns count from 0; null reads as 0 or "".
    std::int64_t integer(int column) const;
    std::string text(int column) const;
    /// Its size in bytes, without reading it.
    std::size_t size(int column) const;

  private:
    [[noreturn]] void fail(int code) const;
    sqlite3* database_;
    sqlite3_stmt* statement_ = nullptr;
};

/// How a file is opened. `create` makes it when it is missing, `existing` refuses that, `reading`
/// writes nothing, not even beside the file, unless another program has it open.
enum class Access : std::uint8_t { create, existing, reading };

class Database {
  public:
    /// Throws DatabaseError, and std::runtime_error with the reason in words for what is no regular
    /// file, or larger than `size_limit`: the file itself, or one of those that SQLite keeps beside
    /// it.
    Database(const std::filesystem::path& file, Access access);
    static Database in_memory();
    static constexpr std::uintmax_t size_limit = std::uintmax_t{1} << 30;  // bytes
    /// What `serialized` gave, to be read. The bytes must outlive it.
    static Database of_bytes(std::string_view file);
    Database(Database&& other) noexcept : database_(std::exchange(other.database_, nullptr)) {}
    ~Database();
    Database(const Database&) = delete;
    Database& operator=(const Database&) = delete;

    void run(const char* sql);
    Statement statement(std::string_view sql) { return {database_, sql}; }
    /// The one value of the one row a query gives.
    std::int64_t integer(const char* sql);
    std::string text(const char* sql);
    std::int64_t last_row() const;
    /// Nothing can be written, whatever it was opened for.
    bool read_only() const;
    /// The bytes its file has, or would have.
    std::string serialized() const;
    /// How long to wait for somebody else who is writing.
    void wait_for_others(int milliseconds);

  private:
    Database() = default;
    void distrust();
    sqlite3* database_ = nullptr;
};

/// Rolls back unless committed.
class DatabaseTransaction {
  public:
    explicit DatabaseTransaction(Database& database);
    ~DatabaseTransaction();
    DatabaseTransaction(const DatabaseTransaction&) = delete;
    DatabaseTransaction& operator=(const DatabaseTransaction&) = delete;
    void commit();

  private:
    Database& database_;
    bool open_ = true;
};

/// What a file of ours says of itself: whose it is (`application_id`), in which version, and the
/// statements that have made its tables.
struct FileFormat {
    std::int32_t application = 0;
    int version = 0;
    std::vector<std::string_view> tables{};
};

/// Makes an empty file one of that format.
void set_format(Database& database, const FileFormat& format);

/// Checks whose a file is and its version, by its first bytes: that it is neither newer nor older.
/// Throws std::runtime_error with the reason in words.
void check_header(std::string_view file, const FileFormat& format);

/// Checks that an open file is of that format, whole, and not newer, and that there is nothing in
/// it but those tables. True: it is; false: it is new and empty. Throws std::runtime_error with the
/// reason in words.
bool check_format(Database& database, const FileFormat& format);

}  // namespace fettle::property
