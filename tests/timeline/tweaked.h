#pragma once
// A game with three balls whose edits by a person are listed as tweaks.

#include <fettle/property/storage/tweaks.h>

#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "playing.h"
#include "temporary_folder.h"

namespace tweaked {

using namespace fettle;
using namespace fettle::app;
using property::Handle;
using property::Tweak;
using property::Value;

inline constexpr const char* three_balls = R"(
    world.a = Body { position = vec(-3, 4), Circle {} }
    world.b = Body { position = vec(0, 4), Circle {} }
    world.c = Body { position = vec(3, 4), Circle {} }
    world.wall = Body { type = "static", position = vec(0, -9), Box {} }
)";

struct Tweaked : TemporaryFolder, Playing {
    property::Tweaks tweaks;
    std::vector<std::string> warnings;

    Tweaked()
        : Playing(three_balls),
          tweaks(tree, path, [this](const std::string& text) { warnings.push_back(text); }) {
        loop->after_barrier([this] { tweaks.barrier(); });
        run(1);
    }
    ~Tweaked() { loop->after_barrier({}); }

    void run(int steps) {
        for (int i = 0; i < steps; ++i) loop->turn();
    }
    template <class What>
    auto person(What what) {
        const property::Tree::CauseScope scope(tree, property::Writer::console);
        return what();
    }
    void edit(const std::string& path_of_cell, double value) {
        person([&] { property::set(tree, path_of_cell, value); });
    }
    Handle at(const std::string& path_of_instance) const {
        return property::get(tree, path_of_instance).reference();
    }
    void make(const std::string& name) { tree.create(*tree.find_class("Body"), at("world"), name); }
    void barrier() {
        tree.barrier();
        tweaks.barrier();
    }
    std::vector<std::string> list() {
        barrier();
        std::vector<std::string> all;
        for (const Tweak& each : tweaks.list())
            all.push_back(each.path + ": " + each.was + " → " + each.now +
                          (each.kept ? ", kept" : ""));
        return all;
    }
    std::string kept_file() const {
        std::ifstream file(path / "main.tweaks.json");
        return {std::istreambuf_iterator<char>(file), {}};
    }
};

using Lines = std::vector<std::string>;

}  // namespace tweaked
