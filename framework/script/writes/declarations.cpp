
#include <fettle/property/path.h>

#include <lua/tree_names.h>
#include <writes/declarations.h>

namespace fettle::script {

void Declarations::begin(bool reload) {
    phase_ = reload ? Phase::reload : Phase::first;
    recording_.declaring = true;
    all_.clear();
    index_.clear();
    places_.clear();
    children_.clear();
    numbers_.clear();
    placed_.clear();
    stand_ins_.clear();
    calls.clear();
    scenes.clear();
}

Declarations::All Declarations::end() {
    if (phase_ == Phase::first) note_lists();
    // A path may have a million characters. In a game with too many long ones the others stay
    // empty, and a reload makes these instances anew.
    constexpr std::size_t most = std::size_t{64} << 20;
    std::size_t bytes = 0;
    for (Declared& each : all_) {
        if (!tree_.alive(each.instance)) continue;
        each.path = future_path(each.instance);
        bytes += each.path.size();
        if (bytes > most) break;
    }
    phase_ = Phase::none;
    recording_.declaring = false;
    std::erase_if(all_, [this](const Declared& each) { return !tree_.alive(each.instance); });
    return std::move(all_);
}

/// The path when all instances have their places; "" if it gets none.
std::string Declarations::future_path(Handle instance) const {
    if (tree_.is_below(instance, tree_.root())) return tree_.path(instance);
    const Handle above = has_place(instance) ? place_of(instance).parent : tree_.parent(instance);
    if (!above) return {};
    const std::string parent = above == tree_.root() ? "" : future_path(above);
    if (parent.empty() && above != tree_.root()) return {};
    const std::string suffix =
        property::path_suffix(has_place(instance) ? place_of(instance).name : tree_.name(instance));
    return parent.empty() && suffix.starts_with('.') ? suffix.substr(1) : parent + suffix;
}

void Declarations::keep(All all) {
    last_ = std::move(all);
    last_index_.clear();
    for (std::size_t i = 0; i < last_.size(); ++i) last_index_[last_[i].instance.key()] = i;
}

// --- Noting

Declarations::Declared& Declarations::entry(Handle instance) {
    const auto [place, added] = index_.try_emplace(instance.key(), all_.size());
    if (added) {
        Declared& made = all_.emplace_back();
        made.instance = instance;
        made.of = &tree_.class_of(instance);
    }
    return all_[place->second];
}

const Declarations::Declared* Declarations::find(Handle instance) const {
    const auto found = index_.find(instance.key());
    return found == index_.end() ? nullptr : &all_[found->second];
}

Declarations::Assignment& Declarations::assignment(Handle instance, std::string_view name) {
    return entry(instance).assignments[std::string(name)];
}

const Declarations::Assignment* Declarations::last_assignment(Handle instance,
                                                              std::string_view name) const {
    const auto found = last_index_.find(instance.key());
    if (found == last_index_.end()) return nullptr;
    const auto& all = last_[found->second].assignments;
    const auto entry = all.find(std::string(name));
    return entry == all.end() ? nullptr : &entry->second;
}

void Declarations::made(Handle instance) {
    if (!active()) return;
    Declared& now = entry(instance);
    now.made = true;
    // What a constructor gives has no earlier value: without it, the default is there.
    for (auto& [name, assignment] : now.assignments) {
        assignment.before = Value();
        assignment.added = false;
    }
}

void Declarations::made_with_values(Handle top) {
    if (!active()) return;
    std::vector<Handle> all = {top};
    tree_.each_below(top, [&](Handle each) {
        if (each != top) all.push_back(each);
    });
    for (const Handle each : all) {
        made(each);
        for (const Property* property : tree_.properties(each))
            if (!property->read_only && tree_.overridden(each, *property))
                wrote(each, property->name);
    }
}

void Declarations::writing(Handle instance, std::string_view name) {
    if (phase_ != Phase::first) return;
    const Declared* known = find(instance);
    if (known != nullptr && (known->made || known->assignments.contains(std::string(name)))) return;
    Assignment& now = assignment(instance, name);
    const Property* property = tree_.find(instance, name);
    now.added = property == nullptr;
    if (property != nullptr) now.before = tree_.peek(instance, *property);
}

void Declarations::wrote(Handle instance, std::string_view name) {
    if (!active()) return;
    const Property* property = tree_.find(instance, name);
    if (property == nullptr) {  // an assignment of nil has removed it
        entry(instance).assignments.erase(std::string(name));
        return;
    }
    Assignment& now = assignment(instance, name);
    now.value = tree_.peek(instance, *property);
    if (reloading()) now.place = tree_.cause().where;
    now.formula.reset();
    if (const property::Formula* formula = tree_.formula(instance, *property))
        now.formula = *formula;
}

void Declarations::wrote_element(Handle instance, std::string_view name) {
    if (!active()) return;
    Assignment& now = assignment(instance, name);
    now.value = Value();
    now.formula.reset();
}

/// The values of lists that got elements, which `wrote_element` has not noted. Other values that
/// are nil are so in the tree, too.
void Declarations::note_lists() {
    for (Declared& each : all_)
        for (auto& [name, assignment] : each.assignments)
            if (assignment.value.is_nil() && !assignment.formula && tree_.alive(each.instance))
                if (const Property* const property = tree_.find(each.instance, name))
                    assignment.value = tree_.peek(each.instance, *property);
}

// --- During a reload

bool Declarations::defers(Handle instance) const {
    return reloading() && (instance == tree_.root() || tree_.is_below(instance, tree_.root()));
}

void Declarations::defer(Handle instance, std::string_view name, const Value& value) {
    const Property* property = tree_.find(instance, name);
    Assignment& now = assignment(instance, name);
    now.value = property == nullptr                     ? value
                : value.is_nil() && !property->nullable ? property->default_value
                                                        : tree_.coerce(instance, *property, value);
    now.place = tree_.cause().where;
    now.formula.reset();
    const Assignment* last = last_assignment(instance, name);
    now.added = last != nullptr ? last->added : property == nullptr;
    if (last != nullptr)
        now.before = last->before;
    else if (property != nullptr)
        now.before = tree_.peek(instance, *property);
}

void Declarations::defer(Handle instance, std::string_view name, property::Formula formula) {
    const Property* property = tree_.find(instance, name);
    defer(instance, name, property == nullptr ? Value() : tree_.peek(instance, *property));
    assignment(instance, name).formula = std::move(formula);
}

const Value* Declarations::seen(Handle instance, std::string_view name) const {
    if (!defers(instance)) return nullptr;
    if (const Declared* known = find(instance))
        if (const auto assignment = known->assignments.find(std::string(name));
            assignment != known->assignments.end())
            return assignment->second.formula ? nullptr : &assignment->second.value;
    // A property that the old code added counts as missing.
    const Assignment* last = last_assignment(instance, name);
    return last != nullptr && !last->added ? &last->before : nullptr;
}

bool Declarations::hides(Handle instance) const {
    if (!reloading()) return false;
    const auto last = last_index_.find(instance.key());
    return last != last_index_.end() && last_[last->second].made;
}

bool Declarations::hides(Handle instance, std::string_view name) const {
    if (!defers(instance)) return false;
    const Declared* now = find(instance);
    if (now != nullptr && now->assignments.contains(std::string(name))) return false;
    const Assignment* last = last_assignment(instance, name);
    return last != nullptr && last->added;
}

std::vector<Handle> Declarations::children(Handle parent) const {
    std::vector<Handle> all = tree_.children(parent);
    if (!reloading()) return all;
    std::erase_if(all, [this](Handle each) { return hides(each); });
    for (const Handle each : placed_)
        if (const auto place = places_.find(each.key());
            place != places_.end() && place->second.parent == parent && tree_.alive(each))
            all.push_back(each);
    return all;
}

std::optional<property::Place> Declarations::find_future(const std::string& path) const {
    for (const Declared& each : all_) {
        if (!tree_.alive(each.instance)) continue;
        const std::string future = future_path(each.instance);
        if (future.empty() || !path.starts_with(future)) continue;
        if (future == path) return property::Place{each.instance, nullptr, {}};
        for (const Property* property : tree_.properties(each.instance))
            if (future + property::path_suffix(property->name) == path)
                return property::Place{each.instance, property, {}};
    }
    return std::nullopt;
}

std::string Declarations::free_name(Handle instance, Handle parent) {
    const std::string& stem = tree_.class_of(instance).stem();
    int& number = numbers_[{parent.key(), stem}];
    for (;;) {
        std::string name = stem + "_" + std::to_string(++number);
        if (!child(parent, name)) return name;
    }
}

void Declarations::place(Handle instance, Handle parent, std::string_view name) {
    std::string chosen(name);
    if (chosen.empty()) chosen = free_name(instance, parent);
    if (const Handle other = child(parent, chosen)) remove(other);
    remove(instance);
    places_[instance.key()] = {parent, chosen};
    children_[{parent.key(), chosen}] = instance;
    placed_.push_back(instance);
    make_its_children(instance);
}

Handle Declarations::stand_in(const Class& of, std::string_view name) {
    const Handle instance = tree_.create(of);
    made(instance);
    place(instance, tree_.root(), name);
    stand_ins_.insert(instance.key());
    return instance;
}

/// A class may make instances below one of its own when that gets a parent, as a map makes its
/// layers. The top level may read them, so the instance gets a detached parent for a moment.
void Declarations::make_its_children(Handle instance) {
    if (tree_.parent(instance)) return;
    const Handle parent = tree_.create(tree_.object_class());
    tree_.move(instance, parent);
    tree_.move(instance, {});
    tree_.destroy(parent);
}

void Declarations::remove(Handle instance) {
    const auto found = places_.find(instance.key());
    if (found == places_.end()) return;
    children_.erase({found->second.parent.key(), found->second.name});
    places_.erase(found);
    std::erase(placed_, instance);
}

Handle Declarations::child(Handle parent, std::string_view name) const {
    if (children_.empty()) return {};
    const auto found = children_.find(std::pair(parent.key(), std::string(name)));
    return found == children_.end() ? Handle{} : found->second;
}

}  // namespace fettle::script
