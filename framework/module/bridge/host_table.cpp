#include "host_table.h"

#include <cstddef>
#include <stdexcept>
#include <utility>

#include <fettle/property/acceptance.h>
#include <fettle/property/drawing.h>
#include <fettle/property/find_instance.h>
#include <fettle/property/path.h>
#include <fettle/property/question.h>
#include <fettle/property/restoring.h>
#include <fettle/property/spelling.h>

namespace fettle::module {

using property::Error;
using property::ErrorKind;
using property::Handle;

HostTable& host_of(void* self) {
    return *static_cast<HostTable*>(self);
}

std::string HostTable::take_reason() {
    std::string reason = std::move(reason_);
    reason_.clear();
    return reason;
}

void HostTable::require(fettle_status status, std::string_view what) {
    const fettle_status refused = std::exchange(error_status_, FETTLE_OK);
    if (status == FETTLE_OK) return reason_.clear();
    std::string reason = take_reason();
    if (reason.empty() && status == refused) reason = error_;
    if (reason.empty())
        reason = std::string(what) + " failed with status " + std::to_string(status) +
                 " and gave no reason";
    throw std::invalid_argument(reason);
}

void HostTable::report_failure(const Named& of, const char* function) noexcept {
    if (reason_.empty()) return;
    std::string text = function;
    if (of.class_name != nullptr) text += std::string(" of ") + of.class_name;
    if (of.member != nullptr) text += std::string(".") + of.member;
    text += ": " + take_reason();
    // The receivers report only; an exception of theirs cannot be handled here.
    try {
        if (const auto sink = failed)  // a copy, because it may replace itself
            sink(text);
        else if (const auto line = print)
            line(text_or_empty(of.module) + ": " + text);
    } catch (...) {
    }
}

namespace {

/// An argument that must not be null. `what`: its name in the table.
template <class T>
T& required(T* argument, const char* what) {
    if (argument == nullptr)
        throw Error(ErrorKind::wrong_type,
                    std::string(what) + ": expected a pointer, got a null pointer");
    return *argument;
}

/// The event of the instance with that tag. Any other pointer is refused, and is not followed: a
/// module may pass the tag of another class, or one that `define_class` has not written.
const property::Event& event_of(const property::Tree& tree, Handle instance, const void* tag) {
    for (const property::Event* event : tree.class_of(instance).events())
        if (event == tag) return *event;
    throw Error(ErrorKind::unknown_name,
                tree.path(instance) +
                    " has no event with this tag: expected the tag of an event of " +
                    tree.class_of(instance).name() + ", as define_class has written it");
}

void require_values(const property::Event& event, const fettle_value* values, std::uint32_t count) {
    if (count != event.fields.size())
        throw Error(ErrorKind::wrong_type, "event " + event.name + ": expected " +
                                               std::to_string(event.fields.size()) +
                                               " values, got " + std::to_string(count));
    if (count != 0) required(values, "values");
}

}  // namespace

/// The functions of the table. `self` is the HostTable.
struct HostFunctions {
    static const void* capability(void*, const char*) { return nullptr; }
    static const char* last_error(void* self) { return host_of(self).error_.c_str(); }
    static void fail(void* self, const char* why) { host_of(self).reason_ = text_or_empty(why); }
    static void print(void* self, const char* line) {
        HostTable& host = host_of(self);
        const HostTable::Call call(host);
        if (line == nullptr) return;
        if (const auto sink = host.print) sink(line);  // a copy, because it may replace itself
    }

    static fettle_status define_class(void* self, const fettle_class* descriptor) {
        HostTable& host = host_of(self);
        return host.guarded([&](property::Tree&) {
            if (!host.define_class)
                throw Error(ErrorKind::bad_structure,
                            "classes are registered during `attach` and at no other time");
            if (descriptor == nullptr || descriptor->struct_size == 0)
                throw Error(ErrorKind::bad_structure,
                            "a class descriptor with its struct_size is expected");
            constexpr std::size_t least = offsetof(fettle_class, pose);  // that of version 1.0
            if (descriptor->struct_size < least)
                throw Error(ErrorKind::bad_structure,
                            "a class descriptor: expected a struct_size of at least " +
                                std::to_string(least) + " bytes, got " +
                                std::to_string(descriptor->struct_size));
            host.define_class(known_part<fettle_class>(descriptor, descriptor->struct_size));
        });
    }

    // --- Instances
    static fettle_handle root(void* self) {
        const HostTable& host = host_of(self);
        return host.tree == nullptr ? fettle_handle{} : sent(host.tree->root());
    }
    static fettle_status create(void* self, const char* class_name, fettle_handle parent,
                                const char* name, fettle_handle* made) {
        HostTable& host = host_of(self);
        return host.guarded([&](property::Tree& tree) {
            const property::Class& of = tree.class_named(text_or_empty(class_name));
            Handle instance;
            if (host.adopt && name != nullptr) instance = host.adopt(of, received(parent), name);
            if (!instance) instance = tree.create(of, received(parent), text_or_empty(name));
            if (made != nullptr) *made = sent(instance);
        });
    }
    static fettle_status destroy(void* self, fettle_handle instance) {
        return host_of(self).guarded(
            [&](property::Tree& tree) { tree.destroy(received(instance)); });
    }
    static std::uint32_t alive(void* self, fettle_handle instance) {
        const HostTable& host = host_of(self);
        return host.tree != nullptr && host.tree->alive(received(instance)) ? 1 : 0;
    }
    /// Returns a null handle if the instance was deleted.
    template <Handle (property::Tree::*Step)(Handle) const>
    static fettle_handle relative(void* self, fettle_handle instance) {
        Handle found;
        (void)host_of(self).guarded(
            [&](property::Tree& tree) { found = (tree.*Step)(received(instance)); });
        return sent(found);
    }
    static fettle_handle child(void* self, fettle_handle instance, const char* name) {
        HostTable& host = host_of(self);
        Handle found;
        (void)host.guarded([&](property::Tree& tree) {
            found = tree.child(received(instance), view(name));
            if (found && host.unknown && host.unknown(tree.class_of(found))) found = {};
        });
        return sent(found);
    }
    static fettle_status find(void* self, const char* path, fettle_handle* found) {
        return host_of(self).guarded([&](property::Tree& tree) {
            fettle_handle& result = required(found, "found");
            result = sent(property::find_instance(tree, text_or_empty(path)));
        });
    }
    static fettle_status path(void* self, fettle_handle instance, const char** path) {
        HostTable& host = host_of(self);
        return host.guarded([&](property::Tree& tree) {
            const char*& result = required(path, "path");
            host.kept_text = tree.path(received(instance));
            result = host.kept_text.c_str();
        });
    }
    static const char* class_name(void* self, fettle_handle instance) {
        const HostTable& host = host_of(self);
        if (host.tree == nullptr || !host.tree->alive(received(instance))) return nullptr;
        return host.tree->class_of(received(instance)).name().c_str();
    }
    static const char* base_class(void* self, const char* class_name) {
        const HostTable& host = host_of(self);
        const property::Class* of =
            host.tree == nullptr ? nullptr : host.tree->find_class(text_or_empty(class_name));
        if (of == nullptr || (host.unknown && host.unknown(*of))) return nullptr;
        return of->base() == nullptr ? "" : of->base()->name().c_str();
    }
    static std::uint32_t is_a(void* self, fettle_handle instance, const char* class_name) {
        const HostTable& host = host_of(self);
        if (host.tree == nullptr || !host.tree->alive(received(instance))) return 0;
        const property::Class* of = host.tree->find_class(text_or_empty(class_name));
        return of != nullptr && host.tree->class_of(received(instance)).is_a(*of) ? 1 : 0;
    }
    static fettle_status row(void* self, fettle_handle instance, fettle_row* row) {
        return host_of(self).guarded(
            [&](property::Tree& tree) { required(row, "row") = tree.row(received(instance)); });
    }
    static fettle_status set_row(void* self, fettle_handle instance, fettle_row row) {
        return host_of(self).guarded(
            [&](property::Tree& tree) { tree.set_row(received(instance), row); });
    }

    // --- Values
    static fettle_status get(void* self, fettle_handle instance, const char* property,
                             fettle_value* value) {
        HostTable& host = host_of(self);
        return host.guarded([&](property::Tree& tree) {
            fettle_value& result = required(value, "value");
            result = host.outgoing().put(tree.get(received(instance), view(property)));
        });
    }
    static fettle_status set(void* self, fettle_handle instance, const char* property,
                             const fettle_value* value) {
        return host_of(self).guarded([&](property::Tree& tree) {
            tree.set(received(instance), view(property), received(required(value, "value")));
        });
    }
    static fettle_status call(void* self, fettle_handle instance, const char* method,
                              const fettle_value* arguments, std::uint32_t count,
                              fettle_result* result) {
        HostTable& host = host_of(self);
        return host.guarded([&](property::Tree& tree) {
            const property::Class& of = tree.class_of(received(instance));
            const property::Method* found = of.method(view(method));
            if (found == nullptr)
                throw Error(ErrorKind::unknown_name,
                            tree.path(received(instance)) + " has no method \"" +
                                text_or_empty(method) + "\"" +
                                property::suggestion(view(method), of.member_names()));
            const std::vector<property::Value> values = received(arguments, count);
            const property::Result answer = tree.call(received(instance), *found, values);
            if (result != nullptr) *result = host.outgoing().put(answer);
        });
    }

    // --- Events
    static std::uint32_t listens(void* self, fettle_handle instance, const void* event) {
        const HostTable& host = host_of(self);
        try {
            if (host.tree == nullptr || !host.tree->alive(received(instance))) return 0;
            const property::Event& which = event_of(*host.tree, received(instance), event);
            return host.tree->listens(received(instance), which) ? 1 : 0;
        } catch (const std::exception&) {  // the instance has no such event
            return 0;
        }
    }
    static fettle_status emit(void* self, fettle_handle instance, const void* event,
                              const fettle_value* values, std::uint32_t count) {
        return host_of(self).guarded([&](property::Tree& tree) {
            const property::Event& which = event_of(tree, received(instance), event);
            require_values(which, values, count);
            tree.emit(received(instance), which, received(values, count));
        });
    }
    static fettle_status ask(void* self, fettle_handle instance, const void* event,
                             fettle_value* values, std::uint32_t count, std::uint32_t changeable) {
        HostTable& host = host_of(self);
        return host.guarded([&](property::Tree& tree) {
            if (!tree.alive(received(instance))) return;  // as `property::call_handlers`
            const property::Event& which = event_of(tree, received(instance), event);
            require_values(which, values, count);
            property::List fields = received(values, count);
            property::call_handlers(tree, received(instance), which, fields, changeable);
            Outgoing& answers = host.outgoing();
            for (std::size_t i = changeable; i < fields.size(); ++i)
                values[i] = answers.put(fields[i]);
        });
    }
    static std::uint32_t accepts(void* self, fettle_handle instance) {
        const HostTable::Call call(host_of(self));
        return property::Acceptance::is_accepted(received(instance)) ? 1 : 0;
    }
    static std::uint64_t step(void* self) {
        const HostTable& host = host_of(self);
        return host.tree == nullptr ? 0 : host.tree->step();
    }
    static void touched(void* self) {
        // The next barrier compares watched properties that `step` may have written.
        (void)host_of(self).guarded([](property::Tree& tree) { tree.stepped(); });
    }
    static void each_restored(void* self, void* context,
                              void (*visit)(void*, fettle_handle, const char*, fettle_row)) {
        (void)host_of(self).guarded([&](property::Tree& tree) {
            required(visit, "visit");
            property::each_restored(
                tree, [&](Handle instance, const property::Class& of, property::Row row) {
                    visit(context, sent(instance), of.name().c_str(), row);
                });
        });
    }
    static void refreshing(void* self, std::uint64_t what) {
        HostTable& host = host_of(self);
        if (host.tree == nullptr || host.part == nullptr) return;
        (void)host.guarded([&](property::Tree& tree) { tree.refreshing(*host.part, what); });
    }
    static double drawing_alpha(void*) { return property::Drawing::alpha(); }
    static void grow(void* self, std::int64_t bytes) {
        (void)host_of(self).guarded([&](property::Tree& tree) { tree.add_weight(bytes); });
    }
};

HostTable::HostTable() {
    using F = HostFunctions;
    table_ = {.struct_size = sizeof table_,
              .abi = FETTLE_ABI,
              .self = this,
              .program = FETTLE_PROGRAM,
              .capability = F::capability,
              .last_error = F::last_error,
              .fail = F::fail,
              .print = F::print,
              .define_class = F::define_class,
              .root = F::root,
              .create = F::create,
              .destroy = F::destroy,
              .alive = F::alive,
              .parent = F::relative<&property::Tree::parent>,
              .first_child = F::relative<&property::Tree::first_child>,
              .next_sibling = F::relative<&property::Tree::next_sibling>,
              .child = F::child,
              .find = F::find,
              .path = F::path,
              .class_name = F::class_name,
              .base_class = F::base_class,
              .is_a = F::is_a,
              .row = F::row,
              .set_row = F::set_row,
              .get = F::get,
              .set = F::set,
              .call = F::call,
              .listens = F::listens,
              .emit = F::emit,
              .ask = F::ask,
              .accepts = F::accepts,
              .step = F::step,
              .touched = F::touched,
              .refreshing = F::refreshing,
              .each_restored = F::each_restored,
              .drawing_alpha = F::drawing_alpha,
              .grow = F::grow};
}

}  // namespace fettle::module
