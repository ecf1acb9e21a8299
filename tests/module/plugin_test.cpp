// Modules in shared objects: the view of a game on a correct module, and faulty modules.

#include <catch.h>
#include <fcntl.h>
#include <shared_object.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <fstream>
#include <thread>
#include <vector>

#include "weather.h"

namespace plugin_test {

using namespace fettle;
namespace fs = std::filesystem;
using namespace fettle::module::testing;
using property::Handle;
using property::Value;

namespace {

struct Game {
    module::Plugins plugins;
    property::Tree tree;
    module::Plugin& weather = plugins.open(built("weather"));
    Handle front;
    Game() {
        weather.attach(tree);
        front = tree.child(tree.root(), "front");
    }
    Value get(const char* path) const { return property::get(tree, path); }
    void set(const char* path, const Value& value) { property::set(tree, path, value); }
    void step() {
        weather.step(0.5);
        weather.report(tree);
        tree.barrier();
    }
};

std::string message_of(const std::function<void()>& act) {
    try {
        act();
    } catch (const property::Error& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST_CASE("a module has a name and a version before it registers anything") {
    module::Plugins plugins;
    const module::Plugin& weather = plugins.open(built("weather"));
    CHECK(weather.name() == "weather");
    CHECK(weather.version() == "1.2");
    CHECK(plugins.find("weather") == &weather);
    CHECK(plugins.find("climate") == nullptr);
}

TEST_CASE("a class that a module registers is a class like any other") {
    Game game;
    const property::Class& cloud = game.tree.class_named("Cloud");
    CHECK(cloud.doc() == "Carries water.");
    CHECK(cloud.base() == &game.tree.object_class());
    const property::Property& water = *cloud.property("water");
    CHECK(water.unit == "kg");
    CHECK(water.range.max == 1000);
    CHECK(water.simulated);
    CHECK(cloud.property("mood")->read_only);
    CHECK(cloud.property("mood")->derives_from == std::vector<std::string>{"water"});
    CHECK(cloud.method("rain")->parameters.at(0).unit == "kg");
    CHECK(cloud.event("rained")->fields.size() == 1);
}

TEST_CASE("values of every binding are written to a module and read back") {
    Game game;
    CHECK(game.get("front.height") == Value(100.0));
    game.set("front.height", 250);
    CHECK(game.get("front.height") == Value(250.0));
    game.set("front.water", 60.0);
    CHECK(game.get("front.water") == Value(60.0));
    CHECK(game.get("front.mood") == Value("heavy"));
    game.set("front.kind", "cirrus");
    CHECK(game.get("front.kind") == Value("cirrus"));
    game.set("front.label", "gr\xC3\xA4u");
    CHECK(game.get("front.label") == Value("gr\xC3\xA4u"));
}

TEST_CASE("values for a module are checked before the module gets them") {
    Game game;
    CHECK(message_of([&] { game.set("front.water", 1001.0); }).find("1000") != std::string::npos);
    CHECK(message_of([&] { game.set("front.kind", "fog"); }).find("cirrus") != std::string::npos);
    CHECK(message_of([&] { game.set("front.mood", "glad"); }) != "");
    CHECK(game.get("front.water") == Value(0.0));
}

TEST_CASE("the error contains the reason for which a module refuses a value") {
    Game game;
    const std::string reported = message_of([&] { game.set("front.height", 13); });
    CHECK(reported.find("front.height") != std::string::npos);
    CHECK(reported.find("thirteen meters bring bad luck") != std::string::npos);
    CHECK(game.get("front.height") == Value(100.0));
}

TEST_CASE("a getter that returns another type than declared gives the default") {
    Game game;
    CHECK(game.get("front.slip") == Value(0.0));
}

TEST_CASE("watchers are notified of changes in a step of a module") {
    Game game;
    std::vector<double> seen;
    game.tree.watch(game.front, "water",
                    [&](const property::Change& c) { seen.push_back(c.new_value.number()); });
    const std::uint64_t before = game.weather.hash();
    game.step();
    CHECK(game.weather.hash() != before);
    game.step();
    CHECK(seen == std::vector<double>{0.5, 1.0});
}

TEST_CASE("methods of a module are called and its events are delivered") {
    Game game;
    double heard = 0;
    game.tree.on(game.front, *game.tree.class_of(game.front).event("rained"),
                 [&](const property::Occurrence& o) { heard = o.record.get("amount").number(); });
    game.set("front.water", 10.0);
    const property::Result left = game.tree.call(game.front, "rain", {Value(4)});
    CHECK(std::get<Value>(left) == Value(6.0));
    CHECK(game.get("front.water") == Value(6.0));
    CHECK(heard == 0);
    game.tree.barrier();
    CHECK(heard == 4);
    CHECK(message_of([&] {
              game.tree.call(game.front, "rain", {Value(99)});
          }).find("not that much water") != std::string::npos);
    const auto survey =
        std::get<std::vector<property::Record>>(game.tree.call(game.front, "survey", {}));
    REQUIRE(survey.size() == 2);
    CHECK(survey[1].get("what") == Value("height"));
    CHECK(survey[1].get("value") == Value(100.0));
}

TEST_CASE("a module makes and destroys rows with their instances") {
    Game game;
    const property::Class& cloud = game.tree.class_named("Cloud");
    std::vector<Handle> made;
    for (int i = 0; i < 63; ++i) made.push_back(game.tree.create(cloud, game.tree.root()));
    CHECK(message_of([&] { game.tree.create(cloud, game.tree.root()); }).find("sky is full") !=
          std::string::npos);
    game.tree.destroy(made[7]);
    const Handle again = game.tree.create(cloud, game.tree.root());
    CHECK(game.tree.row(again) == 8);
    CHECK(game.tree.get(again, "height") == Value(100.0));
}

TEST_CASE("the estimated memory of a game includes what its modules need") {
    Game game;
    const auto before = game.tree.weight();
    const Handle cloud = game.tree.create(game.tree.class_named("Cloud"), game.tree.root());
    CHECK(game.tree.weight() > before + 25000);  // of the class, and what the module adds
    game.tree.destroy(cloud);
    game.tree.barrier();
    CHECK(game.tree.weight() < before + 1000);
}

// --- Faulty modules

TEST_CASE("a file that is not a module is refused with a description") {
    const auto says = [](const char* name, const std::string& text) {
        const std::string reported = refusal(built(name));
        INFO(reported);
        CHECK(reported.find(built(name).string() + ": ") == 0);
        CHECK(reported.find(text) != std::string::npos);
    };
    says("nothing", "there is no such file");
    says("without_entry", "function fettle_module_open, found a shared object without it");
    says("newer_major", "expected a module for version 1.8");
    says("newer_major", "found one for 2.3");
    says("newer_minor", "found one for 1.9");
    says("bad_name", "found \"two words\"");
    says("missing_symbol", "it needs the symbol function_of_another_program");
    says("crash_when_opened", "crashed (Segmentation fault) while it was opened");
    says("crash_in_check", "crashed (Segmentation fault) in its own test");
    says("abort_in_check", "crashed (Aborted) in its own test");
    says("exit_in_check", "ended the process with status 3 in its own test");
    says("fail_in_check", "the barometer is stuck");
    says("hands_on",
         "no class is called \"Clowd\"");  // the message of the host: the module gives none
    says("forgetful", "class Harbor leaves its rows to `save` and `restore`");
    CHECK(refusal(FETTLE_TEST_MODULES).find("found a folder") != std::string::npos);
    CHECK(refusal(built("weather")) == "");
    CHECK(refusal(built("older_minor")) == "");
}

TEST_CASE("a module that ends the process in its trial is refused with any status") {
    const auto says = [](const char* name, const std::string& text) {
        const std::string reported = refusal(built(name));
        INFO(name << ": " << reported);
        CHECK(reported.find(built(name).string() + ": ") == 0);
        CHECK(reported.find(text) != std::string::npos);
    };
    says("exit_well_in_check", "ended the process with status 0 in its own test");
    says("exit_in_constructor", "ended the process with status 0 while it was opened");
    says("exit_when_opened", "ended the process with status 0 while it was opened");
    says("exit_in_attach", "ended the process with status 0 while it registered its classes");
    says("exit_in_step", "ended the process with status 0 in a step");
    says("silent_in_step", "did not come to an end in a step within 10 s");
}

TEST_CASE("a path without a regular file is refused without waiting") {
    const ModuleFile module("weather");
    const fs::path folder = module.path().parent_path();
    const auto says = [&](const fs::path& file, const std::string& found) {
        const std::string reported = refusal(file);
        INFO(reported);
        CHECK(reported == file.string() + ": expected a shared object, found " + found);
    };
    REQUIRE(::mkfifo((folder / "pipe.so").c_str(), 0600) == 0);
    says(folder / "pipe.so", "a pipe");
    fs::create_symlink("/dev/zero", folder / "device.so");
    says(folder / "device.so", "a device");
    fs::create_directory(folder / "folder.so");
    says(folder / "folder.so", "a folder");
    std::ofstream(folder / "huge.so") << "\x7f"
                                         "ELF";
    fs::resize_file(folder / "huge.so", std::uintmax_t{10} << 30);
    says(folder / "huge.so", "a file larger than 1024 MB");
    std::ofstream(folder / "text.so") << "no shared object";
    says(folder / "text.so", "a file of another kind");
    std::ofstream(folder / "empty.so");
    says(folder / "empty.so", "a file of another kind");
}

TEST_CASE("no copy of a module file is left") {
    const auto others = [](const fs::path& file) {
        std::size_t count = 0;
        for (const auto& each : fs::directory_iterator(file.parent_path()))
            count += each.path() != file;
        return count;
    };
    for (const char* const name : {"weather", "exit_in_constructor", "crash_when_opened",
                                   "exit_in_step", "missing_symbol", "without_entry"}) {
        const ModuleFile module(name);
        // Copies left by a killed process, by a living process, and files that are not copies.
        const fs::path folder = module.path().parent_path();
        std::ofstream(folder / ".weather.fettle-1-1.so") << "left";
        std::ofstream(folder / ".weather.so") << "mine";
        const int held =
            ::open((folder / ".weather.fettle-2-1.so").c_str(), O_RDWR | O_CREAT, 0600);
        REQUIRE(::flock(held, LOCK_EX | LOCK_NB) == 0);
        (void)refusal(module.path());
        INFO(name);
        CHECK(others(module.path()) == 2);
        CHECK_FALSE(fs::exists(folder / ".weather.fettle-1-1.so"));
        ::close(held);
    }
}

// Each making of a copy removes those of killed processes, which are the ones without a lock.
TEST_CASE("copies of a module that are made at the same time do not overwrite each other") {
    const ModuleFile module("weather");
    std::atomic<int> missing = 0;
    const auto make_copies = [&] {
        for (int i = 0; i < 300; ++i) {
            const module::ModuleCopy copy(module.path());
            missing += copy.path() == module.path() || !fs::exists(copy.path());
        }
    };
    std::vector<std::thread> threads;
    for (int i = 0; i < 4; ++i) threads.emplace_back(make_copies);
    for (std::thread& thread : threads) thread.join();
    CHECK(missing == 0);
}

TEST_CASE("a module is not loaded twice") {
    module::Plugins plugins;
    plugins.open(built("weather"));
    const auto says = [&](const std::filesystem::path& file) {
        try {
            plugins.open(file);
        } catch (const module::LoadError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    CHECK(says(built("weather")).find("loaded already, as the module weather") !=
          std::string::npos);
    CHECK(says(built("../modules/weather")).find("loaded already") != std::string::npos);
    CHECK(says(built("same_name")).find("module called weather is loaded already") !=
          std::string::npos);
    CHECK(plugins.all().size() == 1);
}

TEST_CASE("a class that already exists is reported and the game is unchanged") {
    Game game;
    module::Plugin& sky = game.plugins.open(built("same_class"));
    try {
        sky.attach(game.tree);
        FAIL("a second class Cloud was taken");
    } catch (const module::LoadError& error) {
        const std::string reported = error.what();
        INFO(reported);
        CHECK(reported.find("same_class.so: module sky") != std::string::npos);
        CHECK(reported.find("there is a class \"Cloud\" already") != std::string::npos);
    }
    game.set("front.water", 3.0);
    CHECK(game.get("front.water") == Value(3.0));
}

}  // namespace plugin_test
