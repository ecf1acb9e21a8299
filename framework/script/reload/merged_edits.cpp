// What a reload does with the edits of persons: those that stay, those that the script replaces,
// and those that files set.

#include <fettle/property/path.h>
#include <fettle/property/storage/tweaks.h>
#include <fettle/script/runtime.h>

#include <lua/machine.h>
#include <reload/merge.h>

namespace fettle::script {

/// Whether the top level gives the property of a new instance what it gave the property of the
/// instance that had its place before.
bool Merge::is_given_as_before(Handle made, const std::string& name) const {
    const auto now = next_by_handle_.find(made.key());
    const Declared* const before = declared_before(tree_.path(made));
    const auto in = [&](const Declared* all) -> const Assignment* {
        if (all == nullptr) return nullptr;
        const auto found = all->assignments.find(name);
        return found == all->assignments.end() ? nullptr : &found->second;
    };
    const Assignment* const is = in(now == next_by_handle_.end() ? nullptr : now->second);
    const Assignment* const was = in(before);
    if (is == nullptr || was == nullptr) return is == was;
    if (is->formula || was->formula)
        return is->formula && was->formula && is->formula->source == was->formula->source;
    return translated(is->value) == was->value;
}

/// Whether the file of kept tweaks sets the value whatever the script gives, or this run has
/// written the value into its scene file.
bool Merge::is_set_by_files(Handle to, const Property& property, const Assignment* now) {
    const property::Tweaks* const tweaks = machine_.options.tweaks;
    if (tweaks == nullptr) return false;
    if (now != nullptr && !now->formula && tweaks->has_kept(to, property, translated(now->value)))
        return true;
    const std::string file = tweaks->set_by_file(to, property);
    if (file.empty()) return false;
    notes_.push_back(said(to, property, now) + ", but " + file + " still sets it");
    return true;
}

/// "main.lua:3 now gives world.ball.mass 3 kg"
std::string Merge::said(Handle of, const Property& property, const Assignment* now) const {
    const std::string path = tree_.path(of) + property::path_suffix(property.name);
    if (now == nullptr) return "the script does not give " + path + " any more";
    const std::string unit = property.unit.empty() ? "" : " " + property.unit;
    const std::string value = now->formula
                                  ? "a formula"
                                  : tree_.text(translated(now->value), property.precision()) + unit;
    return (now->place.empty() ? "the script" : now->place) + " now gives " + path + " " + value;
}

void Merge::drop_edits_below(const std::string& path) {
    property::Tweaks* const tweaks = machine_.options.tweaks;
    const std::size_t count = tweaks == nullptr ? 0 : tweaks->made_no_more(path);
    if (count > 0)
        notes_.push_back("the script does not make " + path + " any more, so " +
                         (count == 1 ? "its edit is" : std::to_string(count) + " edits of it are") +
                         " dropped");
}

/// The edits of an instance of another class are made again with the new one.
void Merge::remake_edits(Handle instance) {
    property::Tweaks* const tweaks = machine_.options.tweaks;
    if (tweaks == nullptr) return;
    tweaks->placed(instance);
    const std::size_t count =
        tweaks->replaced(instance, [&, this](Handle of, const Property& property) {
            return is_given_as_before(of, property.name) ||
                   !tweaks->set_by_file(of, property).empty();
        });
    if (count > 0)
        notes_.push_back("the script makes another " + tree_.path(instance) + " now, so " +
                         (count == 1 ? "an edit" : std::to_string(count) + " edits") + " of it " +
                         (count == 1 ? "is" : "are") + " dropped");
}

/// Whether a person has made or renamed the instance, and this run has written that into its scene
/// file, from which it comes again.
bool Merge::has_kept(Handle instance) const {
    return machine_.options.tweaks != nullptr && machine_.options.tweaks->has_kept(instance);
}

/// The edits of what a scene file has made are kept in that file. Where an instance is deleted or
/// has another name now, what is known of the scene from before stays true.
void Merge::tell_scenes() {
    if (machine_.options.tweaks == nullptr) return;
    for (Declarations::Scene& scene : machine_.declarations.scenes) {
        bool as_in_file = true;
        for (property::SceneInstance& each : scene.instances) {
            const Handle is = result_of(each.instance);
            as_in_file =
                as_in_file && tree_.alive(is) && tree_.alive(each.instance) &&
                (&each == &scene.instances.front() || tree_.name(is) == tree_.name(each.instance));
            each.instance = is;
        }
        if (as_in_file)
            machine_.options.tweaks->scene_loaded(scene.file, scene.instances, scene.named);
    }
}

}  // namespace fettle::script
