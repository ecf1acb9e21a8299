#pragma once
// The fonts of a game by name, with other fonts for letters that one lacks.

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <fettle/property/media.h>
#include <fettle/property/storage/assets.h>

#include <letters/font.h>
#include <letters/system_fonts.h>

namespace fettle::visuals {

/// A font, and other fonts that supply the letters that it lacks.
class Family {
  public:
    Family(std::vector<std::shared_ptr<Font>> fonts, SystemFonts* others)
        : fonts_(std::move(fonts)), others_(others) {}
    /// Without any font on this system, a text has no size and is not drawn.
    bool empty() const { return fonts_.empty(); }
    Font& main() const { return *fonts_.front(); }
    /// The first font that has the letter, then one of the system; the main font if none has it.
    Font& with(char32_t letter) const;

  private:
    std::vector<std::shared_ptr<Font>> fonts_;
    SystemFonts* others_;
};

class Fonts {
  public:
    Fonts(property::Assets* assets, std::function<void(const std::string&)> report)
        : assets_(assets), report_(std::move(report)) {}
    /// "sans", "bold", "mono", or a file of the game. If a file is missing, "sans" and a message.
    const Family& get(const property::FileUser& user, const std::string& name);

    /// Reads the file again. False if it is not a font in use. If it cannot be read, the old font
    /// stays. Layouts made before may still be drawn.
    bool renew(const std::string& name);

  private:
    std::shared_ptr<Font> bundled(const std::string& file);
    std::shared_ptr<Font> of_game(const std::string& what, const std::string& name);

    property::Assets* assets_;
    std::function<void(const std::string&)> report_;
    std::map<std::string, std::shared_ptr<Font>> bundled_;
    std::map<std::string, Family> families_;
    std::vector<Family> replaced_;  // layouts refer to their fonts
    std::unique_ptr<SystemFonts> system_ = std::make_unique<SystemFonts>();
};

}  // namespace fettle::visuals
