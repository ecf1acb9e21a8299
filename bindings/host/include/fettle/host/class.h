/* Classes that a program adds to a game. Their instances are made by fettle_hosted_make and by
 * scripts, and the console, snapshots and the past include them, since the game stores their
 * values. A class stays as long as the game. */

#pragma once

#include <fettle/host/value.h>

FETTLE_HOST_BEGIN

/** A property. Texts may be null where nothing else is said. */
typedef struct fettle_property_def {
    const char* name;                  /* not null */
    const char* unit;                  /* "kg" */
    const char* doc;                   /* what it is; the console and the reference show it */
    fettle_hosted_value default_value; /* nil: zero of the type */
    double min, max;                   /* limits of a number; both 0: none */
    int32_t type;                      /* one of fettle_value_type; FETTLE_VALUE_NIL: any type */
    bool nullable;                     /* nil is a value */
} fettle_property_def;

/** A parameter of a method, or a field of an event. */
typedef struct fettle_parameter_def {
    const char* name; /* not null */
    const char* unit; /* "kg" */
    const char* doc;  /* what it is; the console and the reference show it */
    int32_t type;     /* one of fettle_value_type, but not FETTLE_VALUE_NIL */
} fettle_parameter_def;

/** Called by scripts, by the console and by fettle_hosted_call_method. Results are those of
    fettle_function_callback. Missing arguments are nil. */
typedef fettle_code (*fettle_method_callback)(void* user, fettle_instance self,
                                              const fettle_hosted_value* arguments, uint32_t count,
                                              fettle_hosted_value* result);

/** A method. */
typedef struct fettle_method_def {
    const char* name;                       /* not null */
    const char* doc;                        /* what it is; the console and the reference show it */
    const fettle_parameter_def* parameters; /* in their order */
    uint32_t parameter_count;               /* length of parameters */
    uint32_t required;                      /* number of parameters that must be given */
    fettle_method_callback call;            /* not null */
    void* user;                             /* passed to the callback */
} fettle_method_def;

/** An event, which the program and scripts can emit. */
typedef struct fettle_event_def {
    const char* name;                   /* not null */
    const char* doc;                    /* what it is; the console and the reference show it */
    const fettle_parameter_def* fields; /* data of the event */
    uint32_t field_count;               /* length of fields */
} fettle_event_def;

/** A class. fettle_class_def_init makes all members 0 and null. */
typedef struct fettle_class_def {
    uint32_t size;
    uint32_t property_count, method_count, event_count; /* lengths of the arrays */
    const char* name;                                   /* not null; "Wheel" */
    const char* base;                                   /* null: "Object" */
    const char* doc;                       /* what it is; the console and the reference show it */
    const fettle_property_def* properties; /* its own, without those of its base */
    const fettle_method_def* methods;      /* its own */
    const fettle_event_def* events;        /* its own */
} fettle_class_def;

/** Makes all members 0 and null, and writes `size`. FETTLE_INVALID unless `size` is the size of the
    structure. */
fettle_code fettle_class_def_init(fettle_class_def* def, size_t size);

/** Adds a class to the game. FETTLE_INVALID, and nothing changes, for a name that is taken or that
   is not a name, for a property whose name is nearly that of one of the base class ("velocty" in a
   Body), and for a default that the property would refuse. Not in a callback. */
fettle_code fettle_hosted_define(fettle_hosted* game, const fettle_class_def* def);

FETTLE_HOST_END
