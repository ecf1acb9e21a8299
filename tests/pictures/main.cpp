// fettle_pictures compare KEPT DRAWN              succeeds if the two pictures look the same
// fettle_pictures session FILE PROJECT FOLDER     plays a session, and writes its frames into
// FOLDER; into a file whose name ends in .png, only the last one. Without FOLDER, nothing is drawn

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>

#include <fettle/app/screen.h>

#include "sessions.h"

namespace {

using fettle::app::Pixels;

/// The share of the pixels that differ visibly in a channel, 0 to 1.
double difference(const Pixels& a, const Pixels& b) {
    constexpr int visible = 24;  // of 255
    if (a.width != b.width || a.height != b.height) return 1;
    std::size_t count = 0;
    for (std::size_t i = 0; i + 3 < a.rgba.size(); i += 4) {
        bool differs = false;
        for (std::size_t k = i; k < i + 3; ++k)
            differs = differs || std::abs(int{a.rgba[k]} - int{b.rgba[k]}) > visible;
        count += differs ? 1 : 0;
    }
    return static_cast<double>(count) * 4 / static_cast<double>(a.rgba.size());
}

int compare(const std::string& kept, const std::string& drawn) {
    constexpr double allowed = FETTLE_ALLOWED_DIFFERENCE;
    const double share =
        difference(fettle::app::read_picture(kept), fettle::app::read_picture(drawn));
    if (share <= allowed) return 0;
    std::printf("%s differs in %.2f %% of its pixels from what is drawn now, %s\n", kept.c_str(),
                share * 100, drawn.c_str());
    return 1;
}

int session(const std::string& file, const std::string& project, const std::string& frames) {
    std::printf("%d frames\n", fettle::pictures::play_session(file, project, frames));
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        const std::string command = argc > 1 ? argv[1] : "";
        if (command == "compare" && argc == 4) return compare(argv[2], argv[3]);
        if (command == "session" && (argc == 4 || argc == 5))
            return session(argv[2], argv[3], argc == 5 ? argv[4] : "");
        std::puts(
            "usage: fettle_pictures compare KEPT DRAWN | session FILE PROJECT [FOLDER|PICTURE]");
        return 2;
    } catch (const std::exception& error) {
        std::printf("%s\n", error.what());
        return 1;
    }
}
