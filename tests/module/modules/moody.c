/* A module that behaves differently in the game and in its trial, and that calls the host with null
 * pointers. The environment variable FETTLE_TEST_MOODY has the call that it refuses and the process
 * in which it does: "attach 123", "create 123". */

#include <fettle/module/abi.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { rows = 16 };
static const fettle_host* host;
static double moods[rows];
static uint32_t used;
static fettle_event_tag sulked;

static int refuses(const char* what) {
    const char* const wanted = getenv("FETTLE_TEST_MOODY");
    char here[64];
    snprintf(here, sizeof here, "%s %ld", what, (long)getpid());
    return wanted != 0 && strcmp(wanted, here) == 0;
}

static void* base(void* context) {
    (void)context;
    return moods;
}

static fettle_status create(void* context, fettle_handle self, fettle_row* row) {
    (void)context, (void)self;
    if (refuses("create")) {
        host->fail(host->self, "no mood today");
        return FETTLE_ERR_FAILED;
    }
    *row = used++ % rows;
    moods[*row] = 1;
    return FETTLE_OK;
}

static fettle_status speak(void* context, fettle_handle self, fettle_row row,
                           const fettle_value* arguments, uint32_t count, fettle_result* result) {
    (void)context, (void)self, (void)row, (void)arguments, (void)count, (void)result;
    host->print(host->self, "spoken");
    return FETTLE_OK;
}

/* A result of 4000 million records, without memory for them. */
static fettle_status list(void* context, fettle_handle self, fettle_row row,
                          const fettle_value* arguments, uint32_t count, fettle_result* result) {
    (void)context, (void)self, (void)row, (void)arguments, (void)count;
    result->kind = FETTLE_RECORDS;
    result->count = 4000000000u;
    return FETTLE_OK;
}

/* The number of calls with a null pointer or a foreign tag that the host refused. */
static fettle_status misuse(void* context, fettle_handle self, fettle_row row,
                            const fettle_value* arguments, uint32_t count, fettle_result* result) {
    static const char no_event[256];
    fettle_value value;
    fettle_handle found;
    int64_t refused = 0;
    (void)context, (void)row, (void)arguments, (void)count;
    memset(&value, 0, sizeof value);
    refused += host->get(host->self, self, "mood", 0) != FETTLE_OK;
    refused += host->get(host->self, self, 0, &value) != FETTLE_OK;
    refused += host->set(host->self, self, "mood", 0) != FETTLE_OK;
    refused += host->find(host->self, "game", 0) != FETTLE_OK;
    refused += host->find(host->self, 0, &found) != FETTLE_OK;
    refused += host->path(host->self, self, 0) != FETTLE_OK;
    refused += host->row(host->self, self, 0) != FETTLE_OK;
    refused += host->call(host->self, self, 0, 0, 0, 0) != FETTLE_OK;
    refused += host->call(host->self, self, "speak", 0, 1, 0) != FETTLE_OK;
    refused += host->emit(host->self, self, sulked.id, 0, 1) != FETTLE_OK;
    refused += host->emit(host->self, self, 0, &value, 1) != FETTLE_OK;
    refused += host->emit(host->self, self, no_event, &value, 1) != FETTLE_OK;
    refused += host->emit(host->self, host->root(host->self), sulked.id, &value, 1) != FETTLE_OK;
    refused += host->ask(host->self, self, no_event, &value, 1, 0) != FETTLE_OK;
    refused += host->listens(host->self, self, 0) == 0;
    refused += host->listens(host->self, self, no_event) == 0;
    result->value.type = FETTLE_INTEGER;
    result->value.as.integer = refused;
    return FETTLE_OK;
}

static const fettle_property properties[] = {{.name = "mood",
                                              .type = FETTLE_NUMBER,
                                              .default_value = {FETTLE_NUMBER, 0, {.number = 7}},
                                              .binding = FETTLE_COLUMN,
                                              .native = FETTLE_F64,
                                              .base = base}};
static const fettle_field number[] = {{.name = "number", .type = FETTLE_INTEGER}};
static const fettle_method methods[] = {
    {.name = "speak", .call = speak},
    {.name = "list", .returns = FETTLE_ARRAY(number), .many = 1, .call = list},
    {.name = "misuse",
     .returns = FETTLE_ARRAY(number),
     .effect = FETTLE_CHANGES_TREE,
     .call = misuse}};
static const fettle_event events[] = {
    {.name = "sulked", .fields = FETTLE_ARRAY(number), .tag = &sulked}};

static fettle_status attach(void* context) {
    fettle_class moody;
    (void)context;
    memset(&moody, 0, sizeof moody);
    moody.struct_size = sizeof moody;
    moody.name = "Moody";
    moody.properties = (fettle_array)FETTLE_ARRAY(properties);
    moody.methods = (fettle_array)FETTLE_ARRAY(methods);
    moody.events = (fettle_array)FETTLE_ARRAY(events);
    moody.create = create;
    if (host->define_class(host->self, &moody) != FETTLE_OK) {
        host->fail(host->self, host->last_error(host->self));
        return FETTLE_ERR_FAILED;
    }
    host->print(host->self, "attached");
    if (refuses("attach")) {
        host->fail(host->self, "no game today");
        return FETTLE_ERR_FAILED;
    }
    return FETTLE_OK;
}

/* Makes an instance and a class, if the host still has what `attach` needed. */
static void step(void* context, double dt) {
    fettle_handle made;
    fettle_class again;
    (void)context, (void)dt;
    memset(&again, 0, sizeof again);
    again.struct_size = sizeof again;
    again.name = "Moody";
    host->define_class(host->self, &again);
    host->create(host->self, "Moody", host->root(host->self), "born", &made);
}

FETTLE_MODULE_EXPORT fettle_status fettle_module_open(const fettle_host* given,
                                                      fettle_module* module) {
    host = given;
    module->abi = FETTLE_ABI;
    module->name = "moody";
    module->attach = attach;
    module->step = step;
    return FETTLE_OK;
}
