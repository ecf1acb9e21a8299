#include <look/imgui_backend.h>

#include <algorithm>
#include <cmath>

#include <fettle/property/storage/font_files.h>

#include <look/imgui_compat.h>
#include <look/theme.h>

namespace fettle::console {

namespace {

/// `cell`: the width of its characters, 0 if they have several widths.
ImFont* add_font(ImFontAtlas& atlas, ExtraGlyphs& extra, const char* name, float size, float cell) {
    std::string file = property::font_file(name);
    if (file.empty()) return nullptr;
    ImFontConfig config;
    config.OversampleH = 1;  // whole pixels keep a fixed-width font sharp
    config.OversampleV = 1;
    config.PixelSnapH = true;
    compat::leave_out(config, ExtraGlyphs::others());
    ImFont* const font =
        atlas.AddFontFromFileTTF(file.c_str(), size, &config, ExtraGlyphs::always());
    extra.add_to_last_font(atlas, name, size, cell);
    return font;
}

/// ImGui ends the program, or computes with integers that overflow, for values beyond what a screen
/// and a mouse can have. NaN becomes `low`.
template <class Number>
Number within(Number value, Number low, Number high) {
    return value > low ? std::min(value, high) : low;
}

constexpr float farthest = 1e6f;  // px

ImVec2 position_of(const app::InputEvent& event) {
    return {within(event.x, -farthest, farthest), within(event.y, -farthest, farthest)};
}

int mouse_button(const std::string& name) {
    constexpr std::array<std::string_view, 5> names = {"left", "right", "middle", "extra_1",
                                                       "extra_2"};
    auto found = std::find(names.begin(), names.end(), name);
    return found == names.end() ? -1 : static_cast<int>(found - names.begin());
}

}  // namespace

ImGuiBackend::ImGuiBackend(app::Clipboard* clipboard) : clipboard_(clipboard) {
    ImGuiContext* before = ImGui::GetCurrentContext();
    context_ = ImGui::CreateContext();
    ImGui::SetCurrentContext(context_);
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.LogFilename = nullptr;
    io.UserData = &extra_;  // for ExtraGlyphs::current
    io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
    io.ConfigWindowsMoveFromTitleBarOnly = true;
    io.MousePos = ImVec2(-1, -1);
    compat::prepare_keys(io);
    compat::clipboard(
        this,
        [](void* user) -> const char* {
            auto& self = *static_cast<ImGuiBackend*>(user);
            if (self.clipboard_ != nullptr)
                self.clipboard_text_ = self.extra_.shown(self.clipboard_->read());
            return self.clipboard_text_.c_str();
        },
        [](void* user, const char* text) {
            auto& self = *static_cast<ImGuiBackend*>(user);
            self.clipboard_text_ = text;
            if (self.clipboard_ != nullptr) self.clipboard_->write(self.extra_.meant(text));
        });
    if (before != nullptr) ImGui::SetCurrentContext(before);
}

ImGuiBackend::~ImGuiBackend() {
    ImGui::DestroyContext(context_);
}

void ImGuiBackend::activate() {
    ImGui::SetCurrentContext(context_);
}

void ImGuiBackend::feed(const app::InputEvent& event) {
    activate();
    ImGuiIO& io = ImGui::GetIO();
    switch (event.kind) {
        case app::EventKind::key_pressed:
        case app::EventKind::key_released: {
            feed_modifiers(event);
            bool down = event.kind == app::EventKind::key_pressed;
            for (const auto& [name, code] : compat::keys)
                if (name == event.name) compat::key(io, code, down);
            break;
        }
        case app::EventKind::text:
            io.AddInputCharacter(static_cast<unsigned>(extra_.shown(event.character)));
            break;
        case app::EventKind::mouse_moved: {
            const ImVec2 at = position_of(event);
            compat::mouse_position(io, at.x, at.y);
            break;
        }
        case app::EventKind::mouse_pressed:
        case app::EventKind::mouse_released: {
            const ImVec2 at = position_of(event);
            compat::mouse_position(io, at.x, at.y);
            int button = mouse_button(event.name);
            if (button >= 0)
                compat::mouse_button(io, button, event.kind == app::EventKind::mouse_pressed);
            break;
        }
        case app::EventKind::wheel:
            if (!std::isnan(event.delta)) compat::mouse_wheel(io, within(event.delta, -1e3f, 1e3f));
            break;
        default:
            break;
    }
}

void ImGuiBackend::feed_modifiers(const app::InputEvent& event) {
    activate();
    // The event of a modifier key may contain the state before it.
    bool down = event.kind == app::EventKind::key_pressed;
    auto held = [&](std::string_view name, bool flag) {
        return event.name.ends_with(name) ? down : flag;
    };
    compat::modifiers(ImGui::GetIO(), {held("_control", event.control), held("_shift", event.shift),
                                       held("_alt", event.alt)});
}

void ImGuiBackend::release_all() {
    activate();
    ImGuiIO& io = ImGui::GetIO();
    compat::release_keys(io);
    for (int button = 0; button < 5; ++button) compat::mouse_button(io, button, false);
}

void ImGuiBackend::navigate_with_keys(bool on) {
    activate();
    int& flags = ImGui::GetIO().ConfigFlags;
    flags = on ? flags | ImGuiConfigFlags_NavEnableKeyboard
               : flags & ~ImGuiConfigFlags_NavEnableKeyboard;
}

void ImGuiBackend::close_menus() {
    activate();
    if (ImGui::GetCurrentContext()->OpenPopupStack.Size > 0) ImGui::ClosePopupToLevel(0, true);
}

void ImGuiBackend::build_fonts(float font_size) {
    ImGuiIO& io = ImGui::GetIO();
    font_size_ = font_size;
    if (const auto texture = compat::replaced_texture(); texture != 0) replaced_ = texture;
    io.Fonts->Clear();
    extra_.prepare();
    // A character of DejaVu Sans Mono is 1233/2384 of the font size wide, rounded to whole pixels.
    const float cell = std::floor(font_size * 1233 / 2384 + 0.5f);
    regular_ = add_font(*io.Fonts, extra_, "DejaVuSansMono.ttf", font_size, cell);
    bold_ = add_font(*io.Fonts, extra_, "DejaVuSansMono-Bold.ttf", font_size, cell);
    if (regular_ != nullptr && bold_ != nullptr)
        add_font(*io.Fonts, extra_, "DejaVuSans.ttf", font_size, 0);  // the third font, for labels
    if (regular_ == nullptr) {
        regular_ = io.Fonts->AddFontDefault();
        io.FontGlobalScale = font_size / 13;  // scales the built-in font, which is 13 pixels high
    }
    if (bold_ == nullptr) bold_ = regular_;
    compat::prepare_textures(io);
    extra_.draw_pictures(*io.Fonts);
    fonts_changed_ = true;
    apply_theme(font_size);
}

void ImGuiBackend::begin_frame(float width, float height, double seconds, float font_size) {
    activate();
    ImGuiIO& io = ImGui::GetIO();
    if (font_size != font_size_ || extra_.changed()) build_fonts(font_size);
    constexpr float largest = 32768;  // px
    io.DisplaySize = ImVec2(within(width, 1.0f, largest), within(height, 1.0f, largest));
    io.DeltaTime = static_cast<float>(within(seconds, 1e-5, 1.0));
    ImGui::NewFrame();
}

void ImGuiBackend::end_frame() {
    ImGui::Render();
}

void ImGuiBackend::draw(app::Surface& surface) {
    activate();
    ImDrawData* data = ImGui::GetDrawData();
    if (data == nullptr) return;
    compat::update_textures(*data, surface, textures_on_ != &surface, fonts_changed_);
    if (textures_on_ != &surface)
        pictures_.change_surface();
    else if (replaced_ != 0)
        surface.destroy_texture(replaced_);
    replaced_ = 0;
    textures_on_ = &surface;
    fonts_changed_ = false;
    for (int i = 0; i < data->CmdListsCount; ++i) draw_list(*data->CmdLists[i], surface);
    pictures_.end_frame(surface);
}

// Each command gets only the vertices that it uses, with indices from 0, because a surface may copy
// everything it gets.
void ImGuiBackend::draw_list(const ImDrawList& list, app::Surface& surface) {
    for (const ImDrawCmd& command : list.CmdBuffer) {
        if (command.UserCallback != nullptr || command.ElemCount == 0) continue;
        ImVec2 low(std::max(command.ClipRect.x, 0.0f), std::max(command.ClipRect.y, 0.0f));
        ImVec2 high(std::min(command.ClipRect.z, surface.width()),
                    std::min(command.ClipRect.w, surface.height()));
        if (low.x >= high.x || low.y >= high.y) continue;
        const ImDrawIdx* first = list.IdxBuffer.Data + command.IdxOffset;
        const ImDrawIdx* end = first + command.ElemCount;
        auto [lowest, highest] = std::minmax_element(first, end);
        vertices_.clear();
        for (std::size_t i = *lowest; i <= *highest; ++i) {
            const ImDrawVert& v = list.VtxBuffer.Data[command.VtxOffset + i];
            vertices_.push_back({v.pos.x, v.pos.y, v.uv.x, v.uv.y,
                                 static_cast<std::uint8_t>(v.col >> IM_COL32_R_SHIFT),
                                 static_cast<std::uint8_t>(v.col >> IM_COL32_G_SHIFT),
                                 static_cast<std::uint8_t>(v.col >> IM_COL32_B_SHIFT),
                                 static_cast<std::uint8_t>(v.col >> IM_COL32_A_SHIFT)});
        }
        indices_.clear();
        for (const ImDrawIdx* i = first; i != end; ++i)
            indices_.push_back(static_cast<std::uint16_t>(*i - *lowest));
        const auto picture = pictures_.texture(surface, command.GetTexID());
        surface.triangles(vertices_, indices_, picture ? *picture : compat::texture_of(command),
                          {low.x, low.y, high.x - low.x, high.y - low.y});
    }
}

}  // namespace fettle::console
