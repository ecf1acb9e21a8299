// Classes and instances of a tree: look-up, creation and deletion. Moves are in tree_placing.cpp.

#include <optional>
#include <utility>

#include <fettle/property/path.h>
#include <fettle/property/pinned.h>
#include <fettle/property/spelling.h>

#include <classes/drawn_methods.h>

#include "state.h"

namespace fettle::property {

namespace {

ClassDescriptor object_descriptor() {
    ClassDescriptor object;
    object.name = "Object";
    object.base = "";
    object.doc = "A plain node: a place for children and for properties of your own.";
    Property name{.name = "name",
                  .type = Type::text,
                  .doc = "Its name among the children of its parent: the last part of its path."};
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
        .name = "parent", .type = Type::reference, .doc = "The instance of which it is a child."};
    parent.transient = true;
    parent.binding.kind = BindingKind::node;
    parent.binding.node_get = [](void*, const Tree& in, Handle self) {
        return Value(in.parent(self));
    };
    parent.binding.node_set = [](void*, Tree& in, Handle self, const Value& v) {
        in.move(self, v.reference());
    };
    Property z{.name = "z",
               .type = Type::number,
               .range = {-1e9, 1e9},
               .doc =
                   "The order of drawing: a larger z is drawn later, over a smaller one; equal "
                   "ones in the order of the tree. It is added to the z of everything below."};
    z.sparse = true;
    object.properties = {name, of, parent, z};
    object.methods = drawn_methods();
    object.events = {
        Event{.name = "ready", .doc = "It has been made, with all its properties and children."},
        Event{.name = "deleted",
              .fields = {{.name = "path", .type = Type::text, .doc = "Where it was."},
                         {.name = "cause",
                          .type = Type::text,
                          .doc = "Who deleted it, and at which step."}},
              .doc = "It was deleted; its handle is no longer valid."},
    };
    return object;
}

ClassDescriptor game_descriptor() {
    ClassDescriptor game;
    game.name = "Game";
    game.doc =
        "The root of the tree: its children are the services and whatever a game puts beside them.";
    game.creatable = false;
    game.events = {
        Event{.name = "restored",
              .fields = {{.name = "step",
                          .type = Type::integer,
                          .doc = "Where simulation time goes on from."},
                         {.name = "left",
                          .type = Type::integer,
                          .doc = "The step at which the game was before."}},
              .doc = "A snapshot was restored, or time rewound: everything in the tree "
                     "is as it was then. Variables of scripts that are not in the tree are not."}};
    return game;
}

}  // namespace

Tree::Tree() : state_(std::make_unique<State>(*this)) {
    state_->changes.deleted_event = define(object_descriptor()).event("deleted");
    const Class& game_class = define(game_descriptor());
    state_->restored_event = game_class.event("restored");
    const std::uint32_t index = state_->structure.make(game_class, 0, NodeName::make("game"), true);
    state_->instances.root = state_->instances.nodes.handle(index);
}

Tree::~Tree() {
    // Modules may still be alive and own rows, so the instances are destroyed, children first.
    State& s = *state_;
    s.lifetime.require_unpinned();
    s.lifetime.mark.reset();
    s.lifetime.ending = true;
    // Objects that outlive the tree test `mark` and do not use the tree any more. Observers and
    // parts are removed now, because they may be destroyed before the end of this function.
    s.changes.observers.all.clear();
    s.changes.observers.logs.clear();
    s.history.observe(nullptr);
    s.snapshots.parts.clear();
    s.snapshots.numbers.clear();
    s.changes.weight.mark = INT64_MAX;
    s.formulas.clear();
    for (std::uint32_t i = 1; i < s.instances.nodes.end(); ++i)
        if (s.instances.nodes[i].alive() && s.instances.nodes[i].parent == 0)
            destroy(s.instances.nodes.handle(i));
    if (s.lifetime.uses > 0) s.lifetime.rest = std::move(state_);
}

std::weak_ptr<const Tree*> Tree::lifetime() const {
    return state_->lifetime.mark;
}

Pinned::Pinned(Tree& tree, const char* what)
    : tree_(tree), outer_(std::exchange(tree.state().lifetime.pinned, what)) {}

Pinned::~Pinned() {
    tree_.state().lifetime.pinned = outer_;
}

// --- Classes

const Class& Tree::define(ClassDescriptor descriptor) {
    require_changeable("define a class");
    require_free_names(state_->instances.reserved_names, descriptor);
    Class& made = state_->instances.classes.define(std::move(descriptor));
    add_weight(ClassRegistry::weight_of(made));
    state_->instances.stored.push_back(
        made.stored_.empty() ? nullptr : std::make_unique<StoredColumns>(made));
    for (const Property& property : made.own_properties_)
        property.shortcut.set_interest(state_->changes.watchers.interest(property));
    return made;
}

const Class* Tree::find_class(std::string_view name) const {
    return state_->instances.classes.find(name);
}

const Class& Tree::class_named(std::string_view name) const {
    if (const Class* found = find_class(name)) return *found;
    throw Error(ErrorKind::unknown_name, "no class is called \"" + std::string(name) + "\"" +
                                             suggestion(name, state_->instances.classes.names()));
}

std::vector<const Class*> Tree::classes() const {
    std::vector<const Class*> all;
    all.reserve(state_->instances.classes.size());
    for (std::uint32_t i = 0; i < state_->instances.classes.size(); ++i)
        all.push_back(&state_->instances.classes[i]);
    return all;
}

const Class& Tree::object_class() const {
    return state_->instances.classes[0];
}

// --- Instances

Handle Tree::root() const {
    return state_->instances.root;
}

Handle Tree::create(const Class& instance_class, Handle parent, std::string_view name) {
    if (!parent) parent = {};  // a null handle may have an index
    State& s = *state_;
    s.require_changeable("create an instance");
    s.instances.require_own(instance_class);
    if (s.lifetime.ending)
        throw Error(ErrorKind::deleted, "no instance is made while the tree is being destroyed");
    if (parent) s.instances.require(parent);
    if (s.underway.restoring)
        s.underway.require_row_above(s.instances, parent, "create an instance");
    if (parent) {
        if (s.instances.require(parent).being_deleted)
            s.underway.require_staying(s.instances, parent, "create an instance below it");
        s.instances.require_room_below(parent, 1);
    }
    if (!name.empty()) s.instances.check_child_name(parent, name);
    NodeName chosen = NodeName::make(name.empty() ? std::string_view(instance_class.stem()) : name);
    if (name.empty() && parent) chosen = s.structure.free_name(parent.index, instance_class.stem());
    const Handle made = s.instances.nodes.handle(
        s.structure.make(instance_class, parent.index, chosen, !name.empty()));
    if (s.changes.recording()) s.history.instance_created(made);
    return made;
}

void Tree::destroy(Handle instance) {
    State& s = *state_;
    s.instances.require(instance);
    s.require_changeable("delete an instance");
    if (instance == s.instances.root && !s.lifetime.ending)
        throw Error(ErrorKind::bad_structure, "the root cannot be deleted");
    s.underway.require_staying(s.instances, instance, "delete it");
    if (s.underway.restoring) s.underway.require_rows(s.instances, instance, "delete it");
    if (!s.lifetime.ending) s.underway.require_settled(s.instances, instance, "delete it");
    // The end of the tree cannot be undone, and its modules may be destroyed already.
    if (!s.lifetime.ending && s.changes.recording()) s.history.instance_deleting(instance);
    if (!s.lifetime.ending) s.changes.notify([&](Observer& o) { o.destroying(instance); });
    const std::string problem = s.structure.destroy_below(instance.index);
    s.instances.keep_slots = false;
    if (!problem.empty() && !s.lifetime.ending)
        throw Error(ErrorKind::rejected,
                    problem + " (thrown by its module as it was deleted; it is gone)");
}

void Tree::each_below(Handle top, const std::function<void(Handle)>& visit) const {
    state_->instances.require(top);
    if (!visit) throw Error(ErrorKind::wrong_type, "each_below needs a function");
    state_->instances.reads.note_structure();
    const Pin pin(state_->lifetime, "the function given to each_below");
    std::vector<Handle> all;
    state_->instances.visit_below(
        top.index, [&](std::uint32_t i) { all.push_back(state_->instances.nodes.handle(i)); });
    for (const Handle handle : all)
        if (alive(handle)) visit(handle);
}

std::optional<DeletedInfo> Tree::deleted_info(Handle instance) const {
    if (alive(instance)) return {};
    const Tombstone* const found = state_->instances.tombstones.find(instance);
    if (found == nullptr) return {};
    return DeletedInfo{*found->of, found->name};
}

bool Tree::alive(Handle instance) const {
    return state_->instances.nodes.find(instance) != nullptr;
}
void Tree::require(Handle instance) const {
    state_->instances.require(instance);
}

const Class& Tree::class_of(Handle instance) const {
    return state_->instances.class_of(state_->instances.require(instance));
}
Row Tree::row(Handle instance) const {
    return state_->instances.require(instance).row;
}
void Tree::set_row(Handle instance, Row row) {
    Node& node = state_->instances.require(instance);
    state_->require_changeable("move a row");
    node.row = row;
}

Handle Tree::parent(Handle instance) const {
    state_->instances.reads.note_structure();
    return state_->instances.nodes.handle(state_->instances.require(instance).parent);
}
Handle Tree::first_child(Handle instance) const {
    state_->instances.reads.note_structure();
    return state_->instances.nodes.handle(state_->instances.require(instance).first_child);
}
Handle Tree::next_sibling(Handle instance) const {
    return state_->instances.nodes.handle(state_->instances.require(instance).next);
}

std::vector<Handle> Tree::children(Handle instance) const {
    state_->instances.reads.note_structure();
    std::vector<Handle> all;
    for (std::uint32_t i = state_->instances.require(instance).first_child; i != 0;
         i = state_->instances.nodes[i].next)
        all.push_back(state_->instances.nodes.handle(i));
    return all;
}

std::size_t Tree::child_count(Handle instance) const {
    state_->instances.reads.note_structure();
    state_->instances.require(instance);
    return state_->instances.nodes.child_count(instance.index);
}

Handle Tree::nth_child(Handle instance, std::uint64_t n) const {
    state_->instances.reads.note_structure();
    state_->instances.require(instance);
    return state_->instances.nodes.handle(state_->instances.nodes.nth_child(instance.index, n));
}

Handle Tree::child(Handle instance, std::string_view name) const {
    // Only a formula needs a symbol for the name.
    if (in_formula()) state_->instances.reads.note_name(instance, Symbol(name));
    state_->instances.require(instance);
    return state_->instances.nodes.handle(
        state_->instances.nodes.child(instance.index, NodeName::look_up(name)));
}

bool Tree::is_below(Handle instance, Handle ancestor) const {
    for (std::uint32_t i = state_->instances.require(instance).parent; i != 0;
         i = state_->instances.nodes[i].parent)
        if (i == ancestor.index) return alive(ancestor);
    return false;
}

std::uint64_t Tree::structure() const {
    return state_->structure.version;
}

std::size_t Tree::size() const {
    return state_->instances.nodes.alive();
}

std::string Tree::name(Handle instance) const {
    state_->instances.reads.note_structure();
    return state_->shown_name(instance.index, state_->instances.require(instance)).text();
}

std::string Tree::path(Handle instance) const {
    const State& s = *state_;
    s.instances.require(instance);
    state_->instances.reads.note_structure();
    if (instance == s.instances.root) return "game";
    std::vector<std::uint32_t> chain;
    std::uint32_t top = instance.index;
    for (; s.instances.nodes[top].parent != 0; top = s.instances.nodes[top].parent)
        chain.push_back(top);
    std::string path = top == s.instances.root.index
                           ? ""
                           : "(detached " + s.instances.nodes[top].name.text() + ")";
    for (auto i = chain.rbegin(); i != chain.rend(); ++i)
        path += path_suffix(s.shown_name(*i, s.instances.nodes[*i]).text());
    if (path.front() == '.') return path.substr(1);
    return path.front() == '[' ? "game" + path : path;
}

}  // namespace fettle::property
