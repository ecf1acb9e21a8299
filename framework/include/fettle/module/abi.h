#pragma once
/* The interface between a program and its modules, in plain C.
 *
 * A module is a shared object with one entry point, `fettle_module_open`. It gets a table of host
 * functions and describes itself. In `attach` it registers classes whose properties lie in its own
 * memory. docs/design/modules.md has the rules, docs/guide/hosting.md shows how to write a module.
 *
 * - Only plain data is passed: no C++ type, no exception, no memory that the other side must free.
 * - A structure starts with its size as its maker knew it (an array has the size of an element).
 *   Later versions add fields only at the end. A reader takes each field beyond the size as zero,
 *   and zero always means the default.
 * - Functions return a fettle_status. If a host function refuses, `last_error` has the reason. If a
 *   function of the module refuses, it first gives the reason to `fail`. A function of the module
 *   that returns no status (`step`, `draw`) has failed if it has given a reason to `fail` (since
 *   1.7): the host reports an error of the game.
 * - Texts are UTF-8 and end with a zero unless a length is given. Pointers are valid until the next
 *   call in the same direction; copy the data to keep it. Descriptors given to `define_class` are
 *   copied; the functions and contexts in them are used until `close`.
 * - All calls are made on one thread: the one that owns the tree.
 * - `self` and pointers to results must not be null. Names and values must not be null either,
 *   unless a comment allows it.
 */

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A module runs in programs of the same major number and of the same or a later minor one. */
#define FETTLE_ABI_MAJOR 1
#define FETTLE_ABI_MINOR 8
#define FETTLE_ABI ((uint32_t)FETTLE_ABI_MAJOR << 16 | FETTLE_ABI_MINOR)

typedef enum fettle_status {
    FETTLE_OK = 0,
    FETTLE_ERR_UNKNOWN_NAME,  /* no such property, child, class, method, event */
    FETTLE_ERR_NEAR_MISS,     /* a name that is nearly a declared one */
    FETTLE_ERR_WRONG_TYPE,    /* a value cannot become the type it should have */
    FETTLE_ERR_OUT_OF_RANGE,  /* outside the property's range */
    FETTLE_ERR_NOT_FINITE,    /* NaN anywhere, infinity where it is not allowed */
    FETTLE_ERR_READ_ONLY,     /* only the owner writes it */
    FETTLE_ERR_DELETED,       /* the instance was deleted */
    FETTLE_ERR_BAD_NAME,      /* empty, taken or reserved */
    FETTLE_ERR_BAD_STRUCTURE, /* a parent below its own child, a class that is not creatable ... */
    FETTLE_ERR_BAD_PATH,      /* a path that does not parse */
    FETTLE_ERR_FORMULA,       /* the value is a formula that failed */
    FETTLE_ERR_REJECTED,      /* the owner of the value refused it with a reason */
    FETTLE_ERR_NO_BARRIER_END,
    FETTLE_ERR_FAILED,        /* anything else */
    FETTLE_ERR_WRONG_VERSION, /* built for another major version of this interface */
    FETTLE_STATUS_SIZE = 0x7fffffff
} fettle_status;

/* ---- Values ---------------------------------------------------------------------------------- */

/* Refers to an instance. A handle of a deleted instance is detected. Both 0: no instance. */
typedef struct fettle_handle {
    uint32_t index, generation;
} fettle_handle;

/* The module's own number of one of its objects. */
typedef uint32_t fettle_row;

enum { /* fettle_value.type and all other types */
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
        const char* text; /* a zero at the end is not required */
        const struct fettle_value* list;
    } as;
} fettle_value;

/* An array with the size of its elements as its maker knew them: FETTLE_ARRAY(properties). */
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
       FETTLE_READ_ONLY = 1,         /* derived, or written by the module only */
       FETTLE_TRANSIENT = 2,         /* not saved */
       FETTLE_SIMULATED = 4,         /* `step` writes it without a report */
       FETTLE_CLAMP = 8,             /* values out of range are clamped, not refused */
       FETTLE_INFINITY = 16,         /* plus and minus infinity are allowed */
       FETTLE_NULLABLE = 32,         /* nil is a valid value */
       FETTLE_ANY_TYPE = 64,         /* the value may have any type */
       FETTLE_HIDDEN = 128,          /* not listed by inspectors */
       FETTLE_SINGLE_PRECISION = 256 /* a float with getter and setter */
};

enum {                    /* fettle_property.binding: the place of the value */
       FETTLE_STORED = 0, /* in the host */
       FETTLE_COLUMN,     /* in an array of the module: base(context) + row * stride */
       FETTLE_ACCESSOR    /* the functions get and set */
};

enum { /* fettle_property.native: type of an element of a column */
       FETTLE_F32 = 0,
       FETTLE_F64,
       FETTLE_I32,
       FETTLE_I64,
       FETTLE_BOOL8,
       FETTLE_VEC2F,
       FETTLE_VEC2D,
       FETTLE_COLOR4F,
       FETTLE_ENUM8 /* one byte: index of the enumerator */
};

typedef struct fettle_property {
    const char* name;
    uint32_t type;
    uint32_t flags;
    const char* unit;           /* "kg"; null: none */
    const char* doc;            /* one or two sentences */
    fettle_value default_value; /* nil: zero of the type */
    double min, max; /* inclusive; both 0: no limits. For each component of a vec2 or color */
    const char* const* enumerators;  /* the valid texts; ends with a null */
    const char* const* derives_from; /* paths of a derived property's sources; ends with a null */
    const char* reference_class;     /* valid class of a reference */
    uint32_t element;                /* type of a list's elements; 0: any */
    uint32_t binding;
    uint32_t native;
    uint32_t stride; /* bytes from element to element; 0: size of one element */
    void* context;
    void* (*base)(void* context);
    fettle_status (*get)(void* context, fettle_row row, fettle_value* value);
    fettle_status (*set)(void* context, fettle_row row, const fettle_value* value);
    /* Optional. `reset` removes an override, so that the value is computed again; `overridden`: 1
       if there is an override. */
    fettle_status (*reset)(void* context, fettle_row row);
    uint32_t (*overridden)(void* context, fettle_row row);
    /* Optional, called after a write: marks derived data as out of date, wakes sleeping objects. */
    void (*invalidate)(void* context, fettle_row row);
    /* Since 1.6. Bytes of memory that the module needs for each element of a list, estimated. The
       limits of memory count them. */
    uint32_t element_weight;
    uint32_t reserved;
} fettle_property;

/* A field of an event, or a parameter or a result of a method. */
typedef struct fettle_field {
    const char* name;
    uint32_t type;
    uint32_t flags; /* since 1.1: FETTLE_NULLABLE: the field may be nil */
    const char* unit;
    const char* doc;
    const char* reference_class; /* since 1.1: for a reference, or references in a list */
    uint32_t element;            /* since 1.1: type of a list's elements; 0: any */
    uint32_t reserved;
    double min, max; /* since 1.4: limits of an argument or of a handler's answer; inclusive; both
                        0: none */
} fettle_field;

enum { FETTLE_ONE_VALUE = 0, FETTLE_RECORD, FETTLE_RECORDS };

/* A value, or records: `values` has `count` times `fields` values, record after record. */
typedef struct fettle_result {
    uint32_t kind;
    uint32_t count, fields;
    uint32_t reserved;
    fettle_value value;
    const fettle_value* values;
} fettle_result;

enum {                            /* fettle_method.effect: what a call changes */
       FETTLE_CHANGES_MEMORY = 0, /* only the module's own memory */
       FETTLE_CHANGES_TREE,       /* properties and instances, with the host's functions */
       FETTLE_CHANGES_NOTHING     /* it only reads */
};

typedef struct fettle_method {
    const char* name;
    const char* doc;
    fettle_array parameters; /* of fettle_field */
    fettle_array returns;    /* fields of the record(s), or one field: a plain value */
    uint32_t required;       /* number of required parameters; the others may be nil */
    uint32_t effect;
    uint32_t many; /* 1: returns a list of records */
    uint32_t reserved;
    void* context;
    fettle_status (*call)(void* context, fettle_handle self, fettle_row row,
                          const fettle_value* arguments, uint32_t count, fettle_result* result);
} fettle_method;

/* Written by define_class: the argument for `emit`, and the current number of listeners. */
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

/* Pixels in memory: rows from the top, four bytes a pixel. `owner` and `version` identify them. */
typedef struct fettle_picture {
    uint32_t struct_size;
    uint32_t width, height;
    uint32_t reserved;
    const uint8_t* rgba;
    const void* owner;
    uint64_t version;
} fettle_picture;

enum { FETTLE_BLEND_NORMAL = 0, FETTLE_BLEND_ADD, FETTLE_BLEND_MULTIPLY };

/* Draws in world units, y up. Widths and sizes of lines and points are pixels. */
typedef struct fettle_painter {
    uint32_t struct_size;
    uint32_t reserved;
    void* self;
    void (*circle)(void* self, const double* center, double radius, const float* fill,
                   const float* border, float border_width);
    /* Any outline; `rounding` works only for convex ones. */
    void (*polygon)(void* self, const double* vertices, uint32_t count, double rounding,
                    const float* fill, const float* border, float border_width);
    void (*line)(void* self, const double* from, const double* to, const float* color, float width);
    void (*point)(void* self, const double* position, const float* color, float size);
    void (*text)(void* self, const double* position, const char* text, uint32_t length,
                 double height, const float* color, uint32_t align);
    uint32_t (*shows)(void* self, uint32_t overlay); /* number in property::Overlay */
    uint32_t (*sees)(void* self, const double* lower, const double* upper);
    void (*begin_screen)(void* self);
    void (*end_screen)(void* self);
    /* Since 1.3. `radii`: half axes; `angle`: radians, counter-clockwise. */
    void (*ellipse)(void* self, const double* center, const double* radii, double angle,
                    const float* fill, const float* border, float border_width);
    /* Since 1.3. All following figures are parts of one whole with one common border, until the
       next call; 0: each figure is separate. */
    void (*part_of)(void* self, uint64_t whole);
    /* Since 1.5. `matrix`: the images of (1, 0), (0, 1) and (0, 0). Opacity, blend mode and clip
       rectangle hold until the `pop` of the last `push`. */
    void (*push)(void* self, const double* matrix);
    void (*pop)(void* self);
    void (*fade)(void* self, float opacity);
    void (*blend)(void* self, uint32_t mode);
    void (*clip)(void* self, const double* lower, const double* upper);
    /* `area`: left, top, width and height in pixels of the picture. */
    void (*picture)(void* self, const fettle_picture* picture, const double* area,
                    const double* lower, const double* upper, const float* tint, uint32_t smooth);
    double (*pixels_per_unit)(void* self);
    /* Since 1.8. Factor for the height of texts of overlays: those of the console are larger by it
       than usual. */
    double (*label_scale)(void* self);
} fettle_painter;

enum {                           /* fettle_class.flags */
       FETTLE_NOT_CREATABLE = 1, /* users cannot create instances */
       FETTLE_SAVED_NATIVELY = 2 /* snapshots have its rows from the module's `save`, not value by
                                    value */
};

typedef struct fettle_class {
    uint32_t struct_size;
    uint32_t flags;
    const char* name;
    const char* base; /* null: Object */
    const char* doc;
    const char* stem; /* first part of default names; null: the class name in lower case */
    fettle_array properties, methods, events;
    void* context;
    /* All optional. `create` makes the row with its defaults. `place` is called when an ancestor
       has changed and may change the row. `destroy` ends the row. A class with none of the
       functions uses those of its base. A class with any of them uses none of its base. It is
       refused if its base has rows of another module that its columns, accessors or methods use. */
    fettle_status (*create)(void* context, fettle_handle self, fettle_row* row);
    fettle_status (*place)(void* context, fettle_handle self, fettle_row* row);
    void (*destroy)(void* context, fettle_handle self, fettle_row row);
    void (*draw)(void* context, fettle_handle self, fettle_row row, const fettle_painter* painter,
                 double alpha);
    void (*draw_over)(void* context, fettle_handle self, fettle_row row,
                      const fettle_painter* painter, double alpha);
    /* Since 1.5. Optional: where the instance is drawn, as a map from its coordinates to those of
       the world; for `matrix` see fettle_painter. */
    void (*pose)(void* context, fettle_handle self, fettle_row row, double alpha, double* matrix);
    /* Since 1.6. Bytes of memory that the module needs for an instance, estimated; 0: those of the
       base class. The limits of memory count them. */
    uint32_t weight;
    uint32_t reserved;
} fettle_class;

/* ---- The host -------------------------------------------------------------------------------- */

/* The module gets it when it is opened; valid until `close`. `self` is the first argument of every
   call. */
typedef struct fettle_host {
    uint32_t struct_size;
    uint32_t abi; /* FETTLE_ABI of the host */
    void* self;
    const char* program; /* "fettle 0.1.0" */

    /* An optional table of the host, such as "fettle.edits", or a game's own; null if it does not
       exist. It starts with its struct_size. */
    const void* (*capability)(void* self, const char* name);
    const char* (*last_error)(void* self);
    void (*fail)(void* self, const char* why);
    void (*print)(void* self, const char* line);

    /* Allowed only during `attach`. */
    fettle_status (*define_class)(void* self, const fettle_class* descriptor);

    /* Instances. Parent {0, 0}: no parent; null name: the host makes one. */
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
    /* Null for a deleted instance; the text is valid as long as the tree. */
    const char* (*class_name)(void* self, fettle_handle instance);
    /* Null if there is no such class, "" if it has no base. */
    const char* (*base_class)(void* self, const char* class_name);
    uint32_t (*is_a)(void* self, fettle_handle instance, const char* class_name);
    fettle_status (*row)(void* self, fettle_handle instance, fettle_row* row);
    fettle_status (*set_row)(void* self, fettle_handle instance, fettle_row row);

    /* Values. Writes are coerced, checked and reported to watchers. */
    fettle_status (*get)(void* self, fettle_handle instance, const char* property,
                         fettle_value* value);
    fettle_status (*set)(void* self, fettle_handle instance, const char* property,
                         const fettle_value* value);
    fettle_status (*call)(void* self, fettle_handle instance, const char* method,
                          const fettle_value* arguments, uint32_t count, fettle_result* result);

    /* Events of the module's classes; they are delivered at the next barrier. */
    uint32_t (*listens)(void* self, fettle_handle instance, const void* event);
    fettle_status (*emit)(void* self, fettle_handle instance, const void* event,
                          const fettle_value* values, uint32_t count);

    /* Only within `step`: calls the handlers of a question at once. `values` has one value for each
       field; the handlers may change those from index `changeable` on. */
    fettle_status (*ask)(void* self, fettle_handle instance, const void* event,
                         fettle_value* values, uint32_t count, uint32_t changeable);

    /* Only within a method whose parameter `accept` is true, which means that the caller gave a
       function: whether this function accepts the instance. 1 without a function. */
    uint32_t (*accepts)(void* self, fettle_handle instance);

    uint64_t (*step)(void* self); /* number of the fixed step */
    /* To be called in `report` if `step` wrote properties that may be watched. */
    void (*touched)(void* self);
    /* Since 1.2. To be called before a *read* updates data that edits left out of date, if the time
       of the update may change the last bit of the result; not for updates by an edit itself. A
       replay of these steps gives `what` to the module's `refresh`. */
    void (*refreshing)(void* self, uint64_t what);
    /* Since 1.2. Only within `restore` with `commit` 0: visits each instance that will exist, with
       its class and its row. A module with FETTLE_SAVED_NATIVELY checks that the rows are valid. */
    void (*each_restored)(void* self, void* context,
                          void (*visit)(void* context, fettle_handle instance,
                                        const char* class_name, fettle_row row));
    /* Since 1.3. Position of the current drawing between the last two steps, 0 to 1; 1 outside of
       drawing. */
    double (*drawing_alpha)(void* self);
    /* Since 1.6. Memory that the module has allocated beside that of its instances; negative: that
       it has freed. The limits of memory count it. */
    void (*grow)(void* self, int64_t bytes);
} fettle_host;

/* ---- The module ------------------------------------------------------------------------------ */

/* Filled in by fettle_module_open. The host sets struct_size to the size of its structure. */
typedef struct fettle_module {
    uint32_t struct_size;
    uint32_t abi;        /* FETTLE_ABI as the module was built with */
    const char* name;    /* "wind": an identifier */
    const char* version; /* "1.2"; null: none */
    void* context;
    /* Registers classes and creates the module's own instances. */
    fettle_status (*attach)(void* context);
    /* Optional: the module's own test, called before it is used in a game; the reason of a failure
       goes to `fail`. */
    fettle_status (*check)(void* context);
    /* One fixed step of dt seconds: computes in its own memory. */
    void (*step)(void* context, double dt);
    /* Optional: reports the events of the step. */
    void (*report)(void* context);
    /* Optional: hash of all data that influence later steps. */
    uint64_t (*hash)(void* context);
    /* Both or neither: write and read the rows of FETTLE_SAVED_NATIVELY classes for snapshots.
       `save` calls `bytes` any number of times, in order. `restore` is called twice: with `commit`
       0 it checks all data and changes nothing; with 1, after the tree has restored its instances,
       it restores the rows from the same bytes and must not fail. */
    fettle_status (*save)(void* context, void* sink,
                          void (*bytes)(void* sink, const void* data, size_t size));
    fettle_status (*restore)(void* context, const void* data, size_t size, uint32_t commit);
    /* Optional: ends the module. All rows were destroyed before. */
    void (*close)(void* context);
    /* Since 1.2. Optional: updates the data that it reported with `refreshing`, if the data still
       exist. */
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
