#include <binding/preferences.h>

#include <algorithm>
#include <utility>

#include <fettle/property/error.h>

namespace fettle::interface {

using property::Error;
using property::ErrorKind;
using property::Handle;
using property::List;
using property::Place;
using property::Value;

namespace {

/// All properties below these instances belong to the player.
constexpr std::string_view players_roots[] = {"audio", "input.actions"};

const std::string& path_in(const Value& entry) {
    return entry.list()[0].text();
}

auto entry_of(List& list, const std::string& path) {
    return std::find_if(list.begin(), list.end(),
                        [&](const Value& entry) { return path_in(entry) == path; });
}

void remove(List& list, const std::string& path) {
    if (const auto known = entry_of(list, path); known != list.end()) list.erase(known);
}

/// Whether the list has this entry. The list may be of a saved game, and so hold anything.
bool holds(const List& list, const Value& entry) {
    return std::find(list.begin(), list.end(), entry) != list.end();
}

}  // namespace

Preferences::~Preferences() {
    if (tree_ != nullptr && !life_.expired()) tree_->unobserve(*this);
}

void Preferences::attach(property::Tree& tree, Handle service) {
    tree_ = &tree;
    life_ = tree.lifetime();
    service_ = service;
    tree.observe(*this);
}

bool Preferences::can_be_preference(const Place& place) const {
    if (place.property == nullptr) return false;
    const std::string path = tree_->path(place.instance);
    return std::any_of(std::begin(players_roots), std::end(players_roots),
                       [&](std::string_view root) {
                           return path == root || path.starts_with(std::string(root) + ".");
                       });
}

void Preferences::store(const Place& place) {
    if (!can_be_preference(place)) return;
    put(tree_->path(place.instance) + property::path_suffix(place.property->name),
        tree_->get(place.instance, *place.property));
}

/// Throws property::Error for a path that is not that of a property.
Place Preferences::place_of(const std::string& path) const {
    Place place = property::resolve(*tree_, path);
    if (place.property == nullptr || !place.part.empty())
        throw Error(ErrorKind::rejected,
                    "\"" + path + "\": expected the path of a property, such as \"audio.volume\"");
    return place;
}

void Preferences::prefer(const std::string& path, const Value& value) {
    const Place place = place_of(path);
    const std::string whole =
        tree_->path(place.instance) + property::path_suffix(place.property->name);
    if (value.is_nil()) return put(whole, value);
    tree_->set(place.instance, *place.property, value);
    put(whole, tree_->get(place.instance, *place.property));
}

void Preferences::begin_with(const std::string& path, const Value& value) {
    for (List* const list : {&now_, &waiting_}) {
        remove(*list, path);
        list->push_back(List{path, value});
    }
}

void Preferences::put(const std::string& path, const Value& value) {
    remove(waiting_, path);
    const auto known = entry_of(now_, path);
    if (value.is_nil()) {
        if (known == now_.end()) return;
        now_.erase(known);
    } else if (known == now_.end()) {
        now_.push_back(List{path, value});
    } else if (known->list()[1] == value) {
        return;
    } else {
        *known = List{path, value};
    }
    save();
    if (changed_) changed_(path, value);
}

void Preferences::save() {
    if (tree_->alive(service_) && !(tree_->get(service_, saved_name) == Value(now_)))
        tree_->set(service_, saved_name, Value(now_));
}

bool Preferences::differs() const {
    if (!jumped_ && waiting_.empty()) return false;
    return !waiting_.empty() || !(tree_->get(service_, saved_name) == Value(now_));
}

void Preferences::restore_changed() {
    if (!tree_->alive(service_)) return;
    List due = std::exchange(waiting_, {});
    if (std::exchange(jumped_, false)) {
        const Value then = tree_->get(service_, saved_name);
        for (const Value& entry : now_)
            if (!holds(then.list(), entry) && !holds(due, entry)) due.push_back(entry);
    }
    for (const Value& entry : due)
        if (!write(path_in(entry), entry.list()[1])) waiting_.push_back(entry);
    save();
}

/// False if there is no such property now. A value that the property does not accept any more is
/// removed from the preferences.
bool Preferences::write(const std::string& path, const Value& value) {
    try {
        const Place place = place_of(path);
        tree_->set(place.instance, *place.property, value);
    } catch (const Error& error) {
        if (error.kind() == ErrorKind::unknown_name || error.kind() == ErrorKind::deleted)
            return false;
        remove(now_, path);
        if (problem_) problem_("the player's setting of " + path + " is void: " + error.what());
    }
    return true;
}

}  // namespace fettle::interface
