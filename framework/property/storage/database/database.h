#pragma once
// SQLite for the journal of tweaks and for saves: connections and statements with owners, errors as
// exceptions. A file may come from anywhere, so none is trusted: everything except tables is
// disabled, and the run time of a statement is limited.

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
    /// Another connection is writing; the same call may succeed a moment later.
    bool busy() const;
    /// The file is not a database, or is damaged.
    bool damaged() const;
    /// The same error with the path `where` in front of the message.
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
    /// True if there is a row to read.
    bool step();
    /// Runs the statement to its end and resets it.
    void run();
    void reset();

    // Columns count from 0; null is read as 0 or "".
    std::int64_t integer(int column) const;
    std::string text(int column) const;
    /// Its size in bytes, without reading it.
    std::size_t size(int column) const;

  private:
    [[noreturn]] void fail(int code) const;
    sqlite3* database_;
    sqlite3_stmt* statement_ = nullptr;
};

/// How a file is opened. `create` makes a missing file, `existing` does not. `reading` writes
/// nothing; only if another program has the file open may SQLite write a file beside it.
enum class Access : std::uint8_t { create, existing, reading };

class Database {
  public:
    /// Throws DatabaseError. Throws std::runtime_error with the reason in words if the file, or one
    /// that SQLite keeps beside it, is not a regular file or larger than `size_limit`.
    Database(const std::filesystem::path& file, Access access);
    static Database in_memory();
    static constexpr std::uintmax_t size_limit = std::uintmax_t{1} << 30;  // bytes
    /// A read-only database made of the bytes that `serialized` returned. The bytes must outlive
    /// it.
    static Database of_bytes(std::string_view file);
    Database(Database&& other) noexcept : database_(std::exchange(other.database_, nullptr)) {}
    ~Database();
    Database(const Database&) = delete;
    Database& operator=(const Database&) = delete;

    void run(const char* sql);
    Statement statement(std::string_view sql) { return {database_, sql}; }
    /// The result of a query with one row and one column.
    std::int64_t integer(const char* sql);
    std::string text(const char* sql);
    std::int64_t last_row() const;
    /// Whether the database cannot be written, whatever it was opened for.
    bool read_only() const;
    /// The bytes of its file, or of the file that it would have.
    std::string serialized() const;
    /// Sets how long to wait for another connection that is writing.
    void wait_for_others(int milliseconds);

  private:
    Database() = default;
    void distrust();
    sqlite3* database_ = nullptr;
};

/// Rolls back in the destructor unless committed.
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

/// Format of a file: which application it belongs to (`application_id`), its version, and the
/// statements that create its tables.
struct FileFormat {
    std::int32_t application = 0;
    int version = 0;
    std::vector<std::string_view> tables{};
};

/// Gives an empty file that format.
void set_format(Database& database, const FileFormat& format);

/// Checks the first bytes of a file: the application must match, and the version must be neither
/// newer nor older. Throws std::runtime_error with the reason in words.
void check_header(std::string_view file, const FileFormat& format);

/// Checks that an open file has that format, is not damaged and not newer, and contains only those
/// tables. Returns true if so, false if the file is new and empty. Throws std::runtime_error with
/// the reason in words.
bool check_format(Database& database, const FileFormat& format);

}  // namespace fettle::property
