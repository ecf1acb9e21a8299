#pragma once
// One interface for the sound of SFML 2 and 3.

#include <cstddef>
#include <cstdint>
#include <span>

#include <SFML/Audio.hpp>
#include <SFML/Config.hpp>
#include <SFML/System/Err.hpp>

namespace fettle::app::sfml {

/// Whether the library plays through OpenAL, which can write what it plays to a file.
inline constexpr bool plays_on_openal = SFML_VERSION_MAJOR < 3;

/// The library prints its own messages to a stream, which would be on the terminal of the player.
class NoMessages {
  public:
    NoMessages() : before_(sf::err().rdbuf(nullptr)) {}
    ~NoMessages() { sf::err().rdbuf(before_); }
    NoMessages(const NoMessages&) = delete;

  private:
    std::streambuf* before_;
};

/// Stereo samples of 16 bits that the library asks for on a thread of its own. A derived class
/// calls `stop` in its destructor, since that thread calls its members.
class AudioStream : public sf::SoundStream {
  protected:
    void open(unsigned rate) {
#if SFML_VERSION_MAJOR >= 3
        initialize(2, rate, {sf::SoundChannel::FrontLeft, sf::SoundChannel::FrontRight});
#else
        initialize(2, rate);
#endif
    }
    /// The next samples, left and right in turn. They stay valid until the next call.
    virtual std::span<const std::int16_t> next() = 0;

  private:
    bool onGetData(Chunk& chunk) final {
        const std::span<const std::int16_t> samples = next();
        chunk.samples = samples.data();
        chunk.sampleCount = samples.size();
        return true;
    }
    void onSeek(sf::Time) final {
        // The stream has no beginning to which one could go back.
    }
};

/// True if the library could open a sound device. Only meaningful while a stream exists, which
/// opens it.
bool audio_device_opened();

}  // namespace fettle::app::sfml
