// Tweaks when the script of the game is loaded again. An edit starts from what the script gives. If
// the script changes this, the edit of the same value ends: the change in the script is newer.

#include <fettle/property/path.h>

#include <tweaks/tweaks_state.h>

namespace fettle::property {

/// The tweak about the property; null if there is none, or if its instance was deleted.
Tweaks::State::Entry* Tweaks::State::value_of(Handle instance, const Property& property) const {
    const auto found = by_key.find(key_of(Kind::value, tree.path(instance), property.name));
    return found == by_key.end() || found->second->gone ? nullptr : found->second;
}

/// Also at moments to which the game goes back later.
void Tweaks::State::start_from(Entry& its, const Image& given) {
    const std::int64_t number = its.row.number;
    rename_in_entries([number, given](Entry& each) {
        if (each.row.number != number) return;
        each.was = given;
        if (given.kind == Image::Kind::value)
            each.given = given;
        else
            each.given.reset();
    });
    if (its.in_file) its.in_file = given;
}

std::string Tweaks::State::given_again(Handle instance, const Property& property) {
    settle();
    const std::string path = path_below(tree.path(instance), property.name);
    given_later[path] = tree.step();
    Entry* const its = value_of(instance, property);
    if (its == nullptr) return {};
    const Image given = image_now(tree, instance, property.symbol, false);
    std::string replaced;
    if (!its->away && its->row.state == RowState::open && visible(*its) && !(its->now == given)) {
        const auto [was, now] = change_text(its->was, its->now);
        replaced = was + " → " + now;
    }
    start_from(*its, given);
    if (!its->away) its->now = given;
    index(*its);
    add_to_dirty(*its);
    return replaced;
}

std::size_t Tweaks::State::made_no_more(const std::string& path) {
    settle();
    std::size_t count = 0;
    for (Entry* const its : at_or_below(path)) {
        count += its->row.state == RowState::open && visible(*its) ? 1U : 0U;
        const std::int64_t number = its->row.number;
        rename_in_entries([number](Entry& each) {
            if (each.row.number == number) each.gone = true;
        });
        its->away = true;  // an edit of another instance with this path begins anew
        index(*its);
        add_to_dirty(*its);
    }
    return count;
}

std::size_t Tweaks::State::replaced(Handle instance,
                                    const std::function<bool(Handle, const Property&)>& same) {
    settle();
    std::size_t dropped = 0;
    for (Entry* const its : at_or_below(tree.path(instance))) {
        if (its->row.kind != Kind::value || its->away || its->gone || tree.alive(its->handle))
            continue;
        const bool listed = its->row.state == RowState::open && visible(*its);
        const Handle now = instance_or_none(tree, its->row.instance);
        const Property* const property = now ? tree.find(now, its->row.property) : nullptr;
        bool again = listed && property != nullptr && same(now, *property);
        if (again) {
            start_from(*its, image_now(tree, now, property->symbol, false));
            const Tree::CauseScope cause(tree, Writer::load);
            try {
                apply_image(tree, now, property->name, its->now);
                its->handle = now;
                its->property = property->symbol;
            } catch (const Error&) {  // the other class does not allow this value
                again = false;
            }
        }
        dropped += listed && !again ? 1U : 0U;
        its->gone = its->away = !again;
        index(*its);
        add_to_dirty(*its);
    }
    return dropped;
}

// --- Public functions

std::string Tweaks::set_by_file(Handle instance, const Property& property) const {
    const State& state = usable();
    state_->settle();
    return state.kept.place_of(state.home_of(instance), property.name);
}

bool Tweaks::has_kept(Handle instance, const Property& property, const Value& value) const {
    State& state = usable();
    state.settle();
    const State::Entry* const its = state.value_of(instance, property);
    return its != nullptr && its->in_file &&
           *its->in_file == image_of(state.tree, property,
                                     {.present = true, .overridden = true, .value = value});
}

bool Tweaks::has_kept(Handle instance) const {
    State& state = usable();
    state.settle();
    for (Handle at = instance; at; at = state.tree.parent(at))
        for (const auto* const known : {&state.by_instance.created, &state.by_instance.moved})
            if (const auto found = known->find(at.key());
                found != known->end() && !found->second->row.file.empty() &&
                found->second->row.state == State::RowState::kept)
                return true;
    return false;
}

bool Tweaks::has_edit(Handle instance, const Property& property) const {
    State& state = usable();
    state.settle();
    const State::Entry* const its = state.value_of(instance, property);
    return its != nullptr && !its->away && state.visible(*its);
}

std::string Tweaks::given_again(Handle instance, const Property& property) {
    return usable().given_again(instance, property);
}

void Tweaks::default_changed(Handle instance, const Property& property) {
    State& state = usable();
    state.settle();
    State::Entry* const its = state.value_of(instance, property);
    if (its == nullptr || its->was.kind != Image::Kind::by_default) return;
    const Image now =
        image_of(state.tree, property, {.present = true, .value = property.default_value});
    state.start_from(*its, now);
    if (its->now.kind == Image::Kind::value && its->now.value == now.value) its->now = now;
    state.index(*its);
    state.add_to_dirty(*its);
}

std::size_t Tweaks::made_no_more(const std::string& path) {
    return usable().made_no_more(path);
}

std::size_t Tweaks::replaced(Handle instance,
                             const std::function<bool(Handle, const Property&)>& same) {
    return usable().replaced(instance, same);
}

}  // namespace fettle::property
