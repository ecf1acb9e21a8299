#pragma once
// The view of the prompt: colored text, caret and selection, the dim suggestion, the reverse
// search, and the list of candidates.

#include <imgui.h>

#include <string>
#include <string_view>

#include <look/rect.h>
#include <prompt/prompt.h>

namespace fettle::console {

class PromptView {
  public:
    explicit PromptView(Prompt& prompt) : prompt_(prompt) {}

    /// Required height in pixels; it grows with the number of lines up to a third of `available`.
    float height(float available) const;
    void draw(float height, float cell, bool focused);
    /// Draws the list in a separate window, so that it is above everything.
    void draw_menu(float cell, ImFont* bold);
    /// The rectangle of the list of candidates; empty if it is not shown.
    const Rect& menu_rect() const { return menu_rect_; }
    /// The rectangle of the signature of the call that is being typed.
    const Rect& signature_rect() const { return signature_rect_; }
    const Rect& rect() const { return rect_; }
    /// Whether the prompt was clicked in the last frame.
    bool clicked() const { return clicked_; }

  private:
    void mouse(ImVec2 origin, float line_height, float cell);
    void draw_lines(ImVec2 origin, float line_height, float cell);
    void draw_line(std::string_view line, std::size_t base, ImVec2 at, float line_height,
                   float cell);
    void draw_caret(ImVec2 origin, float line_height, float cell, bool focused);
    void draw_candidate(std::size_t index, float width, float label_width, float cell);
    /// Texts with line breaks, and the height of both with the name, in pixels; 0 if there are
    /// none.
    struct Description {
        std::string facts, doc;
        float height = 0;
    };
    Description describe(float width, float facts_width) const;
    /// Where the menu of candidates is drawn, in pixels.
    struct MenuLayout {
        ImVec2 at;
        float width, height, label_width, row_height;
        float rows;    // that are seen at once
        bool scrolls;  // there are more
        Description description;
    };
    MenuLayout menu_layout(float cell) const;
    void draw_description(const Description& description, float cell, ImFont* bold);
    void draw_signature();
    void follow_caret(ImVec2 size, float line_height, float cell);

    Prompt& prompt_;
    ImVec2 menu_anchor_{0, 0}, signature_anchor_{0, 0};
    ImVec2 scroll_{0, 0};
    std::size_t blink_cursor_ = 0;
    double blink_from_ = 0;
    bool dragging_ = false;
    bool clicked_ = false;
    Rect rect_, menu_rect_, signature_rect_;
    std::size_t shown_selection_ = 0;
    float shown_rows_ = 0;  // of the list
};

}  // namespace fettle::console
