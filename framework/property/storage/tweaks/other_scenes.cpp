#include <tweaks/other_scenes.h>

#include <scenes/scene_names.h>
#include <tweaks/scene_keeping.h>

namespace fettle::property {

namespace fs = std::filesystem;

OtherScenes::OtherScenes(Tweaks::State& state, TweakReport& report)
    : state_(state), report_(report) {
    for (const fs::path& file : state.origins.files()) try {
            std::error_code error;
            const fs::path path = fs::weakly_canonical(file, error);
            const fs::path inside = path.lexically_relative(state.folder);
            if (error || inside.empty() || *inside.begin() == ".." || !state.files.exists(path))
                continue;
            SceneEdit edit(state.tree, state.files.read(path), path.string());
            std::string before = edit.text();
            scenes_.try_emplace(path, Scene{std::move(edit), std::move(before)});
        } catch (const Error&) {  // told when something is to be kept in it
        }
}

template <class Change>
void OtherScenes::change(const fs::path& file, Change change) {
    const auto found = scenes_.find(file);
    if (found == scenes_.end()) return;
    try {
        change(found->second.edit);
    } catch (const Error& error) {
        report_.problems.emplace_back(error.what());
        scenes_.erase(found);
    }
}

void OtherScenes::forget(const JournalRow& deletion) {
    const std::string mention = mention_of(deletion.instance);
    std::string all;
    for (auto& [file, scene] : scenes_) {
        if (scene.edit.text().find(mention) == std::string::npos) continue;
        const std::string before = scene.edit.forget_references({deletion.instance});
        if (before.empty()) continue;
        all += all.empty() ? "{\"file\": " : ", {\"file\": ";
        append_quoted(all, file.string());
        all += ", \"references\": [" + before + "]}";
    }
    if (!all.empty()) taken_out(state_, deletion, "{\"elsewhere\": [" + all + "]}");
}

void OtherScenes::put_back(const JournalRow& restoration) {
    if (restoration.was.find("\"elsewhere\"") == std::string::npos) return;
    const Document document(restoration.was, "journal");
    const Document::Node* all = document.member(document.root(), "elsewhere");
    for (const Document::Node* each = all != nullptr ? document.first(*all) : nullptr; each;
         each = document.next(*each))
        if (const Document::Node* list = document.member(*each, "references"))
            change(document.text(*document.member(*each, "file")),
                   [&](SceneEdit& edit) { edit.put_references_back(document, *list); });
}

void OtherScenes::rename(const InstanceMoves& moves, const fs::path& except) {
    for (auto& [file, scene] : scenes_) {
        if (file == except) continue;
        const std::string now =
            scene_with_paths(state_.tree, scene.edit.text(), [&](const std::string& path) {
                const bool from_root = !path.starts_with('.') && !path.starts_with('[');
                return std::optional(from_root ? moves.now(path) : path);
            });
        if (now != scene.edit.text()) scene.edit = SceneEdit(state_.tree, now, file.string());
    }
}

void OtherScenes::write() {
    for (const auto& [file, scene] : scenes_) {
        if (scene.edit.text() == scene.before) continue;
        try {
            state_.files.write(file, scene.edit.text());
            report_.files.push_back(file.string());
        } catch (const Error& error) {
            report_.problems.emplace_back(error.what());
        }
    }
}

}  // namespace fettle::property
