#include <look/extra_glyphs.h>

#include <algorithm>
#include <string>
#include <utility>

#include <fettle/property/storage/font_files.h>

#include <look/imgui_compat.h>
#include <text/utf8.h>

namespace fettle::console {

namespace {

// Each of them is drawn three times before the console is seen, so these are few.
constexpr ImWchar glyphs[] = {0x0020, 0x017f, 0x0192, 0x0192, 0x0391, 0x03c9, 0x0400, 0x045f,
                              0x2010, 0x203a, 0x2070, 0x208e, 0x20a0, 0x20bf, 0x2100, 0x2103,
                              0x2190, 0x21ff, 0x2200, 0x226f, 0x2308, 0x230b, 0x2500, 0x25ff,
                              0x2713, 0x2718, 0xfffd, 0xfffd, 0};

bool is_always_there(char32_t c) {
    for (const ImWchar* range = glyphs; range[0] != 0; range += 2)
        if (c >= range[0] && c <= range[1]) return true;
    return false;
}

constexpr char32_t first_stand_in = 0x3400, last_stand_in = 0x4dbf, replacement = 0xfffd;

bool needs_stand_in(char32_t c) {
    const bool is_one = c >= first_stand_in && c <= last_stand_in;
    const bool private_use = c >= 0xe000 && c <= 0xf8ff;
    return c > 0xffff || is_one || private_use;
}

/// Whether a text may have characters that need stand-ins, by the first bytes of those.
bool may_need_stand_in(std::string_view text) {
    return std::any_of(text.begin(), text.end(), [](char c) {
        const auto byte = static_cast<unsigned char>(c);
        return byte >= 0xee || byte == 0xe3 || byte == 0xe4;
    });
}

}  // namespace

const ImWchar* ExtraGlyphs::always() {
    return glyphs;
}

const ImWchar* ExtraGlyphs::others() {
    static const std::vector<ImWchar> ranges = [] {
        std::vector<ImWchar> all;
        bool inside = false;
        for (char32_t c = ' '; c <= 0xffff; ++c) {
            const bool other = !is_always_there(c) || cells_of(c) == 0;
            if (other && !inside) all.insert(all.end(), 2, static_cast<ImWchar>(c));
            if (other) all.back() = static_cast<ImWchar>(c);
            inside = other;
        }
        all.push_back(0);
        return all;
    }();
    return ranges.data();
}

const std::vector<const char*>& ExtraGlyphs::fallbacks() {
    static const std::vector<const char*> files = [] {
        std::vector<const char*> all = {"DejaVuSans.ttf"};
        all.insert(all.end(), property::fallback_fonts.begin(), property::fallback_fonts.end());
        return all;
    }();
    return files;
}

void ExtraGlyphs::look(std::string_view text) {
    if constexpr (compat::glyphs_on_demand) return;
    for (std::size_t i = 0; i < text.size(); i = next_code_point(text, i)) {
        if (static_cast<unsigned char>(text[i]) < 0xc0) continue;
        const char32_t c = code_point_at(text, i);
        if (is_always_there(c) && cells_of(c) > 0) continue;
        if (seen_.size() < most && seen_.insert(c).second) changed_ = true;
    }
}

char32_t ExtraGlyphs::shown(char32_t character) {
    if (!needs_stand_in(character)) return character;
    const std::size_t next = first_stand_in + stand_for_.size();
    if (const auto known = stand_ins_.find(character); known != stand_ins_.end())
        return known->second;
    if (next > last_stand_in) return replacement;
    stand_for_.push_back(character);
    return stand_ins_[character] = static_cast<ImWchar>(next);
}

std::string_view ExtraGlyphs::shown(std::string_view text, std::string& storage) {
    look(text);
    if (!may_need_stand_in(text)) return text;
    storage.clear();
    for (std::size_t i = 0; i < text.size();) {
        const std::size_t next = next_code_point(text, i);
        const char32_t c = code_point_at(text, i);
        if (needs_stand_in(c))
            append_code_point(storage, shown(c));
        else
            storage.append(text, i, next - i);
        i = next;
    }
    return storage;
}

std::string ExtraGlyphs::shown(std::string_view text) {
    std::string storage;
    return std::string(shown(text, storage));
}

std::string ExtraGlyphs::meant(std::string_view shown) const {
    if (stand_for_.empty() || !may_need_stand_in(shown)) return std::string(shown);
    std::string text;
    for (std::size_t i = 0; i < shown.size();) {
        const std::size_t next = next_code_point(shown, i);
        const char32_t c = code_point_at(shown, i);
        if (c >= first_stand_in && c - first_stand_in < stand_for_.size())
            append_code_point(text, stand_for_[c - first_stand_in]);
        else
            text.append(shown, i, next - i);
        i = next;
    }
    return text;
}

void ExtraGlyphs::prepare() {
    changed_ = false;
    narrow_.clear();
    wide_.clear();
    pictured_.clear();
    placed_.clear();
    painters_.clear();
    for (const char32_t c : seen_) {
        if (needs_stand_in(c) || cells_of(c) == 0 || pictures_.colored(c)) {
            pictured_.push_back(c);
            continue;
        }
        std::vector<ImWchar>& ranges = cells_of(c) == 2 ? wide_ : narrow_;
        ranges.insert(ranges.end(), 2, static_cast<ImWchar>(c));
    }
    for (std::vector<ImWchar>* const ranges : {&narrow_, &wide_})
        if (!ranges->empty()) ranges->push_back(0);
}

void ExtraGlyphs::add_file(ImFontAtlas& atlas, const char* file, float size, float cell) {
    const std::string found = property::font_file(file);
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
    if constexpr (compat::glyphs_on_demand) {
        const auto paint = [this, own_file, size, cell, painted = std::size_t{0}](
                               ImWchar code, float high) mutable {
            return painted++ < most ? this->paint(code, own_file, high, cell * high / size)
                                    : std::nullopt;
        };
        painters_.push_back(std::make_unique<compat::PaintGlyph>(paint));
        compat::add_painted(atlas, *painters_.back(), size);
        return;
    }
    if (seen_.empty()) return;
    add_file(atlas, own_file, size, cell);
    for (const char* const file : fallbacks())
        if (std::string_view(file) != own_file) add_file(atlas, file, size, cell);
    add_pictures(atlas, size, cell);
}

std::optional<GlyphPictures::Picture> ExtraGlyphs::paint(ImWchar code, const char* own_file,
                                                         float size, float cell) {
    const bool stands = code >= first_stand_in && code - first_stand_in < stand_for_.size();
    const char32_t c = stands ? stand_for_[code - first_stand_in] : char32_t{code};
    if (c < ' ') return std::nullopt;
    auto picture = pictures_.draw(c, size, cell, own_file);
    if (!picture && stands) picture = pictures_.draw(replacement, size, cell, own_file);
    return picture;
}

void ExtraGlyphs::add_pictures(ImFontAtlas& atlas, float size, float cell) {
    ImFont* const font = atlas.Fonts.back();
    for (const char32_t c : pictured_) {
        auto picture = pictures_.draw(c, size, cell);
        if (!picture) picture = pictures_.draw(replacement, size, cell);
        if (!picture) continue;
        const auto code = static_cast<ImWchar>(shown(c));
        const int rect = compat::add_glyph(atlas, font, code, picture->width, picture->height,
                                           picture->advance, ImVec2(picture->left, picture->top));
        placed_.push_back({rect, font, code, std::move(*picture)});
    }
}

void ExtraGlyphs::draw_pictures(ImFontAtlas& atlas) {
    for (const Placed& placed : placed_)
        compat::draw_glyph(atlas, placed.rect, *placed.font, placed.code,
                           placed.picture.rgba.data(), placed.picture.colored);
    placed_.clear();
}

}  // namespace fettle::console
