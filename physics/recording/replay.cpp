#include <fettle/physics/recording.h>
#include <recording/difference.h>
#include <saving/checksum.h>
#include <world/world_data.h>

#include <stdexcept>
#include <utility>

namespace fettle::physics {

using namespace detail;

namespace detail {

/// A function of the user threw at this place of the recording.
struct Unanswered {};

/// The recorded answers of the functions of the user in one step.
class Answers {
  public:
    void begin(std::vector<Answer> answers) {
        answers_ = std::move(answers);
        next_ = 0;
        same_ = true;
    }
    /// True if all questions were those of the recording.
    bool same() const { return same_ && next_ == answers_.size(); }

    /// The next answer; null if it answers another question. Throws `Unanswered` if the function
    /// threw.
    const Answer* next_answer(Answer::To to, uint64_t about_a, uint64_t about_b) {
        if (next_ >= answers_.size()) return refuse();
        const Answer& answer = answers_[next_];
        if (answer.to != to || answer.about_a != about_a || answer.about_b != about_b)
            return refuse();
        ++next_;
        if (!answer.given) throw Unanswered{};
        return &answer;
    }

  private:
    const Answer* refuse() {
        same_ = false;
        return nullptr;
    }
    std::vector<Answer> answers_;
    size_t next_ = 0;
    bool same_ = true;
};

}  // namespace detail

namespace {

void answer_contact(Answers& answers, Answer::To to, ContactEdit& edit) {
    const Answer* answer =
        answers.next_answer(to, key_of(edit.shape_a.id()), key_of(edit.shape_b.id()));
    if (answer == nullptr) return;
    edit.friction = float(answer->values[0]);
    edit.restitution = float(answer->values[1]);
    edit.surface_speed = float(answer->values[2]);
    if (to == Answer::To::mixing) return;
    edit.enabled = answer->first;
    edit.ignored = answer->second;
}

std::vector<Answer> read_answers(ByteReader& in) {
    std::vector<Answer> answers(in.count(encoded_size<Answer>()));
    for (Answer& answer : answers) {
        answer = in.value<Answer>();
        if (answer.to > Answer::To::position)
            throw std::invalid_argument(
                "the recording is damaged: an answer to an unknown question");
    }
    return answers;
}

}  // namespace

struct Replay::Data {
    std::vector<std::byte> bytes;
    std::vector<Chunk> chunks;
    size_t next = 1;  ///< chunk
    bool cut_off = false;
    uint64_t steps = 0, repeated = 0;
    bool over = false;
    World world;
    Answers answers;
    StateBlocks blocks;

    /// Sets the callbacks that the recorded step had. They return the recorded answers.
    void set_callbacks(WorldData& of_world, ByteReader& in) {
        WorldSelf& self = of_world.self;
        const auto [filter, mixing, before_solve] = in.value<Callbacks>();
        self.filter = nullptr;
        self.mix = self.before_solve = nullptr;
        if (filter)
            self.filter = [this, &of_world](const Shape& a, const Shape& b) {
                // Answers are recorded in steps only. Outside of a step, World::validate calls the
                // filter for pairs without a contact: false leaves them out.
                if (!of_world.stepping) return false;
                const Answer* answer =
                    answers.next_answer(Answer::To::filter, key_of(a.id()), key_of(b.id()));
                return answer == nullptr || answer->first;
            };
        if (mixing)
            self.mix = [this](ContactEdit& edit) {
                answer_contact(answers, Answer::To::mixing, edit);
            };
        if (before_solve)
            self.before_solve = [this](ContactEdit& edit) {
                answer_contact(answers, Answer::To::before_solve, edit);
            };
        self.functions.clear();
        for (uint32_t left = in.count(10); left > 0; --left) {
            const auto key = in.value<uint64_t>();
            const BodyId body = {uint32_t(key), uint32_t(key >> 32)};
            const bool velocity = in.value<bool>(), position = in.value<bool>();
            self.functions.push_back({.body = body});
            if (velocity) self.functions.back().velocity = velocity_function(key);
            if (position) self.functions.back().position = position_function(key);
        }
    }

    VelocityFunction velocity_function(uint64_t key) {
        return [this, key](VelocityEdit& edit) {
            const Answer* answer = answers.next_answer(Answer::To::velocity, key, 0);
            if (answer == nullptr) return;
            edit.velocity = {answer->values[0], answer->values[1]};
            edit.angular_velocity = float(answer->values[2]);
        };
    }
    PositionFunction position_function(uint64_t key) {
        return [this, key](PositionEdit& edit) {
            const Answer* answer = answers.next_answer(Answer::To::position, key, 0);
            if (answer == nullptr) return;
            edit.pose = {{answer->values[0], answer->values[1]}, float(answer->values[2])};
        };
    }

    /// Makes the recorded edits before a step; returns the names of the methods that made them.
    std::string make_edits(const WorldState& state, ByteReader in) {
        const auto text = in.bytes(in.value<uint32_t>());
        std::string calls(reinterpret_cast<const char*>(text.data()), text.size());
        blocks.read(state);
        std::vector<std::byte> saved;
        world.save(saved);
        const std::vector<std::byte> edited = apply_difference(blocks, in);
        saved.resize(sizeof(SavedHeader));
        saved.insert(saved.end(), edited.begin(), edited.end());
        write_checksum(saved);
        world.restore(saved);
        return calls;
    }
};

Replay::Replay(std::span<const std::byte> recording) : data_(new Data) {
    Data& data = *data_;
    Chunks chunks = chunks_of(recording);
    data.chunks = std::move(chunks.whole);
    data.cut_off = chunks.cut_off;
    data.bytes.assign(recording.begin(), recording.end());
    for (Chunk& chunk : data.chunks) {
        const auto at = size_t(chunk.content.data() - recording.data());
        chunk.content = std::span(data.bytes).subspan(at, chunk.content.size());
        data.steps += chunk.kind == ChunkKind::step;
    }
    data.world.restore(data.chunks.front().content);
}

Replay::~Replay() = default;
Replay::Replay(Replay&& other) noexcept = default;
Replay& Replay::operator=(Replay&& other) noexcept = default;

/// Throws if it was moved away.
Replay::Data& Replay::data() const {
    if (!data_) throw std::invalid_argument("this replay was moved to another one");
    return *data_;
}

uint64_t Replay::steps() const {
    return data().steps;
}

bool Replay::is_cut_off() const {
    return data().cut_off;
}

const World& Replay::world() const {
    return data().world;
}

std::optional<ReplayedStep> Replay::step() {
    Data& data = this->data();
    if (data.over || data.repeated == data.steps) return {};
    data.over = true;  // if this throws
    WorldData& of_world = *data.world.data_;
    ReplayedStep step = {.number = data.repeated};
    if (data.chunks[data.next].kind == ChunkKind::edits)
        step.calls = data.make_edits(of_world, ByteReader(data.chunks[data.next++].content));
    ByteReader in(data.chunks[data.next++].content);
    step.dt = in.value<float>();
    data.set_callbacks(of_world, in);
    const bool has_result =
        data.next < data.chunks.size() && data.chunks[data.next].kind == ChunkKind::result;
    std::vector<Answer> answers;
    if (has_result) {
        ByteReader result(data.chunks[data.next++].content);
        step.recorded_hash = result.value<uint64_t>();
        answers = read_answers(result);
    }
    data.answers.begin(std::move(answers));
    try {
        data.world.step(step.dt);
    } catch (const Unanswered&) {  // thrown in the recording, too; the step is complete
    }
    ++data.repeated;
    step.hash = data.world.hash();
    step.same = !has_result || (data.answers.same() && step.hash == step.recorded_hash);
    data.over = !step.same;
    return step;
}

}  // namespace fettle::physics
