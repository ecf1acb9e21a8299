#include <database/database.h>

#include <sqlite3.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>

#include <files/file_access.h>

namespace fettle::property {

namespace {

std::string message_of(sqlite3* database, int code) {
    const int primary = code & 0xff;
    if (primary == SQLITE_FULL) return system_reason(ENOSPC);
    if (primary == SQLITE_INTERRUPT) return "reading it takes too long";
    // The message of the connection is more precise, but only if it belongs to this code.
    const bool has_message = database != nullptr && sqlite3_errcode(database) == primary;
    std::string text = has_message ? sqlite3_errmsg(database) : sqlite3_errstr(code);
    if (primary != SQLITE_IOERR && primary != SQLITE_CANTOPEN) return text;
    // SQLite does not keep the reason of a failed commit, so it is taken from errno.
    const int last = errno;
    const int system = database != nullptr ? sqlite3_system_errno(database) : 0;
    if (system != 0 || last != 0) return system_reason(system != 0 ? system : last);
    if (primary == SQLITE_IOERR) text += " (" + std::to_string(code) + ")";
    return text;
}

/// Checks the named file and the files that SQLite opens beside it.
void require_regular_files(const std::filesystem::path& file) {
    for (const char* const suffix : {"", "-wal", "-shm", "-journal"}) {
        const std::string name = file.string() + suffix;
        struct stat status {};
        if (::lstat(name.c_str(), &status) != 0) continue;
        const std::string prefix = *suffix == 0 ? "" : file.filename().string() + suffix + ": ";
        if (const std::string why = why_no_file(status.st_mode); !why.empty())
            throw std::runtime_error(prefix + why);
        if (static_cast<std::uintmax_t>(status.st_size) > Database::size_limit)
            throw std::runtime_error(prefix + "it is larger than " +
                                     std::to_string(Database::size_limit >> 20) + " MB");
    }
}

#ifdef SQLITE_OPEN_NOFOLLOW
constexpr int no_links = SQLITE_OPEN_NOFOLLOW;
#else
constexpr int no_links = 0;
#endif

/// The file as a URI for SQLite.
std::string uri(const std::filesystem::path& file, bool immutable) {
    static constexpr std::string_view digits = "0123456789ABCDEF";
    std::string out = "file:";
    for (const char c : file.string()) {
        const auto byte = static_cast<unsigned char>(c);
        if (c == '%' || c == '?' || c == '#')
            out += {'%', digits[byte >> 4], digits[byte & 15]};
        else
            out += c;
    }
    return out + (immutable ? "?immutable=1" : "");
}

}  // namespace

bool DatabaseError::busy() const {
    return (code_ & 0xff) == SQLITE_BUSY || (code_ & 0xff) == SQLITE_LOCKED;
}

bool DatabaseError::damaged() const {
    return (code_ & 0xff) == SQLITE_CORRUPT || (code_ & 0xff) == SQLITE_NOTADB;
}

// --- Statements ----------------------------------------------------------------------------------

Statement::Statement(sqlite3* database, std::string_view sql) : database_(database) {
    const int code = sqlite3_prepare_v2(database, sql.data(), static_cast<int>(sql.size()),
                                        &statement_, nullptr);
    if (code != SQLITE_OK) fail(code);
}

Statement::~Statement() {
    sqlite3_finalize(statement_);
}

void Statement::fail(int code) const {
    throw DatabaseError(code, message_of(database_, code));
}

Statement& Statement::bind(int parameter, std::int64_t value) {
    const int code = sqlite3_bind_int64(statement_, parameter, value);
    if (code != SQLITE_OK) fail(code);
    return *this;
}

Statement& Statement::bind(int parameter, std::string_view text) {
    const int code = sqlite3_bind_text64(statement_, parameter, text.data(), text.size(),
                                         SQLITE_TRANSIENT, SQLITE_UTF8);
    if (code != SQLITE_OK) fail(code);
    return *this;
}

Statement& Statement::bind_bytes(int parameter, std::string_view bytes) {
    const int code =
        sqlite3_bind_blob64(statement_, parameter, bytes.data(), bytes.size(), SQLITE_TRANSIENT);
    if (code != SQLITE_OK) fail(code);
    return *this;
}

bool Statement::step() {
    errno = 0;
    const int code = sqlite3_step(statement_);
    if (code == SQLITE_ROW) return true;
    if (code == SQLITE_DONE) return false;
    const int extended = sqlite3_extended_errcode(database_);
    throw DatabaseError(extended, message_of(database_, code));
}

void Statement::run() {
    while (step()) {
    }
    reset();
}

void Statement::reset() {
    sqlite3_reset(statement_);
}

std::int64_t Statement::integer(int column) const {
    return sqlite3_column_int64(statement_, column);
}

std::string Statement::text(int column) const {
    const void* bytes = sqlite3_column_blob(statement_, column);
    const int size = sqlite3_column_bytes(statement_, column);
    return bytes == nullptr
               ? std::string()
               : std::string(static_cast<const char*>(bytes), static_cast<std::size_t>(size));
}

std::size_t Statement::size(int column) const {
    return static_cast<std::size_t>(sqlite3_column_bytes(statement_, column));
}

// --- Connections ---------------------------------------------------------------------------------

Database::Database(const std::filesystem::path& named, Access access) : Database() {
    require_regular_files(named);
    errno = 0;
    // The folder may be reached through links, because the user made them. The file itself must not
    // be a link.
    std::error_code ignored;
    const std::filesystem::path whole = std::filesystem::absolute(named);
    const std::filesystem::path file =
        std::filesystem::weakly_canonical(whole.parent_path(), ignored) / whole.filename();
    const int rights = access == Access::create     ? SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE
                       : access == Access::existing ? SQLITE_OPEN_READWRITE
                                                    : SQLITE_OPEN_READONLY;
    // If the file has no log beside it, only the file is read, and SQLite writes nothing.
    const bool immutable =
        access == Access::reading && !std::filesystem::exists(file.string() + "-wal", ignored);
    const int code =
        sqlite3_open_v2(uri(file, immutable).c_str(), &database_,
                        rights | SQLITE_OPEN_URI | SQLITE_OPEN_NOMUTEX | no_links, nullptr);
    if (code != SQLITE_OK) throw DatabaseError(code, message_of(database_, code));
    distrust();
}

/// Protects against hostile files: they must not run their own views, triggers and functions, make
/// SQLite compute forever, or use corrupt data for an attack.
void Database::distrust() {
    for (const auto& [option, value] :
         {std::pair{SQLITE_DBCONFIG_DEFENSIVE, 1}, std::pair{SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0},
          std::pair{SQLITE_DBCONFIG_ENABLE_VIEW, 0}, std::pair{SQLITE_DBCONFIG_ENABLE_TRIGGER, 0},
          std::pair{SQLITE_DBCONFIG_DQS_DDL, 0}, std::pair{SQLITE_DBCONFIG_DQS_DML, 0}})
        sqlite3_db_config(database_, option, value, nullptr);
    for (const auto& [limit, value] :
         {std::pair{SQLITE_LIMIT_SQL_LENGTH, 100'000}, std::pair{SQLITE_LIMIT_COLUMN, 100},
          std::pair{SQLITE_LIMIT_EXPR_DEPTH, 20}, std::pair{SQLITE_LIMIT_COMPOUND_SELECT, 3},
          std::pair{SQLITE_LIMIT_VDBE_OP, 25'000}, std::pair{SQLITE_LIMIT_FUNCTION_ARG, 8},
          std::pair{SQLITE_LIMIT_ATTACHED, 0}, std::pair{SQLITE_LIMIT_TRIGGER_DEPTH, 1}})
        sqlite3_limit(database_, limit, value);
    // The limit is for each statement. The statements of Fettle need some thousands of operations.
    constexpr int max_operations = 200'000'000;
    sqlite3_progress_handler(
        database_, max_operations, [](void*) { return 1; }, nullptr);
    run("PRAGMA cell_size_check = ON");
}

Database Database::in_memory() {
    Database made;
    const int code = sqlite3_open_v2(":memory:", &made.database_,
                                     SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE, nullptr);
    if (code != SQLITE_OK) throw DatabaseError(code, message_of(made.database_, code));
    return made;
}

Database Database::of_bytes(std::string_view file) {
    Database made = in_memory();
    // The parameter of SQLite is not const, but a read-only database is not written to.
    auto* const bytes = reinterpret_cast<unsigned char*>(const_cast<char*>(file.data()));
    const auto size = static_cast<sqlite3_int64>(file.size());
    const int code =
        sqlite3_deserialize(made.database_, "main", bytes, size, size, SQLITE_DESERIALIZE_READONLY);
    if (code != SQLITE_OK) throw DatabaseError(code, message_of(made.database_, code));
    made.distrust();
    return made;
}

std::string Database::serialized() const {
    sqlite3_int64 size = 0;
    unsigned char* bytes = sqlite3_serialize(database_, "main", &size, 0);
    if (bytes == nullptr) throw DatabaseError(SQLITE_NOMEM, "out of memory");
    std::string text(reinterpret_cast<const char*>(bytes), static_cast<std::size_t>(size));
    sqlite3_free(bytes);
    return text;
}

Database::~Database() {
    sqlite3_close(database_);
}

void Database::run(const char* sql) {
    statement(sql).run();
}

std::int64_t Database::integer(const char* sql) {
    Statement query = statement(sql);
    return query.step() ? query.integer(0) : 0;
}

std::string Database::text(const char* sql) {
    Statement query = statement(sql);
    return query.step() ? query.text(0) : std::string();
}

std::int64_t Database::last_row() const {
    return sqlite3_last_insert_rowid(database_);
}

bool Database::read_only() const {
    return sqlite3_db_readonly(database_, "main") == 1;
}

void Database::wait_for_others(int milliseconds) {
    sqlite3_busy_timeout(database_, milliseconds);
}

DatabaseTransaction::DatabaseTransaction(Database& database) : database_(database) {
    // The transaction starts as a writer, because a reader cannot always become one.
    database_.run("BEGIN IMMEDIATE");
}

DatabaseTransaction::~DatabaseTransaction() {
    if (!open_) return;
    try {
        database_.run("ROLLBACK");
    } catch (const DatabaseError&) {  // SQLite has rolled back by itself
    }
}

void DatabaseTransaction::commit() {
    database_.run("COMMIT");
    open_ = false;
}

void set_format(Database& database, const FileFormat& format) {
    for (const std::string_view table : format.tables) database.run(std::string(table).c_str());
    database.run(("PRAGMA application_id = " + std::to_string(format.application)).c_str());
    database.run(("PRAGMA user_version = " + std::to_string(format.version)).c_str());
}

namespace {

/// While it lives, all reads see the state of the first read.
class Reading {
  public:
    explicit Reading(Database& database) : database_(database) { database_.run("BEGIN"); }
    ~Reading() {
        try {
            database_.run("ROLLBACK");
        } catch (const DatabaseError&) {  // SQLite has ended it by itself
        }
    }
    Reading(const Reading&) = delete;

  private:
    Database& database_;
};

void check_identity(std::int64_t application, std::int64_t version, const FileFormat& format) {
    if (application != format.application)
        throw std::runtime_error("it is a file of another program");
    if (version > format.version)
        throw std::runtime_error("it was written by a newer Fettle (version " +
                                 std::to_string(version) + " of the format, this one reads up to " +
                                 std::to_string(format.version) + ")");
}

}  // namespace

void check_header(std::string_view file, const FileFormat& format) {
    // https://sqlite.org/fileformat.html: numbers are big-endian.
    constexpr std::string_view magic{"SQLite format 3\0", 16};
    constexpr std::size_t size = 100, version_at = 60, application_at = 68;
    if (file.size() < size || !file.starts_with(magic))
        throw std::runtime_error("it is not a database");
    const auto number = [file](std::size_t at) {
        std::uint32_t value = 0;
        for (const char c : file.substr(at, sizeof value))
            value = value << 8 | static_cast<unsigned char>(c);
        return static_cast<std::int32_t>(value);
    };
    check_identity(number(application_at), number(version_at), format);
    if (number(version_at) < format.version)
        throw std::runtime_error(
            "it was written by an older Fettle (version " + std::to_string(number(version_at)) +
            " of the format, this one reads version " + std::to_string(format.version) + ")");
}

bool check_format(Database& database, const FileFormat& format) {
    // All checks see one state: another program may be creating the tables now.
    const Reading moment(database);
    const std::int64_t application = database.integer("PRAGMA application_id");
    const std::int64_t version = database.integer("PRAGMA user_version");
    const std::int64_t objects = database.integer("SELECT count(*) FROM sqlite_schema");
    if (application == 0 && version == 0 && objects == 0) return false;
    check_identity(application, version, format);
    std::size_t tables = 0;
    for (Statement each = database.statement("SELECT type, name, sql FROM sqlite_schema");
         each.step(); ++tables)
        if (each.text(0) != "table" || std::find(format.tables.begin(), format.tables.end(),
                                                 each.text(2)) == format.tables.end())
            throw std::runtime_error("it holds the " + each.text(0) + " \"" + each.text(1) +
                                     "\", which such a file does not have");
    if (tables != format.tables.size())
        throw std::runtime_error("it has fewer tables than such a file");
    if (const std::string found = database.text("PRAGMA quick_check(1)"); found != "ok")
        throw std::runtime_error("it is damaged (" + found + ")");
    return true;
}

}  // namespace fettle::property
