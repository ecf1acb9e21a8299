// Checks for a display. SFML 2.5 ends the process if there is none, so the check must come first.

#include <fettle/app/screen.h>

#if defined(__unix__) && !defined(__APPLE__)
#include <dlfcn.h>

#include <cstdlib>
#endif

namespace fettle::app {

#if defined(__unix__) && !defined(__APPLE__)

namespace {

bool look_for_display() {
    const char* name = std::getenv("DISPLAY");
    if (name == nullptr || *name == '\0') return false;
    // SFML uses the same library, so it is already loaded and adds no dependency.
    void* x11 = dlopen("libX11.so.6", RTLD_LAZY | RTLD_LOCAL);
    if (x11 == nullptr) return false;
    using Open = void* (*)(const char*);
    const auto open = reinterpret_cast<Open>(dlsym(x11, "XOpenDisplay"));
    // The connection stays open until the program ends: an X server may reset when its last client
    // closes, and would refuse SFML's connection then.
    return open != nullptr && open(nullptr) != nullptr;
}

}  // namespace

bool display_available() {
    static const bool available = look_for_display();
    return available;
}

#else

bool display_available() {
    return true;
}

#endif

}  // namespace fettle::app
