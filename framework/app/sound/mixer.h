#pragma once
// Adds voices to one stereo signal.
//
// One thread sets the voices, another makes the samples. They share only the list of voices, under
// a lock that is held while the list is exchanged. A voice is compared with the time that it should
// have: if it is far off (the game went back in time, or was stopped), it continues where it should
// be.

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

#include <sound/sound_file.h>
#include <sound/synth.h>

namespace fettle::app {

/// A voice as the mixer plays it. It plays the samples, or else the file, or else the synth.
struct AudibleVoice {
    std::uint64_t id = 0;  // of the voice, as long as it sounds
    std::shared_ptr<const Samples> samples{};
    std::shared_ptr<const SoundFile> file{};
    SynthParameters synth{};
    double duration = 0;  // s
    double time = 0;      // s, how long it has played
    double rate = 1;      // seconds of the sound a second; 0: it pauses
    Stereo loudness{1, 1};
    bool loops = false;
};

class Mixer {
  public:
    static constexpr unsigned rate = 44100;            // Hz
    static constexpr double tolerance = 0.2;           // s, before a voice jumps
    static constexpr std::size_t chunk_frames = 1024;  // that the device requests at once

    /// Sets the voices that sound from now on.
    void set_voices(std::vector<AudibleVoice> all);
    /// Makes the next samples, left and right in turn. For one thread.
    void fill(std::span<std::int16_t> out);
    /// Voices that are mixed now, those included that fade out. For the thread that fills.
    std::size_t size() const { return playing_.size(); }

  private:
    struct Playing {
        AudibleVoice state;
        double position = 0;  // s
        double speed = 1;     // seconds of the sound a second; the last one while it pauses
        Stereo loudness{};    // now, on its way to that of `state`
        bool released = false;
        Generator generator{};
        std::unique_ptr<SoundReader> reader{};

        bool over() const { return !state.loops && position >= state.duration; }
        Stereo sample();
        void advance();
        void add_to(std::span<float> mix);
    };

    void exchange();
    static Playing begun(AudibleVoice state);
    static void release(Playing& voice);
    static void adapt(Playing& voice, const AudibleVoice& to);
    static bool far_off(const Playing& voice, const AudibleVoice& to);

    std::mutex mutex_;
    std::optional<std::vector<AudibleVoice>> next_;  // under the lock
    std::vector<Playing> playing_;
    std::vector<float> mix_;
};

}  // namespace fettle::app
