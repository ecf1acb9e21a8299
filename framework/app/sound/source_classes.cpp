// The classes of sources of sound, and of `audio` with its buses.

#include <fettle/property/error.h>

#include <sound/audio_state.h>

namespace fettle::app {

using property::accessor;
using property::Handle;
using property::Method;
using property::Native;
using property::Property;
using property::Result;
using property::Row;
using property::Tree;
using property::Type;
using property::Value;

namespace {

using State = Audio::State;
using Arguments = std::span<const Value>;

State& state_of(void* context) {
    return *static_cast<State*>(context);
}

// --- audio

Property voices_of_audio(State& state) {
    return {.name = "voices",
            .type = Type::list,
            .doc = "The voices that sound, oldest first.",
            .binding = accessor(state,
                                [](State& s, Row) {
                                    property::List all;
                                    for (const Handle voice : s.by_age())
                                        if (s.source_of(voice)) all.emplace_back(voice);
                                    return all;
                                }),
            .read_only = true,
            .transient = true,
            .simulated = true,
            .element = Type::reference};
}

std::vector<Property> properties_of_audio(State& state) {
    Audio& audio = state.audio;
    return {{.name = "volume",
             .type = Type::number,
             .default_value = 1.0,
             .range = {0, 1},
             .doc = "Loudness of everything, 1 being that of the recordings.",
             .binding = column(audio, Native::f64, 0, [](Audio& a) { return &a.volume; })},
            {.name = "muted",
             .type = Type::boolean,
             .default_value = false,
             .doc = "Silences everything and leaves the volume as it is.",
             .binding = column(audio, Native::boolean, 0, [](Audio& a) { return &a.muted; })},
            {.name = "max_voices",
             .type = Type::integer,
             .default_value = 64,
             .range = {1, Audio::most_voices},
             .doc = "How many voices may sound at once. One more ends the oldest; music ends last.",
             .binding = column(audio, Native::i32, 0, [](Audio& a) { return &a.max_voices; })},
            voices_of_audio(state)};
}

Result stop_all(void* context, Tree& tree, Handle, Row, Arguments arguments) {
    State& s = state_of(context);
    for (const Handle voice : s.by_age())
        if (tree.alive(voice)) s.stop(voice, fade_of(arguments));
    return Value();
}

// --- Sources

/// Sources of a tree whose services have ended have no memory any more. The context is not used
/// then: the instance `audio` shows whether it still exists.
Row make_source(void* context, Tree& tree, Handle self) {
    const Handle service = tree.child(tree.root(), "audio");
    if (!service || tree.class_of(service).name() != "Audio")
        throw property::Error(property::ErrorKind::bad_structure,
                              "nothing can be played any more: the services of this tree ended");
    State& s = state_of(context);
    if (s.free_rows.empty()) {
        s.free_rows.push_back(static_cast<Row>(s.sources.size()));
        s.sources.emplace_back();
    }
    const Row row = s.free_rows.back();
    s.free_rows.pop_back();
    s.sources[row] = {.self = self, .bus = "effects"};
    return row;
}

void end_source(void* context, Tree&, Handle, Row row) {
    State& s = state_of(context);
    s.sources[row] = {};
    s.free_rows.push_back(row);
}

Property bus_property(State& state, const char* bus) {
    return {.name = "bus",
            .type = Type::text,
            .default_value = bus,
            .doc = "The name of the bus in `audio.buses` whose volume applies to it, too.",
            .binding = accessor(
                state, [](State& s, Row row) { return s.sources[row].bus; },
                [](State& s, Row row, const Value& name) { s.set_bus(row, name.text()); })};
}

Property file_property(State& state) {
    return {.name = "file",
            .type = Type::text,
            .default_value = "",
            .doc = "The file below the game's folder: WAV, OGG or FLAC, and MP3 with SFML 2.6.",
            .binding = accessor(
                state, [](State& s, Row row) { return s.sources[row].file; },
                [](State& s, Row row, const Value& name) { s.set_file(row, name.text()); })};
}

Property duration_property(State& state) {
    Property duration{.name = "duration",
                      .type = Type::number,
                      .unit = "s",
                      .doc = "How long it sounds at a pitch of 1."};
    duration.read_only = duration.transient = duration.simulated = true;
    duration.binding.kind = property::BindingKind::node;
    duration.binding.context = &state;
    duration.binding.node_get = [](void* context, const Tree&, Handle self) {
        return Value(state_of(context).duration(self));
    };
    return duration;
}

std::vector<Property> properties_of_sources(State& state) {
    return {{.name = "volume",
             .type = Type::number,
             .default_value = 1.0,
             .range = {0, 4},
             .doc = "Loudness, 1 being that of the recording."},
            {.name = "pitch",
             .type = Type::number,
             .default_value = 1.0,
             .range = {0.01, 100},
             .doc = "How fast it is played: 2 is an octave higher and half as long."},
            {.name = "loop",
             .type = Type::boolean,
             .default_value = false,
             .doc = "Whether a voice begins again at the end."},
            bus_property(state, "effects"),
            {.name = "position",
             .type = Type::vec2,
             .unit = "m",
             .range = {-1e9, 1e9},
             .doc = "Where it is heard from: from the center of the body or other instance with a "
                    "position that it is below, and turning with it, or else in the world. nil: at "
                    "that center, or everywhere the same if it is below none.",
             .nullable = true},
            {.name = "range",
             .type = Type::number,
             .default_value = 50.0,
             .unit = "m",
             .range = {1e-3, 1e6},
             .doc = "How far from the center of the view it can be heard. Only for a sound that is "
                    "heard from a place."},
            {.name = "max_voices",
             .type = Type::integer,
             .default_value = 8,
             .range = {1, Audio::most_voices},
             .doc = "How many of its voices may sound at once. One more ends the oldest."},
            duration_property(state)};
}

Method play_method(State& state) {
    return {.name = "play",
            .parameters = {{.name = "volume", .type = Type::number, .doc = "Of this voice."},
                           {.name = "pitch", .type = Type::number, .doc = "Of this voice."},
                           {.name = "fade",
                            .type = Type::number,
                            .unit = "s",
                            .doc = "How long it takes to become loud, 0 to 1000."},
                           {.name = "time",
                            .type = Type::number,
                            .unit = "s",
                            .doc = "Where in the sound it begins."},
                           {.name = "position",
                            .type = Type::vec2,
                            .unit = "m",
                            .doc = "Where in the world it is heard from."}},
            .returns = {{.name = "voice",
                         .type = Type::reference,
                         .doc = "The voice, as long as it sounds.",
                         .reference_class = "Voice"}},
            .doc =
                "Begins a voice. Music that sounds already goes on, and other music of its bus "
                "fades out.",
            .context = &state,
            .call = [](void* context, Tree&, Handle self, Row, Arguments a) -> Result {
                return Value(state_of(context).play(self, {a[0], a[1], a[2], a[3], a[4]}));
            },
            .effect = property::Effect::tree};
}

Method stop_method(State& state) {
    return {.name = "stop",
            .parameters = {fade_parameter()},
            .doc = "Ends its voices, without `finished`.",
            .context = &state,
            .call = [](void* context, Tree& tree, Handle self, Row, Arguments arguments) -> Result {
                State& s = state_of(context);
                for (const Handle voice : s.by_age())
                    if (tree.alive(voice) && s.source_of(voice) == self)
                        s.stop(voice, fade_of(arguments));
                return Value();
            },
            .effect = property::Effect::tree};
}

}  // namespace

property::Field fade_parameter() {
    return {.name = "fade",
            .type = Type::number,
            .unit = "s",
            .doc = "How long it takes to fade, 0 to 1000. 0: none."};
}

double fade_of(Arguments arguments) {
    return arguments[0].is_nil() ? 0 : arguments[0].number();
}

void define_audio(State& state) {
    Tree& tree = state.tree;
    const property::Class& audio =
        tree.define({.name = "Audio",
                     .doc = "Everything that is heard.",
                     .creatable = false,
                     .properties = properties_of_audio(state),
                     .methods = {{.name = "stop",
                                  .parameters = {fade_parameter()},
                                  .doc = "Ends every voice, without `finished`.",
                                  .context = &state,
                                  .call = stop_all,
                                  .effect = property::Effect::tree}}});
    const property::Class& buses =
        tree.define({.name = "Buses",
                     .doc = "The buses of a game. Add your own: `audio.buses.speech = Bus {}`.",
                     .creatable = false});
    state.classes.bus = &tree.define(
        {.name = "Bus",
         .doc = "A group of sounds with a volume of its own. It acts below `audio.buses`.",
         .properties = {{.name = "volume",
                         .type = Type::number,
                         .default_value = 1.0,
                         .range = {0, 1},
                         .doc = "Loudness of all sounds of the bus."},
                        {.name = "muted",
                         .type = Type::boolean,
                         .default_value = false,
                         .doc = "Silences the bus and leaves its volume as it is."},
                        {.name = "pauses",
                         .type = Type::boolean,
                         .default_value = true,
                         .doc = "Whether its sounds pause with the game (time.paused). false: they "
                                "go on in real time."}}});
    state.of_bus.volume = state.classes.bus->property("volume");
    state.of_bus.muted = state.classes.bus->property("muted");
    state.of_bus.pauses = state.classes.bus->property("pauses");
    state.service = tree.create(audio, tree.root(), "audio");
    state.buses = tree.create(buses, state.service, "buses");
    for (const char* name : {"effects", "music"})
        tree.create(*state.classes.bus, state.buses, name);
}

void define_sources(State& state) {
    Tree& tree = state.tree;
    state.classes.source = &tree.define(
        {.name = "SoundSource",
         .doc = "What can be played. Its voices are below it while they sound.",
         .creatable = false,
         .properties = properties_of_sources(state),
         .methods = {play_method(state), stop_method(state)},
         .events = {{.name = "finished",
                     .fields = {{.name = "voice",
                                 .type = Type::reference,
                                 .doc = "The voice, which lives until the next step.",
                                 .reference_class = "Voice"}},
                     .doc = "A voice has played to its end. Not for one that was stopped."}},
         .lifecycle = {.context = &state, .create = make_source, .destroy = end_source}});
    const property::Class& of = *state.classes.source;
    state.of_source = {of.property("volume"),   of.property("pitch"), of.property("loop"),
                       of.property("position"), of.property("range"), of.property("max_voices")};
    state.classes.sound = &tree.define(
        {.name = "Sound",
         .base = "SoundSource",
         .doc = "A sound from a file, kept decoded: for effects, which may sound many at once.",
         .properties = {file_property(state)}});
    state.classes.music = &tree.define(
        {.name = "Music",
         .base = "SoundSource",
         .doc = "Music from a file, decoded while it plays. In each bus only one sounds at a time: "
                "another one fades in while it fades out.",
         .properties = {file_property(state),
                        {.name = "fade",
                         .type = Type::number,
                         .default_value = 1.0,
                         .unit = "s",
                         .range = {0, 1000},
                         .doc = "How long it takes to fade in, and other music of its bus to fade "
                                "out."},
                        {.name = "loop",
                         .type = Type::boolean,
                         .default_value = true,
                         .doc = "Whether it begins again at the end."},
                        {.name = "bus",
                         .type = Type::text,
                         .default_value = "music",
                         .doc = "The name of the bus in `audio.buses` whose volume applies to it, "
                                "too."}}});
    state.of_music_fade = state.classes.music->property("fade");
}

}  // namespace fettle::app
