#include <images/images.h>

#include <array>
#include <exception>
#include <filesystem>
#include <stdexcept>
#include <utility>

#include <images/decoding.h>

namespace fettle::visuals {

using property::Color;

namespace {

constexpr std::array<std::string_view, 6> endings{".png", ".jpg", ".jpeg", ".bmp", ".tga", ".json"};

constexpr std::string_view saved_game = "save:";

constexpr std::size_t most_bytes = std::size_t{1} << 30;  // of all images of a game

void put(Sheet& sheet, Pixels pixels) {
    sheet.picture.replace(pixels.width, pixels.height, std::move(pixels.rgba));
}

}  // namespace

std::shared_ptr<const Sheet> Images::get(const property::FileUser& user, const std::string& name) {
    auto& known = sheets_[name];
    if (known == nullptr) known = load(user, name);
    return known;
}

/// For a saved game without a picture, such as one of a run without a window, the image is one
/// transparent pixel.
void Images::read_saved(Sheet& into, const std::string& slot) const {
    property::Thumbnail found = saved_ ? saved_(slot) : property::Thumbnail{};
    if (found.empty()) found = {1, 1, {0, 0, 0, 0}};
    into.picture.replace(found.width, found.height, std::move(found.pixels));
    into.found = true;
}

/// Changes nothing that is seen if it throws.
void Images::read(Sheet& into, const std::string& what, const std::string& name) const {
    if (name.starts_with(saved_game)) return read_saved(into, name.substr(saved_game.size()));
    if (assets_ == nullptr) throw std::runtime_error(what + ": this program has no files");
    Export found;
    std::string image = name;
    if (name.ends_with(".json")) {
        found = read_export(assets_->read(what, name, endings));
        image = (std::filesystem::path(name).parent_path() / found.image).generic_string();
        into.image = image;  // read again when it changes, also if it cannot be read now
    }
    Pixels pixels = decode(assets_->read(what, image, endings));
    std::size_t all = pixels.rgba.size();
    for (const auto& [known, sheet] : sheets_)
        if (sheet != nullptr && sheet.get() != &into)
            all += std::size_t{4} * sheet->picture.width() * sheet->picture.height();
    if (all > most_bytes)
        throw std::runtime_error("is too large: the images of this game would have " +
                                 std::to_string(all >> 20) + " MB of pixels, and may have " +
                                 std::to_string(most_bytes >> 20) + " MB");
    if (const auto color = transparent_.find(image); color != transparent_.end())
        pixels.clear(color->second);
    put(into, std::move(pixels));
    into.frames = std::move(found.frames);
    into.animations = std::move(found.animations);
    into.image = image;
    into.found = true;
}

void Images::make_transparent(const std::string& name, const std::optional<Color>& color) {
    const auto known = transparent_.find(name);
    if (color ? known != transparent_.end() && known->second == *color
              : known == transparent_.end())
        return;
    if (color)
        transparent_[name] = *color;
    else
        transparent_.erase(known);
    renew(name);
}

void Images::renew(const std::string& name) {
    for (const auto& [known, sheet] : sheets_) {
        if (sheet == nullptr || (known != name && sheet->image != name)) continue;
        reported_.clear();
        try {
            read(*sheet, "image", known);
        } catch (const std::exception& error) {
            report("\"" + known + "\": " + error.what());
        }
    }
}

std::shared_ptr<Sheet> Images::load(const property::FileUser& user, const std::string& name) {
    auto sheet = std::make_shared<Sheet>();
    const std::string what = user();
    try {
        read(*sheet, what, name);
    } catch (const std::exception& error) {
        const std::string why = error.what();
        report(why.starts_with(what) ? why : what + ": \"" + name + "\": " + why);
        put(*sheet, checkerboard());
    }
    return sheet;
}

void Images::report(const std::string& problem) {
    report_once(problem, [&] { return problem; });
}

void Images::report_once(const std::string& what, const std::function<std::string()>& problem) {
    const auto [reported, added] = reported_.try_emplace(what);
    if (!added) return;
    reported->second = problem();
    if (report_) report_(reported->second);
}

void Images::on_problem(std::function<void(const std::string&)> listener) {
    report_ = std::move(listener);
    if (!report_) return;
    for (const auto& [what, problem] : std::map(reported_)) report_(problem);
}

}  // namespace fettle::visuals
