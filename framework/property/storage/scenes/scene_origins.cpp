#include <scenes/scene_origins.h>

#include <algorithm>

#include <json/document.h>

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

SceneSteps renamed_steps(const SceneSteps& steps,
                         const std::vector<std::pair<SceneSteps, std::string>>& names) {
    const auto same = [](const SceneStep& a, const SceneStep& b) {
        return a.name == b.name && a.place == b.place;
    };
    SceneSteps now = steps;
    for (const auto& [before, name] : names)
        if (!before.empty() && before.size() <= steps.size() &&
            std::equal(before.begin(), before.end(), steps.begin(), same))
            now[before.size() - 1].name = name;
    return now;
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
                          const std::vector<SceneInstance>& instances, bool named_by_script) {
    if (scenes_.size() >= prune_at_) prune(tree);
    const std::size_t number = next_++;
    Scene& scene = scenes_[number];
    scene.file = file;
    scene.instances = instances;
    scene.named_by_script = named_by_script;
    for (std::size_t i = 0; i < instances.size(); ++i) {
        scene.names.push_back(tree.name(instances[i].instance));
        places_[instances[i].instance.key()] = {number, i};
    }
}

// Forgets scenes whose topmost instance is deleted. If undo restores that instance, it counts as
// made by a script.
void SceneOrigins::prune(const Tree& tree) {
    std::erase_if(scenes_, [&](const auto& each) {
        return !tree.alive(each.second.instances.front().instance);
    });
    std::erase_if(places_, [&](const auto& each) { return !scenes_.contains(each.second.scene); });
    prune_at_ = std::max<std::size_t>(64, 2 * scenes_.size());
}

std::optional<SceneOrigins::Origin> SceneOrigins::find(Handle instance) const {
    const auto found = places_.find(instance.key());
    if (found == places_.end()) return std::nullopt;
    const Scene& scene = scenes_.at(found->second.scene);
    return Origin{scene.file, steps_of(scene, found->second.instance),
                  scene.instances.front().instance};
}

SceneSteps SceneOrigins::steps_of(const Scene& scene, std::size_t instance) {
    SceneSteps steps;
    for (std::size_t i = instance; i != 0; i = scene.instances[i].parent)
        steps.push_back({scene.names[i], scene.instances[i].place});
    std::reverse(steps.begin(), steps.end());
    return steps;
}

void SceneOrigins::renamed(const std::filesystem::path& file, const Names& names) {
    for (auto& [number, scene] : scenes_) {
        if (scene.file != file) continue;
        std::vector<std::string> now = scene.names;
        for (std::size_t i = 1; i < now.size(); ++i)
            now[i] = renamed_steps(steps_of(scene, i), names).back().name;
        scene.names = std::move(now);
    }
}

void SceneOrigins::added(const Tree& tree, Handle parent, Handle child) {
    const auto found = places_.find(parent.key());
    if (found == places_.end()) return;
    const Place place = found->second;
    Scene& scene = scenes_.at(place.scene);
    places_[child.key()] = {place.scene, scene.instances.size()};
    scene.instances.push_back({.instance = child, .parent = place.instance, .place = no_place});
    scene.names.push_back(tree.name(child));
}

void SceneOrigins::forget(const Tree& tree, Handle top) {
    if (!places_.empty()) tree.each_below(top, [&](Handle handle) { places_.erase(handle.key()); });
}

void SceneOrigins::forget_part(const Tree& tree, Handle part) {
    const auto found = places_.find(part.key());
    if (found == places_.end() || found->second.instance == 0 || !tree.alive(part)) return;
    const std::size_t scene = found->second.scene;
    tree.each_below(part, [&](Handle handle) {
        if (const auto its = places_.find(handle.key());
            its != places_.end() && its->second.scene == scene && its->second.instance != 0)
            places_.erase(its);
    });
}

std::set<std::filesystem::path> SceneOrigins::files() const {
    std::set<std::filesystem::path> all;
    for (const auto& [number, scene] : scenes_) all.insert(scene.file);
    return all;
}

std::vector<Handle> SceneOrigins::tops(const Tree& tree, const std::filesystem::path& file) const {
    std::vector<Handle> all;
    for (const auto& [number, scene] : scenes_)
        if (scene.file == file && tree.alive(scene.instances.front().instance))
            all.push_back(scene.instances.front().instance);
    return all;
}

bool SceneOrigins::named_by_script(Handle top) const {
    const auto found = places_.find(top.key());
    return found != places_.end() && scenes_.at(found->second.scene).named_by_script;
}

}  // namespace fettle::property
