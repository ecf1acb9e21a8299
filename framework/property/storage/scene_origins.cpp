#include "scene_origins.h"

#include <algorithm>

#include "document.h"

namespace fettle::property {

std::string steps_text(const SceneSteps& steps) {
    std::string out;
    for (const SceneStep& step : steps) {
        out += out.empty() ? "[" : ", ";
        out += '[';
        if (!append_quoted(out, step.name)) out += "\"\"";
        out += ", " + std::to_string(step.place) + "]";
    }
    return out.empty() ? out : out + "]";
}

SceneSteps read_steps(const std::string& text) {
    SceneSteps steps;
    if (text.empty()) return steps;
    const Document document(text, "journal");
    for (const auto* step = document.first(document.root()); step; step = document.next(*step)) {
        const Document::Node* name = document.first(*step);
        const Document::Node* place = name != nullptr ? document.next(*name) : nullptr;
        if (place == nullptr || name->kind != Document::Kind::text ||
            place->kind != Document::Kind::integer)
            document.fail(ErrorKind::bad_structure, step->begin, "not a place in a scene file");
        steps.push_back({document.text(*name), static_cast<std::size_t>(place->integer)});
    }
    return steps;
}

void SceneOrigins::loaded(const Tree& tree, const std::filesystem::path& file,
                          const std::vector<SceneInstance>& instances) {
    if (scenes_.size() >= prune_at_) prune(tree);
    const std::size_t number = next_++;
    Scene& scene = scenes_[number];
    scene.file = file;
    scene.instances = instances;
    for (std::size_t i = 0; i < instances.size(); ++i) {
        scene.names.push_back(tree.name(instances[i].instance));
        places_[key(instances[i].instance)] = {number, i};
    }
}

// Scenes whose topmost instance is gone. Undo may bring it back: it is then what a script made.
void SceneOrigins::prune(const Tree& tree) {
    std::erase_if(scenes_, [&](const auto& each) {
        return !tree.alive(each.second.instances.front().instance);
    });
    std::erase_if(places_, [&](const auto& each) { return !scenes_.contains(each.second.scene); });
    prune_at_ = std::max<std::size_t>(64, 2 * scenes_.size());
}

std::optional<SceneOrigins::Origin> SceneOrigins::find(Handle instance) const {
    const auto found = places_.find(key(instance));
    if (found == places_.end()) return std::nullopt;
    const Scene& scene = scenes_.at(found->second.scene);
    Origin origin{scene.file, {}, scene.instances.front().instance};
    for (std::size_t i = found->second.instance; i != 0; i = scene.instances[i].parent)
        origin.steps.push_back({scene.names[i], scene.instances[i].place});
    std::reverse(origin.steps.begin(), origin.steps.end());
    return origin;
}

}  // namespace fettle::property
