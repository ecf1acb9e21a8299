#include "games/game_costs.h"

#include <sys/resource.h>
#include <sys/wait.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <sstream>
#include <stdexcept>
#include <thread>

#include <fcntl.h>
#include <unistd.h>

#include "games/played.h"
#include "games/undrawn_screen.h"
#include "measure/timing.h"

namespace fettle::bench {

namespace fs = std::filesystem;

namespace {

constexpr int warm_up = 60, steps = 60, frames = 20;

const fs::path scripts = FETTLE_BENCH_SCRIPTS;

/// Enemies that turn to the player in their own `step`, as those of a game do.
const char* const enemies = R"lua(
world.gravity = vec(0, 0)
world.hero = Body { type = "kinematic", Circle { radius = 0.5 } }
Enemy = class("Enemy", Body) { speed = 2.0, charge = 0.0 }
function Enemy:step(dt)
    local to = world.hero.position - self.position
    self.velocity = to * (self.speed / (to:length() + 0.1))
    self.charge = self.charge + dt
    if self.charge > 1 then self.charge = 0 end
end
for i = 0, 3999 do
    world:add(Enemy { position = vec(i % 80 * 3 - 120, i // 80 * 3 - 75), speed = 1 + i % 3,
                      Circle { radius = 0.3 } })
end
)lua";

const char* const sprites = R"lua(
for i = 0, 19999 do
    game:add(Sprite { image = "hero.tga", position = vec(i % 200 * 0.1 - 10, i // 200 * 0.1 - 5),
                      angle = i * 0.1, pixels_per_unit = 100 })
end
view.height = 10
)lua";

const char* const particles = R"lua(
game.sparks = Emitter { rate = 0, burst = 50000, limit = 50000, lifetime = 1000, speed = 1,
                        gravity = vec(0, -0.1), damping = 0.5 }
)lua";

std::string tga(int width, int height) {
    std::string file(18, '\0');
    file[2] = 2;
    file[12] = static_cast<char>(width & 255);
    file[14] = static_cast<char>(height & 255);
    file[16] = 32;
    file[17] = 0x28;
    for (int i = 0; i < width * height; ++i)
        file += {static_cast<char>(i), static_cast<char>(i / 3), 120, static_cast<char>(255)};
    return file;
}

double of_steps(const char* main) {
    const TemporaryGame game;
    game.write("main.lua", main);
    Played played(game.folder());
    return played.step_ms(warm_up, steps);
}

double of_frames(const char* main) {
    const TemporaryGame game;
    game.write("hero.tga", tga(16, 16));
    game.write("main.lua", main);
    Played played(game.folder());
    UndrawnScreen screen(1280, 720);
    played.session().set_screen({1280, 720});
    return played.frame_ms(screen, frames);
}

/// A map with caves: half of its tiles are solid.
std::string caves(int side) {
    std::ostringstream cells;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const double depth = std::sin(0.31 * x) + std::cos(0.23 * y) + std::sin(0.11 * (x + y));
            cells << (x + y == 0 ? "" : ",") << (depth > 0 ? 1 : 0);
        }
    const std::string size = std::to_string(side);
    return R"({"type": "map", "orientation": "orthogonal", "width": )" + size + R"(, "height": )" +
           size + R"(, "tilewidth": 16, "tileheight": 16, "infinite": false,
        "tilesets": [{"firstgid": 1, "name": "tiles", "tilewidth": 16, "tileheight": 16,
            "tilecount": 1, "columns": 1, "image": "tiles.tga", "imagewidth": 16,
            "imageheight": 16, "tiles": [{"id": 0, "properties":
                [{"name": "solid", "type": "bool", "value": true}]}]}],
        "layers": [{"type": "tilelayer", "id": 1, "name": "ground", "width": )" +
           size + R"(, "height": )" + size + R"(, "data": [)" + cells.str() + "]}]}";
}

double map_load() {
    const TemporaryGame game;
    game.write("tiles.tga", tga(16, 16));
    game.write("level.tmj", caves(200));
    game.write("main.lua", "world.ball = Body { Circle { } }");
    std::vector<double> all;
    for (int i = 0; i < 5; ++i) {
        Played played(game.folder());
        played.step_ms(1, 1);
        const ThreadClock clock;
        played.run("world.level = Tilemap { map = \"level.tmj\" }");
        played.session().loop().turn();  // the collisions are made at a barrier
        all.push_back(clock.elapsed_ms());
        played.run("assert(#world.level.collisions:children() > 10)");
    }
    return median(std::move(all));
}

/// A script of a thousand lines: classes, functions and instances.
std::string long_script(int version) {
    std::ostringstream text;
    for (int i = 0; i < 100; ++i)
        text << "Thing" << i << " = class(\"Thing" << i << "\", Body) { speed = " << version
             << ".0, lives = 3 }\nfunction Thing" << i << ":step(dt)\n"
             << "    local to = vec(0, 0) - self.position\n    if to:length() > 5 then\n"
             << "        self.velocity = to * self.speed\n    end\nend\n"
             << "world.thing" << i << " = Thing" << i << " { position = vec(" << i << ", "
             << version << "),\n    Circle { radius = 0.3 } }\n\n";
    return text.str();
}

double reload() {
    const TemporaryGame game;
    game.write("main.lua", long_script(1));
    Played played(game.folder(), true);
    std::vector<double> all;
    for (int version = 2; version < 7; ++version) {
        played.step_ms(0, 2);
        game.write("main.lua", long_script(version));
        for (int looks = 0;; ++looks) {
            const ThreadClock clock;
            const auto followed = played.session().follow_files();
            const double ms = clock.elapsed_ms();
            if (followed == program::Session::Followed::changed) {
                all.push_back(ms);
                break;
            }
            if (looks == 100) throw std::runtime_error("the changed file was not read again");
            std::this_thread::sleep_for(std::chrono::milliseconds(50));
        }
    }
    return median(std::move(all));
}

constexpr const char* thousand = R"lua(
local enemies, bodies = require "enemies", require "bodies"
night:begin()
night:enter(3)
world.hero.max_hp, world.hero.hp = 1e9, 1e9
local kinds = { "shade", "moth", "brute", "spitter" }
for i = 1, 1000 do enemies.spawn(kinds[i % 4 + 1], bodies.toward(i * 2.4, 6 + i % 20)) end
)lua";

double lantern_step() {
    Played played(scripts / "lantern");
    played.step_ms(2, 1);
    played.run(thousand);
    const double ms = played.step_ms(20, steps);
    played.run("assert(#world.swarm:children() > 800, #world.swarm:children())");
    return ms;
}

double lantern_frame() {
    Played played(scripts / "lantern");
    UndrawnScreen screen(1280, 720);
    played.session().set_screen({1280, 720});
    played.step_ms(2, 1);
    played.run(thousand);
    return played.frame_ms(screen, frames);
}

/// Processor time of `fettle run GAME --steps 1`, which opens a window and draws a frame, ms.
double start() {
    const fs::path program = fs::canonical("/proc/self/exe").parent_path() / "fettle";
    const TemporaryGame game;
    game.write("main.lua", "world.ball = Body { Circle { radius = 0.5 } }");
    std::vector<double> all;
    for (int i = 0; i < 5; ++i) {
        const pid_t child = fork();
        if (child == 0) {
            const int nothing = open("/dev/null", O_RDWR);
            for (const int to : {0, 1, 2}) dup2(nothing, to);
            execl(program.c_str(), "fettle", "run", game.folder().c_str(), "--steps", "1",
                  static_cast<char*>(nullptr));
            _exit(127);
        }
        int status = 0;
        rusage used{};
        if (child < 0 || wait4(child, &status, 0, &used) < 0 || status != 0)
            throw std::runtime_error(program.string() + " run failed");
        const auto ms = [](const timeval& t) {
            return 1000.0 * static_cast<double>(t.tv_sec) + static_cast<double>(t.tv_usec) / 1000;
        };
        all.push_back(ms(used.ru_utime) + ms(used.ru_stime));
    }
    return median(std::move(all));
}

}  // namespace

std::vector<GameCost> game_costs() {
    return {
        {"step of 4 000 scripted enemies", "ms", at_most(7.9), false,
         [] { return of_steps(enemies); }},
        {"frame of 20 000 sprites", "ms", below(5), true, [] { return of_frames(sprites); }},
        {"step of 50 000 particles", "ms", at_most(2), false, [] { return of_steps(particles); }},
        {"frame of 50 000 particles", "ms", at_most(5), true, [] { return of_frames(particles); }},
        {"load of a map of 200 x 200 tiles", "ms", below(100), false, map_load},
        {"start to the first frame", "ms", at_most(300), true, start},
        {"reload of 1 000 lines", "ms", below(100), false, reload},
        {"lantern: step with 1 000 enemies", "ms", at_most(8), false, lantern_step},
        {"lantern: frame with 1 000 enemies", "ms", at_most(5), true, lantern_frame},
    };
}

}  // namespace fettle::bench
