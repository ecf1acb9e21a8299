#pragma once
/* The border between a program and its modules, in plain C.
 *
 * A module is a shared object with one entry point, `fettle_module_open`. It is given a table of
 * host functions, describes itself, and in `attach` registers classes whose properties lie in
 * memory of its own. docs/design/modules.md tells the rules, docs/guide/hosting.md shows one being
 * written.
 *
 * - Plain data only. No C++ type, no exception, no allocation that the other side has to free.
 * - A structure starts with its size as its maker knew it (an array of them gives the size of an
 *   element). Fields are only ever added at the end: who reads looks at no field beyond the size,
 *   and takes it as zero. Zero means "the usual" everywhere.
 * - Functions answer with a fettle_status. Why a host function refused is told by `last_error`;
 *   why a function of the module did is told by it with `fail` before it returns.
 * - Texts are UTF-8 and end with a zero unless a length stands beside them. Whatever is pointed to
 *   is good until the next call in the same direction; copy what is to last. Descriptors given to
 *   `define_class` are copied, functions and contexts in them are used until `close`.
 * - One thread calls: the one that owns the tree.
 * - `self` and what a function writes its answer to must not be null; nor must names and values,
 *   unless it says so.
 */

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A module runs in programs of the same major number and of the same or a later minor one. */
#define FETTLE_ABI_MAJOR 1
#define FETTLE_ABI_MINOR 4
#define FETTLE_ABI ((uint32_t)FETTLE_ABI_MAJOR << 16 | FETTLE_ABI_MINOR)

typedef enum fettle_status {
    FETTLE_OK = 0,
    FETTLE_ERR_UNKNOWN_NAME,  /* no such property, child, class, method, event */
    FETTLE_ERR_NEAR_MISS,     /* a name that is nearly a declared one */
    FETTLE_ERR_WRONG_TYPE,    /* a value cannot become the type it should have */
    FETTLE_ERR_OUT_OF_RANGE,  /* outside the property's range */
    FETTLE_ERR_NOT_FINITE,    /* NaN anywhere, infinity where it is not allowed */
    FETTLE_ERR_READ_ONLY,     /* nobody but the owner writes it */
    FETTLE_ERR_DELETED,       /* the instance was deleted */
    FETTLE_ERR_BAD_NAME,      /* empty, taken or reserved */
    FETTLE_ERR_BAD_STRUCTURE, /* a parent inside its own child, a class that may not be created ...
                               */
    FETTLE_ERR_BAD_PATH,      /* a path that does not parse */
    FETTLE_ERR_FORMULA,       /* the value is a formula that failed */
    FETTLE_ERR_REJECTED,      /* the owner of the value refused it and said why */
    FETTLE_ERR_NO_BARRIER_END,
    FETTLE_ERR_FAILED,        /* anything else */
    FETTLE_ERR_WRONG_VERSION, /* built for another major version of this interface */
    FETTLE_STATUS_SIZE = 0x7fffffff
} fettle_status;

/* ---- Values ---------------------------------------------------------------------------------- */

/* Names an instance. One that was deleted is detected, never followed; both 0: none. */
typedef struct fettle_handle {
    uint32_t index, generation;
} fettle_handle;

/* The module's own number for one of its objects. */
typedef uint32_t fettle_row;

enum { /* fettle_value.type and wherever a type is asked for */
       FETTLE_NIL = 0,
       FETTLE_BOOLEAN,
       FETTLE_INTEGER,
       FETTLE_NUMBER,
       FETTLE_TEXT,
       FETTLE_VEC2,
       FETTLE_COLOR,
       FETTLE_REFERENCE,
       FETTLE_LIST
};

/* 24 bytes. `count`: bytes of a text, elements of a list. */
typedef struct fettle_value {
    uint32_t type;
    uint32_t count;
    union {
        uint32_t boolean; /* 0 or 1 */
        int64_t integer;
        double number;
        double vec2[2];
        float color[4]; /* red, green, blue, opacity: 0 to 1, sRGB */
        fettle_handle reference;
        const char* text; /* need not end with a zero */
        const struct fettle_value* list;
    } as;
} fettle_value;

/* An array and how big its elements were to whoever made it: FETTLE_ARRAY(properties). */
typedef struct fettle_array {
    const void* data;
    uint32_t count;
    uint32_t size;
} fettle_array;
#define FETTLE_ARRAY(elements)                                            \
    {                                                                     \
        (elements), (uint32_t)(sizeof(elements) / sizeof((elements)[0])), \
            (uint32_t)sizeof((elements)[0])                               \
    }

/* ---- Classes --------------------------------------------------------------------------------- */

enum {                               /* fettle_property.flags */
       FETTLE_READ_ONLY = 1,         /* derived, or the module's alone */
       FETTLE_TRANSIENT = 2,         /* not saved */
       FETTLE_SIMULATED = 4,         /* `step` writes it without telling */
       FETTLE_CLAMP = 8,             /* out of range is clamped instead of refused */
       FETTLE_INFINITY = 16,         /* plus and minus infinity are allowed */
       FETTLE_NULLABLE = 32,         /* nil is a value of its own */
       FETTLE_ANY_TYPE = 64,         /* takes any type */
       FETTLE_HIDDEN = 128,          /* not listed by inspectors */
       FETTLE_SINGLE_PRECISION = 256 /* a float behind getter and setter */
};

enum {                    /* fettle_property.binding: where the value lies */
       FETTLE_STORED = 0, /* the host keeps it */
       FETTLE_COLUMN,     /* in an array of the module: base(context) + row * stride */
       FETTLE_ACCESSOR    /* behind get and set */
};

enum { /* fettle_property.native: an element of a column */
       FETTLE_F32 = 0,
       FETTLE_F64,
       FETTLE_I32,
       FETTLE_I64,
       FETTLE_BOOL8,
       FETTLE_VEC2F,
       FETTLE_VEC2D,
       FETTLE_COLOR4F,
       FETTLE_ENUM8 /* a byte that indexes the enumerators */
};

typedef struct fettle_property {
    const char* name;
    uint32_t type;
    uint32_t flags;
    const char* unit;               /* "kg"; null: none */
    const char* doc;                /* one or two sentences */
    fettle_value default_value;     /* nil: the zero of the type */
    double min, max;                /* inclusive; both 0: any. Of a vec2 or color: each component */
    const char* const* enumerators; /* a text takes only these; ends with a null */
    const char* const* derives_from; /* of a derived property: paths of its sources; ends with a
                                        null */
    const char* reference_class;     /* a reference takes only these */
    uint32_t element;                /* type of a list's elements; 0: any */
    uint32_t binding;
    uint32_t native;
    uint32_t stride; /* bytes from element to element; 0: that of one element */
    void* context;
    void* (*base)(void* context);
    fettle_status (*get)(void* context, fettle_row row, fettle_value* value);
    fettle_status (*set)(void* context, fettle_row row, const fettle_value* value);
    /* Optional: gives the value back to whoever computes it; whether it differs from that. */
    fettle_status (*reset)(void* context, fettle_row row);
    uint32_t (*overridden)(void* context, fettle_row row);
    /* Optional, after a write: marks what is derived as out of date, wakes sleepers. */
    void (*invalidate)(void* context, fettle_row row);
} fettle_property;

/* Of an event, of a method's parameters and results. */
typedef struct fettle_field {
    const char* name;
    uint32_t type;
    uint32_t flags; /* since 1.1: FETTLE_NULLABLE, of what is told: it may be nil */
    const char* unit;
    const char* doc;
    const char* reference_class; /* since 1.1: of a reference, or of those in a list */
    uint32_t element;            /* since 1.1: type of a list's elements; 0: any */
    uint32_t reserved;
    double min, max; /* since 1.4: of what a handler answers; inclusive; both 0: any */
} fettle_field;

enum { FETTLE_ONE_VALUE = 0, FETTLE_RECORD, FETTLE_RECORDS };

/* A value, or records: `values` holds `count` times `fields` values, record after record. */
typedef struct fettle_result {
    uint32_t kind;
    uint32_t count, fields;
    uint32_t reserved;
    fettle_value value;
    const fettle_value* values;
} fettle_result;

enum {                            /* fettle_method.effect: what a call changes */
       FETTLE_CHANGES_MEMORY = 0, /* the module's own, which nobody else hears of */
       FETTLE_CHANGES_TREE,       /* properties and instances, by the host's functions */
       FETTLE_CHANGES_NOTHING     /* it asks */
};

typedef struct fettle_method {
    const char* name;
    const char* doc;
    fettle_array parameters; /* of fettle_field */
    fettle_array returns;    /* fields of the record(s), or one of the plain value */
    uint32_t required;       /* parameters that must be given; missing ones come as nil */
    uint32_t effect;
    uint32_t many; /* 1: returns a list of such records */
    uint32_t reserved;
    void* context;
    fettle_status (*call)(void* context, fettle_handle self, fettle_row row,
                          const fettle_value* arguments, uint32_t count, fettle_result* result);
} fettle_method;

/* Written by define_class: what to give to `emit`, and how many listen at the moment. */
typedef struct fettle_event_tag {
    const void* id;
    const uint32_t* listeners;
} fettle_event_tag;

typedef struct fettle_event {
    const char* name;
    const char* doc;
    fettle_array fields; /* of fettle_field */
    fettle_event_tag* tag;
} fettle_event;

enum { FETTLE_FACE_MIDDLE = 0, FETTLE_FACE_LEFT, FETTLE_FACE_RIGHT };

/* Draws in world units, y up. Widths and sizes of lines and points are pixels. */
typedef struct fettle_painter {
    uint32_t struct_size;
    uint32_t reserved;
    void* self;
    void (*circle)(void* self, const double* center, double radius, const float* fill,
                   const float* border, float border_width);
    /* Of any outline; `rounding` is for convex ones. */
    void (*polygon)(void* self, const double* vertices, uint32_t count, double rounding,
                    const float* fill, const float* border, float border_width);
    void (*line)(void* self, const double* from, const double* to, const float* color, float width);
    void (*point)(void* self, const double* position, const float* color, float size);
    void (*text)(void* self, const double* position, const char* text, uint32_t length,
                 double height, const float* color, uint32_t align);
    uint32_t (*shows)(void* self, uint32_t overlay); /* as in the order of property::Overlay */
    uint32_t (*sees)(void* self, const double* lower, const double* upper);
    void (*begin_screen)(void* self);
    void (*end_screen)(void* self);
    /* Since 1.3. Half axes, then turned by an angle in radians, counter-clockwise. */
    void (*ellipse)(void* self, const double* center, const double* radii, double angle,
                    const float* fill, const float* border, float border_width);
    /* Since 1.3. The figures that follow are parts of one thing, with a border round the whole,
       until another number is told; 0: each is a thing by itself. */
    void (*part_of)(void* self, uint64_t whole);
} fettle_painter;

enum {                           /* fettle_class.flags */
       FETTLE_NOT_CREATABLE = 1, /* users may not make one */
       FETTLE_SAVED_NATIVELY = 2 /* snapshots have its rows from the module's `save`, not value by
                                    value */
};

typedef struct fettle_class {
    uint32_t struct_size;
    uint32_t flags;
    const char* name;
    const char* base; /* null: Object */
    const char* doc;
    const char* stem; /* what an instance is called when nobody names it; null: the name in lower
                         case */
    fettle_array properties, methods, events;
    void* context;
    /* All optional. Makes the row, with its defaults; tells that what is above has changed, which
       may change the row; ends it. A class with none of the five takes over its base's. */
    fettle_status (*create)(void* context, fettle_handle self, fettle_row* row);
    fettle_status (*place)(void* context, fettle_handle self, fettle_row* row);
    void (*destroy)(void* context, fettle_handle self, fettle_row row);
    void (*draw)(void* context, fettle_handle self, fettle_row row, const fettle_painter* painter,
                 double alpha);
    void (*draw_over)(void* context, fettle_handle self, fettle_row row,
                      const fettle_painter* painter, double alpha);
} fettle_class;

/* ---- The host -------------------------------------------------------------------------------- */

/* Handed to the module when it is opened, good until `close`. `self` goes first into every call. */
typedef struct fettle_host {
    uint32_t struct_size;
    uint32_t abi; /* FETTLE_ABI of the host */
    void* self;
    const char* program; /* "fettle 0.1.0" */

    /* A table that not every host has, or null: "fettle.edits", or a game's own. What it points to
       starts with its struct_size. */
    const void* (*capability)(void* self, const char* name);
    const char* (*last_error)(void* self);
    void (*fail)(void* self, const char* why);
    void (*print)(void* self, const char* line);

    /* Only during `attach`. */
    fettle_status (*define_class)(void* self, const fettle_class* descriptor);

    /* Instances. A parent of {0, 0} is none; a null name lets the host find one. */
    fettle_handle (*root)(void* self);
    fettle_status (*create)(void* self, const char* class_name, fettle_handle parent,
                            const char* name, fettle_handle* made);
    fettle_status (*destroy)(void* self, fettle_handle instance);
    uint32_t (*alive)(void* self, fettle_handle instance);
    fettle_handle (*parent)(void* self, fettle_handle instance);
    fettle_handle (*first_child)(void* self, fettle_handle instance);
    fettle_handle (*next_sibling)(void* self, fettle_handle instance);
    fettle_handle (*child)(void* self, fettle_handle instance, const char* name);
    fettle_status (*find)(void* self, const char* path, fettle_handle* found);
    fettle_status (*path)(void* self, fettle_handle instance, const char** path);
    /* Null for a deleted one; the text lasts as long as the tree. */
    const char* (*class_name)(void* self, fettle_handle instance);
    /* Null when there is no such class, "" when it derives from nothing. */
    const char* (*base_class)(void* self, const char* class_name);
    uint32_t (*is_a)(void* self, fettle_handle instance, const char* class_name);
    fettle_status (*row)(void* self, fettle_handle instance, fettle_row* row);
    fettle_status (*set_row)(void* self, fettle_handle instance, fettle_row row);

    /* Values, as everyone reads and writes them: coerced, checked, watched. */
    fettle_status (*get)(void* self, fettle_handle instance, const char* property,
                         fettle_value* value);
    fettle_status (*set)(void* self, fettle_handle instance, const char* property,
                         const fettle_value* value);
    fettle_status (*call)(void* self, fettle_handle instance, const char* method,
                          const fettle_value* arguments, uint32_t count, fettle_result* result);

    /* Events of the module's classes; told at the next barrier. */
    uint32_t (*listens)(void* self, fettle_handle instance, const void* event);
    fettle_status (*emit)(void* self, fettle_handle instance, const void* event,
                          const fettle_value* values, uint32_t count);

    /* Within `step`: asks those who listen, at once. Of `values`, one for each field, those from
       `changeable` on may be changed by them and come back. */
    fettle_status (*ask)(void* self, fettle_handle instance, const void* event,
                         fettle_value* values, uint32_t count, uint32_t changeable);

    /* Within a method with a parameter `accept`, a function of the caller's that came as true:
       whether it says that the instance counts. 1 where there is none. */
    uint32_t (*accepts)(void* self, fettle_handle instance);

    uint64_t (*step)(void* self); /* number of the fixed step */
    /* In `report`: `step` wrote properties of the module that may be watched. */
    void (*touched)(void* self);
    /* Since 1.2. To be called when somebody *reads* what edits have left out of date, before it is
       brought up to date, where doing that earlier or later may differ in the last bit; not for
       what an edit does itself. Who goes back in time gives `what` to the module's `refresh`. */
    void (*refreshing)(void* self, uint64_t what);
    /* Since 1.2. Within `restore` with `commit` 0: who is about to be there, as what, and which row
       it is going to have. Whoever is FETTLE_SAVED_NATIVELY checks that the rows are its own. */
    void (*each_restored)(void* self, void* context,
                          void (*visit)(void* context, fettle_handle instance,
                                        const char* class_name, fettle_row row));
    /* Since 1.3. How far the picture that is being drawn is between the last two steps, 0 to 1; 1
       while none is. */
    double (*drawing_alpha)(void* self);
} fettle_host;

/* ---- The module ------------------------------------------------------------------------------ */

/* Filled in by fettle_module_open. The host sets struct_size to the room there is. */
typedef struct fettle_module {
    uint32_t struct_size;
    uint32_t abi;        /* FETTLE_ABI as the module was built with */
    const char* name;    /* "wind": an identifier */
    const char* version; /* "1.2"; null: none */
    void* context;
    /* Registers classes and makes what instances it offers. */
    fettle_status (*attach)(void* context);
    /* Optional: the module's own test, made before it is let into a game; `fail` tells why. */
    fettle_status (*check)(void* context);
    /* One fixed step of dt seconds: computes in its own memory. */
    void (*step)(void* context, double dt);
    /* Optional: tells what happened in the step. */
    void (*report)(void* context);
    /* Optional: of everything that influences later steps. */
    uint64_t (*hash)(void* context);
    /* Both or neither: what the rows of classes that are FETTLE_SAVED_NATIVELY are, as bytes for a
       snapshot, and back. `bytes` is called any number of times, in order. `restore` is called
       twice: with `commit` 0 it checks all and changes nothing, with 1, after the tree has its
       instances again, it puts the same bytes into place and does not fail. */
    fettle_status (*save)(void* context, void* sink,
                          void (*bytes)(void* sink, const void* data, size_t size));
    fettle_status (*restore)(void* context, const void* data, size_t size, uint32_t commit);
    /* Optional: ends it. Every row is destroyed before. */
    void (*close)(void* context);
    /* Since 1.2. Optional: brings up to date what it once told by `refreshing`, if it is still
       there. */
    void (*refresh)(void* context, uint64_t what);
} fettle_module;

#define FETTLE_MODULE_ENTRY "fettle_module_open"
typedef fettle_status (*fettle_module_entry)(const fettle_host* host, fettle_module* module);

#if defined(__GNUC__)
#define FETTLE_MODULE_EXPORT __attribute__((visibility("default")))
#else
#define FETTLE_MODULE_EXPORT
#endif

#ifdef __cplusplus
}
#endif
