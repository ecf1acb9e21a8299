// property::Tree for shared objects: forwards calls to the program.

#include "guest_tree.h"

#include <fettle/property/acceptance.h>
#include <fettle/property/between_steps.h>
#include <fettle/property/drawing.h>
#include <fettle/property/error.h>
#include <fettle/property/explaining.h>
#include <fettle/property/path.h>
#include <fettle/property/question.h>
#include <fettle/property/restoring.h>
#include <fettle/property/spelling.h>

namespace fettle::property {

using module::received;
using module::sent;

// --- State

void Tree::State::require(fettle_status status) const {
    if (status != FETTLE_OK) throw Error(module::kind_of(status), host->last_error(host->self));
}

const Class* Tree::State::known(const char* name) {
    if (const Class* own = classes.find(name)) return own;
    const char* base = host->base_class(host->self, name);
    if (base == nullptr) return nullptr;
    ClassDescriptor mirrored;
    mirrored.name = name;
    mirrored.base = base;
    mirrored.creatable = false;
    if (!mirrored.base.empty()) (void)known(mirrored.base.c_str());
    return &classes.define(std::move(mirrored));
}

void Tree::State::follow_listeners() {
    for (const module::GuestEvent& e : events)
        if (e.tag.listeners != nullptr) e.event->listeners = *e.tag.listeners;
}

// --- Tree

Tree::Tree() : state_(std::make_unique<State>()) {
    state_->self = this;
}
Tree::~Tree() = default;

const Class& Tree::define(ClassDescriptor descriptor) {
    State& s = *state_;
    if (!descriptor.base.empty()) (void)s.known(descriptor.base.c_str());
    const Class& made = s.classes.define(descriptor);
    module::export_class(s, descriptor, made);
    return made;
}

const Class* Tree::find_class(std::string_view name) const {
    return state_->known(std::string(name).c_str());
}

const Class& Tree::class_named(std::string_view name) const {
    if (const Class* found = find_class(name)) return *found;
    throw Error(ErrorKind::unknown_name, "no class is called \"" + std::string(name) + "\"");
}

const Class& Tree::object_class() const {
    return class_named("Object");
}

// --- Instances

Handle Tree::root() const {
    const State& s = *state_;
    return received(s.host->root(s.host->self));
}

Handle Tree::create(const Class& instance_class, Handle parent, std::string_view name) {
    State& s = *state_;
    fettle_handle made{};
    const std::string called(name);
    s.require(s.host->create(s.host->self, instance_class.name().c_str(), sent(parent),
                             called.empty() ? nullptr : called.c_str(), &made));
    return received(made);
}

void Tree::destroy(Handle instance) {
    State& s = *state_;
    s.require(s.host->destroy(s.host->self, sent(instance)));
}

bool Tree::alive(Handle instance) const {
    const State& s = *state_;
    return s.host->alive(s.host->self, sent(instance)) != 0;
}

void Tree::require(Handle instance) const {
    const State& s = *state_;
    const char* path = nullptr;
    s.require(s.host->path(s.host->self, sent(instance), &path));
}

const Class& Tree::class_of(Handle instance) const {
    State& s = *state_;
    const char* name = s.host->class_name(s.host->self, sent(instance));
    if (name == nullptr) {
        require(instance);  // throws if the instance was deleted
        throw Error(ErrorKind::unknown_name, "the program has no class for the instance");
    }
    const auto found = s.by_name.find(name);
    if (found != s.by_name.end()) return *found->second;
    const Class* of = s.known(name);
    s.by_name[name] = of;
    return *of;
}

Row Tree::row(Handle instance) const {
    const State& s = *state_;
    fettle_row row = 0;
    s.require(s.host->row(s.host->self, sent(instance), &row));
    return row;
}

void Tree::set_row(Handle instance, Row row) {
    State& s = *state_;
    s.require(s.host->set_row(s.host->self, sent(instance), row));
}

Handle Tree::parent(Handle instance) const {
    const State& s = *state_;
    return received(s.host->parent(s.host->self, sent(instance)));
}

Handle Tree::first_child(Handle instance) const {
    const State& s = *state_;
    return received(s.host->first_child(s.host->self, sent(instance)));
}

Handle Tree::next_sibling(Handle instance) const {
    const State& s = *state_;
    return received(s.host->next_sibling(s.host->self, sent(instance)));
}

Handle Tree::child(Handle instance, std::string_view name) const {
    const State& s = *state_;
    return received(s.host->child(s.host->self, sent(instance), std::string(name).c_str()));
}

std::vector<Handle> Tree::children(Handle instance) const {
    std::vector<Handle> all;
    for (Handle c = first_child(instance); c; c = next_sibling(c)) all.push_back(c);
    return all;
}

bool Tree::is_below(Handle instance, Handle ancestor) const {
    for (Handle at = parent(instance); at; at = parent(at))
        if (at == ancestor) return true;
    return false;
}

void Tree::each_below(Handle top, const std::function<void(Handle)>& visit) const {
    // The list is made first, because the visitor may create and delete instances.
    std::vector<Handle> all;
    for (Handle at = top; at;) {
        all.push_back(at);
        Handle next = first_child(at);
        for (; !next && at != top; at = next ? at : parent(at)) next = next_sibling(at);
        at = next;
    }
    for (const Handle handle : all)
        if (alive(handle)) visit(handle);
}

std::string Tree::path(Handle instance) const {
    const State& s = *state_;
    const char* path = nullptr;
    s.require(s.host->path(s.host->self, sent(instance), &path));
    return path;
}

std::string Tree::path(Handle instance, const Property& property) const {
    return path(instance) + path_suffix(property.name);
}

// --- Values

const Property* Tree::find(Handle instance, Symbol name) const {
    return class_of(instance).property(name);
}

const Property* Tree::find(Handle instance, std::string_view name) const {
    return class_of(instance).property(name);
}

const Property& Tree::property(Handle instance, std::string_view name) const {
    const Class& of = class_of(instance);
    if (const Property* found = of.property(name)) return *found;
    throw Error(ErrorKind::unknown_name, path(instance) + " has no property \"" +
                                             std::string(name) + "\"" +
                                             suggestion(name, of.member_names()));
}

Value Tree::get(Handle instance, std::string_view name) const {
    const State& s = *state_;
    fettle_value value{};
    s.require(s.host->get(s.host->self, sent(instance), std::string(name).c_str(), &value));
    return received(value);
}

Value Tree::get(Handle instance, const Property& property) const {
    return get(instance, property.name);
}

void Tree::set(Handle instance, std::string_view name, const Value& value) {
    State& s = *state_;
    module::Outgoing outgoing;
    const fettle_value given = outgoing.put(value);
    s.require(s.host->set(s.host->self, sent(instance), std::string(name).c_str(), &given));
}

void Tree::set(Handle instance, const Property& property, const Value& value) {
    set(instance, property.name, value);
}

Result Tree::call(Handle instance, std::string_view method,
                  std::initializer_list<Value> arguments) {
    static const std::vector<Field> none;
    State& s = *state_;
    module::Outgoing outgoing;
    fettle_result result{};
    s.require(s.host->call(s.host->self, sent(instance), std::string(method).c_str(),
                           outgoing.put(std::span(arguments.begin(), arguments.size())),
                           static_cast<std::uint32_t>(arguments.size()), &result));
    const Method* known = class_of(instance).method(method);
    return received(result, known == nullptr ? none : known->returns);
}

std::string Tree::text(const Value& value, Precision precision) const {
    if (value.is(Type::reference) && alive(value.reference())) return path(value.reference());
    return value_text(value, precision);
}

// --- Events

namespace {
const void* id_of(const Tree::State& s, const Event& event) {
    for (const module::GuestEvent& e : s.events)
        if (e.event == &event) return e.tag.id;
    return nullptr;
}
}  // namespace

bool Tree::listens(Handle instance, const Event& event) const {
    const State& s = *state_;
    return s.host->listens(s.host->self, sent(instance), id_of(s, event)) != 0;
}

bool Tree::listens(const Event& event) const {
    return event.listeners != 0;
}

void Tree::emit(Handle instance, const Event& event, std::vector<Value> values) {
    State& s = *state_;
    module::Outgoing outgoing;
    s.require(s.host->emit(s.host->self, sent(instance), id_of(s, event),
                           outgoing.put(std::span<const Value>(values)),
                           static_cast<std::uint32_t>(values.size())));
}

void call_handlers(Tree& tree, Handle instance, const Event& event, std::vector<Value>& values,
                   std::size_t changeable) {
    if (event.listeners == 0) return;
    const Tree::State& s = tree.state();
    module::Outgoing outgoing;
    std::vector<fettle_value> fields;
    fields.reserve(values.size());
    for (const Value& value : values) fields.push_back(outgoing.put(value));
    s.require(s.host->ask(s.host->self, sent(instance), id_of(s, event), fields.data(),
                          static_cast<std::uint32_t>(fields.size()),
                          static_cast<std::uint32_t>(changeable)));
    for (std::size_t i = changeable; i < values.size(); ++i) values[i] = received(fields[i]);
}

bool Acceptance::is_accepted(Handle instance) noexcept {
    const fettle_host* host = module::program();
    return host == nullptr || host->accepts(host->self, sent(instance)) != 0;
}

const NotedSteps& noted_steps(const Tree&) {
    static const NotedSteps none;
    return none;
}

double Drawing::alpha() {
    const fettle_host* host = module::program();
    return host == nullptr ? 1 : host->drawing_alpha(host->self);
}

// --- Snapshots

void Tree::add_part(SnapshotPart& part) {
    state_->part = &part;
}

void Tree::remove_part(SnapshotPart&) {
    state_->part = nullptr;
}

/// The host ends the classes of a module that it closes.
std::weak_ptr<const Tree*> Tree::lifetime() const {
    return {};
}

void end_class(Tree&, const Class&) {}

void Tree::add_weight(std::int64_t bytes) {
    const State& s = *state_;
    s.host->grow(s.host->self, bytes);
}

void Tree::refreshing(SnapshotPart&, std::uint64_t what) {
    const State& s = *state_;
    s.host->refreshing(s.host->self, what);
}

void each_restored(const Tree& tree, const std::function<void(Handle, const Class&, Row)>& visit) {
    struct Call {
        const Tree& tree;
        const std::function<void(Handle, const Class&, Row)>& visit;
        std::exception_ptr failed;
    } call{tree, visit, nullptr};
    const fettle_host* host = tree.state().host;
    host->each_restored(
        host->self, &call,
        [](void* context, fettle_handle instance, const char* class_name, fettle_row row) {
            Call& to = *static_cast<Call*>(context);
            if (to.failed) return;
            try {
                to.visit(received(instance), to.tree.class_named(class_name), row);
            } catch (...) {  // no exception may cross the C interface
                to.failed = std::current_exception();
            }
        });
    if (call.failed) std::rethrow_exception(call.failed);
}

// --- Steps

void explain_with(Tree&, const Property&, Explainer) {}

std::uint64_t Tree::step() const {
    const State& s = *state_;
    return s.host->step(s.host->self);
}

void Tree::stepped() {
    const State& s = *state_;
    s.host->touched(s.host->self);
}

}  // namespace fettle::property
