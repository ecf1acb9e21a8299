#include <recording/chunks.h>
#include <saving/seal.h>

namespace fettle::physics::detail {

RecordingHeader recording_header() {
    constexpr uint32_t magic = 0x72546546;  // "FeTr"
    constexpr uint32_t version = 2;
    return {magic, version, sizeof(WorldCoordinate), 0};
}

uint64_t chunk_checksum(ChunkKind kind, uint64_t number, std::span<const std::byte> content) {
    const uint64_t place = (number << 3 | uint64_t(kind)) * 0x9e3779b97f4a7c15u;
    return checksum(content) ^ place;
}

namespace {

[[noreturn]] void refuse_damaged(size_t number, const char* what) {
    throw std::invalid_argument("the recording is damaged: part " + std::to_string(number) + what);
}

RecordingHeader header_of(std::span<const std::byte> recording) {
    RecordingHeader header = {};
    if (recording.size() >= sizeof header) Decoder{recording.data()}(header);
    if (header.magic != recording_header().magic)
        throw std::invalid_argument("the data are not a recording of a world");
    return header;
}

/// Whether a chunk of this kind may come after one of the kind `last`.
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

std::vector<Chunk> chunks_of(std::span<const std::byte> recording) {
    if (header_of(recording) != recording_header())
        throw std::invalid_argument("the recording was made by another version of this library");
    std::vector<Chunk> chunks;
    for (auto left = recording.subspan(sizeof(RecordingHeader)); !left.empty();) {
        const size_t number = chunks.size();
        ChunkHeader chunk = {};
        if (left.size() < sizeof chunk) refuse_damaged(number, " is cut off");
        Decoder{left.data()}(chunk);
        left = left.subspan(sizeof chunk);
        if (chunk.size > left.size()) refuse_damaged(number, " is cut off");
        const auto content = left.first(size_t(chunk.size));
        left = left.subspan(content.size());
        if (chunk.checksum != chunk_checksum(chunk.kind, number, content) || chunk.unused != 0)
            refuse_damaged(number, ": its checksum differs");
        const bool fits = number == 0 ? chunk.kind == ChunkKind::state
                                      : may_follow(chunks.back().kind, chunk.kind);
        if (!fits) refuse_damaged(number, " is not what belongs there");
        chunks.push_back({chunk.kind, content});
    }
    if (chunks.empty()) throw std::invalid_argument("the recording is empty");
    return chunks;
}

}  // namespace fettle::physics::detail
