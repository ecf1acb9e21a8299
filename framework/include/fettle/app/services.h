#pragma once
// Services that every game has in its tree beside the world: `time`, `view`, `input`, `audio`.

#include <functional>
#include <memory>
#include <string>

#include <fettle/app/audio.h>
#include <fettle/app/clock.h>
#include <fettle/app/export.h>
#include <fettle/app/input.h>
#include <fettle/app/view.h>
#include <fettle/property/tree.h>

FETTLE_APP_BEGIN

namespace fettle::app {

class FETTLE_APP_PRIVATE Cameras;
class FETTLE_APP_PRIVATE Effects;

/// Owns the values of the services and adds them to a tree. Order of construction: tree, services,
/// runtime. The destructor deletes the instances of the services, with everything below them; if
/// the tree has ended before, it does nothing. Where instances cannot be deleted (in a formula or a
/// lifecycle function, for example), it ends the program. The classes stay in the tree, but it
/// can get no other services, and no instance of these classes.
class Services {
  public:
    /// `assets`: images, sounds and other files of the game; null if there are none. They must
    /// outlive this object.
    explicit Services(property::Tree& tree, property::Assets* assets = nullptr);
    ~Services();
    Services(const Services&) = delete;
    Services& operator=(const Services&) = delete;

    Clock clock;  ///< the instance `time`
    View view;    ///< the instance `view`
    Audio audio;  ///< the instance `audio`
    Input input;  ///< the instance `input`
    /// The cameras of the game beside the view.
    Cameras& cameras() { return *cameras_; }
    /// The effect of the view.
    Effects& effects() { return *effects_; }
    /// Receives errors of the effect of the view.
    void on_effect_problem(std::function<void(const std::string&)> sink);
    /// Reads the file again if it is that of the effect.
    void renew_effect(const std::string& name);
    property::Assets* const assets;  ///< files of the game; null if there are none

  private:
    property::Tree& define(property::Tree& tree);

    property::Tree& tree_;
    std::weak_ptr<const property::Tree*> tree_life_;
    ClockPart clock_part_{clock};
    std::unique_ptr<Cameras> cameras_;
    std::unique_ptr<Effects> effects_;
};

}  // namespace fettle::app

FETTLE_APP_END
