#include <values/scene_reference.h>

#include <vector>

#include <fettle/property/path.h>
#include <fettle/property/spelling.h>

#include <values/instance_paths.h>

namespace fettle::property {

namespace {

[[noreturn]] void no_such_instance(const SceneBeingLoaded& scene, Handle at, const Segment& segment,
                                   const std::string& path, const Document::Node& node) {
    std::string reason = "refers to " + value_text(Value(path)) + ", which does not exist";
    if (!segment.is_index()) {
        std::vector<std::string> names;
        for (const Handle child : scene.tree.children(at)) names.push_back(scene.tree.name(child));
        reason += suggestion(std::get<std::string>(segment.key), names);
    }
    scene.document.fail(ErrorKind::unknown_name, node.begin, reason);
}

}  // namespace

Handle find_reference(const SceneBeingLoaded& scene, const std::string& path,
                      const Document::Node& node) {
    if (path == ".") return scene.top;
    const bool relative = is_from_top(path);
    std::vector<Segment> segments;
    try {
        segments = parse_path(relative ? "scene" + path : path);
    } catch (const Error& e) {
        scene.document.fail(e.kind(), node.begin,
                            "expected the path of an instance, got " + value_text(Value(path)));
    }
    if (relative) segments.erase(segments.begin());
    Handle at = relative ? scene.top : scene.tree.root();
    for (const Segment& segment : segments) {
        Handle next;
        if (!segment.is_index()) {
            const std::string& name = std::get<std::string>(segment.key);
            next = scene.tree.child(at, name);
            if (!next && at == scene.parent && name == scene.name) next = scene.top;
        }
        if (!next) no_such_instance(scene, at, segment, path, node);
        at = next;
    }
    return at;
}

}  // namespace fettle::property
