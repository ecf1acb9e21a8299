// Classes and instances of a tree: who there is, where they hang, how they come and go. How they
// get other places is tree_placing.cpp.

#include <fettle/property/tree.h>

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <utility>

#include <fettle/property/drawing.h>
#include <fettle/property/path.h>
#include <fettle/property/spelling.h>

#include "state.h"

namespace fettle::property {

Tree::Tree() : state_(std::make_unique<State>(*this)) {
    state_->define_object();
    ClassDescriptor game;
    game.name = "Game";
    game.doc =
        "The root of the tree: its children are the services and whatever a game puts beside them.";
    game.creatable = false;
    game.events = {Event{
        .name = "restored",
        .fields =
            {{.name = "step", .type = Type::integer, .doc = "Where simulation time goes on from."},
             {.name = "left", .type = Type::integer, .doc = "The step that time had come to."}},
        .doc = "A snapshot was restored, or time rewound: everything in the tree "
               "is as it was then. What a script keeps for itself is not."}};
    const Class& game_class = define(std::move(game));
    state_->restored_event = game_class.event("restored");
    const std::uint32_t index = state_->make(game_class, 0, NodeName::make("game"), true);
    state_->root = state_->nodes.handle(index);
}

Tree::~Tree() {
    // Modules may still be alive and own rows: they are told, children first.
    State& s = *state_;
    s.require_unpinned();
    s.life.reset();
    s.ending = true;
    for (std::uint32_t i = 1; i < s.nodes.end(); ++i)
        if (s.nodes[i].alive() && s.nodes[i].parent == 0) destroy(s.nodes.handle(i));
    if (s.uses > 0) s.orphan = std::move(state_);
}

std::weak_ptr<const Tree*> Tree::lifetime() const {
    return state_->life;
}

void Tree::State::define_object() {
    ClassDescriptor object;
    object.name = "Object";
    object.base = "";
    object.doc = "A plain node: a place for children and for properties of your own.";
    Property name{.name = "name",
                  .type = Type::text,
                  .doc = "What its parent calls it: the last part of its path."};
    name.transient = true;
    name.binding.kind = BindingKind::node;
    name.binding.node_get = [](void*, const Tree& in, Handle self) { return Value(in.name(self)); };
    name.binding.node_set = [](void*, Tree& in, Handle self, const Value& v) {
        in.rename(self, v.text());
    };
    Property of{.name = "class", .type = Type::text, .doc = "The name of its class."};
    of.read_only = of.transient = true;
    of.binding.kind = BindingKind::node;
    of.binding.node_get = [](void*, const Tree& in, Handle self) {
        return Value(in.class_of(self).name());
    };
    Property parent{
        .name = "parent", .type = Type::reference, .doc = "The instance it hangs under."};
    parent.transient = true;
    parent.binding.kind = BindingKind::node;
    parent.binding.node_get = [](void*, const Tree& in, Handle self) {
        return Value(in.parent(self));
    };
    parent.binding.node_set = [](void*, Tree& in, Handle self, const Value& v) {
        in.move(self, v.reference());
    };
    object.properties = {name, of, parent};
    object.events = {
        Event{.name = "ready", .doc = "It has been made, with all its properties and children."},
        Event{.name = "deleted",
              .fields = {{.name = "path", .type = Type::text, .doc = "Where it was."},
                         {.name = "cause",
                          .type = Type::text,
                          .doc = "Who deleted it, and at which step."}},
              .doc = "It was deleted; its handle is dead."},
    };
    const Class& defined = tree.define(std::move(object));
    ready_event = defined.event("ready");
    deleted_event = defined.event("deleted");
}

// --- Classes
// ---------------------------------------------------------------------------------------------------------

const Class& Tree::define(ClassDescriptor descriptor) {
    require_changeable("define a class");
    Class& made = state_->classes.define(std::move(descriptor));
    add_weight(weight_of_class);
    state_->stored.push_back(made.stored_.empty() ? nullptr
                                                  : std::make_unique<StoredColumns>(made));
    for (const Property& property : made.own_properties_)
        property.note_interest(state_->watchers.interest(property));
    return made;
}

const Class* Tree::find_class(std::string_view name) const {
    return state_->classes.find(name);
}

const Class& Tree::class_named(std::string_view name) const {
    if (const Class* found = find_class(name)) return *found;
    throw Error(ErrorKind::unknown_name, "no class is called \"" + std::string(name) + "\"" +
                                             suggestion(name, state_->classes.names()));
}

std::vector<const Class*> Tree::classes() const {
    std::vector<const Class*> all;
    for (std::uint32_t i = 0; i < state_->classes.size(); ++i) all.push_back(&state_->classes[i]);
    return all;
}

const Class& Tree::object_class() const {
    return state_->classes[0];
}

// --- Instances
// -------------------------------------------------------------------------------------------------------

Handle Tree::root() const {
    return state_->root;
}

void Tree::State::check_length(std::string_view name) {
    if (name.size() <= longest_name) return;
    throw Error(ErrorKind::bad_name, "the name \"" + std::string(name.substr(0, 40)) +
                                         "...\" has " + std::to_string(name.size()) +
                                         " bytes, and a name has at most " +
                                         std::to_string(longest_name));
}

void Tree::State::check_child_name(Handle parent, std::string_view name) const {
    check_length(name);
    const std::string quoted = "\"" + std::string(name) + "\"";
    if (name.empty()) throw Error(ErrorKind::bad_name, "the name of an instance cannot be empty");
    if (name.find('\0') != std::string_view::npos)
        throw Error(ErrorKind::bad_name, (parent ? tree.path(parent) + ": " : std::string()) +
                                             "the name " + quoted + " holds a zero byte");
    if (!parent) return;
    if (parent == root && name == "game")
        throw Error(ErrorKind::bad_name, "\"game\" is the root itself, not a child of it");
    const Class& above = tree.class_of(parent);
    if (above.property(name) != nullptr)
        throw Error(ErrorKind::bad_name, tree.path(parent) + ": a child cannot be called " +
                                             quoted + ", which is a property of " + above.name());
    if (above.method(name) != nullptr)
        throw Error(ErrorKind::bad_name, tree.path(parent) + ": a child cannot be called " +
                                             quoted + ", which is a method of " + above.name());
    if (tree.child(parent, name))
        throw Error(ErrorKind::bad_name, tree.path(parent) + " has a child " + quoted + " already");
    if (tree.find(parent, name) != nullptr)
        throw Error(ErrorKind::bad_name,
                    tree.path(parent) + ": " + quoted + " is a property there; remove it first");
}

std::uint32_t Tree::State::make(const Class& of, std::uint32_t parent, NodeName name, bool named,
                                Handle again) {
    if (!again && !to_come.empty()) {
        again = to_come.front();
        to_come.erase(to_come.begin());
    }
    if (again) nodes.revive(again);
    const std::uint32_t index = again ? again.index : nodes.allocate();
    const std::int64_t bytes =
        named && name.number == 0 ? weight_of_instance + weight_of_name : weight_of_instance;
    const Pin pin(*this, "a lifecycle function");
    add_weight(bytes);
    nodes[index].class_id = static_cast<std::uint16_t>(of.id_);
    nodes[index].named = named;
    nodes[index].fresh = true;
    fresh.push_back(index);
    nodes.link(index, parent, name);
    const Handle self = nodes.handle(index);
    if (stored[of.id_]) {
        const std::uint32_t row = stored[of.id_]->add();
        nodes[index].stored_row = row;
    }
    const Lifecycle& lifecycle = of.lifecycle();
    std::optional<Making> making_it(std::in_place, *this, self);
    bool has_row = false;
    try {
        if (lifecycle.create) {
            const Row row = lifecycle.create(lifecycle.context, tree, self);
            nodes[index].row = row;
            has_row = true;
        }
        if (!of.columns_found_) require_columns(of);
    } catch (...) {                              // its module has no room for it: it never was
        while (nodes[index].first_child != 0) {  // what it made below it before
            const Handle child = nodes.handle(nodes[index].first_child);
            tell([&](Observer& o) { o.destroying(child); });
            destroy_below(child.index);
        }
        if (has_row && lifecycle.destroy) try {
                lifecycle.destroy(lifecycle.context, tree, self, nodes[index].row);
            } catch (...) {
                // Why there was no room is told.
            }
        if (stored[of.id_]) stored[of.id_]->remove(nodes[index].stored_row);
        nodes.unlink(index);
        nodes.release(index, again && history.keeps_slots());
        note_number(parent, name.base);
        add_weight(-bytes);
        throw;
    }
    finish_making(self, of);
    making_it.reset();
    structure_changed(parent, name);
    if (watchers.any_broad()) {
        shadows.refresh(tree, watchers, self);
        note_listeners();
    }
    if (watchers.any_created())
        queue_item({.kind = QueueItem::Kind::created,
                    .what = Existence{.instance = self,
                                      .instance_class = &of,
                                      .path = {},
                                      .cause = tree.cause(),
                                      .last_values = {}},
                    .recipients = {}});
    tell([&](Observer& o) { o.created(self); });
    return index;
}

/// Looked at once, when the class has its first row: reading asks no column whether it is there.
void Tree::State::require_columns(const Class& of) const {
    for (const Property* property : of.properties_) {
        const Binding& binding = property->binding;
        if (binding.kind == BindingKind::column && binding.base(binding.context) == nullptr)
            throw Error(ErrorKind::rejected,
                        of.name() + "." + property->name +
                            ": it has no memory: the `base` of its column gave a null pointer");
    }
    of.columns_found_ = true;
}

/// What its module may refuse after its row is made. Then the instance came and went, and is told
/// of as such: a log of that does the same again.
void Tree::State::finish_making(Handle self, const Class& of) {
    const Lifecycle& lifecycle = of.lifecycle();
    const Property* at = nullptr;
    try {
        if (lifecycle.place && nodes[self.index].parent != 0) {
            const Row row = lifecycle.place(lifecycle.context, tree, self, nodes[self.index].row);
            nodes[self.index].row = row;
        }
        for (const Property* property : of.initial_) {
            at = property;
            write(self.index, nodes[self.index], *property, property->default_value);
        }
    } catch (const std::invalid_argument& refusal) {
        unmake(self);
        throw Error(ErrorKind::rejected,
                    of.name() + (at == nullptr ? "" : "." + at->name) + ": " + refusal.what());
    } catch (...) {
        unmake(self);
        throw;
    }
}

void Tree::State::unmake(Handle self) {
    tell([&](Observer& o) { o.created(self); });
    tell([&](Observer& o) { o.destroying(self); });
    destroy_below(self.index);
}

Handle Tree::create(const Class& instance_class, Handle parent, std::string_view name) {
    State& s = *state_;
    s.require_changeable("create an instance");
    s.require_own(instance_class);
    if (s.ending)
        throw Error(ErrorKind::deleted, "no instance is made while the tree is being destroyed");
    if (parent) {
        if (s.require(parent).dying) s.require_staying(parent, "create an instance below it");
        s.require_room_below(parent, 1);
    }
    if (!name.empty()) s.check_child_name(parent, name);
    NodeName chosen = NodeName::make(name.empty() ? std::string_view(instance_class.stem()) : name);
    if (name.empty() && parent) chosen = s.free_name(parent.index, instance_class.stem());
    const Handle made = s.nodes.handle(s.make(instance_class, parent.index, chosen, !name.empty()));
    if (s.history.recording()) s.history.born(made);
    return made;
}

void Tree::State::structure_changed(std::uint32_t parent, const NodeName& name) {
    ++upheavals;
    ++structure;
    if (formulas.size() == 0) return;
    // A name that nobody has asked for is no symbol, and does not become one.
    if (const Symbol asked = Symbol::find(name.text())) formulas.changed({parent, asked});
    formulas.structure_changed();
}

void Tree::State::visit_below(std::uint32_t top,
                              const std::function<void(std::uint32_t)>& visit) const {
    // Without recursion: a chain of a million parents is no reason to run out of stack.
    std::uint32_t index = top;
    while (index != 0) {
        const std::uint32_t here = index;
        visit(here);
        if (nodes[here].first_child != 0) {
            index = nodes[here].first_child;
            continue;
        }
        while (index != top && nodes[index].next == 0) index = nodes[index].parent;
        if (index == top) return;
        index = nodes[index].next;
    }
}

void Tree::each_below(Handle top, const std::function<void(Handle)>& visit) const {
    state_->require(top);
    if (!visit) throw Error(ErrorKind::wrong_type, "each_below needs a function");
    if (in_formula()) state_->formulas.note_structure();
    const State::Pin pin(*state_, "the function given to each_below");
    std::vector<Handle> all;
    state_->visit_below(top.index,
                        [&](std::uint32_t i) { all.push_back(state_->nodes.handle(i)); });
    for (const Handle handle : all)
        if (alive(handle)) visit(handle);
}

void Tree::State::bury(Tombstone gone) {
    tombstones.push_back(std::move(gone));
    if (tombstones.size() > most_tombstones) tombstones.pop_front();
}

const Tombstone* Tree::State::tombstone(Handle handle) const {
    const auto found = std::find_if(tombstones.rbegin(), tombstones.rend(),
                                    [&](const Tombstone& t) { return t.handle == handle; });
    return found == tombstones.rend() ? nullptr : &*found;
}

std::optional<Remains> Tree::remains(Handle instance) const {
    if (alive(instance)) return {};
    const Tombstone* const found = state_->tombstone(instance);
    if (found == nullptr) return {};
    return Remains{*found->of, found->name};
}

bool Tree::alive(Handle instance) const {
    return state_->nodes.find(instance) != nullptr;
}
void Tree::require(Handle instance) const {
    state_->require(instance);
}

void Tree::State::throw_deleted(Handle handle) const {
    // Undo may bring it back: a formula that looks for it is asked again then.
    if (formulas.tracking()) tree.state().formulas.note_structure();
    if (!handle) throw Error(ErrorKind::deleted, "no instance: the reference is empty");
    if (const Tombstone* t = tombstone(handle))
        throw Error(ErrorKind::deleted,
                    t->path + " was deleted at step " + std::to_string(t->cause.step) + " by " +
                        (t->cause.where.empty() ? std::string(writer_name(t->cause.writer))
                                                : t->cause.where));
    throw Error(ErrorKind::deleted, "the instance was deleted");
}

const Class& Tree::class_of(Handle instance) const {
    return state_->classes[state_->require(instance).class_id];
}
Row Tree::row(Handle instance) const {
    return state_->require(instance).row;
}
void Tree::set_row(Handle instance, Row row) {
    Node& node = state_->require(instance);
    state_->require_changeable("move a row");
    node.row = row;
}

Handle Tree::parent(Handle instance) const {
    if (in_formula()) state_->formulas.note_structure();
    return state_->nodes.handle(state_->require(instance).parent);
}
Handle Tree::first_child(Handle instance) const {
    if (in_formula()) state_->formulas.note_structure();
    return state_->nodes.handle(state_->require(instance).first_child);
}
Handle Tree::next_sibling(Handle instance) const {
    return state_->nodes.handle(state_->require(instance).next);
}

std::vector<Handle> Tree::children(Handle instance) const {
    if (in_formula()) state_->formulas.note_structure();
    std::vector<Handle> all;
    for (std::uint32_t i = state_->require(instance).first_child; i != 0; i = state_->nodes[i].next)
        all.push_back(state_->nodes.handle(i));
    return all;
}

std::size_t Tree::child_count(Handle instance) const {
    if (in_formula()) state_->formulas.note_structure();
    state_->require(instance);
    return state_->nodes.child_count(instance.index);
}

Handle Tree::nth_child(Handle instance, std::uint64_t n) const {
    if (in_formula()) state_->formulas.note_structure();
    state_->require(instance);
    return state_->nodes.handle(state_->nodes.nth_child(instance.index, n));
}

Handle Tree::child(Handle instance, std::string_view name) const {
    if (in_formula()) state_->formulas.note_name(instance, Symbol(name));
    state_->require(instance);
    return state_->nodes.handle(state_->nodes.child(instance.index, NodeName::look_up(name)));
}

bool Tree::is_below(Handle instance, Handle ancestor) const {
    for (std::uint32_t i = state_->require(instance).parent; i != 0; i = state_->nodes[i].parent)
        if (i == ancestor.index) return alive(ancestor);
    return false;
}

std::uint64_t Tree::structure() const {
    return state_->structure;
}

std::size_t Tree::size() const {
    return state_->nodes.alive();
}

std::string Tree::name(Handle instance) const {
    if (in_formula()) state_->formulas.note_structure();
    return state_->require(instance).name.text();
}

std::string Tree::path(Handle instance) const {
    const State& s = *state_;
    s.require(instance);
    if (in_formula()) state_->formulas.note_structure();
    if (instance == s.root) return "game";
    std::vector<std::uint32_t> chain;
    std::uint32_t top = instance.index;
    for (; s.nodes[top].parent != 0; top = s.nodes[top].parent) chain.push_back(top);
    std::string path = top == s.root.index ? "" : "(detached " + s.nodes[top].name.text() + ")";
    for (auto i = chain.rbegin(); i != chain.rend(); ++i)
        path += path_suffix(s.nodes[*i].name.text());
    if (path.front() == '.') return path.substr(1);
    return path.front() == '[' ? "game" + path : path;
}

void Tree::draw(Handle top, Painter& painter, double alpha) const {
    const State& s = *state_;
    s.require(top);
    const Drawing drawing(alpha);
    const State::Pin pin(*state_, "a lifecycle function");
    std::vector<std::uint32_t> over;
    s.visit_below(top.index, [&](std::uint32_t i) {
        const Lifecycle& lifecycle = s.classes[s.nodes[i].class_id].lifecycle();
        if (lifecycle.draw)
            lifecycle.draw(lifecycle.context, *this, s.nodes.handle(i), s.nodes[i].row, painter,
                           alpha);
        if (lifecycle.draw_over) over.push_back(i);
    });
    for (const std::uint32_t i : over) {
        const Lifecycle& lifecycle = s.classes[s.nodes[i].class_id].lifecycle();
        lifecycle.draw_over(lifecycle.context, *this, s.nodes.handle(i), s.nodes[i].row, painter,
                            alpha);
    }
}

}  // namespace fettle::property
