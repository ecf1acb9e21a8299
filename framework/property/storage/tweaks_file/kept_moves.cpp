// When an instance gets another name or parent, the paths in its kept tweaks are changed.

#include <array>

#include <fettle/property/path.h>

#include <scenes/scene_edit.h>
#include <scenes/scene_names.h>
#include <tweaks_file/kept_tweaks.h>
#include <values/scene_value.h>

namespace fettle::property {

void KeptTweaks::require_movable(const std::string& from, const std::string& to) const {
    const std::string made = made_above(from);
    if (!made.empty() && made != from && split_path(from).first != split_path(to).first)
        throw Error(ErrorKind::rejected,
                    "it is a part of " + made + ", and another parent of a part cannot be kept");
}

bool KeptTweaks::moves_to(const std::string& path) const {
    return contents_.moves.moves_to(path);
}

bool KeptTweaks::moves_away(const std::string& path) const {
    return !contents_.moves.moved_from(path).empty();
}

std::string KeptTweaks::moved_out_of(const std::string& path) const {
    const std::string home = contents_.moves.home(path);
    for (const Moved& each : contents_.moved)
        if (each.home != home && is_at_or_below(each.home, home) && !is_at_or_below(each.now, path))
            return each.now;
    return {};
}

/// Writes that an instance moves from the path that a scene file gives.
void KeptTweaks::put_moved(const std::string& home, const std::string& now) {
    for (const Moved& each : contents_.moved)
        if (each.home == home) drop("moved", each.key);
    if (home == now) return;
    std::string quoted;
    append_quoted(quoted, now);
    put("moved", home, quoted);
}

void KeptTweaks::move(const std::vector<MoveStep>& moves) {
    fold();
    const InstanceMoves all = combined_moves(moves);
    for (const MoveStep& move : moves) {
        if (makes(move.from) || moves_to(move.from)) continue;
        const std::string home = contents_.moves.home(move.from);
        if (is_marked(home))
            throw Error(ErrorKind::rejected,
                        move.from + " is in the place of what the file moves to " +
                            contents_.moves.moved_from(move.from) + ": choose another name");
        put_moved(home, all.now(move.from));
    }
    for (const Moved& each : contents_.moved) put_moved(each.home, all.now(each.now));
    std::map<std::string, std::vector<MoveStep>> parts;  // by the instance that they are a part of
    for (const MoveStep& move : moves)
        if (const std::string made = made_above(move.from); made != move.from)
            parts[made].push_back(move);
    std::vector<std::pair<std::string, std::string>> moved;
    for (const std::string& key : contents_.created) {
        const std::string now = all.now(key);
        if (now == key && !parts.contains(key)) continue;
        const Node& node = *member("created", key);
        SceneEdit edit(tree_, std::string(document_->raw(node)), "its scene");
        for (const MoveStep& step : in_order(parts[key])) {
            edit.rename(steps_between(key, step.from), split_path(step.to).second);
        }
        if (split_path(now).second != split_path(key).second)
            edit.rename({}, split_path(now).second);
        drop("created", key);
        moved.emplace_back(now, without_indent(edit.text(), *document_, node));
    }
    for (const auto& [key, scene] : moved) put("created", key, scene);
    const NewPath now_at = [&](const std::string& path) { return all.now(path); };
    rename_values(now_at);
    rename_deleted(now_at);
    fold();
    rename_in_references(now_at);
}

SceneSteps KeptTweaks::steps_between(const std::string& top, const std::string& path) {
    SceneSteps steps;
    const std::vector<Segment> names = parse_path(path);
    for (std::size_t i = parse_path(top).size(); i < names.size(); ++i)
        steps.push_back({std::get<std::string>(names[i].key), no_place});
    return steps;
}

/// The path of the nearest instance, at `path` or above it, that the file makes; "" if it makes
/// none, or if the file moves what is at `path` or nearer above it.
std::string KeptTweaks::made_above(const std::string& path) const {
    const std::vector<Segment> names = parse_path(path);
    for (std::size_t count = names.size(); count > 0; --count)
        if (std::string made = joined_path(names, count); created_.contains(made))
            return made;
        else if (moves_to(made))
            break;
    return {};
}

bool KeptTweaks::makes(const std::string& path) const {
    return !made_above(path).empty();
}

void KeptTweaks::rename(const NewPath& now_at) {
    if (document_ == nullptr || !problem_.empty()) return;
    rename_values(now_at);
    for (const std::string& key : contents_.created)
        if (const auto now = now_at(key)) {
            drop("created", key);
            put("created", *now, text_of("created", key));
        }
    for (const Moved& each : contents_.moved) drop("moved", each.key);
    for (const Moved& each : contents_.moved)
        put_moved(now_at(each.home).value_or(each.home), now_at(each.now).value_or(each.now));
    rename_deleted(now_at);
    fold();
    rename_in_references(now_at);
}

void KeptTweaks::rename_deleted(const NewPath& now_at) {
    for (const std::string& path : contents_.deleted) {
        const auto [parent, name] = split_path(path);
        if (const auto above = now_at(parent); above && *above != parent) {
            drop("deleted", path);
            put_deleted(path_below(*above, name));
        }
    }
}

void KeptTweaks::rename_values(const NewPath& now_at) {
    // Values are added after all removals, because two instances may exchange their names.
    std::vector<std::array<std::string, 3>> renamed;  // section, key, value
    for (const auto& [instance, values] : contents_.values)
        if (const auto now = now_at(instance))
            for (const Kept& kept : values) {
                drop("values", kept.key);
                for (const char* section : {"values", "given"})
                    if (member(section, kept.key) != nullptr)
                        renamed.push_back({section, *now + path_suffix(kept.property),
                                           text_of(section, kept.key)});
            }
    for (const auto& [section, key, value] : renamed) put(section, key, value);
}

std::vector<std::pair<std::string, std::string>> KeptTweaks::all_keys() const {
    std::vector<std::pair<std::string, std::string>> all;
    for (const std::string& key : contents_.created) all.emplace_back("created", key);
    for (const auto& [instance, values] : contents_.values)
        for (const Kept& kept : values) all.emplace_back("values", kept.key);
    return all;
}

std::optional<std::string> KeptTweaks::with_paths(const std::string& section,
                                                  const std::string& key,
                                                  const NewPath& now_at) const {
    const std::string text = text_of(section, key);
    std::string now;
    try {
        if (section == "created") {
            now = scene_with_paths(tree_, text, now_at);
        } else {
            const auto [instance, property] = split_path(key);
            Type type = Type::nil, element = Type::nil;
            // A value of an undeclared property contains its type.
            if (const Handle handle = this->instance(instance))
                if (const Property* declared = tree_.class_of(handle).property(property))
                    type = declared_type(*declared), element = declared->element;
            now = value_with_paths(text, now_at, type, element);
        }
    } catch (const Error&) {  // errors of the value are reported when the game starts
        return std::nullopt;
    }
    return now == text ? std::nullopt : std::optional(now);
}

void KeptTweaks::rename_in_references(const NewPath& now_at) {
    for (const auto& [section, key] : all_keys())
        if (const auto now = with_paths(section, key, now_at)) put(section, key, *now);
}

}  // namespace fettle::property
