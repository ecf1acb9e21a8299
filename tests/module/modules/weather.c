/* A module in plain C: clouds that gather water and rain. It is built several times, each time with
 * one of the macros below, which make one kind of faulty module each. */

#include <math.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <fettle/module/abi.h>

#ifndef CLASS_NAME
#define CLASS_NAME "Cloud"
#endif
#ifndef FRONT_CLASS
#define FRONT_CLASS CLASS_NAME
#endif
#ifndef MODULE_NAME
#define MODULE_NAME "weather"
#endif
#ifndef ABI
#define ABI FETTLE_ABI
#endif

enum { max_clouds = 64 };
static const double dry = 0.0;

#ifdef EXIT_IN_CONSTRUCTOR
__attribute__((constructor)) static void before_all(void) {
    _exit(0);
}
#endif

/* Another layout of the structure, as another version may have: a reload must not copy its bytes.
 */
typedef struct Cloud {
#ifdef OTHER_LAYOUT
    char padding[40];
    uint8_t kind;
    double height;
    double water;
#else
    double water;
    double height;
    uint8_t kind;
#endif
    fettle_handle self;
    uint32_t used;
} Cloud;

static const fettle_host* host;
static Cloud clouds[max_clouds];
static fettle_event_tag rained;

static void* water_base(void* context) {
    (void)context;
    return &clouds[0].water;
}
static void* kind_base(void* context) {
    (void)context;
    return &clouds[0].kind;
}

static fettle_status get_height(void* context, fettle_row row, fettle_value* value) {
    (void)context;
    value->type = FETTLE_NUMBER;
    value->as.number = clouds[row].height;
    return FETTLE_OK;
}

static fettle_status set_height(void* context, fettle_row row, const fettle_value* value) {
    (void)context;
    if (value->as.number == 13) {
        host->fail(host->self, "thirteen meters bring bad luck");
        return FETTLE_ERR_REJECTED;
    }
    clouds[row].height = value->as.number;
    return FETTLE_OK;
}

static fettle_status get_mood(void* context, fettle_row row, fettle_value* value) {
    static char mood[32];
    (void)context;
    strcpy(mood, clouds[row].water > 50 ? "heavy" : "light");
    value->type = FETTLE_TEXT;
    value->as.text = mood;
    value->count = (uint32_t)strlen(mood);
    return FETTLE_OK;
}

/* Declared as a number, but returns a text. */
static fettle_status get_slip(void* context, fettle_row row, fettle_value* value) {
    return get_mood(context, row, value);
}

static fettle_status rain(void* context, fettle_handle self, fettle_row row,
                          const fettle_value* arguments, uint32_t count, fettle_result* result) {
    const double amount = count > 0 && arguments[0].type == FETTLE_NUMBER ? arguments[0].as.number
                                                                          : clouds[row].water;
    (void)context;
    if (amount > clouds[row].water) {
        host->fail(host->self, "there is not that much water in the cloud");
        return FETTLE_ERR_REJECTED;
    }
    clouds[row].water -= amount;
    if (host->listens(host->self, self, rained.id)) {
        fettle_value amount_field;
        memset(&amount_field, 0, sizeof amount_field);
        amount_field.type = FETTLE_NUMBER;
        amount_field.as.number = amount;
        host->emit(host->self, self, rained.id, &amount_field, 1);
    }
    result->kind = FETTLE_ONE_VALUE;
    result->value.type = FETTLE_NUMBER;
    result->value.as.number = clouds[row].water;
    return FETTLE_OK;
}

static fettle_status survey(void* context, fettle_handle self, fettle_row row,
                            const fettle_value* arguments, uint32_t count, fettle_result* result) {
    static fettle_value values[4];
    (void)context, (void)self, (void)arguments, (void)count;
    memset(values, 0, sizeof values);
    values[0].type = values[2].type = FETTLE_TEXT;
    values[0].as.text = "water", values[0].count = 5;
    values[2].as.text = "height", values[2].count = 6;
    values[1].type = values[3].type = FETTLE_NUMBER;
    values[1].as.number = clouds[row].water;
    values[3].as.number = clouds[row].height;
    result->kind = FETTLE_RECORDS;
    result->count = 2;
    result->fields = 2;
    result->values = values;
    return FETTLE_OK;
}

static fettle_status create(void* context, fettle_handle self, fettle_row* row) {
    (void)context;
    for (*row = 0; *row < max_clouds && clouds[*row].used; ++*row) {
    }
    if (*row == max_clouds) {
        host->fail(host->self, "the sky is full");
        return FETTLE_ERR_REJECTED;
    }
    memset(&clouds[*row], 0, sizeof(Cloud));
    clouds[*row].height = 100;
    clouds[*row].water = dry;
    clouds[*row].self = self;
    clouds[*row].used = 1;
    host->grow(host->self, 20000);
    return FETTLE_OK;
}

static void destroy(void* context, fettle_handle self, fettle_row row) {
    (void)context, (void)self;
    clouds[row].used = 0;
    host->grow(host->self, -20000);
}

static void draw(void* context, fettle_handle self, fettle_row row, const fettle_painter* painter,
                 double alpha) {
    const double center[2] = {0, clouds[row].height};
    const float white[4] = {1, 1, 1, 1};
    (void)context, (void)self, (void)alpha;
    painter->circle(painter->self, center, 1, white, white, 0);
}

static const char* const kinds[] = {"cumulus", "stratus", "cirrus", NULL};
static const char* const of_water[] = {"water", NULL};

static const fettle_property properties[] = {
#ifdef RETYPED
    {.name = "water", .type = FETTLE_TEXT},
#else
    {.name = "water",
     .type = FETTLE_NUMBER,
     .flags = FETTLE_SIMULATED,
     .unit = "kg",
     .doc = "How much it carries.",
     .min = 0,
     .max = 1000,
     .binding = FETTLE_COLUMN,
     .native = FETTLE_F64,
     .stride = sizeof(Cloud),
     .base = water_base},
#endif
    {.name = "kind",
     .type = FETTLE_TEXT,
     .enumerators = kinds,
     .binding = FETTLE_COLUMN,
     .native = FETTLE_ENUM8,
     .stride = sizeof(Cloud),
     .base = kind_base},
    {.name = "height",
     .type = FETTLE_NUMBER,
     .default_value = {FETTLE_NUMBER, 0, {.number = 100}},
     .unit = "m",
     .binding = FETTLE_ACCESSOR,
     .get = get_height,
     .set = set_height},
    {.name = "mood",
     .type = FETTLE_TEXT,
     .derives_from = of_water,
     .binding = FETTLE_ACCESSOR,
     .get = get_mood},
    {.name = "slip", .type = FETTLE_NUMBER, .binding = FETTLE_ACCESSOR, .get = get_slip},
    {.name = "label", .type = FETTLE_TEXT},
#ifdef OTHER_LAYOUT
    {.name = "silver", .type = FETTLE_BOOLEAN},
#endif
};

static const fettle_field amount[] = {{.name = "amount", .type = FETTLE_NUMBER, .unit = "kg"}};
static const fettle_field left[] = {{.name = "left", .type = FETTLE_NUMBER, .unit = "kg"}};
static const fettle_field figures[] = {{.name = "what", .type = FETTLE_TEXT},
                                       {.name = "value", .type = FETTLE_NUMBER}};
static const fettle_method methods[] = {
    {.name = "rain",
     .parameters = FETTLE_ARRAY(amount),
     .returns = FETTLE_ARRAY(left),
     .call = rain},
#ifdef OTHER_LAYOUT
    {.name = "hail", .call = rain},
#else
    {.name = "survey", .returns = FETTLE_ARRAY(figures), .call = survey},
#endif
};
static const fettle_event events[] = {
    {.name = "rained", .fields = FETTLE_ARRAY(amount), .tag = &rained},
#ifdef OTHER_LAYOUT
    {.name = "hailed"},
#endif
};

static fettle_status attach(void* context) {
    fettle_class cloud;
    fettle_handle made;
    (void)context;
#ifdef EXIT_IN_ATTACH
    exit(0);
#endif
    memset(&cloud, 0, sizeof cloud);
    cloud.struct_size = sizeof cloud;
    cloud.name = CLASS_NAME;
    cloud.doc = "Carries water.";
    cloud.properties = (fettle_array)FETTLE_ARRAY(properties);
    cloud.methods = (fettle_array)FETTLE_ARRAY(methods);
    cloud.events = (fettle_array)FETTLE_ARRAY(events);
    cloud.weight = 5000;
    cloud.create = create;
    cloud.destroy = destroy;
    cloud.draw = draw;
#ifdef OTHER_LAYOUT
    cloud.draw_over = draw;
#endif
    if (host->define_class(host->self, &cloud) != FETTLE_OK) {
        host->fail(host->self, host->last_error(host->self));
        return FETTLE_ERR_FAILED;
    }
    return host->create(host->self, FRONT_CLASS, host->root(host->self), "front", &made);
}

static void step(void* context, double dt) {
    (void)context;
#ifdef EXIT_IN_STEP
    _exit(0);
#elif defined SILENT_IN_STEP
    for (int i = 3; i < 1024; ++i)
        close(i); /* closes all files, so the parent would wait without end for a message */
    for (;;) pause();
#endif
    for (int i = 0; i < max_clouds; ++i)
        if (clouds[i].used) clouds[i].water += dt;
}

static void report(void* context) {
    (void)context;
    host->touched(host->self);
}

static uint64_t hash(void* context) {
    uint64_t all = 0;
    (void)context;
    for (int i = 0; i < max_clouds; ++i) all = all * 31 + (uint64_t)(clouds[i].water * 1024);
    return all;
}

static fettle_status check(void* context) {
    (void)context;
#if defined CRASH_IN_CHECK
    raise(SIGSEGV);
#elif defined ABORT_IN_CHECK
    abort();
#elif defined EXIT_IN_CHECK
    _exit(EXIT_IN_CHECK);
#elif defined FAIL_IN_CHECK
    host->fail(host->self, "the barometer is stuck");
    return FETTLE_ERR_FAILED;
#endif
    return FETTLE_OK;
}

#ifdef NEEDS_MISSING_SYMBOL
void function_of_another_program(void);
#endif

#ifndef WITHOUT_ENTRY
FETTLE_MODULE_EXPORT fettle_status fettle_module_open(const fettle_host* given,
                                                      fettle_module* module) {
    module->abi = ABI;
    if (given->abi >> 16 != FETTLE_ABI_MAJOR) return FETTLE_ERR_WRONG_VERSION;
#ifdef CRASH_WHEN_OPENED
    raise(SIGSEGV);
#endif
#ifdef EXIT_WHEN_OPENED
    _exit(0);
#endif
#ifdef NEEDS_MISSING_SYMBOL
    function_of_another_program();
#endif
    host = given;
    module->name = MODULE_NAME;
    module->version = "1.2";
    module->attach = attach;
    module->check = check;
    module->step = step;
    module->report = report;
    module->hash = hash;
    return FETTLE_OK;
}
#endif
