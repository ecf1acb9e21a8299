// The class of voices.

#include <stdexcept>

#include <sound/audio_state.h>

namespace fettle::app {

using property::Handle;
using property::Property;
using property::Row;
using property::Tree;
using property::Type;
using property::Value;

namespace {

std::vector<Property> properties_of_voices() {
    Property order{.name = "order",
                   .type = Type::integer,
                   .default_value = 0,
                   .range = {0, 1e15},
                   .doc = "Counts voices in the order in which they began."};
    Property over{.name = "over",
                  .type = Type::boolean,
                  .default_value = false,
                  .doc = "Whether it has played to its end. It is deleted in the next step."};
    order.hidden = over.hidden = true;
    return {{.name = "volume",
             .type = Type::number,
             .default_value = 1.0,
             .range = {0, 4},
             .doc = "Loudness, in addition to that of its source."},
            {.name = "pitch",
             .type = Type::number,
             .default_value = 1.0,
             .range = {0.01, 100},
             .doc = "How fast it is played, in addition to the pitch of its source."},
            {.name = "time",
             .type = Type::number,
             .default_value = 0.0,
             .unit = "s",
             .range = {0, 1e6},
             .doc = "How much of the sound it has played. Setting it goes there."},
            {.name = "playing",
             .type = Type::boolean,
             .default_value = true,
             .doc = "Whether it goes on; false: it pauses."},
            {.name = "pauses",
             .type = Type::boolean,
             .default_value = true,
             .doc = "Whether it pauses with the game. false if it began while the game was paused, "
                    "so that the click of a menu is heard."},
            {.name = "position",
             .type = Type::vec2,
             .unit = "m",
             .range = {-1e9, 1e9},
             .doc = "Where in the world it is heard from. nil: from where its source is.",
             .nullable = true},
            {.name = "fade",
             .type = Type::number,
             .default_value = 1.0,
             .range = {0, 1},
             .doc = "Loudness while it fades, on its way to `fade_to`."},
            {.name = "fade_to",
             .type = Type::number,
             .default_value = 1.0,
             .range = {0, 1},
             .doc = "The loudness to which it fades. A voice that has faded to 0 ends."},
            {.name = "fade_time",
             .type = Type::number,
             .default_value = 0.0,
             .unit = "s",
             .range = {0, 1000},
             .doc = "How long it takes to fade from 0 to 1."},
            order,
            over};
}

Row make_voice(void* context, Tree&, Handle self) {
    static_cast<Audio::State*>(context)->voices.push_back(self);
    return 0;
}

Row place_voice(void* context, Tree& tree, Handle self, Row row) {
    const auto& s = *static_cast<const Audio::State*>(context);
    if (const Handle above = tree.parent(self); above && !s.is_source(above))
        throw std::invalid_argument(
            "a voice is a child of the Sound, Music or Synth that plays it: call `play` there");
    return row;
}

void end_voice(void* context, Tree&, Handle self, Row) {
    std::erase(static_cast<Audio::State*>(context)->voices, self);
}

}  // namespace

void define_voice(Audio::State& state) {
    state.classes.voice = &state.tree.define(
        {.name = "Voice",
         .doc = "A Sound, Music or Synth that is playing once; `play` makes it. It ends with the "
                "sound, in simulation time.",
         .properties = properties_of_voices(),
         .methods = {{.name = "stop",
                      .parameters = {fade_parameter()},
                      .doc = "Ends it, without `finished`.",
                      .context = &state,
                      .call = [](void* context, Tree&, Handle self, Row,
                                 std::span<const Value> arguments) -> property::Result {
                          static_cast<Audio::State*>(context)->stop(self, fade_of(arguments));
                          return Value();
                      },
                      .effect = property::Effect::tree}},
         .events = {{.name = "finished", .doc = "It has played to its end."}},
         .lifecycle = {
             .context = &state, .create = make_voice, .place = place_voice, .destroy = end_voice}});
    const property::Class& of = *state.classes.voice;
    state.of_voice = {of.property("volume"),  of.property("pitch"),     of.property("time"),
                      of.property("playing"), of.property("position"),  of.property("fade"),
                      of.property("fade_to"), of.property("fade_time"), of.property("order"),
                      of.property("over"),    of.property("pauses")};
}

}  // namespace fettle::app
