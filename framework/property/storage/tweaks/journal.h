#pragma once
// The journal of tweaks: a SQLite file with one row per edit by a person. It is written in one
// transaction per barrier, without waiting for the disk, so committed edits survive a crash of the
// process. A second thread with its own connection synchronizes with the disk and empties the
// write-ahead log.

#include <cstdint>
#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <database/database.h>

namespace fettle::property {

/// A row of the journal. Each run numbers its own rows.
struct JournalRow {
    /// `restored`: the undo of a deletion that was already kept.
    enum class Kind : std::uint8_t { value, created, deleted, moved, restored };
    enum class State : std::uint8_t { open, kept, dropped };

    static constexpr std::int64_t elsewhere = -1;  // value of `run` for rows of a read-only journal
    // Of a row of this run (`number`) whose edit the game has left behind by going back in time.
    static constexpr std::int64_t left_behind = -2;
    std::int64_t run = 0;
    std::int64_t number = 0;
    Kind kind = Kind::value;
    State state = State::open;
    std::string instance;  // path of the instance; for a deletion and a move, its home path
    std::string property;  // "" unless kind is value
    /// The old and the new value, encoded as in image.h. For a creation, `now` is the text of a
    /// scene. For a move, `now` is the new path. For a row of kind `restored`, `was` is the text
    /// that the deletion removed from a file, and `now` is the text of a scene.
    std::string was, now;
    std::string was_text, now_text;  // the same values in readable form
    std::int64_t step = 0;
    std::int64_t time = 0;  // seconds since 1970
    std::string file;       // scene file of the instance; "" if a script made it
    std::string inside;     // path of the instance within that file
    std::string kept_in;    // name of the file into which the tweak was kept
};

class Journal {
  public:
    using Warn = std::function<void(const std::string&)>;

    /// The file is `name`.sqlite in the first folder where it can be written. Nothing is created
    /// before the first commit. An unusable file is left unchanged and reported to `warn`, and
    /// another name (`name`.2.sqlite) is used. A folder that is a link is not followed.
    Journal(std::vector<std::filesystem::path> folders, std::string name, Warn warn);
    ~Journal();
    Journal(const Journal&) = delete;
    Journal& operator=(const Journal&) = delete;

    /// Returns the rows of earlier runs whose state is `open`, oldest first.
    std::vector<JournalRow> earlier();

    /// Reads the states of these rows of earlier runs again, because other running programs may
    /// have changed them.
    void refresh(std::deque<JournalRow>& rows);

    struct Changes {
        std::vector<const JournalRow*> put;      // new or changed rows of this run
        std::vector<std::int64_t> withdrawn;     // numbers of rows of this run to be deleted
        std::vector<const JournalRow*> settled;  // rows of other runs that are now kept or dropped
        std::vector<const JournalRow*> renamed;  // open rows of other runs: files got other names
        std::vector<const JournalRow*> removed;  // invalid rows of other runs to be deleted
    };
    /// Commits all changes or none. False if another program is writing now. Throws DatabaseError.
    bool commit(const Changes& changes);
    /// After this, a commit waits up to some seconds for another program, because it may be the
    /// last commit of this run.
    void wait_longer();
    /// True if the file was removed or replaced: the rows of this run must be put again.
    bool vanished();
    std::int64_t run() const { return run_; }
    /// Path of the journal; empty before the first commit.
    const std::filesystem::path& file() const { return file_; }

  private:
    class Checkpoints;
    std::filesystem::path candidate(const std::filesystem::path& folder, int number) const;
    std::string open(const std::filesystem::path& file, Access access);
    std::string try_to_open(const std::filesystem::path& file, Access access);
    bool can_be_read(const std::filesystem::path& file);
    void leave_out_unusable_folders();
    void find_existing();
    void create();
    void begin_run();
    /// Writes into the database, within the transaction of a commit.
    void write(const Changes& changes);
    void read_rows(Database& from, std::vector<JournalRow>& rows);

    std::vector<std::filesystem::path> folders_;
    std::string name_;
    Warn warn_;
    std::filesystem::path file_;
    std::uint64_t identity_ = 0;  // identity of the file, to detect that it was replaced
    std::unique_ptr<Database> database_;
    std::unique_ptr<Checkpoints> checkpoints_;
    std::set<std::filesystem::path> unusable_;
    std::vector<std::filesystem::path> unwritable_;  // read-only journals
    std::int64_t run_ = 0;
    int timeout_ = 20;  // ms; short, because a frame must not wait
};

}  // namespace fettle::property
