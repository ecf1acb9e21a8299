#pragma once
// Where the fonts of the system are.

#include <array>
#include <cstdlib>
#include <filesystem>
#include <string>

#include <fettle/property/storage/export.h>

FETTLE_STORAGE_BEGIN

namespace fettle::property {

/// Fonts with letters and signs that DejaVu lacks, the first ones first.
inline constexpr std::array fallback_fonts{"DroidSansFallbackFull.ttf", "wqy-zenhei.ttc",
                                           "NotoSansCJK-Regular.ttc", "NanumGothic.ttf",
                                           "Symbola_hint.ttf"};

/// The file of a font by its name, such as "DejaVuSans.ttf"; "" if it is not installed. The
/// environment variable FETTLE_FONTS names the folder with the fonts of a packaged game.
inline std::string font_file(const std::string& name) {
    // Debian's folders, then folders of other systems with the same fonts.
    static constexpr std::array folders{"/usr/share/fonts/truetype/dejavu",
                                        "/usr/share/fonts/dejavu-sans-fonts",
                                        "/usr/share/fonts/dejavu-sans-mono-fonts",
                                        "/usr/share/fonts/dejavu",
                                        "/usr/share/fonts/TTF",
                                        "/usr/share/fonts/truetype/droid",
                                        "/usr/share/fonts/truetype/wqy",
                                        "/usr/share/fonts/truetype/noto",
                                        "/usr/share/fonts/noto",
                                        "/usr/share/fonts/google-noto-color-emoji-fonts",
                                        "/usr/share/fonts/opentype/noto",
                                        "/usr/share/fonts/noto-cjk",
                                        "/usr/share/fonts/truetype/ancient-scripts",
                                        "/usr/local/share/fonts/dejavu",
                                        "/Library/Fonts",
                                        "/opt/homebrew/share/fonts",
                                        "C:/Windows/Fonts"};
    const auto file_in = [&name](const std::filesystem::path& folder) {
        const std::filesystem::path file = folder / name;
        std::error_code ignored;
        return std::filesystem::is_regular_file(file, ignored) ? file.string() : std::string();
    };
    if (const char* const own = std::getenv("FETTLE_FONTS"))
        if (std::string file = file_in(own); !file.empty()) return file;
    for (const char* const folder : folders)
        if (std::string file = file_in(folder); !file.empty()) return file;
    return {};
}

}  // namespace fettle::property

FETTLE_STORAGE_END
