#include <filesystem>
#include <fstream>
#include <utility>
#include <vector>

#include "catch.h"
#include "hosted.h"

namespace saves_test {

using namespace hosted;
namespace fs = std::filesystem;

/// An empty folder for the files of a test.
struct Folder {
    explicit Folder(const std::string& name) : path(fs::temp_directory_path() / name) {
        fs::remove_all(path);
        fs::create_directories(path);
    }
    ~Folder() { fs::remove_all(path); }
    std::string operator/(const char* name) const { return (path / name).string(); }
    fs::path path;
};

fettle_hosted_def definition() {
    fettle_hosted_def def;
    require(fettle_hosted_def_init(&def, sizeof def));
    return def;
}

Game created(const fettle_hosted_def& def, const char* lua = "") {
    fettle_hosted* made = nullptr;
    require(fettle_hosted_create(&def, &made));
    Game game(made);
    require(fettle_hosted_run(made, lua, "test"));
    return game;
}

struct Listed {
    std::string slot, problem;
    int64_t step;
};
std::vector<Listed> listed(const Game& game) {
    fettle_hosted_saved out[8];
    uint32_t count = 0;
    require(fettle_hosted_saves(game.get(), out, 8, &count));
    std::vector<Listed> found;
    for (uint32_t i = 0; i < count; ++i)
        found.push_back({out[i].slot, out[i].problem, out[i].step});
    return found;
}

void keep_problems(const Game& game, std::vector<std::string>* messages) {
    require(fettle_hosted_on_problem(
        game.get(),
        [](void* user, const fettle_hosted_problem* problem) {
            static_cast<std::vector<std::string>*>(user)->push_back(problem->message);
        },
        messages));
}

const char* const falling = "world.ball = Body { Circle {}, position = vec(0, 5) }";

TEST_CASE("a save and a snapshot report in the same words what does not fit the game") {
    const Folder folder("fettle_host_remarks");
    const std::string saves = folder / "saves";
    fettle_hosted_def def = definition();
    def.saves = saves.c_str();
    std::vector<char> state;
    {
        const Game game = created(def,
                                  "class('Door', Body) { wide = 3, open = true } "
                                  "world.door = Door { wide = 5 }");
        const void* bytes = nullptr;
        size_t size = 0;
        require(fettle_hosted_snapshot(game.get(), &bytes, &size));
        state.assign(static_cast<const char*>(bytes), static_cast<const char*>(bytes) + size);
        require(fettle_hosted_save(game.get(), "old"));
    }
    std::vector<std::string> messages;
    const Game game = created(def, "class('Door', Body) { wide = 'very' } world.door = Door {}");
    keep_problems(game, &messages);
    require(fettle_hosted_load_save(game.get(), "old"));
    const std::vector<std::string> loaded = std::exchange(messages, {});
    require(fettle_hosted_restore(game.get(), state.data(), state.size()));
    REQUIRE_FALSE(loaded.empty());
    REQUIRE(messages.size() == loaded.size());
    const std::string of_save = "the saved game \"old\": ", of_state = "the restored state: ";
    for (size_t i = 0; i < messages.size(); ++i) {
        REQUIRE(loaded[i].starts_with(of_save));
        REQUIRE(messages[i].starts_with(of_state));
        CHECK(messages[i].substr(of_state.size()) == loaded[i].substr(of_save.size()));
    }
    CHECK_THAT(messages[0], contains("Door"));
}

TEST_CASE("a host saves games in slots and loads them in another run") {
    const Folder folder("fettle_host_slots");
    const std::string saves = folder / "saves";
    fettle_hosted_def def = definition();
    def.saves = saves.c_str();
    double height = 0;
    {
        const Game game = created(def, falling);
        for (int i = 0; i < 20; ++i) require(fettle_hosted_step(game.get()));
        height = number_at(game.get(), "world.ball.position.y");
        require(fettle_hosted_save(game.get(), "first"));
        for (int i = 0; i < 20; ++i) require(fettle_hosted_step(game.get()));
        CHECK(number_at(game.get(), "world.ball.position.y") < height - 1);
        require(fettle_hosted_run(game.get(), "save_game('second')", "test"));
        require(fettle_hosted_step(game.get()));
        const std::vector<Listed> all = listed(game);
        REQUIRE(all.size() == 2);
        CHECK(all[0].slot == "first");
        CHECK(all[0].step == 20);
        CHECK(all[0].problem.empty());
        CHECK(all[1].slot == "second");
    }
    const Game later = created(def, falling);
    require(fettle_hosted_load_save(later.get(), "first"));
    CHECK(number_at(later.get(), "world.ball.position.y") == height);
    CHECK(number_at(later.get(), "time.step") == 20);
    require(fettle_hosted_step(later.get()));
    require(fettle_hosted_delete_save(later.get(), "first"));
    CHECK(listed(later).size() == 1);
    uint32_t count = 9;
    require(fettle_hosted_saves(later.get(), nullptr, 0, &count));
    CHECK(count == 1);
}

TEST_CASE("a save that cannot be used is refused and changes nothing") {
    const Folder folder("fettle_host_wrong_saves");
    fettle_hosted_def def = definition();
    const std::string saves = folder.path.string();
    def.saves = saves.c_str();
    const Game game = created(def, falling);
    require(fettle_hosted_save(game.get(), "first"));
    require(fettle_hosted_step(game.get()));
    const double height = number_at(game.get(), "world.ball.position.y");
    CHECK(fettle_hosted_load_save(game.get(), "frist") == FETTLE_INVALID);
    CHECK_THAT(fettle_last_error(), contains("first"));
    CHECK(fettle_hosted_delete_save(game.get(), "frist") == FETTLE_INVALID);
    CHECK(fettle_hosted_save(game.get(), "../x") == FETTLE_INVALID);
    CHECK(fettle_hosted_save(game.get(), nullptr) == FETTLE_INVALID);
    CHECK_THAT(fettle_last_error(), contains("slot: expected a pointer, got null"));

    def.name = "another";
    const Game another = created(def, falling);
    CHECK(fettle_hosted_load_save(another.get(), "first") == FETTLE_INVALID);
    CHECK_THAT(fettle_last_error(), contains("another"));
    REQUIRE(listed(another).size() == 1);
    CHECK_FALSE(listed(another)[0].problem.empty());

    for (const fs::path& file : fs::directory_iterator(folder.path))
        fs::resize_file(file, fs::file_size(file) / 2);
    CHECK(fettle_hosted_load_save(game.get(), "first") == FETTLE_INVALID);
    CHECK(number_at(game.get(), "world.ball.position.y") == height);
}

TEST_CASE("a host that cannot write its saves keeps the older one") {
    const Folder folder("fettle_host_no_place");
    const std::string file = folder / "file";
    std::ofstream(file) << "no folder";
    fettle_hosted_def def = definition();
    def.saves = file.c_str();
    const Game game = created(def, falling);
    CHECK(fettle_hosted_save(game.get(), "first") == FETTLE_INVALID);
    CHECK_THAT(fettle_last_error(), contains(file));
    std::vector<std::string> messages;
    keep_problems(game, &messages);
    require(fettle_hosted_run(game.get(), "save_game('first')", "test"));
    require(fettle_hosted_step(game.get()));
    REQUIRE(messages.size() == 1);
    CHECK_THAT(messages[0], contains("the game was not saved"));
}

TEST_CASE("a host without a folder for saves has none") {
    const Game game = make(falling);
    CHECK(fettle_hosted_save(game.get(), "first") == FETTLE_INVALID);
    CHECK_THAT(fettle_last_error(), contains("created without a folder for saved games"));
    CHECK(fettle_hosted_load_save(game.get(), "first") == FETTLE_INVALID);
    CHECK(fettle_hosted_delete_save(game.get(), "first") == FETTLE_INVALID);
    uint32_t count = 0;
    CHECK(fettle_hosted_saves(game.get(), nullptr, 0, &count) == FETTLE_INVALID);
}

TEST_CASE("a game is not saved by the functions that it calls") {
    const Folder folder("fettle_host_save_inside");
    const std::string saves = folder.path.string();
    fettle_hosted_def def = definition();
    def.saves = saves.c_str();
    const Game game = created(def, falling);
    require(fettle_hosted_add_function(
        game.get(), "save_it",
        [](void* user, const fettle_hosted_value*, uint32_t, fettle_hosted_value* result) {
            auto* const of = static_cast<fettle_hosted*>(user);
            const bool refused = fettle_hosted_save(of, "x") == FETTLE_LOCKED &&
                                 fettle_hosted_load_save(of, "x") == FETTLE_LOCKED;
            *result = number(refused ? 1 : 0);
            return fettle_code{FETTLE_DONE};
        },
        game.get()));
    fettle_hosted_value result;
    require(fettle_hosted_evaluate(game.get(), "save_it()", &result, nullptr));
    CHECK(result.as.number == 1);
}

TEST_CASE("the store of a hosted game outlives it") {
    const Folder folder("fettle_host_store");
    const std::string file = folder / "store.json";
    fettle_hosted_def def = definition();
    def.store_file = file.c_str();
    created(def, "store.best = 7 store.levels = { first = true }");
    const auto best = [&](const Game& game) {
        fettle_hosted_value value;
        require(fettle_hosted_evaluate(game.get(), "store.best", &value, nullptr));
        return value;
    };
    CHECK(best(created(def)).as.integer == 7);
    std::ofstream(file) << "{ damaged";
    const Game game = created(def);
    std::vector<std::string> messages;
    keep_problems(game, &messages);
    REQUIRE(messages.size() == 1);
    CHECK_THAT(messages[0], contains("the store of the game is empty"));
    CHECK_THAT(messages[0], contains("this file gets another name"));
    CHECK(best(game).type == FETTLE_VALUE_NIL);
    const Game without = make();
    CHECK(fettle_hosted_run(without.get(), "store.best = 1", "test") == FETTLE_FAILED);
    CHECK_THAT(fettle_last_error(), contains("store: this game has no place for one"));
}

TEST_CASE("edits in the console of a hosted game are kept for later runs") {
    const Folder folder("fettle_host_tweaks");
    std::ofstream(folder.path / "main.lua") << falling;
    const std::string path = folder.path.string();
    fettle_hosted_def def = definition();
    def.tweaks_of = path.c_str();
    {
        const Game game = created(def);
        require(fettle_hosted_load(game.get(), path.c_str()));
        const char* output = nullptr;
        require(
            fettle_hosted_evaluate(game.get(), "world.ball.gravity_scale = 0.5", nullptr, nullptr));
        require(fettle_hosted_evaluate(game.get(), "world.ball.bullet = true", nullptr, nullptr));
        require(fettle_hosted_step(game.get()));
        require(fettle_hosted_evaluate(game.get(), "keep('world.ball.gravity_scale')", nullptr,
                                       &output));
        CHECK_THAT(output, contains("kept 1 tweak"));
    }
    const Game later = created(def);
    std::vector<std::string> messages;
    keep_problems(later, &messages);
    require(fettle_hosted_load(later.get(), path.c_str()));
    CHECK(number_at(later.get(), "world.ball.gravity_scale") == 0.5);
    CHECK(get(later.get(), "world.ball.bullet").as.boolean == 0);
    REQUIRE(messages.size() == 1);
    CHECK_THAT(messages[0], contains("edits of earlier runs that were not kept: 1"));
    require(fettle_hosted_evaluate(later.get(), "reapply_tweaks('**')", nullptr, nullptr));
    CHECK(get(later.get(), "world.ball.bullet").as.boolean == 1);
}

}  // namespace saves_test
