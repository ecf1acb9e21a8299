#include <look/extra_glyphs.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <string>

#include <model/utf8.h>

namespace fettle::console {

namespace {

/// Debian's folders first, then folders of other systems with the same fonts.
constexpr std::array<const char*, 9> font_folders = {"/usr/share/fonts/truetype/dejavu",
                                                     "/usr/share/fonts/TTF",
                                                     "/usr/share/fonts/dejavu",
                                                     "/usr/share/fonts/dejavu-sans-mono-fonts",
                                                     "/usr/share/fonts/truetype/droid",
                                                     "/usr/share/fonts/truetype/wqy",
                                                     "/usr/share/fonts/opentype/noto",
                                                     "/usr/share/fonts/noto-cjk",
                                                     "/usr/share/fonts/truetype/ancient-scripts"};

/// Fonts that have what the others lack.
constexpr std::array<const char*, 5> fallbacks = {"DejaVuSans.ttf", "DroidSansFallbackFull.ttf",
                                                  "wqy-zenhei.ttc", "NotoSansCJK-Regular.ttc",
                                                  "Symbola_hint.ttf"};

constexpr ImWchar glyphs[] = {0x0020, 0x024f, 0x0370, 0x04ff, 0x2000, 0x214f, 0x2190, 0x22ff,
                              0x2500, 0x25ff, 0x2600, 0x27bf, 0xfffd, 0xfffd, 0};

bool is_always_there(char32_t c) {
    for (const ImWchar* range = glyphs; range[0] != 0; range += 2)
        if (c >= range[0] && c <= range[1]) return true;
    return false;
}

}  // namespace

std::string font_file(const char* name) {
    std::vector<std::filesystem::path> all(font_folders.begin(), font_folders.end());
    if (const char* const own = std::getenv("FETTLE_FONTS")) all.insert(all.begin(), own);
    for (const std::filesystem::path& folder : all) {
        std::filesystem::path file = folder / name;
        std::error_code error;
        if (std::filesystem::is_regular_file(file, error)) return file.string();
    }
    return {};
}

const ImWchar* ExtraGlyphs::always() {
    return glyphs;
}

void ExtraGlyphs::look(std::string_view text) {
    for (std::size_t i = 0; i < text.size(); i = next_code_point(text, i)) {
        if (static_cast<unsigned char>(text[i]) < 0xc0) continue;
        const char32_t c = code_point_at(text, i);
        if (c > IM_UNICODE_CODEPOINT_MAX || is_always_there(c)) continue;
        if (seen_.size() < most && seen_.insert(c).second) changed_ = true;
    }
}

void ExtraGlyphs::prepare() {
    changed_ = false;
    narrow_.clear();
    wide_.clear();
    for (const char32_t c : seen_) {
        std::vector<ImWchar>& ranges = is_wide(c) ? wide_ : narrow_;
        ranges.insert(ranges.end(), 2, static_cast<ImWchar>(c));
    }
    for (std::vector<ImWchar>* const ranges : {&narrow_, &wide_})
        if (!ranges->empty()) ranges->push_back(0);
}

void ExtraGlyphs::add_file(ImFontAtlas& atlas, const char* file, float size, float cell) {
    const std::string found = font_file(file);
    if (found.empty()) return;
    for (const bool wide : {false, true}) {
        const std::vector<ImWchar>& ranges = wide ? wide_ : narrow_;
        if (ranges.empty()) continue;
        ImFontConfig config;
        config.MergeMode = true;
        config.OversampleH = config.OversampleV = 1;
        config.PixelSnapH = true;
        if (cell > 0) config.GlyphMinAdvanceX = config.GlyphMaxAdvanceX = wide ? 2 * cell : cell;
        atlas.AddFontFromFileTTF(found.c_str(), size, &config, ranges.data());
    }
}

void ExtraGlyphs::add_to_last_font(ImFontAtlas& atlas, const char* own_file, float size,
                                   float cell) {
    if (seen_.empty()) return;
    add_file(atlas, own_file, size, cell);
    for (const char* const file : fallbacks)
        if (std::string_view(file) != own_file) add_file(atlas, file, size, cell);
}

}  // namespace fettle::console
