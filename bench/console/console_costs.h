#pragma once
// Measures the time that the console takes in games with many bodies.

#include <cstddef>
#include <string>
#include <vector>

#include <fettle/app/screen.h>

namespace fettle::bench {

/// Processor time of the parts of a frame, ms.
struct ConsolePhases {
    double after_step = 0;      // updating breaks, plots and onion skins
    double between_frames = 0;  // waiting commands; ghosts
    double widgets = 0;         // reading the values that windows show, and layout
    double triangles = 0;       // passing the triangles to the screen
    double total() const { return after_step + between_frames + widgets + triangles; }
};

struct ConsoleCost {
    std::string state{};     // of the console: "closed"
    ConsolePhases median{};  // each phase by itself
    double frame = 0;        // median of all phases together, ms
    double longest = 0;      // of the frames, ms
    std::size_t drawn = 0;   // triangles of the last frame
};

/// Measures a game with that many sleeping bodies of one shape each, and one that flies. `screen`
/// receives the triangles; null: they are only counted. The first frames of a state, which lay out
/// windows and read the tree, are left out.
std::vector<ConsoleCost> console_costs(int bodies, int frames, app::Screen* screen);

}  // namespace fettle::bench
