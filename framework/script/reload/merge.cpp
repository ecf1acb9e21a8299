#include <algorithm>
#include <functional>

#include <fettle/property/exception_text.h>
#include <fettle/property/path.h>
#include <fettle/property/sibling_order.h>
#include <fettle/property/storage/tweaks.h>
#include <fettle/script/runtime.h>

#include <handlers/timers.h>
#include <lua/interpreter.h>
#include <lua/machine.h>
#include <lua/stack.h>
#include <reload/merge.h>
#include <values/members.h>
#include <values/values.h>

namespace fettle::script {

namespace {

bool is_place(const std::string& name) {
    return name == "name" || name == "parent";
}

/// A property whose default became 1.0 in place of 1 has numbers in place of integers.
bool is_same(const Value& a, const Value& b) {
    return a == b || (a.is_numeric() && b.is_numeric() && a.as_double() == b.as_double());
}

bool is_below_any(const std::string& path, const std::unordered_set<std::string>& paths) {
    for (std::size_t end = path.find_first_of(".["); end != std::string::npos;
         end = path.find_first_of(".[", end + 1))
        if (paths.contains(path.substr(0, end))) return true;
    return false;
}

}  // namespace

Merge::Merge(Machine& machine, Declarations::All next, std::vector<std::string>& notes)
    : machine_(machine), tree_(machine.tree), next_(std::move(next)), notes_(notes) {
    for (const Declared& each : next_) next_by_handle_[each.instance.key()] = &each;
    for (const Declared& each : machine.declarations.last()) {
        last_by_handle_[each.instance.key()] = &each;
        if (each.made && !each.path.empty()) last_by_path_[each.path] = &each;
    }
}

Handle Merge::result_of(Handle instance) const {
    const auto found = results_.find(instance.key());
    return found == results_.end() ? instance : found->second;
}

template <class Change>
void Merge::attempt(Handle instance, const std::string& name, Change change) {
    try {
        change();
    } catch (const std::exception& error) {
        const std::string path = tree_.alive(instance) ? tree_.path(instance) : "(deleted)";
        std::string text = property::exception_text(error);
        if (text.find(path) == std::string::npos)
            text = path + property::path_suffix(name) + ": " + text;
        notes_.push_back("reload: " + text);
    }
}

void Merge::run(const std::vector<ScriptClasses::NewDefault>& defaults) {
    const Declarations& declarations = machine_.declarations;
    for (const Handle made : declarations.placed()) {
        if (!tree_.alive(made)) continue;
        const Declarations::Place& place = declarations.place_of(made);
        match(made, place.parent, place.name);
    }
    for (const auto& [made, living] : pairs_) {
        if (!tree_.alive(living)) continue;
        const auto now = next_by_handle_.find(made.key());
        if (now == next_by_handle_.end()) continue;
        const Declared* before = declared_before(living, now->second->path);
        if (before == nullptr && has_kept(living)) before = now->second;
        apply(*now->second, living, before);
    }
    note_orders();
    refer_to_results();
    delete_undeclared();
    place_new();
    put_in_order();
    // Instances of the game that the top level did not make.
    for (const Declared& now : next_)
        if (!now.made && tree_.alive(now.instance) &&
            (now.instance == tree_.root() || tree_.is_below(now.instance, tree_.root())))
            apply(now, now.instance, declared_before(now.instance, now.path));
    for (const Declared& before : machine_.declarations.last())
        if (!before.made && tree_.alive(before.instance) &&
            !next_by_handle_.contains(before.instance.key()) &&
            !matched_.contains(before.instance.key()))
            apply({}, before.instance, &before);
    apply_defaults(defaults);
}

// --- Which instance stands for which

const Merge::Declared* Merge::declared_before(const std::string& path) const {
    const auto found = last_by_path_.find(path);
    return found == last_by_path_.end() ? nullptr : found->second;
}

const Merge::Declared* Merge::declared_before(Handle living, const std::string& path) const {
    if (const auto found = last_by_handle_.find(living.key()); found != last_by_handle_.end())
        return found->second;
    return declared_before(path);
}

/// The living instance for an earlier declaration: the declared instance, also if it has moved, or
/// an instance of the same class that the game has put in its place.
Handle Merge::living(const Declared& before, Handle parent, const std::string& name) const {
    if (tree_.alive(before.instance) && &tree_.class_of(before.instance) == before.of)
        return before.instance;
    if (!tree_.alive(parent)) return {};
    const Handle there = tree_.child(parent, name);
    return there && &tree_.class_of(there) == before.of ? there : Handle{};
}

void Merge::match(Handle made, Handle parent, const std::string& name) {
    if (machine_.declarations.is_stand_in(made)) return mark_deleted(made);
    parent = result_of(parent);
    const auto entry = next_by_handle_.find(made.key());
    const std::string path = entry == next_by_handle_.end() ? "" : entry->second->path;
    const Declared* const before = declared_before(path);
    if (before == nullptr)
        if (const Handle there = tree_.alive(parent) ? tree_.child(parent, name) : Handle{};
            there && !matched_.contains(there.key()) && has_kept(there) &&
            &tree_.class_of(there) == &tree_.class_of(made))
            return add_pair(made, there);
    if (before == nullptr || before->of != &tree_.class_of(made)) {
        waiting_.push_back({made, parent, name});
        return;
    }
    const Handle there = living(*before, parent, name);
    if (!there)
        mark_deleted(made);
    else if (matched_.contains(there.key()))
        waiting_.push_back({made, parent, name});
    else
        add_pair(made, there);
}

void Merge::add_pair(Handle made, Handle living) {
    results_[made.key()] = living;
    matched_.insert(living.key());
    pairs_.emplace_back(made, living);
    match_below(made, living);
}

void Merge::match_below(Handle made, Handle living) {
    for (const Handle child : tree_.children(made)) {
        const std::string name = tree_.name(child);
        const auto entry = next_by_handle_.find(child.key());
        if (entry != next_by_handle_.end() && entry->second->made) {
            match(child, living, name);
            continue;
        }
        // The class makes this child for both instances.
        const Handle there = tree_.child(living, name);
        if (there && &tree_.class_of(there) == &tree_.class_of(child)) add_pair(child, there);
    }
}

/// The game has deleted the declared instance, so it is not made again.
void Merge::mark_deleted(Handle made) {
    const auto entry = next_by_handle_.find(made.key());
    const Declared* const before =
        entry == next_by_handle_.end() ? nullptr : declared_before(entry->second->path);
    const Handle gone =
        before != nullptr && !tree_.alive(before->instance) ? before->instance : made;
    results_[made.key()] = gone;
    pairs_.emplace_back(made, gone);
    for (const Handle child : tree_.children(made)) mark_deleted(child);
}

// --- Values

Value Merge::translated(const Value& value) const {
    if (value.is(Type::reference)) return result_of(value.reference());
    if (!value.is(Type::list)) return value;
    List list;
    for (const Value& element : value.list()) list.push_back(translated(element));
    return list;
}

/// Values are given in the order of declaration, because the valid values of one may depend on
/// others.
void Merge::apply(const Declared& now, Handle to, const Declared* before) {
    std::vector<std::string> names;
    for (const Property* property : tree_.class_of(to).properties())
        names.push_back(property->name);
    const std::size_t declared = names.size();
    const auto add = [&](const auto& all) {
        for (const auto& [name, assignment] : all)
            if (std::ranges::find(names, name) == names.end()) names.push_back(name);
    };
    add(now.assignments);
    if (before != nullptr) add(before->assignments);
    std::sort(names.begin() + static_cast<std::ptrdiff_t>(declared), names.end());
    for (const std::string& name : names) {
        if (is_place(name)) continue;
        const auto a = now.assignments.find(name);
        const Assignment* const is = a == now.assignments.end() ? nullptr : &a->second;
        const Assignment* was = nullptr;
        if (before != nullptr)
            if (const auto b = before->assignments.find(name); b != before->assignments.end())
                was = &b->second;
        if (is != nullptr || was != nullptr)
            attempt(to, name, [&] { apply_one(to, name, is, was); });
    }
}

void Merge::apply_one(Handle to, const std::string& name, const Assignment* now,
                      const Assignment* before) {
    const Property* property = tree_.find(to, name);
    if (now == nullptr ? property == nullptr : is_declared_before(to, property, *now, before))
        return;
    if (property != nullptr && (property->read_only || is_set_by_files(to, *property, now))) return;
    const bool same_text = now != nullptr && now->formula && before != nullptr && before->formula &&
                           before->formula->source == now->formula->source;
    std::string place = now == nullptr ? std::string() : now->place;
    std::function<std::string()> locate = [&place] { return place; };
    const property::Tree::CauseScope cause(tree_, property::Writer::script, &locate);
    set(to, name, now, before);
    changed_ = true;
    property = tree_.find(to, name);
    if (machine_.options.tweaks == nullptr || property == nullptr || same_text) return;
    const std::string edit = machine_.options.tweaks->given_again(to, *property);
    if (!edit.empty())
        notes_.push_back(said(to, *property, now) + ", in place of the edit " + edit);
}

/// Whether nothing is to be done: the top level said the same before, so what has happened to the
/// value since stays.
bool Merge::is_declared_before(Handle to, const Property* property, const Assignment& now,
                               const Assignment* before) const {
    if (before == nullptr || before->formula.has_value() != now.formula.has_value()) return false;
    if (!now.formula) return is_same(before->value, translated(now.value));
    // The same text as before may use other variables of the script.
    const property::Formula* const formula =
        property == nullptr ? nullptr : tree_.formula(to, *property);
    return before->formula->source == now.formula->source &&
           (formula == nullptr || formula->source != now.formula->source);
}

void Merge::set(Handle to, const std::string& name, const Assignment* now,
                const Assignment* before) {
    if (now != nullptr && now->formula) return tree_.set_formula(to, name, *now->formula);
    if (now != nullptr) return tree_.set_or_add(to, name, translated(now->value));
    const Property& property = *tree_.find(to, name);  // declared no more
    if (property.binding.kind == property::BindingKind::ad_hoc)
        tree_.remove_ad_hoc(to, name);
    else if (before->before.is_nil())
        tree_.reset(to, property);
    else
        tree_.set(to, property, before->before);
}

/// References in new instances, which were written while the others were detached.
void Merge::refer_to_results() {
    for (const Declared& now : next_) {
        if (!now.made || results_.contains(now.instance.key()) || !tree_.alive(now.instance))
            continue;
        for (const auto& [name, assignment] : now.assignments) {
            if (assignment.formula || is_place(name)) continue;
            const Value value = translated(assignment.value);
            if (value == assignment.value) continue;
            attempt(now.instance, name,
                    [&, this, &name = name] { tree_.set(now.instance, name, value); });
        }
    }
}

void Merge::apply_defaults(const std::vector<ScriptClasses::NewDefault>& defaults) {
    if (defaults.empty()) return;
    std::vector<Handle> all;
    tree_.each_below(tree_.root(), [&](Handle each) { all.push_back(each); });
    property::Tweaks* const tweaks = machine_.options.tweaks;
    for (const Handle each : all)
        for (const auto& [property, before] : defaults) {
            if (!tree_.class_of(each).is_a(*property->owner)) continue;
            const Property* const here = tree_.find(each, property->symbol);
            if (here == property && tweaks != nullptr) tweaks->default_changed(each, *here);
            if (here != property || tree_.formula(each, *here) != nullptr ||
                !(tree_.peek(each, *here) == before))
                continue;
            const auto declared = last_by_handle_.find(each.key());
            if (declared != last_by_handle_.end() &&
                declared->second->assignments.contains(property->name))
                continue;
            if (tweaks != nullptr && tweaks->has_edit(each, *property)) continue;
            const auto* const wanted = property;
            attempt(each, property->name,
                    [&, this] { tree_.set(each, *wanted, wanted->default_value); });
            changed_ = true;
        }
}

// --- Places

void Merge::delete_undeclared() {
    std::unordered_set<std::string> declared, undeclared;
    for (const Declared& now : next_) declared.insert(now.path);
    std::vector<const Declared*> gone;
    for (const Declared& before : machine_.declarations.last())
        if (before.made && !before.path.empty() && !matched_.contains(before.instance.key())) {
            gone.push_back(&before);
            // The edits of one that gets another class follow it.
            if (!declared.contains(before.path)) undeclared.insert(before.path);
        }
    for (const Declared* const before : gone)
        if (undeclared.contains(before->path) && !is_below_any(before->path, undeclared))
            drop_edits_below(tree_.alive(before->instance) ? tree_.path(before->instance)
                                                           : before->path);
    for (const Declared* const before : gone)
        if (tree_.alive(before->instance)) {
            changed_ = true;
            attempt(before->instance, "", [&] { tree_.destroy(before->instance); });
        }
}

void Merge::place_new() {
    for (const Waiting& each : waiting_) {
        const Handle parent = result_of(each.parent);
        if (!tree_.alive(each.instance) || !tree_.alive(parent)) continue;
        changed_ = true;
        attempt(each.instance, each.name, [&] {
            const Handle other = tree_.child(parent, each.name);
            if (other && other != each.instance && !tree_.parent(each.instance))
                tree_.replace(other, each.instance);
            else
                tree_.move(each.instance, parent, each.name);
            remake_edits(each.instance);
        });
    }
}

/// To be called before new instances leave the detached ones.
void Merge::note_orders() {
    for (const auto& [made, living] : pairs_)
        if (made != living && tree_.alive(made)) orders_.emplace_back(living, tree_.children(made));
    std::unordered_map<std::uint64_t, std::size_t> known;
    for (const Handle made : machine_.declarations.placed()) {
        if (!tree_.alive(made)) continue;
        const Handle parent = result_of(machine_.declarations.place_of(made).parent);
        const auto [at, is_new] = known.try_emplace(parent.key(), orders_.size());
        if (is_new) orders_.emplace_back(parent, std::vector<Handle>());
        orders_[at->second].second.push_back(made);
    }
}

/// A new instance comes behind the one that stands before it in the file, and those whose order has
/// changed in the file change it.
void Merge::put_in_order() {
    for (const auto& [parent, children] : orders_) {
        if (!tree_.alive(parent)) continue;
        std::vector<Handle> wanted;
        std::unordered_set<std::uint64_t> declared;
        for (const Handle child : children)
            if (const Handle is = result_of(child);
                tree_.alive(is) && tree_.parent(is) == parent && declared.insert(is.key()).second)
                wanted.push_back(is);
        std::vector<Handle> now = tree_.children(parent);
        std::erase_if(now, [&](Handle each) { return !declared.contains(each.key()); });
        if (now == wanted) continue;
        for (std::size_t i = 1; i < wanted.size(); ++i)
            attempt(wanted[i], "",
                    [&, i] { property::put_behind(tree_, wanted[i], wanted[i - 1]); });
    }
}

// --- The end

void Merge::rebind(Handle made, Handle living) {
    lua_State* const L = machine_.lua.main;
    push_registry(L, machine_.boxes.proxies);
    if (lua_rawgeti(L, -1, static_cast<lua_Integer>(made.key())) == LUA_TUSERDATA) {
        auto* const box = static_cast<InstanceBox*>(lua_touserdata(L, -1));
        box->handle = living;
        box->members = &machine_.members.of(tree_.alive(living) ? tree_.class_of(living)
                                                                : tree_.class_of(made));
        lua_rawseti(L, -2, static_cast<lua_Integer>(living.key()));
        lua_pushnil(L);
        lua_rawseti(L, -2, static_cast<lua_Integer>(made.key()));
    } else {
        lua_pop(L, 1);
    }
    lua_pop(L, 1);
    machine_.timers.change_owner(made, living);
}

/// Calls of methods that change something are made for new instances only.
void Merge::call_new() {
    for (const Declarations::Call& call : std::exchange(machine_.declarations.calls, {})) {
        const auto made = next_by_handle_.find(call.instance.key());
        if (made == next_by_handle_.end() || !made->second->made ||
            results_.contains(call.instance.key()) || !tree_.alive(call.instance))
            continue;
        std::vector<Value> arguments;
        for (const Value& each : call.arguments) arguments.push_back(translated(each));
        attempt(call.instance, call.method->name,
                [&] { tree_.call(call.instance, *call.method, arguments); });
    }
}

void Merge::finish() {
    tell_scenes();
    for (const auto& [made, living] : pairs_)
        if (made != living) rebind(made, living);
    call_new();
    for (const auto& [made, living] : pairs_)
        if (tree_.alive(made)) attempt(made, "", [&, h = made] { tree_.destroy(h); });
    for (Declared& each : next_) {
        each.instance = result_of(each.instance);
        for (auto& [name, assignment] : each.assignments)
            assignment.value = translated(assignment.value);
    }
    machine_.declarations.keep(std::move(next_));
}

}  // namespace fettle::script
