// Writes recordings. A reader ignores a last line without a line end, so every recorded line is
// complete.

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <utility>

#include <fettle/app/recording.h>

#include <time/recording_text.h>

namespace fettle::app {

namespace {

/// Of the text that is kept in memory: more than two hours of frames.
constexpr std::size_t greatest_text = 64 << 20;  // bytes

}  // namespace

Recorder::Recorder(const RunStart& start) {
    line("fettle-recording " + std::to_string(recording_format));
    line("game " + in_quotes(start.game.string()));
    for (const std::string& module : start.modules) line("module " + in_quotes(module));
    line("seed " + hex(start.seed));
    line("screen " + exact(start.width) + " " + exact(start.height));
    for (const std::string& chunk : start.evals) line("eval " + in_quotes(chunk));
    for (const auto& [step, chunk] : start.at)
        line("at " + std::to_string(step) + " " + in_quotes(chunk));
    for (const std::vector<std::string>& words : start.tweaks) {
        std::string text = "tweak";
        for (const std::string& word : words) text += " " + in_quotes(word);
        line(text);
    }
    if (!start.test.empty()) {
        std::string text = "test";
        for (const std::string& word : start.test) text += " " + in_quotes(word);
        line(text);
    }
    line("begin");
}

Recorder::~Recorder() {
    if (loop_ != nullptr) loop_->set_observer(nullptr);
    if (tree_ != nullptr) tree_->unobserve(*this);
    close();
}

void Recorder::begin(property::Tree& tree, Loop& loop) {
    tree_ = &tree;
    loop_ = &loop;
    tree.observe(*this);
    loop.set_observer(this);
}

void Recorder::write_to(const std::filesystem::path& file, std::uint64_t hash_steps) {
    if (!complete()) throw RecordingError(file.string() + ": cannot be written: " + incomplete_);
    close();
    out_ = std::fopen(file.c_str(), "wb");
    if (out_ == nullptr)
        throw RecordingError(file.string() + ": cannot be written: " + std::strerror(errno));
    file_ = file;
    hash_steps_ = std::max<std::uint64_t>(hash_steps, 1);
    problem_.clear();
    write(text_);
    flush();
    if (problem_.empty()) return;
    close();
    throw RecordingError(problem_);
}

void Recorder::close() {
    if (out_ == nullptr) return;
    if (std::fclose(std::exchange(out_, nullptr)) != 0) note_problem();
}

void Recorder::end(const std::string& why) {
    close();
    incomplete_ = why;
    text_ = {};
}

void Recorder::note_problem() {
    if (problem_.empty())
        problem_ = file_.string() + ": the recording ends here: " + std::strerror(errno);
}

void Recorder::write(std::string_view text) {
    if (out_ == nullptr || !problem_.empty()) return;
    if (std::fwrite(text.data(), 1, text.size(), out_) != text.size()) note_problem();
}

void Recorder::line(const std::string& text) {
    if (complete()) {
        text_ += text;
        text_ += '\n';
    }
    write(text);
    write("\n");
    // Only the text in memory is limited: a file that is being written gets all lines.
    if (text_.size() > greatest_text) {
        incomplete_ = "only the first " + std::to_string(greatest_text >> 20) +
                      " MB of a recording are kept, and this run is longer";
        text_ = {};
    }
}

void Recorder::flush() {
    if (out_ != nullptr && problem_.empty() && std::fflush(out_) != 0) note_problem();
}

void Recorder::event(const InputEvent& event, bool taken) {
    line(event_text(event, taken));
    if (event.kind == EventKind::closing) flush();
}

void Recorder::command(std::string_view command) {
    line("command " + in_quotes(command));
    flush();
}

void Recorder::selected(const std::vector<property::Handle>& instances) {
    if (instances.empty() || instances == selected_) return;
    selected_ = instances;
    std::string text = "selected";
    for (const property::Handle each : instances) text += " " + encoded(property::Value(each));
    line(text);
}

void Recorder::file(const RunFile& file) {
    std::string text = (file.overwritten ? "overwritten " : "file ") + in_quotes(file.name);
    if (file.overwritten && file.content)
        text += " " + in_quotes(*file.content);
    else if (!file.overwritten && file.checksum)
        text += " " + hex(*file.checksum);
    line(text);
    // The file itself is overwritten next, so its old content must be on disk before.
    if (file.overwritten) flush();
}

void Recorder::frame_begins(double seconds, std::int64_t step_limit) {
    line("frame " + exact(seconds) + " " + std::to_string(step_limit));
    tree_->unobserve(*this);
}

void Recorder::turn_begins() {
    line("turn");
    tree_->unobserve(*this);
}

void Recorder::frame_ends() {
    tree_->observe(*this);
    flush();
}

void Recorder::stepped() {
    std::string text = "step " + std::to_string(tree_->step());
    // Hashes cost more than everything else, so text that may never be written has none.
    if (out_ != nullptr && tree_->step() % hash_steps_ == 0)
        for (const auto& [part, hash] : loop_->hashes()) text += " " + part + " " + hex(hash);
    line(text);
}

// Whether a write came from the inspector or another layer. Commands (with the undo that they
// call), events and formulas repeat their own writes in a replay, so those are not recorded. The
// tree is observed between two frames only: inside a frame the game itself writes.
bool Recorder::writes_alone() const {
    const property::Cause cause = tree_->cause();
    return !loop_->script_runs() && cause.writer != property::Writer::console &&
           cause.writer != property::Writer::formula && cause.where != "window";
}

std::string Recorder::edit_text(const char* word, property::Handle instance,
                                const property::Property& property) const {
    return std::string(word) + " " + std::to_string(static_cast<int>(tree_->cause().writer)) + " " +
           encoded(property::Value(instance)) + " " + in_quotes(property.name);
}

void Recorder::wrote(property::Handle instance, const property::Property& property,
                     const property::Value& now) {
    if (writes_alone()) line(edit_text("write", instance, property) + " " + encoded(now));
}

void Recorder::was_reset(property::Handle instance, const property::Property& property) {
    if (writes_alone()) line(edit_text("reset", instance, property));
}

void Recorder::removed(property::Handle instance, const property::Property& property) {
    if (writes_alone()) line(edit_text("removed", instance, property));
}

void Recorder::edit_begins(const std::string& name, bool scripts) {
    edits_.push_back(writes_alone());
    if (edits_.back()) line("edit " + std::to_string(int{scripts}) + " " + in_quotes(name));
}

void Recorder::edit_ends() {
    if (edits_.empty()) return;  // it began while the tree was not observed
    if (edits_.back()) line("edit_ends");
    edits_.pop_back();
}

}  // namespace fettle::app
