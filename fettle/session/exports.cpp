#include <session/exports.h>

#include <fstream>

#include <fettle/app/screen.h>

#include <files/game_path.h>
#include <session/session.h>

namespace fettle::program {

namespace fs = std::filesystem;

namespace {

constexpr int most_exports = 1000;  // of one game, so that a script does not fill the disk

}  // namespace

fs::path free_name(const fs::path& player, const std::string& name, const std::string& stem,
                   const std::string& kind) {
    if (player.empty()) throw FileError("this user has no folder for data of games");
    const fs::path folder = player / name;
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) throw FileError(folder.string() + ": " + error.message());
    for (int i = 1; i <= most_exports; ++i) {
        fs::path file = folder / (stem + "-" + std::to_string(i) + "." + kind);
        if (!fs::exists(fs::symlink_status(file, error))) return file;
    }
    throw FileError(folder.string() + ": there are " + std::to_string(most_exports) +
                    " files already; remove some");
}

std::string write_export(const fs::path& file, const std::string& content) {
    std::ofstream out(file, std::ios::binary);
    out << content;
    out.close();
    if (out) return file.string();
    std::error_code error;
    fs::remove(file, error);
    throw FileError(file.string() + ": it could not be written");
}

std::string draw_export(const fs::path& file, float width, float height,
                        const std::function<void(app::Surface&)>& draw) {
    if (!app::display_available())
        throw FileError("export_plot: a picture needs a display; \"csv\" needs none");
    const auto picture =
        app::make_picture(static_cast<unsigned>(width), static_cast<unsigned>(height));
    picture->begin(property::Color{0, 0, 0, 1});
    draw(picture->surface());
    picture->present();
    picture->save(file);
    return file.string();
}

fs::path Session::new_export(const std::string& kind) const {
    if (replayed_ != nullptr || isolated() || options_.sandbox)
        throw FileError("export_plot: a replay, a test and a game in a sandbox write no plots");
    return free_name(property::player_folder(options_.game, settings_.id), "plots", "plot", kind);
}

}  // namespace fettle::program
