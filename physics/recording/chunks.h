#pragma once

#include <saving/fields.h>
#include <saving/words.h>
#include <world/world_observer.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

// The format of a recording: a header, and then chunks, each with a checksum that also depends on
// its kind and its place. The first chunk is a saved world. For each step, the following chunks are
// the edits before it, if there were any, the step, and its result. A recording may end anywhere
// after the first chunk: an incomplete last chunk is not read.

namespace fettle::physics::detail {

enum class ChunkKind : uint32_t { state = 1, edits = 2, step = 3, result = 4 };

struct RecordingHeader {
    uint32_t magic;
    uint32_t version;
    uint32_t coordinate;  ///< bytes of a coordinate of a position: 4 or 8
    uint32_t unused;      ///< 0

    static void fields(auto& io, auto& s) { io(s.magic, s.version, s.coordinate, s.unused); }
    bool operator==(const RecordingHeader&) const = default;
};
static_assert(sizeof(RecordingHeader) == 16);

RecordingHeader recording_header();

struct ChunkHeader {
    ChunkKind kind;
    uint32_t size_check;  ///< of kind, number and size: `checksum` is of no use if the content was
                          ///< cut off
    uint64_t size;        ///< bytes after this header
    uint64_t checksum;

    static void fields(auto& io, auto& s) { io(s.kind, s.size_check, s.size, s.checksum); }
};
static_assert(sizeof(ChunkHeader) == 24);

// The questions of a step to the functions of the user, with their answers.
void fields(auto& io, Some<Callbacks> auto& s) {
    io(s.filter, s.mixing, s.before_solve);
}
void fields(auto& io, Some<Answer> auto& s) {
    io(s.about_a, s.about_b, s.to, s.given, s.first, s.second, s.unused);
    for (auto& value : s.values) io(value);
}

struct Chunk {
    ChunkKind kind;
    std::span<const std::byte> content;
};

/// The header of the chunk with this number.
ChunkHeader chunk_header(ChunkKind kind, uint64_t number, std::span<const std::byte> content);

struct Chunks {
    std::vector<Chunk> whole;
    bool cut_off = false;  ///< the recording ends within the next one
};

/// The chunks of a recording. Throws std::invalid_argument if it is damaged, or ends within the
/// first one.
Chunks chunks_of(std::span<const std::byte> recording);

/// Appends numbers and records to bytes, in the order of saving/words.h.
class ByteWriter {
  public:
    explicit ByteWriter(std::vector<std::byte>& out) : out_(out) {}
    void bytes(const void* from, size_t size) {
        const auto* begin = static_cast<const std::byte*>(from);
        out_.insert(out_.end(), begin, begin + size);
    }
    template <class T>
    void value(const T& value) {
        const size_t size = encoded_size<T>();
        out_.resize(out_.size() + size);
        Encoder{out_.data() + (out_.size() - size)}(value);
    }

  private:
    std::vector<std::byte>& out_;
};

/// Throws std::invalid_argument if the bytes end too early.
class ByteReader {
  public:
    explicit ByteReader(std::span<const std::byte> in) : in_(in) {}
    std::span<const std::byte> bytes(uint64_t size) {
        if (size > in_.size())
            throw std::invalid_argument("the recording is damaged: a part of it ends too early");
        const auto taken = in_.first(size_t(size));
        in_ = in_.subspan(size_t(size));
        return taken;
    }
    template <class T>
    T value() {
        T value{};
        const auto encoded = bytes(encoded_size<T>());
        try {
            Decoder{encoded.data()}(value);
        } catch (const std::invalid_argument& unreadable) {
            throw std::invalid_argument(std::string("the recording is damaged: ") +
                                        unreadable.what());
        }
        return value;
    }
    /// The number of elements of a list that follows.
    uint32_t count(size_t least_size) {
        const auto count = value<uint32_t>();
        if (count > in_.size() / least_size)
            throw std::invalid_argument("the recording is damaged: a part of it ends too early");
        return count;
    }
    bool at_end() const { return in_.empty(); }

  private:
    std::span<const std::byte> in_;
};

}  // namespace fettle::physics::detail
