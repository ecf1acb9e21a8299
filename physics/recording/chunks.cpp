#include <recording/chunks.h>
#include <saving/checksum.h>

#include <string>

namespace fettle::physics::detail {

RecordingHeader recording_header() {
    constexpr uint32_t magic = 0x72546546;  // "FeTr"
    constexpr uint32_t version = 3;
    return {magic, version, sizeof(WorldCoordinate), 0};
}

namespace {

/// A number that differs for each kind of chunk and each place.
uint64_t place_of(ChunkKind kind, uint64_t number) {
    return (number << 3 | uint64_t(kind)) * 0x9e3779b97f4a7c15u;
}

uint32_t size_check(ChunkKind kind, uint64_t number, uint64_t size) {
    return uint32_t(((place_of(kind, number) ^ size) * 0xd6e8feb86659fd93u) >> 32);
}

[[noreturn]] void refuse_damaged(size_t number, const char* what) {
    throw std::invalid_argument("the recording is damaged: part " + std::to_string(number) + what);
}

/// Refuses a recording that does not begin as this library writes it, with the reason.
void check_header(std::span<const std::byte> recording) {
    RecordingHeader header = {};
    if (recording.size() >= sizeof header) Decoder{recording.data()}(header);
    const RecordingHeader expected = recording_header();
    if (header.magic != expected.magic)
        throw std::invalid_argument("the data are not a recording of a world");
    if (header.version != expected.version)
        throw std::invalid_argument(
            "the recording was made by another version of this library, in format " +
            std::to_string(header.version) + ": expected format " +
            std::to_string(expected.version));
    if (header.coordinate + expected.coordinate == sizeof(float) + sizeof(double))
        throw std::invalid_argument(other_precision("the recording was made"));
    if (header != expected)
        throw std::invalid_argument("the recording is damaged: its header differs");
}

/// True if a chunk of this kind may come after one of the kind `last`.
bool may_follow(ChunkKind last, ChunkKind kind) {
    switch (kind) {
        case ChunkKind::state:
            return false;
        case ChunkKind::edits:
            return last == ChunkKind::state || last == ChunkKind::result;
        case ChunkKind::step:
            return last != ChunkKind::step;
        case ChunkKind::result:
            return last == ChunkKind::step;
    }
    return false;
}

}  // namespace

ChunkHeader chunk_header(ChunkKind kind, uint64_t number, std::span<const std::byte> content) {
    return {kind, size_check(kind, number, content.size()), content.size(),
            checksum(content) ^ place_of(kind, number)};
}

Chunks chunks_of(std::span<const std::byte> recording) {
    check_header(recording);
    Chunks chunks;
    for (auto left = recording.subspan(sizeof(RecordingHeader)); !left.empty();) {
        const size_t number = chunks.whole.size();
        ChunkHeader header = {};
        chunks.cut_off = left.size() < sizeof header;
        if (chunks.cut_off) break;
        Decoder{left.data()}(header);
        left = left.subspan(sizeof header);
        if (header.size_check != size_check(header.kind, number, header.size))
            refuse_damaged(number, ": the checksum of its size differs");
        chunks.cut_off = header.size > left.size();
        if (chunks.cut_off) break;
        const auto content = left.first(size_t(header.size));
        left = left.subspan(content.size());
        if (header.checksum != chunk_header(header.kind, number, content).checksum)
            refuse_damaged(number, ": its checksum differs");
        const bool fits = number == 0 ? header.kind == ChunkKind::state
                                      : may_follow(chunks.whole.back().kind, header.kind);
        if (!fits) refuse_damaged(number, " is of a kind that cannot come there");
        chunks.whole.push_back({header.kind, content});
    }
    if (chunks.whole.empty())
        throw std::invalid_argument("the recording ends before the world that it begins with");
    return chunks;
}

}  // namespace fettle::physics::detail
