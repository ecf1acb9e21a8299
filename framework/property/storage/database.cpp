#include "database.h"

#include <sqlite3.h>

namespace fettle::property {

namespace {

std::string words(sqlite3* database, int code) {
    // The message of the connection says more than the code alone, when it is about this code.
    const bool told = database != nullptr && sqlite3_errcode(database) == (code & 0xff);
    std::string text = told ? sqlite3_errmsg(database) : sqlite3_errstr(code);
    if ((code & 0xff) == SQLITE_IOERR) text += " (" + std::to_string(code) + ")";
    return text;
}

/// As SQLite's URIs want it.
std::string uri(const std::filesystem::path& file, bool immutable) {
    static constexpr std::string_view digits = "0123456789ABCDEF";
    std::string out = "file:";
    for (const char c : std::filesystem::absolute(file).string()) {
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
    throw DatabaseError(code, words(database_, code));
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
    const int code = sqlite3_step(statement_);
    if (code == SQLITE_ROW) return true;
    if (code == SQLITE_DONE) return false;
    const int extended = sqlite3_extended_errcode(database_);
    throw DatabaseError(extended, words(database_, code));
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

Database::Database(const std::filesystem::path& file, Access access) {
    const int rights = access == Access::create     ? SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE
                       : access == Access::existing ? SQLITE_OPEN_READWRITE
                                                    : SQLITE_OPEN_READONLY;
    // Without a log beside it nothing but the file itself needs to be read, and nothing is written.
    std::error_code ignored;
    const bool immutable =
        access == Access::reading && !std::filesystem::exists(file.string() + "-wal", ignored);
    const int code = sqlite3_open_v2(uri(file, immutable).c_str(), &database_,
                                     rights | SQLITE_OPEN_URI | SQLITE_OPEN_NOMUTEX, nullptr);
    if (code == SQLITE_OK) return;
    const DatabaseError error(code, words(database_, code));
    sqlite3_close(database_);
    throw error;
}

Database Database::in_memory() {
    Database made;
    const int code = sqlite3_open_v2(":memory:", &made.database_,
                                     SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE, nullptr);
    if (code != SQLITE_OK) throw DatabaseError(code, words(made.database_, code));
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

Transaction::Transaction(Database& database) : database_(database) {
    // At once the one writer: a transaction that began by reading could not always become it.
    database_.run("BEGIN IMMEDIATE");
}

Transaction::~Transaction() {
    if (!open_) return;
    try {
        database_.run("ROLLBACK");
    } catch (const DatabaseError&) {  // SQLite has rolled back by itself
    }
}

void Transaction::commit() {
    database_.run("COMMIT");
    open_ = false;
}

void set_format(Database& database, const FileFormat& format) {
    database.run(("PRAGMA application_id = " + std::to_string(format.application)).c_str());
    database.run(("PRAGMA user_version = " + std::to_string(format.version)).c_str());
}

bool check_format(Database& database, const FileFormat& format) {
    const std::int64_t application = database.integer("PRAGMA application_id");
    const std::int64_t version = database.integer("PRAGMA user_version");
    if (application == 0 && version == 0 &&
        database.integer("SELECT count(*) FROM sqlite_schema") == 0)
        return false;
    if (application != format.application)
        throw std::runtime_error("it is a file of another program");
    if (version > format.version)
        throw std::runtime_error("it was written by a newer Fettle (version " +
                                 std::to_string(version) + " of the format, this one reads up to " +
                                 std::to_string(format.version) + ")");
    if (const std::string found = database.text("PRAGMA quick_check(1)"); found != "ok")
        throw std::runtime_error("it is damaged (" + found + ")");
    return true;
}

}  // namespace fettle::property
