#pragma once
// A run of a game with a journal of tweaks.

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include <fettle/property/storage/tweaks.h>

#include "game_folder.h"
#include "scene_world.h"

namespace scene_test {

/// A run of a game in a folder: a tree, and its tweaks.
struct Run : SceneWorld {
    explicit Run(const GameFolder& folder)
        : tweaks(std::make_unique<Tweaks>(
              tree, folder.path(), [this](const std::string& text) { reported.push_back(text); })) {
    }

    template <class F>
    void person(F edit) {
        {
            const Tree::CauseScope scope(tree, Writer::console);
            edit();
        }
        barrier();
    }
    void barrier() {
        tree.barrier();
        tweaks->barrier();
    }
    /// Lines as "world.a.number: 1 → 2".
    std::vector<std::string> lines() const {
        std::vector<std::string> all;
        for (const Tweak& tweak : tweaks->list())
            all.push_back((tweak.earlier ? "earlier " : "") + tweak.path + ": " + tweak.was +
                          " → " + tweak.now + (tweak.kept ? " kept in " + tweak.kept_in : "") +
                          (tweak.committed ? "" : " not yet"));
        return all;
    }
    /// `parent`: null for the world.
    Handle load(const GameFolder& folder, const std::string& file, Handle parent = {}) {
        std::vector<SceneInstance> instances;
        const Handle top =
            load_scene(tree, folder / file, parent ? parent : world, {}, nullptr, &instances);
        tweaks->scene_loaded(folder / file, instances);
        return top;
    }
    Handle at(const std::string& path) {
        Handle handle = tree.root();
        for (std::size_t begin = 0; begin <= path.size();) {
            const std::size_t end = std::min(path.find('.', begin), path.size());
            handle = tree.child(handle, path.substr(begin, end - begin));
            begin = end + 1;
        }
        return handle;
    }

    std::vector<std::string> reported;
    std::unique_ptr<Tweaks> tweaks;
};

}  // namespace scene_test
