#include <look/imgui_backend.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <vector>

#include <look/imgui_compat.h>
#include <look/theme.h>

namespace fettle::console {

namespace {

/// Debian's folder first, then folders of other systems with the same fonts.
constexpr std::array<const char*, 4> font_folders = {
    "/usr/share/fonts/truetype/dejavu", "/usr/share/fonts/TTF", "/usr/share/fonts/dejavu",
    "/usr/share/fonts/dejavu-sans-mono-fonts"};

std::string font_file(const char* name) {
    // A packaged game brings its fonts along.
    std::vector<std::filesystem::path> all(font_folders.begin(), font_folders.end());
    if (const char* const own = std::getenv("FETTLE_FONTS")) all.insert(all.begin(), own);
    for (const std::filesystem::path& folder : all) {
        std::filesystem::path file = folder / name;
        std::error_code error;
        if (std::filesystem::is_regular_file(file, error)) return file.string();
    }
    return {};
}

/// Characters for units and names: Latin, Greek, Cyrillic, punctuation, superscripts, currency,
/// letterlike, arrows, mathematics, box drawing, geometric shapes, dingbats.
constexpr ImWchar glyphs[] = {0x0020, 0x024f, 0x0370, 0x04ff, 0x2000, 0x214f, 0x2190, 0x22ff,
                              0x2500, 0x25ff, 0x2600, 0x27bf, 0xfffd, 0xfffd, 0};

ImFont* add_font(ImFontAtlas& atlas, const char* name, float size) {
    std::string file = font_file(name);
    if (file.empty()) return nullptr;
    ImFontConfig config;
    config.OversampleH = 1;  // whole pixels keep a fixed-width font sharp
    config.OversampleV = 1;
    config.PixelSnapH = true;
    return atlas.AddFontFromFileTTF(file.c_str(), size, &config, glyphs);
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
    io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
    io.ConfigWindowsMoveFromTitleBarOnly = true;
    io.MousePos = ImVec2(-1, -1);
    compat::prepare_keys(io);
    compat::clipboard(
        this,
        [](void* user) -> const char* {
            auto& self = *static_cast<ImGuiBackend*>(user);
            if (self.clipboard_ != nullptr) self.clipboard_text_ = self.clipboard_->read();
            return self.clipboard_text_.c_str();
        },
        [](void* user, const char* text) {
            auto& self = *static_cast<ImGuiBackend*>(user);
            self.clipboard_text_ = text;
            if (self.clipboard_ != nullptr) self.clipboard_->write(text);
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
            io.AddInputCharacter(event.character);
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

void ImGuiBackend::build_fonts(float font_size) {
    ImGuiIO& io = ImGui::GetIO();
    font_size_ = font_size;
    io.Fonts->Clear();
    regular_ = add_font(*io.Fonts, "DejaVuSansMono.ttf", font_size);
    bold_ = add_font(*io.Fonts, "DejaVuSansMono-Bold.ttf", font_size);
    if (regular_ != nullptr && bold_ != nullptr)
        add_font(*io.Fonts, "DejaVuSans.ttf", font_size);  // the third font, for labels
    if (regular_ == nullptr) {
        regular_ = io.Fonts->AddFontDefault();
        io.FontGlobalScale = font_size / 13;  // scales the built-in font, which is 13 pixels high
    }
    if (bold_ == nullptr) bold_ = regular_;
    compat::prepare_textures(io);
    fonts_changed_ = true;
    apply_theme(font_size);
}

void ImGuiBackend::begin_frame(float width, float height, double seconds, float font_size) {
    activate();
    ImGuiIO& io = ImGui::GetIO();
    if (font_size != font_size_) build_fonts(font_size);
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
    compat::update_textures(*data, surface, textures_on_ != &surface || fonts_changed_);
    textures_on_ = &surface;
    fonts_changed_ = false;
    for (int i = 0; i < data->CmdListsCount; ++i) draw_list(*data->CmdLists[i], surface);
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
        surface.triangles(vertices_, indices_, compat::texture_of(command),
                          {low.x, low.y, high.x - low.x, high.y - low.y});
    }
}

}  // namespace fettle::console
