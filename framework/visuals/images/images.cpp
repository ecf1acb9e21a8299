#include <images/images.h>

#include <array>
#include <exception>
#include <filesystem>
#include <stdexcept>
#include <utility>

#include <images/decoding.h>

namespace fettle::visuals {
namespace {

constexpr std::array<std::string_view, 6> endings{".png", ".jpg", ".jpeg", ".bmp", ".tga", ".json"};

void put(Sheet& sheet, Pixels pixels) {
    sheet.picture.replace(pixels.width, pixels.height, std::move(pixels.rgba));
}

}  // namespace

std::shared_ptr<const Sheet> Images::get(const std::string& what, const std::string& name) {
    auto& known = sheets_[name];
    if (known == nullptr) known = load(what, name);
    return known;
}

std::shared_ptr<const Sheet> Images::load(const std::string& what, const std::string& name) {
    auto sheet = std::make_shared<Sheet>();
    try {
        if (assets_ == nullptr) throw std::runtime_error(what + ": this program has no files");
        std::string image = name;
        if (name.ends_with(".json")) {
            Export found = read_export(assets_->read(what, name, endings));
            image = (std::filesystem::path(name).parent_path() / found.image).generic_string();
            sheet->frames = std::move(found.frames);
            sheet->animations = std::move(found.animations);
        }
        put(*sheet, decode(assets_->read(what, image, endings)));
        sheet->found = true;
    } catch (const std::exception& error) {
        const std::string why = error.what();
        tell(why.starts_with(what) ? why : what + ": \"" + name + "\": " + why);
        sheet->frames.clear();
        sheet->animations.clear();
        put(*sheet, checkerboard());
    }
    return sheet;
}

void Images::tell(const std::string& problem) {
    if (told_.insert(problem).second && tell_) tell_(problem);
}

void Images::on_problem(std::function<void(const std::string&)> tell) {
    tell_ = std::move(tell);
    if (!tell_) return;
    for (const std::string& problem : std::set(told_)) tell_(problem);
}

}  // namespace fettle::visuals
