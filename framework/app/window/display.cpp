// Whether there is a display. SFML 2.5 ends the process when it finds none, so that one has to look
// before making anything of SFML's.

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
    // SFML's own library for windows; already loaded, hence not worth a dependency.
    void* x11 = dlopen("libX11.so.6", RTLD_LAZY | RTLD_LOCAL);
    if (x11 == nullptr) return false;
    using Open = void* (*)(const char*);
    const auto open = reinterpret_cast<Open>(dlsym(x11, "XOpenDisplay"));
    // The connection stays open as long as the program runs: a server whose last client leaves
    // starts anew, and would turn away SFML, which comes next.
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
