// Events of classes that a script has defined.

#include <algorithm>
#include <utility>

#include <fettle/property/error.h>

#include "class_registry.h"
#include "descriptor_check.h"
#include "lasting_fields.h"

namespace fettle::property {

namespace {

/// In a class that has the event, also an inherited one: in the list and in the index.
constexpr std::int64_t weight_in_class = 64;

std::int64_t weight_of_event(const Event& event) {
    std::size_t bytes = sizeof(Event) + event.name.size() + event.doc.size();
    for (const Field& field : event.fields)
        bytes += 2 * (sizeof(Field) + field.name.size() + field.reference_class.size());
    return static_cast<std::int64_t>(bytes);
}

}  // namespace

std::int64_t ClassRegistry::declare_events(Class& of, std::vector<Event> wanted) {
    const std::vector<Class*> all = with_derived(of);
    for (const Event& event : wanted) {
        if (!is_word(event.name))
            throw Error(ErrorKind::bad_name,
                        of.name() + ": \"" + event.name + "\" cannot be the name of an event");
        for (const Class* each : all) {
            const Event* const known = each->event(event.name);
            if (each->property(event.name) != nullptr || each->method(event.name) != nullptr ||
                (known != nullptr && known->owner != &of))
                throw Error(ErrorKind::bad_name, of.name() + ": the event \"" + event.name +
                                                     "\": " + each->name() +
                                                     " has that name already");
        }
    }
    for (const Event& known : late_events_) {
        if (known.owner != &of) continue;
        for (Class* each : all) {
            std::erase(each->events_, &known);
            each->event_index_.erase(known.symbol);
        }
    }
    std::int64_t weight = 0;
    for (Event& event : wanted) {
        weight += weight_of_event(event) + weight_in_class * static_cast<std::int64_t>(all.size());
        // Handlers keep the address of an event, so one that comes again has the same.
        auto kept = std::find_if(late_events_.begin(), late_events_.end(), [&](const Event& each) {
            return each.owner == &of && each.name == event.name;
        });
        if (kept == late_events_.end()) {
            late_events_.push_back({.name = event.name});
            kept = std::prev(late_events_.end());
            kept->symbol = Symbol(kept->name);
            kept->owner = &of;
        }
        kept->fields = std::move(event.fields);
        kept->doc = std::move(event.doc);
        kept->record_fields = &lasting(kept->fields);
        for (Class* each : all) {
            each->events_.push_back(&*kept);
            each->event_index_[kept->symbol] = &*kept;
        }
    }
    return weight;
}

}  // namespace fettle::property
