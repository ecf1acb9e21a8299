#pragma once
// The sound device. It follows the voices in the tree and never changes anything in it.

#include <memory>
#include <string>

#include <fettle/app/export.h>

FETTLE_APP_BEGIN

namespace fettle::app {

class Services;

/// The device is opened when the first voice sounds, so that a game without sound never opens it.
class Loudspeaker {
  public:
    Loudspeaker();
    ~Loudspeaker();
    Loudspeaker(const Loudspeaker&) = delete;
    Loudspeaker& operator=(const Loudspeaker&) = delete;

    /// To be called after each frame: from now on the device plays the voices that sound now.
    /// `halted`: the game makes no steps after an error, although its clock is not paused.
    void follow(const Services& services, bool halted);
    /// Stops the sound. Must be called before the services are destroyed.
    void silence();
    /// The reason why there is no sound, once; "" otherwise.
    std::string consume_problem();

  private:
    struct FETTLE_APP_PRIVATE Device;
    std::unique_ptr<Device> device_;
    std::string problem_;
    bool failed_ = false;
};

}  // namespace fettle::app

FETTLE_APP_END
