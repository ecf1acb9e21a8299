/* A module in plain C whose rows contain data that no property shows, so that snapshots store their
 * bytes. Its steps ask questions, one of its methods gets a function, and its fields use every kind
 * of description. */

#include <stdlib.h>
#include <string.h>

#include <fettle/module/abi.h>

enum { max_harbors = 8, shown = 4 };

typedef struct Harbor {
    double level;  /* m */
    uint64_t tide; /* state of the random generator; no property shows it */
    fettle_handle self, pilot;
    uint32_t used;
} Harbor;

static const fettle_host* host;
static Harbor harbors[max_harbors];
static fettle_event_tag rising, docked;

/* The smaller structure of a field in modules for an older interface: the program reads the missing
 * members as zero. */
typedef struct old_field {
    const char* name;
    uint32_t type;
    uint32_t reserved;
    const char* unit;
    const char* doc;
} old_field;

static void* level_base(void* context) {
    (void)context;
    return &harbors[0].level;
}

static fettle_status get_pilot(void* context, fettle_row row, fettle_value* value) {
    (void)context;
    value->type = harbors[row].pilot.generation == 0 ? FETTLE_NIL : FETTLE_REFERENCE;
    value->as.reference = harbors[row].pilot;
    return FETTLE_OK;
}

static fettle_status set_pilot(void* context, fettle_row row, const fettle_value* value) {
    const fettle_handle none = {0, 0};
    (void)context;
    harbors[row].pilot = value->type == FETTLE_NIL ? none : value->as.reference;
    return FETTLE_OK;
}

/* Number of children for which the function returns true. */
static fettle_status ships(void* context, fettle_handle self, fettle_row row,
                           const fettle_value* arguments, uint32_t count, fettle_result* result) {
    static fettle_value found[shown];
    fettle_handle at = host->first_child(host->self, self);
    (void)context, (void)row, (void)arguments, (void)count;
    memset(found, 0, sizeof found);
    result->kind = FETTLE_ONE_VALUE;
    result->value.type = FETTLE_LIST;
    result->value.as.list = found;
    for (; at.generation != 0 && result->value.count < shown;
         at = host->next_sibling(host->self, at)) {
        if (!host->accepts(host->self, at)) continue;
        found[result->value.count].type = FETTLE_REFERENCE;
        found[result->value.count++].as.reference = at;
    }
    return FETTLE_OK;
}

static fettle_status create(void* context, fettle_handle self, fettle_row* row) {
    (void)context;
    for (*row = 0; *row < max_harbors && harbors[*row].used; ++*row) {
    }
    if (*row == max_harbors) return FETTLE_ERR_FAILED;
    memset(&harbors[*row], 0, sizeof(Harbor));
    harbors[*row].tide = 12345 + *row;
    harbors[*row].self = self;
    harbors[*row].used = 1;
    return FETTLE_OK;
}

static void destroy(void* context, fettle_handle self, fettle_row row) {
    (void)context, (void)self;
    harbors[row].used = 0;
}

static fettle_status attach(void* context) {
    static const fettle_property properties[] = {{.name = "level",
                                                  .type = FETTLE_NUMBER,
                                                  .flags = FETTLE_SIMULATED,
                                                  .unit = "m",
                                                  .binding = FETTLE_COLUMN,
                                                  .native = FETTLE_F64,
                                                  .stride = sizeof(Harbor),
                                                  .base = level_base},
                                                 {.name = "pilot",
                                                  .type = FETTLE_REFERENCE,
                                                  .flags = FETTLE_NULLABLE,
                                                  .reference_class = "Object",
                                                  .binding = FETTLE_ACCESSOR,
                                                  .get = get_pilot,
                                                  .set = set_pilot},
                                                 {.name = "berths",
                                                  .type = FETTLE_LIST,
                                                  .reference_class = "Harbor",
                                                  .element = FETTLE_REFERENCE}};
    static const fettle_field found[] = {{.name = "ships",
                                          .type = FETTLE_LIST,
                                          .reference_class = "Object",
                                          .element = FETTLE_REFERENCE}};
    static const old_field accept[] = {{"accept", FETTLE_BOOLEAN, 0, NULL, "Which ones count."}};
    static const old_field rises[] = {{"tide", FETTLE_INTEGER, 0, NULL, NULL},
                                      {"rise", FETTLE_NUMBER, 0, "m", NULL}};
    static const fettle_field docks[] = {{.name = "ship",
                                          .type = FETTLE_REFERENCE,
                                          .flags = FETTLE_NULLABLE,
                                          .reference_class = "Harbor"}};
    static const fettle_method methods[] = {{.name = "ships",
                                             .parameters = FETTLE_ARRAY(accept),
                                             .returns = FETTLE_ARRAY(found),
                                             .effect = FETTLE_CHANGES_NOTHING,
                                             .call = ships}};
    static const fettle_event events[] = {
        {.name = "rising", .fields = FETTLE_ARRAY(rises), .tag = &rising},
        {.name = "docked", .fields = FETTLE_ARRAY(docks), .tag = &docked}};
    fettle_class harbor;
    (void)context;
    memset(&harbor, 0, sizeof harbor);
    harbor.struct_size = sizeof harbor;
    harbor.flags = FETTLE_SAVED_NATIVELY;
    harbor.name = "Harbor";
    harbor.properties = (fettle_array)FETTLE_ARRAY(properties);
    harbor.methods = (fettle_array)FETTLE_ARRAY(methods);
    harbor.events = (fettle_array)FETTLE_ARRAY(events);
    harbor.create = create;
    harbor.destroy = destroy;
    if (host->define_class(host->self, &harbor) == FETTLE_OK) return FETTLE_OK;
    host->fail(host->self, host->last_error(host->self));
    return FETTLE_ERR_FAILED;
}

static void step(void* context, double dt) {
    (void)context;
    for (int i = 0; i < max_harbors; ++i) {
        Harbor* h = &harbors[i];
        fettle_value fields[2];
        if (!h->used) continue;
        h->tide = h->tide * 6364136223846793005u + 1442695040888963407u;
        memset(fields, 0, sizeof fields);
        fields[0].type = FETTLE_INTEGER;
        fields[0].as.integer = (int64_t)(h->tide >> 40);
        fields[1].type = FETTLE_NUMBER;
        fields[1].as.number = dt * (double)(h->tide >> 40) / (1 << 24);
        if (*rising.listeners != 0 &&
            host->ask(host->self, h->self, rising.id, fields, 2, 1) != FETTLE_OK)
            host->print(host->self, host->last_error(host->self));
        h->level += fields[1].as.number;
    }
}

static void report(void* context) {
    (void)context;
    host->touched(host->self);
}

static uint64_t hash(void* context) {
    uint64_t all = 0, level;
    (void)context;
    for (int i = 0; i < max_harbors; ++i) {
        if (!harbors[i].used) continue;
        memcpy(&level, &harbors[i].level, sizeof level);
        all = (all * 31 + level) * 31 + harbors[i].tide;
    }
    return all;
}

#ifndef FORGETFUL
static fettle_status save(void* context, void* sink,
                          void (*bytes)(void* sink, const void* data, size_t size)) {
    const uint64_t one = sizeof(Harbor);
    (void)context;
    bytes(sink, &one, sizeof one);
    for (int i = 0; i < max_harbors; ++i) bytes(sink, &harbors[i], sizeof(Harbor));
    return FETTLE_OK;
}

static fettle_status restore(void* context, const void* data, size_t size, uint32_t commit) {
    uint64_t one = 0;
    (void)context;
    if (size == sizeof one + sizeof harbors) memcpy(&one, data, sizeof one);
    if (one != sizeof(Harbor)) {
        host->fail(host->self, "the chart is torn");
        return FETTLE_ERR_REJECTED;
    }
    if (commit) memcpy(harbors, (const char*)data + sizeof one, sizeof harbors);
    return FETTLE_OK;
}
#endif

FETTLE_MODULE_EXPORT fettle_status fettle_module_open(const fettle_host* given,
                                                      fettle_module* module) {
    module->abi = FETTLE_ABI;
    if (given->abi >> 16 != FETTLE_ABI_MAJOR) return FETTLE_ERR_WRONG_VERSION;
    host = given;
    module->name = "harbor";
    module->attach = attach;
    module->step = step;
    module->report = report;
    module->hash = hash;
#ifndef FORGETFUL
    module->save = save;
    module->restore = restore;
#endif
    return FETTLE_OK;
}
