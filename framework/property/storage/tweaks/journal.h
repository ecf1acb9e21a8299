#pragma once
// The journal of tweaks: a SQLite file in which every edit by a person is a row. It is written in
// one transaction a barrier, without waiting for the disk, so what was committed survives the death
// of the process; another thread, with a connection of its own, synchronizes with the disk and
// empties the write-ahead log.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <database/database.h>

namespace fettle::property {

/// A row of the journal. A run numbers its own rows.
struct JournalRow {
    /// `restored`: a deletion that was kept has been undone since.
    enum class Kind : std::uint8_t { value, created, deleted, moved, restored };
    enum class State : std::uint8_t { open, kept, dropped };

    static constexpr std::int64_t elsewhere = -1;  // as `run`: of a journal that can only be read
    std::int64_t run = 0;
    std::int64_t number = 0;
    Kind kind = Kind::value;
    State state = State::open;
    std::string instance;  // path; of a deletion and of a move, the one that the files give it
    std::string property;  // "" unless kind is value
    /// As image.h writes them. `now` of a creation: a scene; of a move: the path. Of a restoration,
    /// `was` is what its deletion took out of a file, and `now` a scene.
    std::string was, now;
    std::string was_text, now_text;  // for people
    std::int64_t step = 0;
    std::int64_t time = 0;  // seconds since 1970
    std::string file;       // the scene file the instance came from; "" when a script made it
    std::string inside;     // where in that file
    std::string kept_in;    // the file it was kept in
};

class Journal {
  public:
    using Warn = std::function<void(const std::string&)>;

    /// The file is `name`.sqlite in the first of the folders it can be written in; nothing is
    /// created before the first commit. A file that cannot be used is left as it is, `warn` is
    /// told, and another one (`name`.2.sqlite) is taken. A link in the place of one of the folders
    /// is not followed.
    Journal(std::vector<std::filesystem::path> folders, std::string name, Warn warn);
    ~Journal();
    Journal(const Journal&) = delete;
    Journal& operator=(const Journal&) = delete;

    /// Rows of earlier runs that are still open, oldest first.
    std::vector<JournalRow> earlier();

    /// Brings rows of earlier runs up to what the journal says now: a run that is still there, or
    /// another one, may have changed them since.
    void refresh(std::vector<JournalRow>& rows);

    struct Changes {
        std::vector<const JournalRow*> put;      // rows of this run, new ones or new contents
        std::vector<std::int64_t> withdrawn;     // rows of this run, by number
        std::vector<const JournalRow*> settled;  // rows of other runs that are not open any more
        std::vector<const JournalRow*> removed;  // rows of other runs that are no tweaks
    };
    /// All of it or nothing. False when another program is writing just now. Throws DatabaseError.
    bool commit(const Changes& changes);
    /// From now on a commit waits some seconds for another program that is writing: there may be no
    /// next one.
    void be_patient();
    /// True when the file was removed behind our back: rows of this run must be put again.
    bool vanished();
    std::int64_t run() const { return run_; }
    /// Where rows go; empty before the first.
    const std::filesystem::path& file() const { return file_; }

  private:
    class Checkpoints;
    std::filesystem::path candidate(const std::filesystem::path& folder, int number) const;
    std::string open(const std::filesystem::path& file, Access access);
    std::string try_to_open(const std::filesystem::path& file, Access access);
    bool can_be_read(const std::filesystem::path& file);
    void leave_out_odd_folders();
    void find_existing();
    void create();
    void begin_run();
    void read_rows(Database& from, std::vector<JournalRow>& rows);

    std::vector<std::filesystem::path> folders_;
    std::string name_;
    Warn warn_;
    std::filesystem::path file_;
    std::uint64_t identity_ = 0;  // of the file, to notice that the name leads to another one
    std::unique_ptr<Database> database_;
    std::unique_ptr<Checkpoints> checkpoints_;
    std::set<std::filesystem::path> unusable_;
    std::vector<std::filesystem::path> unwritable_;  // journals that can only be read
    std::int64_t run_ = 0;
    int patience_ = 20;  // ms; a frame must not wait
};

}  // namespace fettle::property
