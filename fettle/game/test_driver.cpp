#include <game/test_driver.h>

#include <stdexcept>
#include <string_view>
#include <utility>

#include <fettle/property/utf8.h>

#include <files/game_path.h>

namespace fettle::program {

namespace {

/// The characters of a text in UTF-8. Invalid bytes are left out.
std::u32string characters(const std::string& text) {
    std::u32string all;
    for (std::size_t i = 0; i < text.size();) {
        const std::size_t size = property::valid_code_point_size(std::string_view(text).substr(i));
        if (size > 0) all += property::code_point_at(text, i);
        i += size > 0 ? size : 1;
    }
    return all;
}

}  // namespace

TestDriver::TestDriver(TestChoice choice, const std::filesystem::path& game_folder,
                       property::GameFiles& files, app::Services& services,
                       script::Runtime& runtime)
    : choice_(std::move(choice)),
      folder_(game_folder),
      files_(files),
      services_(services),
      runtime_(runtime) {}

bool TestDriver::start() {
    const std::filesystem::path library = assets() / "testing" / "testing.lua";
    runtime_.add_function("fettle_test", [this](std::span<const property::Value> arguments) {
        return request(arguments);
    });
    if (!runtime_.run(files_.read(library), "testing.lua")) return false;
    if (!runtime_.run(files_.read(folder_ / choice_.file), choice_.file)) return false;
    return choice_.name.empty() || runtime_.call("fettle_test_begin", {choice_.name});
}

void TestDriver::turn() {
    if (done_ || choice_.name.empty()) return;
    if (!runtime_.call("fettle_test_turn", {})) return;
    // A picture is drawn while no script runs.
    while (const std::optional<Picture> picture = std::exchange(picture_, std::nullopt)) {
        const std::string why = compare_ ? compare_(picture->name, picture->tolerance) : "";
        const property::Value answer = why.empty() ? property::Value() : property::Value(why);
        if (!runtime_.call("fettle_test_turn", {answer})) return;
    }
}

/// Carries out the requests of the functions of tests.
property::Value TestDriver::request(std::span<const property::Value> arguments) {
    const std::string kind = arguments.empty() ? "" : arguments[0].text();
    if (kind == "test" && arguments.size() == 2)
        names_.push_back(arguments[1].text());
    else if (kind == "type" && arguments.size() == 2)
        type(arguments[1].text());
    else if (kind == "picture" && arguments.size() == 3)
        picture_ = {.name = arguments[1].text(), .tolerance = arguments[2].as_double()};
    else if (kind == "quits" && arguments.size() == 1)
        waits_for_quit_ = true;
    else if (kind == "done" && arguments.size() == 1)
        done_ = true;
    else
        throw std::invalid_argument("fettle_test is called by the functions of tests only");
    return {};
}

/// The game gets the text as if it were typed. The text does not pass through the loop, because a
/// recording would then contain it, and a replay, which runs the test again, would type it twice.
void TestDriver::type(const std::string& text) {
    for (const char32_t character : characters(text)) {
        app::InputEvent event;
        event.kind = app::EventKind::text;
        event.character = character;
        services_.input.apply(event);
    }
}

}  // namespace fettle::program
