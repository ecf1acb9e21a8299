#include <letters/system_fonts.h>

#include <fontconfig/fontconfig.h>

#include <exception>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <utility>

namespace fettle::visuals {
namespace {

struct EndConfig {
    void operator()(FcConfig* config) const { FcConfigDestroy(config); }
};
struct EndPattern {
    void operator()(FcPattern* pattern) const { FcPatternDestroy(pattern); }
};
struct EndSet {
    void operator()(FcFontSet* set) const { FcFontSetDestroy(set); }
};

/// Without a configuration there are no fonts, and Fontconfig would complain about that.
bool has_configuration() {
    FcChar8* const file = FcConfigFilename(nullptr);
    if (file == nullptr) return false;
    std::error_code error;
    const bool there = std::filesystem::exists(reinterpret_cast<const char*>(file), error);
    FcStrFree(file);
    return there;
}

}  // namespace

struct SystemFonts::Found {
    std::string file;
    int index = 0;
    std::shared_ptr<FcCharSet> letters;
    std::unique_ptr<Font> font;
    bool damaged = false;
};

SystemFonts::SystemFonts() = default;
SystemFonts::~SystemFonts() = default;

Font* SystemFonts::load(Found& found) {
    if (found.font != nullptr || found.damaged) return found.font.get();
    try {
        std::ifstream in(found.file, std::ios::binary);
        std::ostringstream content;
        content << in.rdbuf();
        found.font = std::make_unique<Font>(std::move(content).str(), found.index);
    } catch (const std::exception&) {
        found.damaged = true;  // a damaged font of the system is like a missing one
    }
    return found.font.get();
}

Font* SystemFonts::with(char32_t letter) {
    const auto [known, added] = known_.try_emplace(letter, nullptr);
    if (!added) return known->second;
    if (!std::exchange(searched_, true) && has_configuration()) {
        const std::unique_ptr<FcConfig, EndConfig> config(FcInitLoadConfigAndFonts());
        const std::unique_ptr<FcPattern, EndPattern> wanted(
            FcNameParse(reinterpret_cast<const FcChar8*>("sans")));
        if (config == nullptr || wanted == nullptr) return nullptr;
        FcConfigSubstitute(config.get(), wanted.get(), FcMatchPattern);
        FcDefaultSubstitute(wanted.get());
        FcResult result = FcResultMatch;
        // The list has only fonts with letters that the fonts before them lack.
        const std::unique_ptr<FcFontSet, EndSet> sorted(
            FcFontSort(config.get(), wanted.get(), FcTrue, nullptr, &result));
        for (int i = 0; sorted != nullptr && i < sorted->nfont; ++i) {
            FcChar8* file = nullptr;
            FcCharSet* letters = nullptr;
            auto found = std::make_unique<Found>();
            if (FcPatternGetString(sorted->fonts[i], FC_FILE, 0, &file) != FcResultMatch ||
                FcPatternGetCharSet(sorted->fonts[i], FC_CHARSET, 0, &letters) != FcResultMatch)
                continue;
            FcPatternGetInteger(sorted->fonts[i], FC_INDEX, 0, &found->index);
            found->file = reinterpret_cast<const char*>(file);
            found->letters.reset(FcCharSetCopy(letters), FcCharSetDestroy);
            found_.push_back(std::move(found));
        }
    }
    for (const auto& found : found_) {
        if (!FcCharSetHasChar(found->letters.get(), letter)) continue;
        Font* const font = load(*found);
        if (font == nullptr || !font->has(letter)) continue;
        known->second = font;
        break;
    }
    return known->second;
}

}  // namespace fettle::visuals
