#pragma once
// Differences between versions of Dear ImGui: passing keys (1.87), setting the clipboard (1.91.1),
// ending windows after an exception (1.91.3), the outline of the widget that has the keyboard
// (1.91.4), making textures and glyphs (1.92), and giving the keyboard to a widget (an error
// of 1.90.1). Only this file depends on the version.

#include <imgui.h>
#include <imgui_internal.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <optional>
#include <string_view>
#include <utility>

#include <fettle/app/surface.h>

#include <look/glyph_pictures.h>

namespace fettle::console::compat {

inline ImTextureID texture_id(app::Surface::Texture texture) {
    // A pointer before 1.91.4, an integer since then.
    return (ImTextureID)(std::uintptr_t)texture;  // NOLINT(performance-no-int-to-ptr)
}

inline app::Surface::Texture surface_texture(ImTextureID id) {
    return static_cast<app::Surface::Texture>((std::uintptr_t)id);
}

#if IMGUI_VERSION_NUM >= 18700
using KeyCode = ImGuiKey;
#else
using KeyCode = int;
#endif

/// The color of the outline round the widget that has the keyboard.
#if IMGUI_VERSION_NUM >= 19140
inline constexpr ImGuiCol keyboard_outline = ImGuiCol_NavCursor;
#else
inline constexpr ImGuiCol keyboard_outline = ImGuiCol_NavHighlight;
#endif

/// Keys that widgets use, by their names in app::InputEvent.
inline constexpr std::pair<std::string_view, KeyCode> keys[] = {
    {"tab", ImGuiKey_Tab},
    {"left", ImGuiKey_LeftArrow},
    {"right", ImGuiKey_RightArrow},
    {"up", ImGuiKey_UpArrow},
    {"down", ImGuiKey_DownArrow},
    {"page_up", ImGuiKey_PageUp},
    {"page_down", ImGuiKey_PageDown},
    {"home", ImGuiKey_Home},
    {"end", ImGuiKey_End},
    {"insert", ImGuiKey_Insert},
    {"delete", ImGuiKey_Delete},
    {"backspace", ImGuiKey_Backspace},
    {"space", ImGuiKey_Space},
    {"enter", ImGuiKey_Enter},
    {"escape", ImGuiKey_Escape},
    {"a", ImGuiKey_A},
    {"c", ImGuiKey_C},
    {"v", ImGuiKey_V},
    {"x", ImGuiKey_X},
    {"y", ImGuiKey_Y},
    {"z", ImGuiKey_Z},
};

struct Modifiers {
    bool control = false, shift = false, alt = false;
};

using ReadClipboard = const char* (*)(void* user);
using WriteClipboard = void (*)(void* user, const char* text);

#if IMGUI_VERSION_NUM >= 18700

inline void prepare_keys(ImGuiIO& io) {
    io.ConfigInputTrickleEventQueue = false;  // the console separates events by frames of its own
}
inline void key(ImGuiIO& io, KeyCode code, bool down) {
    io.AddKeyEvent(code, down);
}
inline void modifiers(ImGuiIO& io, Modifiers m) {
#if IMGUI_VERSION_NUM >= 18900
    io.AddKeyEvent(ImGuiMod_Ctrl, m.control);
    io.AddKeyEvent(ImGuiMod_Shift, m.shift);
    io.AddKeyEvent(ImGuiMod_Alt, m.alt);
#else
    io.AddKeyEvent(ImGuiKey_ModCtrl, m.control);
    io.AddKeyEvent(ImGuiKey_ModShift, m.shift);
    io.AddKeyEvent(ImGuiKey_ModAlt, m.alt);
#endif
}
inline void release_keys(ImGuiIO& io) {
    for (const auto& [name, code] : keys) io.AddKeyEvent(code, false);
    modifiers(io, {});
}
inline void mouse_position(ImGuiIO& io, float x, float y) {
    io.AddMousePosEvent(x, y);
}
inline void mouse_button(ImGuiIO& io, int button, bool down) {
    io.AddMouseButtonEvent(button, down);
}
inline void mouse_wheel(ImGuiIO& io, float notches) {
    io.AddMouseWheelEvent(0, notches);
}

#else

inline void prepare_keys(ImGuiIO& io) {
    for (const auto& [name, code] : keys) io.KeyMap[code] = code;
}
inline void key(ImGuiIO& io, KeyCode code, bool down) {
    io.KeysDown[code] = down;
}
inline void modifiers(ImGuiIO& io, Modifiers m) {
    io.KeyCtrl = m.control;
    io.KeyShift = m.shift;
    io.KeyAlt = m.alt;
}
inline void release_keys(ImGuiIO& io) {
    for (const auto& [name, code] : keys) io.KeysDown[code] = false;
    modifiers(io, {});
}
inline void mouse_position(ImGuiIO& io, float x, float y) {
    io.MousePos = ImVec2(x, y);
}
inline void mouse_button(ImGuiIO& io, int button, bool down) {
    io.MouseDown[button] = down;
}
inline void mouse_wheel(ImGuiIO& io, float notches) {
    io.MouseWheel += notches;
}

#endif

/// Whether the key went down in this frame. `repeated`: also while it is held.
inline bool pressed(ImGuiKey key, bool repeated = false) {
#if IMGUI_VERSION_NUM >= 18700
    return ImGui::IsKeyPressed(key, repeated);
#else
    return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key), repeated);
#endif
}
/// Whether the next widget is disabled.
inline bool disabled() {
    return (ImGui::GetCurrentContext()->CurrentItemFlags & ImGuiItemFlags_Disabled) != 0;
}
/// Whether a widget became active in the last frame.
inline bool keyboard_moved() {
    const ImGuiContext& context = *ImGui::GetCurrentContext();
    return context.ActiveId != 0 && context.ActiveIdIsJustActivated;
}
/// Takes the keyboard away from the active widget.
inline void release_keyboard() {
    ImGui::ClearActiveID();
}
/// Gives the keyboard to the next widget, in the next frame. Release 1.90.1 only does so if the
/// widget that had it last is in the same window.
inline void give_keyboard() {
#if IMGUI_VERSION_NUM >= 19010 && IMGUI_VERSION_NUM < 19020
    ImGuiContext& context = *ImGui::GetCurrentContext();
    context.NavFocusScopeId = context.CurrentFocusScopeId;
#endif
    ImGui::SetKeyboardFocusHere();
}
inline bool enter_pressed() {
    return pressed(ImGuiKey_Enter) || pressed(ImGuiKey_Tab);
}
inline bool escape_pressed() {
    return pressed(ImGuiKey_Escape);
}

/// Presses the button with that name in the next frame. The function for it has two names, by
/// version; the fields that it sets have one.
inline void press(const char* button) {
    ImGuiContext& context = *ImGui::GetCurrentContext();
    context.NavNextActivateId = ImGui::GetID(button);
    context.NavNextActivateFlags = ImGuiActivateFlags_None;
}

/// Ends the windows, groups, fonts and colors that were begun after its construction and that an
/// exception left open.
class Recovery {
  public:
#if IMGUI_VERSION_NUM >= 19130
    Recovery() {
        ImGui::ErrorRecoveryStoreState(&before_);
    }
    void recover() const {
        // Otherwise each of them is reported: the program ends, prints, or shows a tooltip.
        ImGuiIO& io = ImGui::GetIO();
        const bool asserts = std::exchange(io.ConfigErrorRecoveryEnableAssert, false);
        const bool prints = std::exchange(io.ConfigErrorRecoveryEnableDebugLog, false);
        const bool shows = std::exchange(io.ConfigErrorRecoveryEnableTooltip, false);
        ImGui::ErrorRecoveryTryToRecoverState(&before_);
        io.ConfigErrorRecoveryEnableAssert = asserts;
        io.ConfigErrorRecoveryEnableDebugLog = prints;
        io.ConfigErrorRecoveryEnableTooltip = shows;
    }

  private:
    ImGuiErrorRecoveryState before_;
#else
    /// Ends all that is open, so nothing may be open at the construction.
    void recover() const {
        const ImGuiContext& context = *ImGui::GetCurrentContext();
        while (context.FontStack.Size > 0) ImGui::PopFont();
        while (context.CurrentWindowStack.Size > 1) {
            end_window_content(context);
            if ((context.CurrentWindow->Flags & ImGuiWindowFlags_ChildWindow) != 0)
                ImGui::EndChild();
            else
                ImGui::End();
        }
        end_window_content(context);
    }

  private:
    static void end_window_content(const ImGuiContext& context) {
        // Groups that were begun in a table must end before the table does.
        while (context.GroupStack.Size >
               context.CurrentWindowStack.back().StackSizesOnBegin.SizeOfGroupStack)
            ImGui::EndGroup();
        ImGui::ErrorCheckEndWindowRecover(nullptr);
    }
#endif
};

/// Selects another font in the current size. To be ended with ImGui::PopFont().
inline void push_font(ImFont* font) {
#if IMGUI_VERSION_NUM >= 19200
    ImGui::PushFont(font, 0.0f);
#else
    ImGui::PushFont(font);
#endif
}

#if IMGUI_VERSION_NUM >= 19110

/// `user` is passed as the first argument of both functions.
inline void clipboard(void* user, ReadClipboard read, WriteClipboard write) {
    static thread_local ReadClipboard reader;
    static thread_local WriteClipboard writer;
    reader = read;
    writer = write;
    ImGuiPlatformIO& platform = ImGui::GetPlatformIO();
    platform.Platform_ClipboardUserData = user;
    platform.Platform_GetClipboardTextFn = [](ImGuiContext*) {
        return reader(ImGui::GetPlatformIO().Platform_ClipboardUserData);
    };
    platform.Platform_SetClipboardTextFn = [](ImGuiContext*, const char* text) {
        writer(ImGui::GetPlatformIO().Platform_ClipboardUserData, text);
    };
}

#else

inline void clipboard(void* user, ReadClipboard read, WriteClipboard write) {
    ImGuiIO& io = ImGui::GetIO();
    io.ClipboardUserData = user;
    io.GetClipboardTextFn = read;
    io.SetClipboardTextFn = write;
}

#endif

/// Draws the picture of a character for a line `size` pixels high; nothing: another font has it.
using PaintGlyph = std::function<std::optional<GlyphPictures::Picture>(ImWchar code, float size)>;

#if IMGUI_VERSION_NUM >= 19200

/// Whether a glyph is made when it is needed first. Before 1.92, all are made before the first
/// frame with them.
inline constexpr bool glyphs_on_demand = true;

/// What a font file is used for: all but these ranges, at most 32 that end with 0.
inline void leave_out(ImFontConfig& config, const ImWchar* ranges) {
    config.GlyphExcludeRanges = ranges;
}
inline bool load_glyph(ImFontAtlas* atlas, ImFontConfig* source, ImFontBaked* baked, void*,
                       ImWchar code, ImFontGlyph* glyph, float* only_advance) {
    const PaintGlyph* paint = nullptr;
    std::memcpy(&paint, source->FontData, sizeof paint);
    const auto picture = (*paint)(code, baked->Size);
    if (!picture) return false;
    if (only_advance != nullptr) {
        *only_advance = picture->advance;
        return true;
    }
    const ImFontAtlasRectId place = ImFontAtlasPackAddRect(atlas, picture->width, picture->height);
    if (place == ImFontAtlasRectId_Invalid) return false;
    glyph->Codepoint = code;
    glyph->AdvanceX = picture->advance;
    glyph->X0 = picture->left;
    glyph->Y0 = picture->top;
    glyph->X1 = picture->left + static_cast<float>(picture->width);
    glyph->Y1 = picture->top + static_cast<float>(picture->height);
    glyph->Visible = 1;
    glyph->Colored = picture->colored ? 1 : 0;
    glyph->PackId = place;
    ImFontAtlasBakedSetFontGlyphBitmap(atlas, baked, source, glyph,
                                       ImFontAtlasPackGetRect(atlas, place), picture->rgba.data(),
                                       ImTextureFormat_RGBA32, picture->width * 4);
    return true;
}
/// Characters that the files of the last font lack are painted. `paint` must exist as long as the
/// fonts do.
inline void add_painted(ImFontAtlas& atlas, const PaintGlyph& paint, float size) {
    static const ImFontLoader loader = [] {
        ImFontLoader made;
        made.Name = "pictures";
        made.FontBakedLoadGlyph = load_glyph;
        return made;
    }();
    const PaintGlyph* const at = &paint;
    ImFontConfig config;
    config.MergeMode = true;
    config.PixelSnapH = true;
    config.SizePixels = size;
    config.FontLoader = &loader;
    config.FontData = const_cast<const PaintGlyph**>(&at);  // the atlas copies the pointer
    config.FontDataSize = sizeof at;
    config.FontDataOwnedByAtlas = false;
    atlas.AddFont(&config);
}
/// The texture that new fonts will replace; 0: Dear ImGui destroys it by itself.
inline app::Surface::Texture replaced_texture() {
    return 0;
}
inline int add_glyph(ImFontAtlas&, ImFont*, ImWchar, int, int, float, ImVec2) {
    return 0;
}
inline void draw_glyph(ImFontAtlas&, int, ImFont&, ImWchar, const std::uint8_t*, bool) {}

inline void prepare_textures(ImGuiIO& io) {
    io.BackendFlags |= ImGuiBackendFlags_RendererHasTextures;
}
inline app::Surface::Texture texture_of(const ImDrawCmd& command) {
    return surface_texture(command.GetTexID());
}
/// Updates the textures of the surface before drawing. `changed`: it is another one than for the
/// last frame, and has none of them.
inline void update_textures(ImDrawData& data, app::Surface& surface, bool changed, bool) {
    if (data.Textures == nullptr) return;
    for (ImTextureData* texture : *data.Textures) {
        auto width = static_cast<unsigned>(texture->Width);
        auto height = static_cast<unsigned>(texture->Height);
        auto known = surface_texture(texture->TexID);
        if (texture->Status == ImTextureStatus_WantDestroy) {
            if (!changed) surface.destroy_texture(known);
            texture->SetTexID(ImTextureID_Invalid);
            texture->SetStatus(ImTextureStatus_Destroyed);
        } else if (texture->Status == ImTextureStatus_Destroyed) {
            continue;
        } else if (changed || texture->Status == ImTextureStatus_WantCreate) {
            auto* pixels = static_cast<const std::uint8_t*>(texture->GetPixels());
            texture->SetTexID(texture_id(surface.create_texture(width, height, pixels)));
            texture->SetStatus(ImTextureStatus_OK);
        } else if (texture->Status == ImTextureStatus_WantUpdates) {
            // Complete rows are copied, so that the pixels are contiguous.
            auto top = static_cast<unsigned>(texture->UpdateRect.y);
            auto* pixels =
                static_cast<const std::uint8_t*>(texture->GetPixelsAt(0, texture->UpdateRect.y));
            surface.update_texture(known, 0, top, width, texture->UpdateRect.h, pixels);
            texture->SetStatus(ImTextureStatus_OK);
        }
    }
}

#else

inline constexpr bool glyphs_on_demand = false;
inline void leave_out(ImFontConfig&, const ImWchar*) {}
inline app::Surface::Texture replaced_texture() {
    return surface_texture(ImGui::GetIO().Fonts->TexID);
}
inline void add_painted(ImFontAtlas&, const PaintGlyph&, float) {}
/// Reserves a part of the texture for the picture of a character. Returns its number.
inline int add_glyph(ImFontAtlas& atlas, ImFont* font, ImWchar code, int width, int height,
                     float advance, ImVec2 corner) {
    return atlas.AddCustomRectFontGlyph(font, code, width, height, advance, corner);
}
/// Copies the picture into the texture that was made. `colored`: it is drawn in its own colors.
inline void draw_glyph(ImFontAtlas& atlas, int rect, ImFont& font, ImWchar code,
                       const std::uint8_t* rgba, bool colored) {
    const ImFontAtlasCustomRect& place = *atlas.GetCustomRectByIndex(rect);
    if (atlas.TexPixelsRGBA32 == nullptr || !place.IsPacked()) return;
    const std::size_t row = std::size_t{4} * place.Width;
    for (unsigned y = 0; y < place.Height; ++y)
        std::memcpy(atlas.TexPixelsRGBA32 +
                        std::size_t(place.Y + y) * static_cast<std::size_t>(atlas.TexWidth) +
                        place.X,
                    rgba + y * row, row);
    if (const ImFontGlyph* const glyph = font.FindGlyphNoFallback(code))
        const_cast<ImFontGlyph*>(glyph)->Colored = colored ? 1 : 0;
}

inline void prepare_textures(ImGuiIO& io) {
    unsigned char* pixels = nullptr;
    int width = 0, height = 0;
    io.Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);  // builds the font atlas before a frame
}
/// A frame stores the texture number at its beginning, but another surface has other numbers. The
/// fonts are the only texture, so their current number is used.
inline app::Surface::Texture texture_of(const ImDrawCmd&) {
    return surface_texture(ImGui::GetIO().Fonts->TexID);
}
/// `changed`: it is another surface than for the last frame. `rebuilt`: the fonts were built again.
inline void update_textures(ImDrawData&, app::Surface& surface, bool changed, bool rebuilt) {
    ImFontAtlas& fonts = *ImGui::GetIO().Fonts;
    if (!changed && !rebuilt) return;
    unsigned char* pixels = nullptr;
    int width = 0, height = 0;
    fonts.GetTexDataAsRGBA32(&pixels, &width, &height);
    auto made =
        surface.create_texture(static_cast<unsigned>(width), static_cast<unsigned>(height), pixels);
    fonts.SetTexID(texture_id(made));
}

#endif

}  // namespace fettle::console::compat
