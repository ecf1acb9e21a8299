// Whether there is a display. SFML 2.5 ends the process when it finds none, so that one has to look
// before making anything of SFML's.

#include <fettle/app/screen.h>

#if defined(__unix__) && !defined(__APPLE__)
#include <dlfcn.h>

#include <cstdlib>
#endif

namespace fettle::app {

#if defined(__unix__) && !defined(__APPLE__)

bool display_available() {
    const char* name = std::getenv("DISPLAY");
    if (name == nullptr || *name == '\0') return false;
    // SFML's own library for windows; already loaded, hence not worth a dependency.
    void* x11 = dlopen("libX11.so.6", RTLD_LAZY | RTLD_LOCAL);
    if (x11 == nullptr) return false;
    using Open = void* (*)(const char*);
    using Close = int (*)(void*);
    const auto open = reinterpret_cast<Open>(dlsym(x11, "XOpenDisplay"));
    const auto close = reinterpret_cast<Close>(dlsym(x11, "XCloseDisplay"));
    if (open == nullptr || close == nullptr) return false;
    void* display = open(nullptr);
    if (display == nullptr) return false;
    close(display);
    return true;  // the library stays loaded: SFML is about to use it
}

#else

bool display_available() {
    return true;
}

#endif

}  // namespace fettle::app
