#pragma once
// Drives one test of a game: the functions of tests in its scripts, and the test as a coroutine
// that goes on before every step. A replay of the run drives the test again.

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <fettle/app/services.h>
#include <fettle/property/storage/game_files.h>
#include <fettle/script/runtime.h>

namespace fettle::program {

/// A test in a file of the game. `file` is relative to the game's folder. Without a name, the tests
/// are only listed.
struct TestChoice {
    std::string file;
    std::string name;
};

class TestDriver {
  public:
    /// Compares the present picture of the game with the one of that name. Returns "" if they are
    /// alike, otherwise why not.
    using ComparePicture = std::function<std::string(const std::string& name, double tolerance)>;

    TestDriver(TestChoice choice, const std::filesystem::path& game_folder,
               property::GameFiles& files, app::Services& services, script::Runtime& runtime);

    /// Loads the file of tests and begins the test. False after an error, which is given to the
    /// runtime's `on_error`.
    bool start();
    /// Call before each step.
    void turn();
    /// Without it, pictures are not compared.
    void on_picture(ComparePicture compare) { compare_ = std::move(compare); }

    /// The tests of the file, in their order.
    const std::vector<std::string>& names() const { return names_; }
    bool done() const { return done_; }
    /// The test waits for the game to call quit(), which ends the test.
    bool waits_for_quit() const { return waits_for_quit_; }

  private:
    struct Picture {
        std::string name;
        double tolerance = 0;
    };
    property::Value request(std::span<const property::Value> arguments);
    void type(const std::string& text);

    TestChoice choice_;
    std::filesystem::path folder_;
    property::GameFiles& files_;
    app::Services& services_;
    script::Runtime& runtime_;
    ComparePicture compare_;
    std::vector<std::string> names_;
    std::optional<Picture> picture_;
    bool done_ = false;
    bool waits_for_quit_ = false;
};

}  // namespace fettle::program
