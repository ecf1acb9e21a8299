// Voices: how they begin, how time passes for them, how they end.

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <utility>

#include <fettle/property/error.h>
#include <fettle/property/last_value.h>
#include <fettle/property/spelling.h>

#include <sound/audio_state.h>

namespace fettle::app {

using property::Handle;
using property::Property;
using property::Row;
using property::Tree;
using property::Value;
using property::Vec2;

namespace {

constexpr double longest_fade = 1000;   // s
constexpr double pause_interval = 0.1;  // s, less than what the mixer corrects

void require_fade(double seconds) {
    if (!(seconds >= 0 && seconds <= longest_fade))
        throw std::invalid_argument("fade = " + property::number_text(seconds) +
                                    ": expected a time from 0 to 1000 s");
}

}  // namespace

Audio::Audio(Tree& tree, const View& view, const Clock& clock, property::Assets* assets)
    : state_(std::make_unique<State>(*this, tree, view, clock, assets)) {
    define_audio(*state_);
    define_sources(*state_);
    define_synth(*state_);
    define_voice(*state_);
}

Audio::~Audio() = default;

void Audio::renew(const std::string& name) {
    const std::shared_ptr<const SoundFile> sound = state_->files.renew(name);
    if (sound == nullptr) return;
    for (State::Source& source : state_->sources)
        if (source.file == name) source.sound = sound;
}

void Audio::step(double dt) {
    state_->waited = 0;
    for (const Handle voice : state_->by_age())
        if (state_->tree.alive(voice)) state_->advance_voice(voice, dt);
}

/// The log of the timeline keeps each write until the game goes on, so the writes are rare. Between
/// two of them, the mixer advances by itself.
void Audio::wait(double seconds) {
    State& s = *state_;
    if (!s.at_present()) return;
    s.waited += seconds;
    if (s.waited < pause_interval) return;
    const double dt = std::exchange(s.waited, 0);
    for (const Handle voice : s.by_age())
        if (s.tree.alive(voice) && s.ignores_pause(voice)) s.advance_voice(voice, dt);
}

Audio::State::State(Audio& the_audio, Tree& the_tree, const View& the_view, const Clock& the_clock,
                    property::Assets* assets)
    : audio(the_audio), tree(the_tree), view(the_view), clock(the_clock), files(assets) {}

// --- Values

double Audio::State::number(Handle of, const Property& property) const {
    double fast = 0;
    if (tree.read(of, property, fast)) return fast;
    return value(of, property).as_double();
}

Value Audio::State::value(Handle of, const Property& property) const {
    return property::last_value(tree, of, property);
}

bool Audio::State::is_source(Handle instance) const {
    return instance && tree.class_of(instance).is_a(*classes.source);
}

bool Audio::State::is_music(Handle instance) const {
    return instance && tree.class_of(instance).is_a(*classes.music);
}

Handle Audio::State::source_of(Handle voice) const {
    const Handle above = tree.parent(voice);
    return is_source(above) ? above : Handle{};
}

double Audio::State::duration(Handle source) const {
    if (tree.class_of(source).is_a(*classes.synth)) return synth_parameters(source).duration();
    const Source& row = sources[tree.row(source)];
    return row.sound == nullptr ? 0 : row.sound->duration();
}

void Audio::State::set_file(Row row, const std::string& name) {
    Source& source = sources[row];
    std::shared_ptr<const SoundFile> found;
    const std::string what = tree.path(source.self) + ".file";
    if (!name.empty()) found = files.get(what, name);
    if (found != nullptr && !is_music(source.self) && found->decoded_size() > greatest_decoded)
        throw std::invalid_argument("\"" + name + "\" takes " +
                                    std::to_string(found->decoded_size() >> 20) +
                                    " MiB when it is decoded, and a Sound at most " +
                                    std::to_string(greatest_decoded >> 20) + ": play it as Music");
    source.file = name;
    source.sound = std::move(found);
}

void Audio::State::set_bus(Row row, const std::string& name) {
    if (!tree.child(buses, name)) {
        std::vector<std::string> names;
        for (const Handle bus : tree.children(buses)) names.push_back(tree.name(bus));
        throw std::invalid_argument("audio.buses has no \"" + name + "\"" +
                                    property::suggestion(name, names));
    }
    sources[row].bus = name;
}

// --- Beginning

std::vector<Handle> Audio::State::by_age() const {
    std::vector<std::pair<std::int64_t, Handle>> all;
    all.reserve(voices.size());
    for (const Handle voice : voices)
        all.emplace_back(tree.peek(voice, *of_voice.order).integer(), voice);
    std::ranges::sort(all, {}, [](const auto& one) {
        return std::pair(one.first, std::pair(one.second.index, one.second.generation));
    });
    std::vector<Handle> handles;
    handles.reserve(all.size());
    for (const auto& [order, voice] : all) handles.push_back(voice);
    return handles;
}

bool Audio::State::ends(Handle voice) const {
    return value(voice, *of_voice.over).boolean() || number(voice, *of_voice.fade_to) <= 0;
}

/// Ends the oldest voices where there are too many: first of the source of the new voice, then of
/// all. Music is ended last.
void Audio::State::make_room(Handle voice) {
    const Handle source = source_of(voice);
    std::vector<Handle> all = by_age();
    std::erase(all, voice);
    std::vector<Handle> own;
    std::ranges::copy_if(all, std::back_inserter(own),
                         [&](Handle other) { return source_of(other) == source; });
    const auto limit = static_cast<std::size_t>(value(source, *of_source.max_voices).integer());
    for (std::size_t i = 0; i + limit <= own.size(); ++i) tree.destroy(own[i]);
    std::erase_if(all, [&](Handle other) { return !tree.alive(other); });
    std::stable_partition(all.begin(), all.end(),
                          [&](Handle other) { return !is_music(source_of(other)); });
    const auto most = static_cast<std::size_t>(audio.max_voices);
    for (std::size_t i = 0; i < all.size() && voices.size() > most; ++i) tree.destroy(all[i]);
}

/// Other music of the same bus fades out.
void Audio::State::cross_fade(Handle voice, double fade) {
    const std::string bus = sources[tree.row(source_of(voice))].bus;
    for (const Handle other : by_age()) {
        const Handle source = source_of(other);
        if (other != voice && is_music(source) && !ends(other) &&
            sources[tree.row(source)].bus == bus)
            stop(other, fade);
    }
}

void Audio::State::set_named_values(Handle voice, const Play& how) {
    const auto set = [&](const Property* property, const Value& to) {
        if (!to.is_nil()) tree.set(voice, *property, to);
    };
    set(of_voice.volume, how.volume);
    set(of_voice.pitch, how.pitch);
    set(of_voice.time, how.time);
    set(of_voice.position, how.position);
}

/// Music that fades out goes on from its present loudness and its present time.
void Audio::State::fade_in_again(Handle voice, const Play& how, double fade) {
    set_named_values(voice, how);
    tree.set(voice, *of_voice.playing, true);
    tree.set(voice, *of_voice.fade_time, fade);
    tree.set(voice, *of_voice.fade_to, 1.0);
    cross_fade(voice, fade);
}

Handle Audio::State::play(Handle source, const Play& how) {
    const bool streams = is_music(source);
    if (duration(source) <= 0)
        throw std::invalid_argument(tree.class_of(source).is_a(*classes.synth)
                                        ? "attack, sustain and decay are all 0: it has no length"
                                        : "it has no file to play: set `file`");
    double fade = how.fade.is_nil() ? 0 : how.fade.number();
    require_fade(fade);
    if (streams) {
        if (how.fade.is_nil()) fade = number(source, *of_music_fade);
        for (const Handle voice : by_age()) {
            if (source_of(voice) != source || value(voice, *of_voice.over).boolean()) continue;
            if (ends(voice)) fade_in_again(voice, how, fade);
            return voice;
        }
    }
    std::int64_t order = 1;
    for (const Handle voice : voices)
        order = std::max(order, tree.peek(voice, *of_voice.order).integer() + 1);
    const Handle voice = tree.create(*classes.voice, source);
    try {
        tree.set(voice, *of_voice.order, order);
        set_named_values(voice, how);
        if (clock.paused) tree.set(voice, *of_voice.pauses, false);
        if (fade > 0) {
            tree.set(voice, *of_voice.fade_time, fade);
            tree.set(voice, *of_voice.fade, 0.0);
        }
    } catch (...) {
        tree.destroy(voice);
        throw;
    }
    if (streams) cross_fade(voice, fade);
    make_room(voice);
    return voice;
}

void Audio::State::stop(Handle voice, double fade) {
    require_fade(fade);
    if (fade <= 0) return tree.destroy(voice);
    tree.set(voice, *of_voice.fade_time, fade);
    tree.set(voice, *of_voice.fade_to, 0.0);
}

// --- Time

/// Advances a voice by `dt` seconds. A voice that is over lives one step longer, so that handlers
/// of its event can read it.
void Audio::State::advance_voice(Handle voice, double dt) {
    const Handle source = source_of(voice);
    if (!source) return;
    if (value(voice, *of_voice.over).boolean()) return tree.destroy(voice);
    if (!value(voice, *of_voice.playing).boolean()) return;
    const double fade = number(voice, *of_voice.fade), fade_to = number(voice, *of_voice.fade_to);
    if (fade != fade_to) {
        const double seconds = number(voice, *of_voice.fade_time);
        const double most = seconds > 0 ? dt / seconds : 1;
        const double next =
            fade < fade_to ? std::min(fade_to, fade + most) : std::max(fade_to, fade - most);
        if (next <= 0) return tree.destroy(voice);
        tree.set(voice, *of_voice.fade, next);
    }
    const double length = duration(source);
    const double pitch = number(voice, *of_voice.pitch) * number(source, *of_source.pitch);
    const double time = number(voice, *of_voice.time) + dt * pitch;
    const bool loops = length > 0 && value(source, *of_source.loop).boolean();
    if (time < length || loops) {
        tree.set(voice, *of_voice.time, time < length ? time : std::fmod(time, length));
        return;
    }
    tree.set(voice, *of_voice.time, length);
    tree.set(voice, *of_voice.playing, false);
    tree.set(voice, *of_voice.over, true);
    const auto emit = [&](Handle to, std::vector<Value> values) {
        const property::Event& finished = *tree.class_of(to).event("finished");
        if (tree.listens(to, finished)) tree.emit(to, finished, std::move(values));
    };
    emit(voice, {});
    emit(source, {Value(voice)});
}

}  // namespace fettle::app
