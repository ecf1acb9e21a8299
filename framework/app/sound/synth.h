#pragma once
// Sounds from parameters: an oscillator whose frequency moves, two filters, an echo of a few
// milliseconds and an envelope. The kinds of parameters are those of Pettersson's sfxr (2007), in
// physical units.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <fettle/property/class.h>

namespace fettle::app {

enum class Wave : std::uint8_t { square, saw, sine, triangle, noise };
inline constexpr std::array<const char*, 5> wave_names{"square", "saw", "sine", "triangle",
                                                       "noise"};

struct SynthParameters {
    Wave wave = Wave::square;
    std::int64_t seed = 1;
    double attack = 0, sustain = 0.1, punch = 0, decay = 0.2;
    double frequency = 440, slide = 0, slide_change = 0;
    double vibrato = 0, vibrato_rate = 8;
    double arpeggio = 0, arpeggio_time = 0.1, retrigger = 0;
    double duty = 0.5, duty_slide = 0;
    double flanger = 0, flanger_slide = 0;
    double low_pass = 20000, low_pass_slide = 0, resonance = 0;
    double high_pass = 0, high_pass_slide = 0;

    double duration() const { return attack + sustain + decay; }  // s
    friend bool operator==(const SynthParameters&, const SynthParameters&) = default;
};

/// One number of the parameters, as a property of the class Synth.
struct SynthNumber {
    const char* name;
    double SynthParameters::*member;
    property::Range range;
    const char* unit;
    /// How `mutate` changes it: by a factor (0), or by at most this much.
    double step;
    const char* doc;
};
std::span<const SynthNumber> synth_numbers();

/// Makes the samples one after another. The parameters may change between them.
class Generator {
  public:
    /// The sample at the current time, -1 to 1 and somewhat beyond; then `dt` seconds pass.
    double next(const SynthParameters& parameters, double dt);
    /// Goes to a moment, by making the samples up to it: about 20 ms for a sound of 10 s.
    void go_to(const SynthParameters& parameters, double seconds);
    double time() const { return time_; }  // s

  private:
    void control(const SynthParameters& p, double dt);
    double oscillator(const SynthParameters& p, double dt);
    double filtered(double sample);
    double flanged(double sample);
    double envelope(const SynthParameters& p) const;

    double time_ = 0;
    int until_control_ = 0;
    double phase_ = 0, noise_phase_ = 0;
    double frequency_ = 0, duty_ = 0.5;
    struct LowPass {
        double g = 0, k = 0, a = 1, first = 0, second = 0;
        bool on = false;
    } low_;
    struct HighPass {
        double a = 0, in = 0, out = 0;
    } high_;
    std::vector<float> delay_;  // a ring; empty until there is a flanger
    std::size_t at_ = 0, behind_ = 0;
};

/// The lowest and the highest sample of each of `columns` equal parts of the sound.
std::vector<std::array<double, 2>> wave_form(const SynthParameters& parameters,
                                             std::size_t columns);

}  // namespace fettle::app
