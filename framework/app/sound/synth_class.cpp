// The class Synth, its presets and its mutations.

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <stdexcept>
#include <utility>

#include <fettle/property/spelling.h>

#include <sound/audio_state.h>

namespace fettle::app {

using property::Handle;
using property::Property;
using property::Row;
using property::Tree;
using property::Type;
using property::Value;
using property::Vec2;

namespace {

using S = SynthParameters;

struct Preset {
    const char* name;
    S values;
};

/// The parameters of the default, changed.
S preset(Wave wave, std::initializer_list<std::pair<double S::*, double>> values) {
    S all;
    all.wave = wave;
    for (const auto& [member, value] : values) all.*member = value;
    return all;
}

const std::vector<Preset>& presets() {
    static const std::vector<Preset> all = {
        {"coin", preset(Wave::square, {{&S::sustain, 0.08},
                                       {&S::decay, 0.35},
                                       {&S::punch, 0.3},
                                       {&S::frequency, 988},
                                       {&S::arpeggio, 5},
                                       {&S::arpeggio_time, 0.07}})},
        {"jump", preset(Wave::square, {{&S::sustain, 0.08},
                                       {&S::decay, 0.2},
                                       {&S::frequency, 300},
                                       {&S::slide, 3.5},
                                       {&S::duty, 0.3},
                                       {&S::high_pass, 100}})},
        {"hit", preset(Wave::noise, {{&S::sustain, 0.03},
                                     {&S::decay, 0.14},
                                     {&S::punch, 0.5},
                                     {&S::frequency, 420},
                                     {&S::slide, -9},
                                     {&S::low_pass, 6000}})},
        {"explosion", preset(Wave::noise, {{&S::sustain, 0.2},
                                           {&S::decay, 0.9},
                                           {&S::punch, 0.7},
                                           {&S::frequency, 160},
                                           {&S::slide, -1.5},
                                           {&S::low_pass, 3000},
                                           {&S::low_pass_slide, -1.2},
                                           {&S::flanger, 2},
                                           {&S::flanger_slide, 4}})},
        {"blip", preset(Wave::square, {{&S::sustain, 0.05},
                                       {&S::decay, 0.04},
                                       {&S::frequency, 620},
                                       {&S::duty, 0.35},
                                       {&S::high_pass, 150}})},
        {"power_up", preset(Wave::square, {{&S::sustain, 0.3},
                                           {&S::decay, 0.35},
                                           {&S::frequency, 330},
                                           {&S::slide, 6},
                                           {&S::retrigger, 0.13},
                                           {&S::vibrato, 0.4},
                                           {&S::vibrato_rate, 14},
                                           {&S::duty, 0.4}})},
    };
    return all;
}

Property number_property(const SynthNumber& number) {
    return {.name = number.name,
            .type = Type::number,
            .default_value = S{}.*number.member,
            .unit = number.unit,
            .range = number.range,
            .doc = number.doc};
}

std::vector<Property> properties_of_synths(Audio::State& state) {
    std::vector<Property> all;
    all.push_back({.name = "wave",
                   .type = Type::text,
                   .default_value = wave_names[0],
                   .doc = "The form of the wave.",
                   .enumerators = {wave_names.begin(), wave_names.end()}});
    all.push_back({.name = "seed",
                   .type = Type::integer,
                   .default_value = S{}.seed,
                   .range = {0, 1e15},
                   .doc = "Which noise it is. The same seed gives the same noise."});
    all.push_back({.name = "volume",
                   .type = Type::number,
                   .default_value = 0.5,
                   .doc = "Loudness, 1 being as loud as a file can be."});
    for (const SynthNumber& number : synth_numbers()) all.push_back(number_property(number));
    const auto low_pass = std::ranges::find(all, "low_pass", &Property::name);
    all.push_back({.name = "filter",
                   .type = Type::number,
                   .default_value = low_pass->default_value,
                   .unit = low_pass->unit,
                   .range = low_pass->range,
                   .doc = "A short name for `low_pass`.",
                   .binding = property::accessor(
                       state,
                       [](Audio::State& s, Row row) {
                           const Handle synth = s.sources[row].self;
                           return s.number(synth, *s.of_synth.low_pass);
                       },
                       [](Audio::State& s, Row row, const Value& value) {
                           s.tree.set(s.sources[row].self, *s.of_synth.low_pass, value);
                       }),
                   .transient = true,
                   .derives_from = {"low_pass"}});
    return all;
}

/// Changes about half of the numbers, each within its range.
void mutate(Audio::State& state, Handle synth, double amount) {
    if (!state.audio.random)
        throw std::invalid_argument("there is no game with random numbers here");
    std::size_t index = 0;
    for (const SynthNumber& number : synth_numbers()) {
        const Property& property = *state.of_synth.numbers[index++];
        const double by = state.audio.random(), chance = state.audio.random();
        if (chance < 0.5) continue;
        const double change = (2 * by - 1) * amount;
        const double now = state.number(synth, property);
        const double next = number.step > 0 ? now + change * number.step : now * std::exp(change);
        state.tree.set(synth, property, std::clamp(next, number.range.min, number.range.max));
    }
}

std::vector<property::Method> methods_of_synths(Audio::State& state) {
    return {
        {.name = "preset",
         .parameters = {{.name = "name",
                         .type = Type::text,
                         .doc = "\"coin\", \"jump\", \"hit\", \"explosion\", \"blip\", "
                                "\"power_up\"."}},
         .required = 1,
         .doc = "Sets all parameters to those of a preset.",
         .context = &state,
         .call = [](void* context, Tree&, Handle self, Row,
                    std::span<const Value> arguments) -> property::Result {
             set_preset(*static_cast<Audio::State*>(context), self, arguments[0].text());
             return Value();
         },
         .effect = property::Effect::tree},
        {.name = "mutate",
         .parameters = {{.name = "amount",
                         .type = Type::number,
                         .doc = "How much, 0 to 1: 0.1 is a variation, 1 another sound. Default "
                                "0.1."}},
         .doc = "Changes about half of the numbers by a random amount, with the random numbers of "
                "the game.",
         .context = &state,
         .call = [](void* context, Tree&, Handle self, Row,
                    std::span<const Value> arguments) -> property::Result {
             const double amount = arguments[0].is_nil() ? 0.1 : arguments[0].number();
             if (!(amount >= 0 && amount <= 1))
                 throw std::invalid_argument("amount = " + property::number_text(amount) +
                                             ": expected a number from 0 to 1");
             mutate(*static_cast<Audio::State*>(context), self, amount);
             return Value();
         },
         .effect = property::Effect::tree},
        {.name = "wave_form",
         .parameters = {{.name = "columns",
                         .type = Type::integer,
                         .doc = "In how many parts of the same length, 1 to 4096."}},
         .required = 1,
         .returns = {{.name = "columns",
                      .type = Type::list,
                      .doc = "For each part its lowest and its highest sample, from -1 to 1: "
                             "vec(lowest, highest).",
                      .element = Type::vec2}},
         .doc = "The form of the sound, for a picture of it.",
         .context = &state,
         .call = [](void* context, Tree&, Handle self, Row,
                    std::span<const Value> arguments) -> property::Result {
             const std::int64_t columns = arguments[0].integer();
             if (columns < 1 || columns > 4096)
                 throw std::invalid_argument("columns = " + std::to_string(columns) +
                                             ": expected a number from 1 to 4096");
             const auto& s = *static_cast<const Audio::State*>(context);
             property::List all;
             for (const auto& [low, high] :
                  wave_form(s.synth_parameters(self), static_cast<std::size_t>(columns)))
                 all.emplace_back(Vec2(low, high));
             return Value(std::move(all));
         },
         .effect = property::Effect::nothing}};
}

}  // namespace

void define_synth(Audio::State& state) {
    state.classes.synth = &state.tree.define(
        {.name = "Synth",
         .base = "SoundSource",
         .doc = "A sound from parameters, without a file. `Synth.coin()`, `jump`, `hit`, "
                "`explosion`, `blip` and `power_up` make ready ones. A changed parameter is heard "
                "at once, also in voices that sound.",
         .properties = properties_of_synths(state),
         .methods = methods_of_synths(state)});
    state.of_synth.wave = state.classes.synth->property("wave");
    state.of_synth.low_pass = state.classes.synth->property("low_pass");
    state.of_synth.seed = state.classes.synth->property("seed");
    for (const SynthNumber& number : synth_numbers())
        state.of_synth.numbers.push_back(state.classes.synth->property(number.name));
}

SynthParameters Audio::State::synth_parameters(Handle synth) const {
    SynthParameters all;
    const int wave = of_synth.wave->enumerator_index(value(synth, *of_synth.wave).text());
    all.wave = static_cast<Wave>(std::max(wave, 0));
    all.seed = value(synth, *of_synth.seed).integer();
    std::size_t index = 0;
    for (const SynthNumber& each : synth_numbers())
        all.*each.member = number(synth, *of_synth.numbers[index++]);
    return all;
}

void set_preset(Audio::State& state, Handle synth, const std::string& name) {
    const auto found = std::ranges::find(presets(), name, &Preset::name);
    if (found == presets().end()) {
        std::vector<std::string> names;
        for (const Preset& each : presets()) names.emplace_back(each.name);
        std::string hint = property::suggestion(name, names);
        if (hint.empty()) {
            hint = "; there are";
            for (const std::string& each : names) hint += (&each == &names[0] ? " " : ", ") + each;
        }
        throw std::invalid_argument("there is no preset \"" + name + "\"" + hint);
    }
    state.tree.set(synth, *state.of_synth.wave,
                   wave_names[static_cast<std::size_t>(found->values.wave)]);
    std::size_t index = 0;
    for (const SynthNumber& each : synth_numbers())
        state.tree.set(synth, *state.of_synth.numbers[index++], found->values.*each.member);
}

std::string_view Audio::library() {
    return R"(
for _, name in ipairs { "coin", "jump", "hit", "explosion", "blip", "power_up" } do
    Synth[name] = function(class, values)
        local by_dot = not pcall(class.alive, class) and values ~= class
        if not by_dot or values ~= nil and type(values) ~= "table" then
            error("Synth." .. name .. ": takes a table of values, or nothing" ..
                (by_dot and "" or "; call it with a dot, on a class"), 2)
        end
        local synth = class {}
        synth:preset(name)
        for key, value in pairs(values or {}) do synth[key] = value end
        return synth
    end
end
)";
}

}  // namespace fettle::app
