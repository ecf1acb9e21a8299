#pragma once
// Recordings: everything that came into a run from outside, with the hash of the state after every
// step, so that the run can be made again and be seen to be the same. docs/design/time.md tells the
// format.

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <fettle/app/loop.h>
#include <fettle/property/observer.h>

#include <fettle/app/export.h>

FETTLE_APP_BEGIN

namespace fettle::app {

/// A file that cannot be written, read, or understood. The message names it, and the line.
class RecordingError : public std::runtime_error {
  public:
    using runtime_error::runtime_error;
};

/// How a run began.
struct RunStart {
    std::filesystem::path game;
    std::vector<std::string> modules;  // named beside what the game itself names
    std::uint64_t seed = 0;
    double width = 0, height = 0;  // of the window, pixels
    std::vector<std::string> evals;
    std::vector<std::pair<std::uint64_t, std::string>> at;
    std::vector<std::vector<std::string>> tweaks;  // of earlier runs, each in words
};

/// A file that the run came upon: another one is not the same run.
struct RunFile {
    std::string name;
    std::optional<std::uint64_t> checksum{};  // nothing: there was no such file
    bool overwritten = false;                 // by the run itself; what it was is here
    std::optional<std::string> content{};
};

/// Writes a recording as the run goes on. What was written so far is a recording of the run so far,
/// whatever happens then.
class Recorder : public Witness, public property::Observer {
  public:
    /// Throws RecordingError.
    Recorder(const std::filesystem::path& file, const RunStart& start);
    ~Recorder() override;
    Recorder(const Recorder&) = delete;
    /// The game is loaded: from now on everything counts.
    void begin(property::Tree& tree, Loop& loop);

    void command(std::string_view command);
    void file(const RunFile& file);
    void event(const InputEvent& event, bool taken) override;
    void frame_begins(double seconds, std::int64_t step_limit) override;
    void turn_begins() override;
    void frame_ends() override;
    void stepped() override;

    void wrote(property::Handle instance, const property::Property& property,
               const property::Value& now) override;
    void was_reset(property::Handle instance, const property::Property& property) override;

    /// What went wrong with the file since, "" when nothing: a run is not ended by a full disk.
    const std::string& problem() const { return problem_; }

  private:
    bool writes_alone() const;
    void line(const std::string& text);
    void flush();

    std::filesystem::path file_;
    std::FILE* out_ = nullptr;
    std::string problem_;
    property::Tree* tree_ = nullptr;
    Loop* loop_ = nullptr;
    bool inside_ = false;  // a frame: what is written then comes from the game itself
};

/// A recording, read. Throws RecordingError for what is damaged, newer, or none.
class Recording {
  public:
    explicit Recording(const std::filesystem::path& file);
    ~Recording();
    const RunStart& start() const { return start_; }
    const std::vector<RunFile>& files() const { return files_; }
    /// How many steps it holds.
    std::uint64_t steps() const;

  private:
    friend class Replay;
    struct FETTLE_APP_PRIVATE Item;
    void read_start(const std::string& word, const std::string& rest, int number);
    bool read_file(const std::string& word, const std::string& rest);
    [[noreturn]] void fail(int number, const std::string& why) const;

    std::filesystem::path file_;
    RunStart start_;
    std::vector<RunFile> files_;
    std::vector<Item> items_;
};

/// Makes a recorded run again.
class Replay : public Witness {
  public:
    Replay(const Recording& recording, property::Tree& tree, script::Runtime& runtime, Loop& loop);
    ~Replay() override;
    /// Goes on to the end of the next frame. False when there is none.
    bool frame();
    /// The first difference, in a sentence; "" while there is none.
    const std::string& difference() const { return difference_; }
    /// Steps that were the same.
    std::uint64_t steps() const { return steps_; }

    void event(const InputEvent&, bool) override {}
    void frame_begins(double, std::int64_t) override {}
    void turn_begins() override {}
    void frame_ends() override {}
    void stepped() override;

  private:
    void feed(const Recording::Item& item);

    const Recording& recording_;
    property::Tree& tree_;
    script::Runtime& runtime_;
    Loop& loop_;
    std::size_t next_ = 0;
    std::uint64_t steps_ = 0;
    std::string difference_;
};

}  // namespace fettle::app

FETTLE_APP_END
