#include <commands/gallery.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <stdexcept>
#include <system_error>
#include <utility>

#include <fettle/property/spelling.h>
#include <fettle/property/storage/saves.h>

#include <files/settings.h>
#include <session/session.h>

namespace fettle::program {

namespace fs = std::filesystem;

namespace {

constexpr unsigned picture_width = 1280, picture_height = 800;  // px, as it is drawn
constexpr std::uint32_t widest_picture = 480;                   // px, as it is kept
constexpr int picture_step = 180;   // the step after which a game is drawn
constexpr double longest_call = 2;  // s, one call into the scripts of a game that is drawn

/// The first sentence of the comment at the top of a script.
std::string first_sentence(const fs::path& script) {
    std::ifstream in(script);
    std::string text;
    for (std::string line; std::getline(in, line) && line.starts_with("--");) {
        line.erase(0, std::min(line.find_first_not_of("- "), line.size()));
        if (line.empty() && !text.empty()) break;
        text += (text.empty() ? "" : " ") + line;
    }
    const std::size_t end = text.find(". ");
    return end == std::string::npos ? text : text.substr(0, end + 1);
}

std::string title_of(const fs::path& game, const std::string& given) {
    if (!given.empty()) return given;
    std::string name = game.filename().string();
    if (!name.empty() && name[0] >= 'a' && name[0] <= 'z')
        name[0] = static_cast<char>(name[0] - 'a' + 'A');
    return name;
}

GalleryEntry entry_of(const fs::path& game) {
    property::GameSettings settings;
    try {
        settings = read_settings(game);
    } catch (const property::Error&) {
        // The game reports the error in its settings when it is opened.
    }
    return {.name = game.filename().string(),
            .title = title_of(game, settings.name),
            .about = first_sentence(game / "main.lua"),
            .released = !settings.version.empty(),
            .game = game};
}

/// Runs the game for some steps, without a trace, and draws it.
app::Pixels drawn(const fs::path& game) {
    RunOptions run;
    run.game = game;
    run.headless = true;
    run.isolated = true;
    Session session(run, nullptr, {});
    session.on_output([](std::string_view) {});
    session.runtime().limit_calls(longest_call, {});
    session.set_screen({picture_width, picture_height});
    session.start();
    for (int i = 0; i < picture_step && !session.failed() && !session.loop().stopped(); ++i)
        session.loop().turn();
    if (session.failed()) return {};
    const auto screen = app::make_picture(picture_width, picture_height);
    session.loop().draw(*screen, 0);
    screen->present();
    app::Pixels pixels = screen->pixels();
    property::Thumbnail small = property::scaled_down(
        {pixels.width, pixels.height, std::move(pixels.rgba)}, widest_picture);
    return {small.width, small.height, std::move(small.pixels)};
}

}  // namespace

std::vector<GalleryEntry> gallery_entries(const fs::path& gallery) {
    std::vector<GalleryEntry> entries;
    std::error_code error;
    for (fs::directory_iterator it(gallery.parent_path(), error), end; !error && it != end;
         it.increment(error)) {
        const fs::path& game = it->path();
        if (game.filename() == gallery.filename() || !fs::exists(game / "main.lua", error))
            continue;
        entries.push_back(entry_of(game));
    }
    std::ranges::sort(entries, [](const GalleryEntry& a, const GalleryEntry& b) {
        return a.released != b.released ? a.released : a.name < b.name;
    });
    return entries;
}

Gallery::Gallery(fs::path game) : game_(std::move(game)), entries_(gallery_entries(game_)) {}

void Gallery::connect(Session& session) {
    for (auto& [name, picture] : pictures_) picture.texture = 0;
    places_.clear();
    choice_.reset();
    script::Runtime& runtime = session.runtime();
    runtime.add_function("gallery_games",
                         [this](std::span<const property::Value>) { return games(); });
    runtime.add_function("gallery_show", [this](std::span<const property::Value> arguments) {
        show(arguments);
        return property::Value();
    });
    runtime.add_function("open_game", [this](std::span<const property::Value> arguments) {
        choose(arguments.empty() ? "" : arguments[0].text());
        return property::Value();
    });
}

property::Value Gallery::games() const {
    property::List list;
    for (const GalleryEntry& entry : entries_)
        list.emplace_back(property::List{entry.name, entry.title, entry.about});
    return list;
}

void Gallery::show(std::span<const property::Value> arguments) {
    if (arguments.size() != 6)
        throw std::invalid_argument(
            "gallery_show: needs a name, a rectangle and where the list begins");
    const auto number = [&](std::size_t i) { return static_cast<float>(arguments[i].as_double()); };
    places_.push_back(
        {arguments[0].text(), {number(1), number(2), number(3), number(4)}, number(5)});
}

void Gallery::choose(const std::string& name) {
    const auto found = std::ranges::find(entries_, name, &GalleryEntry::name);
    if (found == entries_.end()) {
        std::vector<std::string> names;
        for (const GalleryEntry& entry : entries_) names.push_back(entry.name);
        throw std::invalid_argument("open_game: there is no game \"" + name + "\" in the gallery" +
                                    property::suggestion(name, names));
    }
    choice_ = found->game;
}

std::optional<fs::path> Gallery::take_choice() {
    return std::exchange(choice_, std::nullopt);
}

void Gallery::make_picture() {
    for (const GalleryEntry& entry : entries_) {
        if (pictures_.contains(entry.name)) continue;
        Picture& picture = pictures_[entry.name];
        try {
            picture.pixels = drawn(entry.game);
        } catch (const std::exception&) {
            // It gets no picture, and shows its error when it is opened.
        }
        return;
    }
}

void Gallery::draw(app::Surface& surface, double) {
    for (const Place& place : std::exchange(places_, {})) {
        const auto found = pictures_.find(place.name);
        if (found == pictures_.end() || found->second.pixels.rgba.empty()) continue;
        Picture& picture = found->second;
        if (picture.texture == 0)
            picture.texture = surface.create_texture(picture.pixels.width, picture.pixels.height,
                                                     picture.pixels.rgba.data());
        const auto& [left, top, width, height] = place.rectangle;
        const std::array<app::SurfaceVertex, 4> corners = {
            {{left, top, 0, 0, 255, 255, 255, 255},
             {left + width, top, 1, 0, 255, 255, 255, 255},
             {left + width, top + height, 1, 1, 255, 255, 255, 255},
             {left, top + height, 0, 1, 255, 255, 255, 255}}};
        constexpr std::array<std::uint16_t, 6> indices = {0, 1, 2, 0, 2, 3};
        surface.triangles(corners, indices, picture.texture,
                          {0, place.top, surface.width(), surface.height() - place.top});
    }
}

}  // namespace fettle::program
