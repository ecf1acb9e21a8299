// Checks for a display. SFML 2.5 ends the process if there is none, so the check must come first.

#include <fettle/app/screen.h>

#include <sfml/x11.h>

namespace fettle::app {

bool display_available() {
#if defined(__unix__) && !defined(__APPLE__)
    return sfml::has_x11();
#else
    return true;
#endif
}

}  // namespace fettle::app
