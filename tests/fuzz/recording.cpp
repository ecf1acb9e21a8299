// A recording of a physics world: arbitrary bytes, and a valid recording with some changed bytes.
// It is refused, or replayed step by step. The checksums are corrected after a change; otherwise
// they alone would refuse the recording.

#include <cstring>
#include <stdexcept>
#include <vector>

#include <fettle/physics/physics.h>
#include <fettle/physics/recording.h>
#include <recording/chunks.h>

using namespace fettle::physics;

namespace {

std::vector<std::byte> true_recording() {
    std::vector<std::byte> bytes;
    World world;
    world.create_body({.type = BodyType::static_body}).add(Chain{.points = {{-9, 0}, {9, 0}}});
    for (int i = 0; i < 4; ++i)
        world.create_body({.position = {0.3f * float(i), 0.6f + float(i)}}).add(Box{});
    world.start_recording([&](auto more) { bytes.insert(bytes.end(), more.begin(), more.end()); });
    world.set_filter([](const Shape&, const Shape&) { return true; });
    world.set_before_solve([](ContactEdit& edit) { edit.friction = 0.2f; });
    world.bodies()[2].set_velocity_function([](VelocityEdit& edit) { edit.velocity.x = 1; });
    for (int i = 0; i < 5; ++i) {
        world.create_body({.position = {4, 2.0f * float(i)}}).add(Circle{});
        world.step(1.0f / 60);
    }
    return bytes;
}

/// Makes the checksums of all chunks right, as far as their sizes lead.
void seal_again(std::vector<std::byte>& bytes) {
    std::uint64_t number = 0;
    for (std::size_t at = sizeof(detail::RecordingHeader); at < bytes.size(); ++number) {
        detail::ChunkHeader chunk;
        if (bytes.size() - at < sizeof chunk) return;
        std::memcpy(&chunk, &bytes[at], sizeof chunk);
        const std::size_t begin = at + sizeof chunk;
        if (chunk.size > bytes.size() - begin) return;
        const auto content = std::span<const std::byte>(bytes).subspan(begin, chunk.size);
        chunk = detail::chunk_header(chunk.kind, number, content);
        std::memcpy(&bytes[at], &chunk, sizeof chunk);
        at = begin + chunk.size;
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const std::vector<std::byte> recorded = true_recording();
    std::vector<std::byte> bytes;
    if (size > 0 && data[0] % 4 == 0) {
        bytes.resize(size - 1);
        if (size > 1) std::memcpy(bytes.data(), data + 1, size - 1);
    } else {
        bytes = recorded;
        for (std::size_t i = 1; i + 2 < size; i += 3) {
            const std::size_t at = (std::size_t{data[i]} << 8 | data[i + 1]) * 11 % bytes.size();
            bytes[at] = static_cast<std::byte>(data[i + 2]);
        }
    }
    // One input in four keeps the wrong checksums and must be refused.
    if (size == 0 || data[0] % 4 != 3) seal_again(bytes);
    try {
        Replay replay(bytes);
        while (replay.step()) {
        }
    } catch (const std::invalid_argument&) {
        return 0;
    }
    return 0;
}
