/* Changes and events. Their callbacks are called at barriers (fettle_hosted_barrier): after the
 * change, once for all changes of a property since the last barrier. */

#pragma once

#include <fettle/host/property.h>

FETTLE_HOST_BEGIN

/** Ends with fettle_hosted_disconnect. A restored snapshot does not end it. */
typedef uint64_t fettle_connection;

/** A change of a property. Its texts and values are valid during the call. */
typedef struct fettle_hosted_change {
    fettle_instance instance;                 /* that has changed */
    const char* property;                     /* its name */
    const char* cause;                        /* "console, step 412", "main.lua:30, step 412" */
    uint64_t step;                            /* in which it was changed */
    fettle_hosted_value old_value, new_value; /* before and after */
} fettle_hosted_change;

/** Called for each change. */
typedef void (*fettle_change_callback)(void* user, const fettle_hosted_change* change);

/** Watches all properties that match a pattern: a path, in which `*` is any name and `**` any
    number of levels ("world.*.mass"). `connection` may be null. */
fettle_code fettle_hosted_watch(fettle_hosted* game, const char* pattern,
                                fettle_change_callback changed, void* user,
                                fettle_connection* connection);

/** Watches one property; for a handle to a component, the whole property. */
fettle_code fettle_property_watch(fettle_hosted* game, fettle_property_id property,
                                  fettle_change_callback changed, void* user,
                                  fettle_connection* connection);

/** Called for each instance that was made or deleted. The texts are valid during the call. */
typedef void (*fettle_existence_callback)(void* user, fettle_instance instance,
                                          const char* class_name, const char* path);

/** Watches the creation or deletion of instances of a class and of the classes that derive from it.
 */
fettle_code fettle_hosted_watch_made(fettle_hosted* game, const char* class_name,
                                     fettle_existence_callback made, void* user,
                                     fettle_connection* connection);
fettle_code fettle_hosted_watch_deleted(fettle_hosted* game, const char* class_name,
                                        fettle_existence_callback deleted, void* user,
                                        fettle_connection* connection);

/** An event of an instance. `fields` and `values` have `count` elements. */
typedef struct fettle_hosted_occurrence {
    fettle_instance instance;          /* that the event is about */
    uint64_t step;                     /* in which it happened */
    const char* event;                 /* its name */
    const char* const* fields;         /* names of the fields */
    const fettle_hosted_value* values; /* of the fields */
    uint32_t count;                    /* length of both */
} fettle_hosted_occurrence;

/** Called for each event. */
typedef void (*fettle_event_callback)(void* user, const fettle_hosted_occurrence* occurrence);

/** An event of one instance, as "contact_begin" of a body. */
fettle_code fettle_hosted_on(fettle_hosted* game, fettle_instance instance, const char* event,
                             fettle_event_callback happened, void* user,
                             fettle_connection* connection);

/** The event of all instances of a class. */
fettle_code fettle_hosted_on_all(fettle_hosted* game, const char* class_name, const char* event,
                                 fettle_event_callback happened, void* user,
                                 fettle_connection* connection);

/** Queues an event for the next barrier. `values` has one for each field of the event, and may be
    null if `count` is 0. */
fettle_code fettle_hosted_emit(fettle_hosted* game, fettle_instance instance, const char* event,
                               const fettle_hosted_value* values, uint32_t count);

/** Ends a connection: its callback is not called any more. */
fettle_code fettle_hosted_disconnect(fettle_hosted* game, fettle_connection connection);

FETTLE_HOST_END
