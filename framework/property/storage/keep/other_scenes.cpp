#include <keep/other_scenes.h>

#include <keep/scene_keeping.h>
#include <scenes/scene_names.h>

namespace fettle::property {

namespace fs = std::filesystem;

std::map<fs::path, OtherScenes::Text>& OtherScenes::texts() {
    if (texts_) return *texts_;
    texts_.emplace();
    for (const fs::path& loaded : state_.origins.files()) try {
            const auto file = state_.own_file(loaded);
            if (!file) continue;
            const std::string text = state_.files.read(*file);
            texts_->try_emplace(*file, Text{text, text});
        } catch (const Error&) {  // reported when something is kept in that file
        }
    return *texts_;
}

template <class Change>
void OtherScenes::change(const fs::path& file, Text& text, Change change) {
    try {
        SceneEdit edit(state_.tree, text.now, file.string());
        change(edit);
        text.now = edit.text();
    } catch (const Error& error) {
        report_.problems.emplace_back(error.what());
    }
}

void OtherScenes::forget(const JournalRow& deletion) {
    const std::string mention = mention_of(deletion.instance);
    std::string all;
    for (auto& [file, text] : texts()) {
        if (text.now.find(mention) == std::string::npos) continue;
        std::string before;
        change(file, text,
               [&](SceneEdit& edit) { before = edit.forget_references({deletion.instance}); });
        if (before.empty()) continue;
        all += all.empty() ? "{\"file\": " : ", {\"file\": ";
        append_quoted(all, file.string());
        all += ", \"references\": [" + before + "]}";
    }
    if (!all.empty()) store_removed_text(state_, deletion, "{\"elsewhere\": [" + all + "]}");
}

void OtherScenes::put_back(const JournalRow& restoration) {
    if (restoration.was.find("\"elsewhere\"") == std::string::npos) return;
    const Document document(restoration.was, "journal");
    const Document::Node* all = document.member(document.root(), "elsewhere");
    for (const Document::Node* each = all != nullptr ? document.first(*all) : nullptr; each;
         each = document.next(*each)) {
        const Document::Node* list = document.member(*each, "references");
        const Document::Node* file = document.member(*each, "file");
        if (list == nullptr || file == nullptr || file->kind != Document::Kind::text) continue;
        const auto found = texts().find(document.text(*file));
        if (found != texts().end())
            change(found->first, found->second,
                   [&](SceneEdit& edit) { edit.put_references_back(document, *list); });
    }
}

void OtherScenes::rename(const InstanceMoves& moves, const fs::path& except) {
    for (auto& [file, text] : texts())
        if (file != except)
            change(file, text, [&](SceneEdit& edit) {
                const std::string now =
                    scene_with_paths(state_.tree, edit.text(), [&](const std::string& path) {
                        return std::optional(is_from_top(path) ? path : moves.now(path));
                    });
                edit = SceneEdit(state_.tree, now, edit.document().file_name());
            });
}

void OtherScenes::write() {
    if (!texts_) return;
    for (const auto& [file, text] : *texts_) {
        if (text.now == text.before) continue;
        try {
            state_.files.write(file, text.now);
            report_.files.push_back(file.string());
        } catch (const Error& error) {
            report_.problems.emplace_back(error.what());
        }
    }
}

}  // namespace fettle::property
