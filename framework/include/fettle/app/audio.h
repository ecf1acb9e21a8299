#pragma once
// Sound as properties: `audio`, its buses, the classes Sound, Music and Synth, and their voices.
//
// A voice is an instance below the source that plays it, as long as it sounds. Everything about it
// is in the tree and follows simulation time, with a sound device or without. A Loudspeaker reads
// the tree and makes it audible.

#include <cstdint>
#include <functional>
#include <memory>
#include <string_view>

#include <fettle/app/clock.h>
#include <fettle/app/export.h>
#include <fettle/app/view.h>
#include <fettle/property/tree.h>

FETTLE_APP_BEGIN

namespace fettle::property {
class Assets;
}

namespace fettle::app {

class Audio {
  public:
    static constexpr std::int32_t most_voices = 256;

    /// Adds the classes and `audio` to the tree. All arguments must outlive this object; `assets`
    /// is null if the game has no files.
    Audio(property::Tree& tree, const View& view, const Clock& clock, property::Assets* assets);
    ~Audio();
    Audio(const Audio&) = delete;
    Audio& operator=(const Audio&) = delete;

    double volume = 1;                 // of all sounds, 0 to 1
    bool muted = false;                // of all sounds
    std::int32_t max_voices = 64;      // beyond it, the oldest voice ends
    std::function<double()> random{};  // the game's random numbers, 0 to 1; the loop sets it

    /// To be called when the file `name` of the game has changed: sounds that begin from now on use
    /// its new content. Throws property::Error if it cannot be read; the old sound stays then.
    void renew(const std::string& name);
    /// A step of `dt` seconds passes for all voices. The modules step afterwards.
    void step(double dt);
    /// This many seconds of real time pass in a paused game, for the voices that do not pause with
    /// it. They do not advance while an earlier step is shown.
    void wait(double seconds);
    /// Functions of the classes in Lua: `Synth.coin()`.
    static std::string_view library();

    struct FETTLE_APP_PRIVATE State;
    State& state() const { return *state_; }

  private:
    std::unique_ptr<State> state_;
};

}  // namespace fettle::app

FETTLE_APP_END
