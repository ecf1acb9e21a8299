// The file in which the console's layout of a game is kept.

#include <catch.h>
#include <session/console_layout.h>
#include <temporary_folder.h>

#include <filesystem>
#include <iterator>

namespace kept_layout_test {

using namespace fettle;

TEST_CASE("nothing that another run leaves keeps the layout of the console from being written") {
    const TemporaryFolder folder;
    // A fixed name of a temporary file would be taken by whichever game ends first.
    std::filesystem::create_directories(folder.path / "console.json.new" / "in the way");
    console::Layout layout;
    layout.pins = {"world.ball.mass"};
    layout.settings["plot_height"] = property::Value(300.0);
    program::write_layout(folder.path, layout);
    const console::Layout read = program::read_layout(folder.path);
    CHECK(read.pins == layout.pins);
    CHECK(read.settings.at("plot_height") == property::Value(300.0));
    layout.pins.clear();
    program::write_layout(folder.path, layout);
    CHECK(program::read_layout(folder.path).pins.empty());
    CHECK(std::distance(std::filesystem::directory_iterator(folder.path),
                        std::filesystem::directory_iterator()) == 2);
}

}  // namespace kept_layout_test
