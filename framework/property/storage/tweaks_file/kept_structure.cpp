// Applies what the file of kept tweaks says about instances: which are deleted, moved and made. One
// may be possible only after another: a move into a new instance, a new instance in the place of
// one that is deleted or has moved away, the deletion of what another one leaves before. So each is
// done as soon as it is possible.

#include <algorithm>
#include <functional>

#include <fettle/property/path.h>

#include <scenes/scene_load.h>
#include <tweaks_file/kept_tweaks.h>

namespace fettle::property {

KeptTweaks::Open KeptTweaks::all_open() {
    Open open;
    if (document_ == nullptr || !problem_.empty()) return open;
    for (const Moved& each : contents_.moved)
        if (const Handle instance = find(*member("moved", each.key), each.home, SIZE_MAX,
                                         "there is nothing to move to " + each.now))
            open.movers.push_back({&each, instance});
    std::ranges::stable_sort(open.movers, {},
                             [](const Mover& mover) { return parse_path(mover.move->now).size(); });
    const Node* deleted = document_->member(document_->root(), "deleted");
    for (const Node* node = deleted != nullptr ? document_->first(*deleted) : nullptr; node;
         node = document_->next(*node))
        open.deletions.emplace_back(node, contents_.deleted[open.deletions.size()]);
    open.to_delete.insert(contents_.deleted.begin(), contents_.deleted.end());
    for (const std::string& key : contents_.created) {
        const std::vector<Segment> names = parse_path(key);
        open.creations.emplace(joined_path(names, names.size()), &key);
    }
    return open;
}

std::vector<Handle> KeptTweaks::apply_structure() {
    Open open = all_open();
    std::vector<Handle> moved;
    for (const Mover& mover : open.movers) moved.push_back(mover.instance);
    make_room(open);
    // Without moves nothing waits for anything but its parent.
    for (const bool last : {false, true}) {
        if (!last && moved.empty()) continue;
        for (bool more = true; more;) {
            more = delete_some(open, last);
            more = move_some(open, last) || more;
            more = create_some(open, last) || more;
        }
    }
    moved_ = true;
    return moved;
}

/// An instance whose place another one gets has a name in between until it has its own place.
void KeptTweaks::make_room(const Open& open) {
    std::size_t number = 0;
    for (const Mover& mover : open.movers) {
        const std::string& home = mover.move->home;
        if (!contents_.moves.moves_to(home) && !open.creations.contains(home)) continue;
        std::string name;
        do name = "_in_between_" + std::to_string(++number);
        while (tree_.child(tree_.parent(mover.instance), name));
        const Tree::CauseScope cause(tree_, Writer::load);
        tree_.rename(mover.instance, name);
    }
}

bool KeptTweaks::move_some(Open& open, bool last) {
    // Each sees which others still wait, so none is removed before all were tried.
    std::unordered_set<const Moved*> done;
    for (const Mover& mover : open.movers)
        if (move_now(mover, open, done, last)) done.insert(mover.move);
    std::erase_if(open.movers, [&](const Mover& mover) { return done.contains(mover.move); });
    return !done.empty();
}

/// False if that is not possible yet. `last`: then that is reported.
bool KeptTweaks::move_now(const Mover& mover, const Open& open,
                          const std::unordered_set<const Moved*>& done, bool last) {
    const Handle instance = mover.instance;
    if (!tree_.alive(instance)) return true;  // it was deleted
    const auto [path, name] = split_path(mover.move->now);
    const Handle parent = instance_or_none(tree_, path);
    const Handle there = parent ? tree_.child(parent, name) : Handle{};
    const bool waits =
        !parent || (there && there != instance) ||
        std::ranges::any_of(open.movers, [&](const Mover& other) {
            return !done.contains(other.move) && tree_.alive(other.instance) &&
                   (parent == other.instance || tree_.is_below(parent, other.instance));
        });
    if (waits && !last) return false;
    const Tree::CauseScope cause(tree_, Writer::load);
    const Node& node = *member("moved", mover.move->key);
    try {
        if (!parent)
            throw Error(ErrorKind::unknown_name, "there is no " + path + "; it stays where it is");
        if (tree_.parent(instance) != parent)
            tree_.move(instance, parent, name);
        else if (there != instance)
            tree_.rename(instance, name);
        return true;
    } catch (const Error& error) {
        warn(node.begin, mover.move->home + ": " + error.what());
    }
    const std::string before = split_path(mover.move->home).second;
    if (!tree_.child(tree_.parent(instance), before)) tree_.rename(instance, before);
    return true;
}

bool KeptTweaks::delete_some(Open& open, bool last) {
    const auto remains = [&](const std::pair<const Node*, std::string>& deletion) {
        const auto& [node, path] = deletion;
        const Handle there = instance_or_none(tree_, path);
        const bool waits = !there || std::ranges::any_of(open.movers, [&](const Mover& mover) {
            return tree_.alive(mover.instance) &&
                   (mover.instance == there || tree_.is_below(mover.instance, there));
        });
        if (waits && !last) return true;
        open.to_delete.erase(path);
        // An instance that an edit put in its place is made in any case, so a missing one is no
        // error.
        const bool replaced = member("created", path) != nullptr;
        const Handle instance =
            find(*node, path, SIZE_MAX, replaced ? "" : "there is nothing to delete");
        if (!instance) return false;
        try {
            const Tree::CauseScope cause(tree_, Writer::load);
            tree_.destroy(instance);
        } catch (const Error& error) {
            warn(node->begin, path + ": " + error.what());
        }
        return false;
    };
    return std::erase_if(open.deletions, std::not_fn(remains)) > 0;
}

/// Makes parents before their children, in any order of the file. References are set after all
/// instances exist.
bool KeptTweaks::create_some(Open& open, bool last) {
    const std::size_t before = open.creations.size();
    for (const std::string& key : contents_.created) {
        if (open.creations.empty()) break;
        const std::vector<Segment> names = parse_path(key);
        Handle at = tree_.root();
        for (std::size_t i = 0; at && i < names.size(); ++i) {
            const std::string path = joined_path(names, i + 1);
            if (open.to_delete.contains(path)) break;
            const auto& name = std::get<std::string>(names[i].key);
            const auto its = open.creations.find(path);
            if (its != open.creations.end()) {
                const std::string& made = *its->second;
                open.creations.erase(its);
                if (!tree_.child(at, name)) create(made);
            }
            at = tree_.child(at, name);
        }
        if (last && open.creations.erase(joined_path(names, names.size())) != 0) create(key);
    }
    return open.creations.size() < before;
}

void KeptTweaks::create(const std::string& path) {
    const Node* node = member("created", path);
    const std::vector<Segment> segments = parse_path(path);
    const Handle parent = find(*node, path, segments.size() - 1, "nothing can be made below it");
    if (!parent) return;
    const std::string& name = std::get<std::string>(segments.back().key);
    if (tree_.child(parent, name)) return;
    try {
        // The text is padded with lines, so that errors name the right line.
        std::string text(document_->line(node->begin) - 1, '\n');
        text += document_->raw(*node);
        const auto scene = std::make_shared<const Document>(std::move(text), file_.string());
        std::vector<OpenReference> open;
        const Handle top = load_scene_document(tree_, *scene, parent, name, open);
        for (const OpenReference& each : open)
            waiting_.push_back({each.instance, each.property,
                                tree_.path(each.instance) + path_suffix(each.property), top, scene,
                                each.node});
    } catch (const SceneError& error) {
        report(error);
    } catch (const Error& error) {
        warn(node->begin, path + ": " + error.what());
    }
}

}  // namespace fettle::property
