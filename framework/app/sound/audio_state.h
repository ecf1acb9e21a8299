#pragma once
// Sources and voices: what the classes in the tree have in common.

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <fettle/app/audio.h>
#include <fettle/property/storage/assets.h>

#include <sound/mixer.h>
#include <sound/sound_file.h>
#include <sound/synth.h>

namespace fettle::app {

struct Audio::State {
    State(Audio& audio, property::Tree& tree, const View& view, const Clock& clock,
          property::Assets* assets);
    State(const State&) = delete;  // properties are bound to its members

    /// The values of a source that are checked against files and buses.
    struct Source {
        property::Handle self{};
        std::string file{};
        std::string bus{};
        std::shared_ptr<const SoundFile> sound{};
    };
    struct SourceProperties {
        const property::Property *volume, *pitch, *loop, *position, *range, *max_voices;
    };
    struct VoiceProperties {
        const property::Property *volume, *pitch, *time, *playing, *position;
        const property::Property *fade, *fade_to, *fade_time, *order, *over, *pauses;
    };

    struct SynthProperties {
        const property::Property *wave, *seed, *low_pass;
        std::vector<const property::Property*> numbers;
    };
    struct BusProperties {
        const property::Property *volume, *muted, *pauses;
    };
    struct Classes {
        const property::Class *source, *sound, *music, *synth, *voice, *bus;
    };

    // Values of stored properties; if a formula fails, its last valid one.
    double number(property::Handle of, const property::Property& property) const;
    property::Value value(property::Handle of, const property::Property& property) const;

    bool is_source(property::Handle instance) const;
    bool is_music(property::Handle instance) const;
    /// The source of a voice; null if its parent is not a source.
    property::Handle source_of(property::Handle voice) const;
    double duration(property::Handle source) const;  // s
    SynthParameters synth_parameters(property::Handle synth) const;
    void set_file(property::Row row, const std::string& name);
    void set_bus(property::Row row, const std::string& name);

    /// Living voices, oldest first.
    std::vector<property::Handle> by_age() const;
    bool ends(property::Handle voice) const;  // it is over, or fades out

    struct Play {
        property::Value volume{}, pitch{}, fade{}, time{}, position{};  // nil: not given
    };
    property::Handle play(property::Handle source, const Play& how);
    void stop(property::Handle voice, double fade);
    void advance_voice(property::Handle voice, double dt);
    /// False if the game shows an earlier step than the newest.
    bool at_present() const { return clock.step >= clock.newest; }
    /// Whether the voice sounds in a paused game, too.
    bool ignores_pause(property::Handle voice) const;

    /// The voices that sound now. `halted`: every voice pauses.
    std::vector<AudibleVoice> audible_voices(bool halted) const;

    Audio& audio;
    property::Tree& tree;
    const View& view;
    const Clock& clock;
    SoundFiles files;

    property::Handle service{}, buses{};
    Classes classes{};
    SourceProperties of_source{};
    VoiceProperties of_voice{};
    SynthProperties of_synth{};
    BusProperties of_bus{};
    const property::Property* of_music_fade = nullptr;

    std::vector<Source> sources{};  // by row
    std::vector<property::Row> free_rows{};
    std::vector<property::Handle> voices{};  // in any order
    double waited = 0;  // s of a paused game that have not passed for voices yet

  private:
    void make_room(property::Handle voice);
    /// Writes what the call of `play` names.
    void set_named_values(property::Handle voice, const Play& how);
    void fade_in_again(property::Handle voice, const Play& how, double fade);
    void cross_fade(property::Handle voice, double fade);
    std::optional<property::Vec2> place(property::Handle voice, property::Handle source) const;
    Stereo loudness(property::Handle voice, property::Handle source) const;
    /// Null if the source is on no bus.
    property::Handle bus_of(property::Handle source) const;
    double bus_loudness(property::Handle source) const;
};

// Each function defines classes. They are called in this order.
void define_audio(Audio::State& state);
void define_sources(Audio::State& state);
void define_synth(Audio::State& state);
void define_voice(Audio::State& state);

/// The parameter of the methods `stop`, and its value.
property::Field fade_parameter();
double fade_of(std::span<const property::Value> arguments);

/// Sets the parameters of a synth to those of a preset; throws std::invalid_argument with the
/// nearest name if there is none of that name.
void set_preset(Audio::State& state, property::Handle synth, const std::string& name);

}  // namespace fettle::app
