#pragma once
// Fonts of the system for letters that the fonts of a game lack: Chinese, emoji, symbols.

#include <map>
#include <memory>
#include <vector>

#include <letters/font.h>

namespace fettle::visuals {

class SystemFonts {
  public:
    SystemFonts();
    ~SystemFonts();
    SystemFonts(const SystemFonts&) = delete;
    /// Null if no font of the system has the letter. The first call looks for the fonts.
    Font* with(char32_t letter);

  private:
    struct Found;
    Font* load(Found& font);

    bool searched_ = false;
    std::vector<std::unique_ptr<Found>> found_;  // the best ones first
    std::map<char32_t, Font*> known_;
};

}  // namespace fettle::visuals
