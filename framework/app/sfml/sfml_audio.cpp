// Checks for a sound device. The library does not tell whether it has found one.

#include <sfml/sfml_audio.h>

#if SFML_VERSION_MAJOR < 3 && defined(__unix__) && !defined(__APPLE__)
#include <dlfcn.h>
#endif

namespace fettle::app::sfml {

#if SFML_VERSION_MAJOR >= 3

bool audio_device_opened() {
    return sf::PlaybackDevice::getDevice().has_value();
}

#elif defined(__unix__) && !defined(__APPLE__)

bool audio_device_opened() {
    // SFML uses the same library, so it is already loaded and adds no dependency. Where it is not
    // found (a static build), nothing is known, and playing without a device does no harm.
    void* openal = dlopen("libopenal.so.1", RTLD_LAZY | RTLD_NOLOAD);
    if (openal == nullptr) return true;
    using Current = void* (*)();
    const auto current = reinterpret_cast<Current>(dlsym(openal, "alcGetCurrentContext"));
    return current == nullptr || current() != nullptr;
}

#else

bool audio_device_opened() {
    return true;
}

#endif

}  // namespace fettle::app::sfml
