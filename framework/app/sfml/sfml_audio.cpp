// Opening a sound device. SFML 2 does not report whether it has found one, and the libraries below
// it write pages of messages to the terminal if there is none.

#include <sfml/sfml_audio.h>

#if defined(__unix__) && !defined(__APPLE__)
#include <dlfcn.h>

#include <cstdlib>
#endif

namespace fettle::app::sfml {

#if defined(__unix__) && !defined(__APPLE__)

namespace {

/// Takes the messages of ALSA, which OpenAL uses.
void ignore_message(const char*, int, const char*, int, const char*, ...) {}

}  // namespace

void silence_audio_libraries() {
    ::setenv("ALSOFT_LOGLEVEL", "0", 0);  // a value of the user stays
    void* alsa = dlopen("libasound.so.2", RTLD_LAZY | RTLD_LOCAL);
    if (alsa == nullptr) return;
    using SetHandler = int (*)(void (*)(const char*, int, const char*, int, const char*, ...));
    const auto set = reinterpret_cast<SetHandler>(dlsym(alsa, "snd_lib_error_set_handler"));
    if (set != nullptr) set(ignore_message);
}

bool openal_device_opened() {
    // SFML uses the same library, so it is already loaded and adds no dependency. Where it is not
    // found (a static build), the device counts as open: playing without one does no harm.
    void* openal = dlopen("libopenal.so.1", RTLD_LAZY | RTLD_NOLOAD);
    if (openal == nullptr) return true;
    using Current = void* (*)();
    const auto current = reinterpret_cast<Current>(dlsym(openal, "alcGetCurrentContext"));
    return current == nullptr || current() != nullptr;
}

#else

void silence_audio_libraries() {}

bool openal_device_opened() {
    return true;
}

#endif

}  // namespace fettle::app::sfml
