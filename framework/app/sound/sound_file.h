#pragma once
// Sound files: WAV, OGG and FLAC, and MP3 where the library reads it. The library decodes them from
// memory, because their bytes come from the game's assets.

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fettle/property/storage/assets.h>

namespace fettle::app {

inline constexpr std::array<std::string_view, 5> sound_endings{".wav", ".ogg", ".oga", ".flac",
                                                               ".mp3"};
/// A Sound is kept decoded; a larger one must be played as Music.
inline constexpr std::size_t greatest_decoded = std::size_t{64} << 20;  // bytes

/// One sample of both channels, -1 to 1.
struct Stereo {
    float left = 0, right = 0;
};

/// A sound in memory, decoded.
struct Samples {
    unsigned rate = 0, channels = 0;
    std::vector<std::int16_t> values;
    std::uint64_t frames() const { return values.size() / channels; }
    Stereo frame(std::uint64_t index) const;
};

class SoundFile {
  public:
    /// Throws std::invalid_argument with the reason if it is not a sound that can be played.
    explicit SoundFile(std::string bytes);

    double duration() const { return static_cast<double>(frames_) / rate_; }  // s
    unsigned rate() const { return rate_; }                                   // Hz
    unsigned channels() const { return channels_; }
    std::uint64_t frames() const { return frames_; }
    const std::string& bytes() const { return bytes_; }
    std::size_t decoded_size() const;  // bytes

    /// The whole sound, decoded at the first call. For one thread.
    std::shared_ptr<const Samples> samples() const;

  private:
    std::string bytes_;
    unsigned rate_ = 0, channels_ = 0;
    std::uint64_t frames_ = 0;
    mutable std::shared_ptr<const Samples> samples_;
};

/// Decodes a file piece by piece while it is played.
class SoundReader {
  public:
    explicit SoundReader(std::shared_ptr<const SoundFile> file);
    ~SoundReader();
    /// Silence beyond the end. Fast if the frames are read in order.
    Stereo frame(std::uint64_t index);
    /// Frame 0, without reading again at the end of a sound that loops.
    Stereo first_frame();

  private:
    void load(std::uint64_t index);
    struct Decoder;
    std::shared_ptr<const SoundFile> file_;
    std::unique_ptr<Decoder> decoder_;
    Samples block_;
    std::uint64_t first_ = 0, count_ = 0;  // frames in the block
    std::uint64_t next_ = 0;               // the frame that the decoder reads next
    std::uint64_t end_;            // behind the last frame; a damaged file has fewer than it states
    std::optional<Stereo> start_;  // frame 0, once it was read
};

/// The sound files of a game. Each is read once.
class SoundFiles {
  public:
    explicit SoundFiles(property::Assets* assets) : assets_(assets) {}
    /// `what` begins the messages: "world.ball.sound.file". Throws property::Error, with the
    /// nearest name for a missing file.
    std::shared_ptr<const SoundFile> get(const std::string& what, const std::string& name);

    /// Reads the file again if it is in use, and returns it; null if it is not. Throws as `get`,
    /// and then the old one stays.
    std::shared_ptr<const SoundFile> renew(const std::string& name);

  private:
    std::shared_ptr<const SoundFile> read(const std::string& what, const std::string& name) const;

    property::Assets* assets_;
    std::map<std::string, std::shared_ptr<const SoundFile>> files_;
};

}  // namespace fettle::app
