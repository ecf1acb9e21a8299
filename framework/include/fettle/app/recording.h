#pragma once
// Recordings: all input of a run, with hashes of the state after steps, so that the run can be
// repeated and compared. docs/design/time.md has the format.

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

/// A file that cannot be written, read, or parsed. The message names the file and the line.
class RecordingError : public std::runtime_error {
  public:
    using runtime_error::runtime_error;
};

/// Start of a run.
struct RunStart {
    std::filesystem::path game;
    std::vector<std::string> modules;  // in addition to those that the game names
    std::uint64_t seed = 0;
    double width = 0, height = 0;  // of the window, pixels
    std::vector<std::string> evals;
    std::vector<std::pair<std::uint64_t, std::string>> at;
    std::vector<std::vector<std::string>> tweaks;  // of earlier runs, each as a list of words
    std::vector<std::string> test{};  // the file and the name of the test that the run is; or empty
};

/// A file that the run has read, so that the run depends on its content.
struct RunFile {
    std::string name;
    std::optional<std::uint64_t> checksum{};  // none: the file did not exist
    bool overwritten = false;                 // by the run itself; `content` is the old one
    std::optional<std::string> content{};
};

/// Records a run from its beginning, in memory, and in a file as soon as one is wanted. At any
/// moment the file is a valid recording of the run so far.
class Recorder : public LoopObserver, public property::Observer {
  public:
    explicit Recorder(const RunStart& start);
    ~Recorder() override;
    Recorder(const Recorder&) = delete;
    /// Begins recording, after the game was loaded.
    void begin(property::Tree& tree, Loop& loop);

    /// Writes the run so far into the file, which it replaces, and then all that follows. From here
    /// on the recording has the hashes of the state after every `hash_steps` steps, 1 or more.
    /// Throws RecordingError, also if the run is not completely in memory.
    void write_to(const std::filesystem::path& file, std::uint64_t hash_steps = 1);
    /// Ends the file. `write_to` may write the run again.
    void close();
    /// The file that is being written; "" if there is none.
    std::filesystem::path writes_to() const {
        return out_ != nullptr ? file_ : std::filesystem::path();
    }
    /// Ends the recording, because a replay cannot repeat what follows: `why`.
    void end(const std::string& why);
    /// Whether all of the run is in `text()`.
    bool complete() const { return incomplete_.empty(); }
    /// Why it is not; "" if it is.
    const std::string& incomplete() const { return incomplete_; }
    /// The recording of the run so far; "" if it is not complete.
    const std::string& text() const { return text_; }

    void command(std::string_view command);
    /// The instances that are selected in the console when the next command runs; the last one is
    /// `it`. Nothing is written if it is the same as before.
    void selected(const std::vector<property::Handle>& instances);
    void file(const RunFile& file);
    void event(const InputEvent& event, bool taken) override;
    void frame_begins(double seconds, std::int64_t step_limit) override;
    void turn_begins() override;
    void frame_ends() override;
    void stepped() override;

    void wrote(property::Handle instance, const property::Property& property,
               const property::Value& now) override;
    void was_reset(property::Handle instance, const property::Property& property) override;
    void removed(property::Handle instance, const property::Property& property) override;
    void edit_begins(const std::string& name, bool scripts) override;
    void edit_ends() override;

    /// The error of writing the file, "" if there is none. Such an error ends neither the run nor
    /// the recording in memory.
    const std::string& problem() const { return problem_; }

  private:
    bool writes_alone() const;
    /// "write", "reset" or "removed", with the writer, the instance and the name.
    std::string edit_text(const char* word, property::Handle instance,
                          const property::Property& property) const;
    void line(const std::string& text);
    void write(std::string_view text);
    void flush();
    void note_problem();

    std::string text_;
    std::string incomplete_;
    std::filesystem::path file_;
    std::uint64_t hash_steps_ = 1;
    std::FILE* out_ = nullptr;
    std::string problem_;
    property::Tree* tree_ = nullptr;
    Loop* loop_ = nullptr;
    std::vector<property::Handle> selected_;  // as it was written last
    std::vector<bool> edits_;                 // that are open: whether they are recorded
};

/// A recording read from a file. Throws RecordingError if the file is damaged, has a newer format,
/// or is not a recording.
class Recording {
  public:
    explicit Recording(const std::filesystem::path& file);
    ~Recording();
    const RunStart& start() const { return start_; }
    const std::vector<RunFile>& files() const { return files_; }
    /// Number of its steps.
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

/// Repeats a recorded run.
class Replay : public LoopObserver {
  public:
    Replay(const Recording& recording, property::Tree& tree, script::Runtime& runtime, Loop& loop);
    ~Replay() override;
    /// Receives the instances that were selected in the console when a command ran. Without this
    /// function, the last of them becomes `it`.
    void on_selected(std::function<void(const std::vector<property::Handle>&)> select) {
        select_ = std::move(select);
    }
    /// Runs to the end of the next frame. False if there is none.
    bool frame();
    /// The first difference, as a sentence; "" if there is none.
    const std::string& difference() const { return difference_; }
    /// Number of steps without a difference.
    std::uint64_t steps() const { return steps_; }

    void event(const InputEvent&, bool) override {}
    void frame_begins(double, std::int64_t) override {}
    void turn_begins() override {}
    void frame_ends() override {}
    void stepped() override;

  private:
    void feed(const Recording::Item& item);
    /// Compares the hashes in the recording with those of the present state.
    void compare(const Hashes& then, const std::string& step);

    const Recording& recording_;
    property::Tree& tree_;
    script::Runtime& runtime_;
    Loop& loop_;
    std::function<void(const std::vector<property::Handle>&)> select_;
    std::size_t next_ = 0;
    std::uint64_t steps_ = 0;
    std::string difference_;
};

}  // namespace fettle::app

FETTLE_APP_END
