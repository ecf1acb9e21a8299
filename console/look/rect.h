#pragma once

#include <imgui.h>

namespace fettle::console {

/// A rectangle on the screen, in pixels.
struct Rect {
    ImVec2 low{0, 0}, high{0, 0};
    bool contains(float x, float y) const {
        return x >= low.x && x < high.x && y >= low.y && y < high.y;
    }
    ImVec2 middle() const { return ImVec2((low.x + high.x) / 2, (low.y + high.y) / 2); }
    bool empty() const { return low.x >= high.x || low.y >= high.y; }
};

/// The rectangle of the current window; the next function gives that of the last widget.
inline Rect window_rect() {
    ImVec2 at = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    return {at, ImVec2(at.x + size.x, at.y + size.y)};
}
inline Rect item_rect() {
    return {ImGui::GetItemRectMin(), ImGui::GetItemRectMax()};
}

}  // namespace fettle::console
