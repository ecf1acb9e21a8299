#pragma once

#include <fettle/physics/export.h>
#include <fettle/physics/owned.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

// Repeats what World::start_recording has recorded, to find errors.

FETTLE_PHYSICS_BEGIN

namespace fettle::physics {

class World;

/// A step of a recording that was repeated.
struct ReplayedStep {
    uint64_t number = 0;  ///< from 0
    float dt = 0.0f;      ///< s
    /// The methods that edited the world since the step before, in the order of the calls, with the
    /// methods that they call themselves: "Body::set_velocity 12, World::create_body". Their effect
    /// is in the recording; their arguments are not.
    std::string calls = {};
    /// Hash of the world after the step when it was recorded; none if the recording ends within
    /// this step, because the program ended there.
    std::optional<uint64_t> recorded_hash = {};
    uint64_t hash = 0;  ///< after the repeated step: `World::hash`
    /// False if the hashes differ, or if a callback was to be called for another contact than in
    /// the recording. The replay ends then.
    bool same = true;
};

/// Repeats a recording step by step. Callbacks are not called: their recorded results are used. A
/// recording can be replayed by the version of the library that made it, as a saved world can be
/// restored.
///
///     std::vector<std::byte> bytes;
///     world.start_recording(
///         [&](auto more) { bytes.insert(bytes.end(), more.begin(), more.end()); });
///     world.step(1.0f / 60);
///     Replay replay(bytes);
///     while (const auto step = replay.step())
///         if (!step->same) std::cout << "step " << step->number << " differs";
class Replay {
  public:
    /// `recording` is copied. Throws std::invalid_argument if it is not a recording, was made by
    /// another version of the library, is damaged, or ends within the first part that was given to
    /// the sink. If it ends within a later part, because the program ended while it wrote a file,
    /// the parts before can be replayed.
    explicit Replay(std::span<const std::byte> recording);
    ~Replay();
    /// `other` can be assigned to and destroyed then; its functions throw std::invalid_argument.
    Replay(Replay&& other) noexcept;
    Replay& operator=(Replay&& other) noexcept;  ///< the earlier replay ends

    uint64_t steps() const;   ///< in the recording
    bool is_cut_off() const;  ///< the recording ends within a part that was given to the sink
    /// Repeats the next step. Empty at the end, and after a step that was not the same. Throws
    /// std::invalid_argument if the edits before the step do not make a valid world, which damage
    /// that the checksums do not notice may cause; the replay ends then.
    std::optional<ReplayedStep> step();
    /// The world after the last repeated step; before the first: at the beginning. It lives as long
    /// as the replay. `World::clone` makes a copy that can be edited.
    const World& world() const;

  private:
    struct Data;
    Data& data() const;

    detail::Owned<Data> data_;
};

}  // namespace fettle::physics

FETTLE_PHYSICS_END
