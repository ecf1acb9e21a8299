#pragma once
// Sound of SFML: streams that the program fills.

#include <cstddef>
#include <cstdint>
#include <span>

#include <SFML/Audio.hpp>

#include <sfml/sfml.h>

namespace fettle::app::sfml {

/// Silences the libraries through which SFML plays, as `NoMessages` does for SFML. To be called
/// before the first stream exists.
void silence_audio_libraries();

/// A stream of stereo samples of 16 bits. The library fetches them on its own thread. A derived
/// class calls `stop` in its destructor, because that thread calls its members.
class AudioStream : public StereoStream {
  protected:
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

}  // namespace fettle::app::sfml
