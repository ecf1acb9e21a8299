#pragma once
// Sizes of windows that several parts of the layout need.

#include <imgui.h>

namespace fettle::console {

inline constexpr int panel_flags =
    ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
    ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoScrollWithMouse;
inline constexpr float margin = 8;           // pixels around the windows
inline constexpr float least_inspector = 8;  // the height of the inspector below the panel, in ems

}  // namespace fettle::console
