#include <recording/difference.h>
#include <world/world_data.h>

#include <string>
#include <utility>

namespace fettle::physics {

using namespace detail;

namespace {

/// Passes the chunks of a recording to the sink.
class Recorder : public WorldObserver {
  public:
    explicit Recorder(RecordingSink sink) : sink_(std::move(sink)) {}

    void begin(const WorldState& state, const std::vector<std::byte>& saved) {
        chunk_.clear();
        ByteWriter(chunk_).value(recording_header());
        begin_chunk(ChunkKind::state);
        ByteWriter(chunk_).bytes(saved.data(), saved.size());
        end_chunk();
        sink_(chunk_);
        last_.read(state);
    }

    void edit_called(const char* of, const char* function) override {
        std::string name = std::string(of) + "::" + function;
        if (name == last_call_) {
            ++times_;
            return;
        }
        append_last_call();
        last_call_ = std::move(name);
        times_ = 1;
    }

    void step_begins(const WorldState& state, const Callbacks& callbacks,
                     std::span<const BodyFunctions> functions, float dt) override {
        append_last_call();
        chunk_.clear();
        write_edits(state);
        begin_chunk(ChunkKind::step);
        ByteWriter out(chunk_);
        out.value(dt);
        out.value(callbacks);
        out.value(uint32_t(functions.size()));
        for (const BodyFunctions& each : functions) {
            out.value(key_of(each.body));
            out.value(each.velocity != nullptr);
            out.value(each.position != nullptr);
        }
        end_chunk();
        sink_(chunk_);  // once: it may throw or destroy the world
    }

    void answered(const Answer& answer) override { answers_.push_back(answer); }

    void step_ends(const WorldState& state, uint64_t hash) override {
        chunk_.clear();
        begin_chunk(ChunkKind::result);
        ByteWriter out(chunk_);
        out.value(hash);
        out.value(uint32_t(answers_.size()));
        for (const Answer& answer : answers_) out.value(answer);
        answers_.clear();
        end_chunk();
        sink_(chunk_);
        last_.read(state);
    }

  private:
    /// Names of more calls before one step are left out: a program that makes a world may have many
    /// thousands.
    static constexpr size_t longest_calls = 1u << 16;

    void append_last_call() {
        if (times_ > 0 && calls_.size() < longest_calls) {
            if (!calls_.empty()) calls_ += ", ";
            calls_ += last_call_;
            if (times_ > 1) calls_ += " " + std::to_string(times_);
        }
        times_ = 0;
        last_call_.clear();
    }

    void write_edits(const WorldState& state) {
        now_.read(state);
        begin_chunk(ChunkKind::edits);
        ByteWriter out(chunk_);
        out.value(uint32_t(calls_.size()));
        out.bytes(calls_.data(), calls_.size());
        const bool differs = write_difference(last_, now_, out);
        if (!differs && calls_.empty()) return chunk_.clear();
        if (!differs) out.value(uint32_t{0});
        calls_.clear();
        end_chunk();
    }

    void begin_chunk(ChunkKind kind) {
        header_at_ = chunk_.size();
        ByteWriter(chunk_).value(ChunkHeader{kind, 0, 0, 0});
    }
    void end_chunk() {
        ChunkHeader header = {};
        Decoder{&chunk_[header_at_]}(header);
        const auto content = std::span(chunk_).subspan(header_at_ + sizeof header);
        header = chunk_header(header.kind, number_++, content);
        Encoder{&chunk_[header_at_]}(header);
    }

    RecordingSink sink_;
    StateBlocks last_;  ///< after the last step
    StateBlocks now_;
    std::vector<std::byte> chunk_;  ///< what the sink gets next
    size_t header_at_ = 0;
    uint64_t number_ = 0;  ///< of the next chunk
    std::string calls_, last_call_;
    size_t times_ = 0;  ///< consecutive calls of `last_call_`
    std::vector<Answer> answers_;
};

}  // namespace

void World::start_recording(RecordingSink sink) {
    WorldData& data = edit(__func__);
    if (!sink) throw std::invalid_argument("sink: expected a function, got an empty one");
    if (is_recorded())
        throw std::invalid_argument(
            "the world is recorded already: call World::stop_recording before");
    auto recorder = std::make_unique<Recorder>(std::move(sink));
    // The state as it is: a refresh here would give the parts of new shapes other slots than one at
    // the next step, and with them another order of contacts.
    std::vector<std::byte> saved;
    save(saved);
    WorldLock lock(data.self, WorldLock::During::query, in_recording);
    recorder->begin(data, saved);
    const bool lives = !data.self.orphaned();
    if (lives) data.self.set_observer(std::move(recorder));
    lock.finish();
}

}  // namespace fettle::physics
