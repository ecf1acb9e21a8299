#include <sfml/x11.h>

#if defined(__unix__) && !defined(__APPLE__)
#include <dlfcn.h>

#include <array>
#include <cstdlib>
#endif

namespace fettle::app::sfml {

#if defined(__unix__) && !defined(__APPLE__)

namespace {

/// A connection of its own, and what is called on it. SFML uses the same library, so it is already
/// loaded and adds no dependency.
struct X11 {
    void* server = nullptr;
    int (*query_keymap)(void*, char*) = nullptr;

    X11() {
        const char* name = std::getenv("DISPLAY");
        if (name == nullptr || *name == '\0') return;
        void* library = dlopen("libX11.so.6", RTLD_LAZY | RTLD_LOCAL);
        if (library == nullptr) return;
        using Open = void* (*)(const char*);
        const auto open = reinterpret_cast<Open>(dlsym(library, "XOpenDisplay"));
        query_keymap = reinterpret_cast<int (*)(void*, char*)>(dlsym(library, "XQueryKeymap"));
        // It stays open until the program ends: an X server may reset when its last client closes,
        // and would refuse SFML's connection then.
        if (open != nullptr) server = open(nullptr);
    }
};

const X11& x11() {
    static const X11 connection;
    return connection;
}

}  // namespace

bool has_x11() {
    return x11().server != nullptr;
}

bool is_key_left_of_1_down() {
    constexpr unsigned code = 49;  // TLDE, in all layouts of a PC
    if (x11().server == nullptr || x11().query_keymap == nullptr) return false;
    std::array<char, 32> down{};
    x11().query_keymap(x11().server, down.data());
    return (static_cast<unsigned char>(down[code / 8]) >> code % 8 & 1u) != 0;
}

#else

bool has_x11() {
    return false;
}

bool is_key_left_of_1_down() {
    return false;
}

#endif

}  // namespace fettle::app::sfml
