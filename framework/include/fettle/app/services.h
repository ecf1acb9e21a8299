#pragma once
// Services that every game has in its tree beside the world: `time`, `view`, `input`, `audio`.

#include <fettle/app/clock.h>
#include <fettle/app/export.h>
#include <fettle/app/input.h>
#include <fettle/app/view.h>
#include <fettle/property/tree.h>

FETTLE_APP_BEGIN

namespace fettle::app {

struct Audio {
    double volume = 1;  // of all sounds, 0 to 1
    bool muted = false;
};

/// Owns the values of the services and adds them to a tree. The tree must outlive this object.
/// Order of construction: tree, modules, services, runtime.
class Services {
  public:
    explicit Services(property::Tree& tree);
    ~Services();
    Services(const Services&) = delete;
    Services& operator=(const Services&) = delete;

    Clock clock;
    View view;
    Audio audio;
    Input input;

  private:
    property::Tree& define(property::Tree& tree);

    property::Tree& tree_;
    ClockPart clock_part_{clock};
};

}  // namespace fettle::app

FETTLE_APP_END
