#include <letters/fonts.h>

#include <algorithm>
#include <array>
#include <exception>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <utility>

#include <fettle/property/storage/font_files.h>

namespace fettle::visuals {
namespace {

constexpr std::array<std::string_view, 3> font_endings{".ttf", ".otf", ".ttc"};

/// The content of a font file of the system; empty if it has none of that name.
std::string system_font(const std::string& name) {
    std::ifstream in(property::font_file(name), std::ios::binary);
    std::ostringstream content;
    if (in) content << in.rdbuf();
    return content.str();
}

}  // namespace

Font& Family::with(char32_t letter) const {
    const auto found = std::find_if(fonts_.begin(), fonts_.end(),
                                    [&](const auto& font) { return font->has(letter); });
    if (found != fonts_.end()) return **found;
    Font* const other = others_ == nullptr ? nullptr : others_->with(letter);
    return other == nullptr ? main() : *other;
}

const Family& Fonts::get(const property::FileUser& user, const std::string& name) {
    if (const auto known = families_.find(name); known != families_.end()) return known->second;
    const std::shared_ptr<Font> sans = bundled("DejaVuSans.ttf");
    std::vector<std::shared_ptr<Font>> fonts;
    if (name == "mono")
        fonts.push_back(bundled("DejaVuSansMono.ttf"));
    else if (name == "bold")
        fonts.push_back(bundled("DejaVuSans-Bold.ttf"));
    else if (name != "sans" && !name.empty())
        fonts.push_back(of_game(user(), name));
    fonts.push_back(sans);
    std::erase(fonts, nullptr);
    if (fonts.empty()) report_(user() + ": this system has no font (Debian: fonts-dejavu-core)");
    return families_.emplace(name, Family(std::move(fonts), system_.get())).first->second;
}

bool Fonts::renew(const std::string& name) {
    const auto known = families_.find(name);
    if (known == families_.end()) return false;
    std::vector<std::shared_ptr<Font>> fonts = {of_game("font", name), bundled("DejaVuSans.ttf")};
    if (fonts.front() == nullptr) return false;
    std::erase(fonts, nullptr);
    replaced_.push_back(std::exchange(known->second, Family(std::move(fonts), system_.get())));
    return true;
}

std::shared_ptr<Font> Fonts::bundled(const std::string& file) {
    const auto [at, added] = bundled_.try_emplace(file);
    if (!added) return at->second;
    try {
        if (std::string content = system_font(file); !content.empty())
            at->second = std::make_shared<Font>(std::move(content));
    } catch (const std::exception&) {
        // A damaged file of the system is like a missing one.
    }
    return at->second;
}

std::shared_ptr<Font> Fonts::of_game(const std::string& what, const std::string& name) {
    try {
        if (assets_ == nullptr) throw std::runtime_error(what + ": this program has no files");
        return std::make_shared<Font>(assets_->read(what, name, font_endings));
    } catch (const std::exception& error) {
        std::string why = error.what();
        if (name.find('.') == name.npos)
            why += "; the fonts without a file are sans, bold and mono";
        report_(why.starts_with(what) ? why : what + ": \"" + name + "\" " + why);
        return nullptr;
    }
}

}  // namespace fettle::visuals
