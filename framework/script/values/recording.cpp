#include <algorithm>

#include <lua/tree_names.h>
#include <values/recording.h>

namespace fettle::script {

Recording::Edit* Recording::add(Handle of) {
    constexpr std::size_t limit = 1000;  // a limit for commands that edit very many cells
    if (edits.size() >= limit) {
        ++dropped;
        return nullptr;
    }
    edits.emplace_back().instance = of;
    return &edits.back();
}

Recording::Edit* Recording::edit_of(Handle of, property::Symbol written) {
    const auto found = std::find_if(edits.begin(), edits.end(), [&](const Edit& edit) {
        return edit.instance == of && edit.symbol == written && edit.note.empty();
    });
    if (found != edits.end()) return &*found;
    Edit* const added = add(of);
    if (added != nullptr) added->symbol = written;
    return added;
}

Recording::Edit* Recording::note(Handle of, std::string path, std::string text) {
    Edit* const noted = active ? add(of) : nullptr;
    if (noted == nullptr) return nullptr;
    noted->path = std::move(path);
    noted->note = std::move(text);
    return noted;
}

}  // namespace fettle::script
