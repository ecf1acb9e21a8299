#include <fettle/app/loudspeaker.h>

#include <array>
#include <span>
#include <utility>

#include <fettle/app/services.h>

#include <sfml/sfml_audio.h>
#include <sound/audio_state.h>
#include <sound/mixer.h>

namespace fettle::app {

/// One stream with all voices.
struct Loudspeaker::Device : sfml::AudioStream {
    Device() { open(Mixer::rate); }
    ~Device() override { stop(); }

    std::span<const std::int16_t> next() override {
        mixer.fill(samples);
        return samples;
    }

    Mixer mixer;
    std::array<std::int16_t, 2 * Mixer::chunk_frames> samples{};
    bool started = false;
};

Loudspeaker::Loudspeaker() = default;
Loudspeaker::~Loudspeaker() = default;

void Loudspeaker::follow(const Services& services, bool halted) {
    const Audio::State& audio = services.audio.state();
    if (failed_ || (device_ == nullptr && audio.voices.empty())) return;
    if (device_ == nullptr) {
        const sfml::NoMessages quiet;
        sfml::silence_audio_libraries();
        device_ = std::make_unique<Device>();
        if (!sfml::audio_device_opened()) {
            device_.reset();
            failed_ = true;
            problem_ = "there is no sound device: the game plays on and is not heard";
            return;
        }
    }
    device_->mixer.set_voices(audio.audible_voices(halted));
    if (!std::exchange(device_->started, true)) device_->play();
}

void Loudspeaker::silence() {
    if (device_ != nullptr) device_->mixer.set_voices({});
}

std::string Loudspeaker::consume_problem() {
    return std::exchange(problem_, {});
}

}  // namespace fettle::app
