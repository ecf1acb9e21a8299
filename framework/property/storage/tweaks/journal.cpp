#include <tweaks/journal.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
#include <thread>
#include <utility>

#include <database/checkpoints.h>
#include <files/file_access.h>

namespace fettle::property {

namespace fs = std::filesystem;

namespace {

const FileFormat journal_format{
    .application = 0x4654574b,  // "FTWK"
    .version = 1,
    .tables = {"CREATE TABLE runs (id INTEGER PRIMARY KEY, started INTEGER, process INTEGER)",
               "CREATE TABLE tweaks (run INTEGER, number INTEGER, kind INTEGER, state INTEGER, "
               "instance TEXT, property TEXT, was TEXT, now TEXT, was_text TEXT, now_text TEXT, "
               "step INTEGER, time INTEGER, file TEXT, inside TEXT, kept_in TEXT, PRIMARY KEY "
               "(run, number)) WITHOUT ROWID"}};
constexpr int max_files = 9;
constexpr int io_error = 10;        // an error code of SQLite that does not concern the file
constexpr int long_timeout = 2000;  // ms; for opening a file and for the last commit

std::uint64_t identity_of(const fs::path& file) {
    struct stat status {};
    return ::stat(file.c_str(), &status) == 0 ? static_cast<std::uint64_t>(status.st_ino) : 0;
}

/// Uses the effective user id, unlike `access`.
bool may_write(const fs::path& file) {
    return ::faccessat(AT_FDCWD, file.c_str(), W_OK, AT_EACCESS) == 0;
}

void make_tables(Database& database) {
    DatabaseTransaction transaction(database);
    // Another run may have made the tables meanwhile.
    if (database.integer("SELECT count(*) FROM sqlite_schema") == 0)
        set_format(database, journal_format);
    transaction.commit();
}

}  // namespace

class Journal::Checkpoints : public CheckpointThread {
    using CheckpointThread::CheckpointThread;
};

Journal::Journal(std::vector<fs::path> folders, std::string name, Warn warn)
    : folders_(std::move(folders)), name_(std::move(name)), warn_(std::move(warn)) {
    leave_out_unusable_folders();
    find_existing();
}

Journal::~Journal() {
    // The last connection that closes decides about synchronization, so the connection of the
    // checkpoint thread must be the last.
    database_.reset();
    checkpoints_.reset();
}

fs::path Journal::candidate(const fs::path& folder, int number) const {
    return folder / (name_ + (number > 1 ? "." + std::to_string(number) : "") + ".sqlite");
}

/// Opens the journal. Returns "" on success, otherwise the reason. A file that can only be read is
/// added to the list of such files. Throws DatabaseError if other programs keep writing to it.
std::string Journal::open(const fs::path& file, Access access) {
    using std::chrono::milliseconds, std::chrono::steady_clock;
    const auto deadline = steady_clock::now() + milliseconds(long_timeout);
    while (true) try {
            return try_to_open(file, access);
        } catch (const DatabaseError& error) {
            // While another connection enables the write-ahead log, SQLite does not wait by itself.
            if (!error.busy() || steady_clock::now() > deadline) throw;
            std::this_thread::sleep_for(milliseconds(2));
        }
}

std::string Journal::try_to_open(const fs::path& file, Access access) {
    try {
        auto database = std::make_unique<Database>(file, access);
        database->wait_for_others(long_timeout);
        const bool made = check_format(*database, journal_format);
        if (database->read_only()) throw std::runtime_error("it can only be read");
        database->run("PRAGMA synchronous = OFF");
        if (database->text("PRAGMA journal_mode = WAL") != "wal")
            throw DatabaseError(io_error, "its file system allows no write-ahead log");
        if (!made) make_tables(*database);
        database->run("PRAGMA wal_autocheckpoint = 0");
        database->wait_for_others(timeout_);
        database_ = std::move(database);
        file_ = file;
        identity_ = identity_of(file);
        return {};
    } catch (const DatabaseError& error) {
        if (error.busy()) throw;  // another file would not help
        if (error.damaged()) unusable_.insert(file);
        return error.what();
    } catch (const std::runtime_error& error) {
        unusable_.insert(file);
        return error.what();
    }
}

/// Adds a journal in a read-only folder to the list of journals that can only be read.
bool Journal::can_be_read(const fs::path& file) {
    unusable_.insert(file);
    try {
        Database database(file, Access::reading);
        if (!check_format(database, journal_format)) return false;
    } catch (const std::runtime_error&) {
        return false;
    }
    if (may_write(file) && may_write(file.parent_path())) return false;
    unwritable_.push_back(file);
    return true;
}

void Journal::leave_out_unusable_folders() {
    std::erase_if(folders_, [this](const fs::path& folder) {
        struct stat status {};
        if (::lstat(folder.c_str(), &status) != 0 || S_ISDIR(status.st_mode)) return false;
        const std::string why =
            S_ISREG(status.st_mode) ? "it is a file" : why_no_file(status.st_mode);
        warn_(folder.string() + ": expected a folder for the journal of tweaks, but " +
              why.substr(0, why.find(',')) + "; it is left as it is");
        return true;
    });
}

void Journal::find_existing() {
    std::error_code ignored;
    for (const fs::path& folder : folders_)
        for (int number = 1; number <= max_files && !database_; ++number) {
            const fs::path file = candidate(folder, number);
            if (!fs::exists(file, ignored)) continue;
            std::string problem;
            try {
                problem = open(file, Access::existing);
            } catch (const DatabaseError&) {
                return;  // the first commit tries again
            }
            if (problem.empty() || can_be_read(file)) continue;
            unusable_.insert(file);
            warn_(file.string() + ": this journal of tweaks cannot be used: " + problem +
                  "; it is left as it is");
        }
}

void Journal::create() {
    std::string reasons;
    for (const fs::path& folder : folders_) {
        std::error_code error;
        fs::create_directories(folder, error);
        if (!error && !may_write(folder)) error.assign(errno, std::generic_category());
        std::string problem = error ? error.message() : std::string();
        for (int number = 1; number <= max_files && problem.empty(); ++number) {
            const fs::path file = candidate(folder, number);
            if (unusable_.contains(file)) continue;
            // Another run may have made the file in the meantime.
            problem = open(file, Access::create);
            if (problem.empty()) {
                if (!reasons.empty())
                    warn_("tweaks are journaled in " + file.string() + " (" + reasons + ")");
                return;
            }
            if (unusable_.contains(file)) problem.clear();
        }
        reasons += (reasons.empty() ? "" : "; ") + folder.string() + ": " + problem;
    }
    throw std::runtime_error(reasons.empty() ? "there is no folder it could be written in"
                                             : reasons);
}

void Journal::begin_run() {
    const auto now = std::chrono::system_clock::now().time_since_epoch();
    database_->statement("INSERT INTO runs (started, process) VALUES (?, ?)")
        .bind(1, std::chrono::duration_cast<std::chrono::seconds>(now).count())
        .bind(2, static_cast<std::int64_t>(::getpid()))
        .run();
    run_ = database_->last_row();
}

void Journal::read_rows(Database& from, std::vector<JournalRow>& rows) {
    Statement query = from.statement(
        "SELECT run, number, kind, state, instance, property, was, now, was_text, now_text, step, "
        "time, file, inside, kept_in FROM tweaks WHERE run <> ? AND state = 0 ORDER BY run, "
        "number");
    query.bind(1, run_);
    while (query.step()) {
        JournalRow& row = rows.emplace_back();
        row.run = query.integer(0);
        row.number = query.integer(1);
        const std::int64_t kind = query.integer(2);
        row.kind = static_cast<JournalRow::Kind>(kind >= 0 && kind <= 4 ? kind : UINT8_MAX);
        row.state = static_cast<JournalRow::State>(query.integer(3));
        row.instance = query.text(4);
        row.property = query.text(5);
        row.was = query.text(6);
        row.now = query.text(7);
        row.was_text = query.text(8);
        row.now_text = query.text(9);
        row.step = query.integer(10);
        row.time = query.integer(11);
        row.file = query.text(12);
        row.inside = query.text(13);
        row.kept_in = query.text(14);
    }
}

std::vector<JournalRow> Journal::earlier() {
    std::vector<JournalRow> rows;
    const auto read = [&](Database& from, const fs::path& file) {
        try {
            read_rows(from, rows);
        } catch (const DatabaseError& error) {
            warn_(file.string() + ": cannot be read: " + error.what());
        }
    };
    for (const fs::path& file : unwritable_) {
        try {
            Database database(file, Access::reading);
            const std::size_t known = rows.size();
            read(database, file);
            // The state of these rows cannot be updated in that file, and its run numbers mean
            // nothing here.
            for (std::size_t i = known; i < rows.size(); ++i) rows[i].run = JournalRow::elsewhere;
        } catch (const DatabaseError& error) {
            warn_(file.string() + ": cannot be read: " + error.what());
        }
    }
    if (database_) read(*database_, file_);
    return rows;
}

void Journal::refresh(std::deque<JournalRow>& rows) {
    if (!database_) return;
    try {
        Statement query = database_->statement(
            "SELECT state, was, now, was_text, now_text, step, time, file, inside, kept_in FROM "
            "tweaks "
            "WHERE run = ? AND number = ?");
        for (JournalRow& row : rows) {
            if (row.run < 0 || row.state != JournalRow::State::open) continue;
            query.bind(1, row.run).bind(2, row.number);
            JournalRow now = row;
            if (query.step()) {
                now.state =
                    query.integer(0) == 0 ? JournalRow::State::open : JournalRow::State::kept;
                now.was = query.text(1);
                now.now = query.text(2);
                now.was_text = query.text(3);
                now.now_text = query.text(4);
                now.step = query.integer(5);
                now.time = query.integer(6);
                now.file = query.text(7);
                now.inside = query.text(8);
                now.kept_in = query.text(9);
            } else {
                now.state = JournalRow::State::dropped;  // undone by its own run
            }
            query.reset();
            row = std::move(now);
        }
    } catch (const DatabaseError&) {  // they stay as they are
    }
}

void Journal::write(const Changes& changes) {
    Statement put = database_->statement(
        "INSERT OR REPLACE INTO tweaks VALUES (?,?,?,?,?,?,?,?,?,?,?,?,?,?,?)");
    for (const JournalRow* row : changes.put) {
        put.bind(1, run_)
            .bind(2, row->number)
            .bind(3, static_cast<std::int64_t>(row->kind))
            .bind(4, static_cast<std::int64_t>(row->state))
            .bind(5, row->instance)
            .bind(6, row->property)
            .bind(7, row->was)
            .bind(8, row->now)
            .bind(9, row->was_text)
            .bind(10, row->now_text)
            .bind(11, row->step)
            .bind(12, row->time)
            .bind(13, row->file)
            .bind(14, row->inside)
            .bind(15, row->kept_in);
        put.run();
    }
    Statement withdraw = database_->statement("DELETE FROM tweaks WHERE run = ? AND number = ?");
    for (const std::int64_t number : changes.withdrawn)
        withdraw.bind(1, run_).bind(2, number).run();
    for (const JournalRow* row : changes.removed)
        withdraw.bind(1, row->run).bind(2, row->number).run();
    // The condition compares the content, because the run of the row may still change it.
    Statement settle = database_->statement(
        "UPDATE tweaks SET state = ?, kept_in = ? WHERE run = ? AND number = ? AND now = "
        "?");
    for (const JournalRow* row : changes.settled)
        settle.bind(1, static_cast<std::int64_t>(row->state))
            .bind(2, row->kept_in)
            .bind(3, row->run)
            .bind(4, row->number)
            .bind(5, row->now)
            .run();
    Statement rename = database_->statement(
        "UPDATE tweaks SET instance = ?, inside = ?, was = ?, was_text = ? WHERE run = ? "
        "AND number = ? AND now = ?");
    for (const JournalRow* row : changes.renamed)
        rename.bind(1, row->instance)
            .bind(2, row->inside)
            .bind(3, row->was)
            .bind(4, row->was_text)
            .bind(5, row->run)
            .bind(6, row->number)
            .bind(7, row->now)
            .run();
}

bool Journal::commit(const Changes& changes) {
    try {
        if (!database_) create();
        if (!checkpoints_) checkpoints_ = std::make_unique<Checkpoints>(file_);
        const std::int64_t known = run_;
        DatabaseTransaction transaction(*database_);
        if (run_ == 0) begin_run();
        try {
            write(changes);
            transaction.commit();
        } catch (...) {
            run_ = known;
            throw;
        }
    } catch (const DatabaseError& error) {
        if (error.busy()) return false;
        throw error.at(file_);
    }
    checkpoints_->notify();
    return true;
}

void Journal::wait_longer() {
    timeout_ = long_timeout;
    if (database_) database_->wait_for_others(timeout_);
}

bool Journal::vanished() {
    if (!database_ || identity_of(file_) == identity_) return false;
    database_.reset();
    checkpoints_.reset();
    run_ = 0;
    return true;
}

}  // namespace fettle::property
