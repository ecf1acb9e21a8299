/* A module with invalid values. */

#include <fettle/module/abi.h>
#include <string.h>

#ifndef STRIDE
#define STRIDE 0
#endif

static const fettle_host* host;

static void* nowhere(void* context) {
    (void)context;
    return 0;
}

static fettle_status fails(void* context, fettle_row row, fettle_value* value) {
    (void)context, (void)row, (void)value;
    host->fail(host->self, "the sensor is wet");
    return FETTLE_ERR_FAILED;
}

static fettle_status no_type(void* context, fettle_row row, fettle_value* value) {
    (void)context, (void)row;
    value->type = 99;
    return FETTLE_OK;
}

static fettle_status no_text(void* context, fettle_row row, fettle_value* value) {
    (void)context, (void)row;
    value->type = FETTLE_TEXT;
    value->count = 3;
    return FETTLE_OK;
}

static fettle_status no_list(void* context, fettle_row row, fettle_value* value) {
    (void)context, (void)row;
    value->type = FETTLE_LIST;
    value->count = 3;
    return FETTLE_OK;
}

static fettle_status endless(void* context, fettle_row row, fettle_value* value) {
    static fettle_value itself;
    (void)context, (void)row;
    itself.type = FETTLE_LIST;
    itself.count = 1;
    itself.as.list = &itself;
    *value = itself;
    return FETTLE_OK;
}

#ifdef HALF_SAVED
static fettle_status save(void* context, void* sink,
                          void (*bytes)(void* sink, const void* data, size_t size)) {
    (void)context, (void)sink, (void)bytes;
    return FETTLE_OK;
}
#endif

static const fettle_property properties[] = {
    {.name = "hollow",
     .type = FETTLE_NUMBER,
     .flags = FETTLE_READ_ONLY,
     .binding = FETTLE_COLUMN,
     .native = FETTLE_F64,
     .stride = STRIDE,
     .base = nowhere},
    {.name = "failing", .type = FETTLE_NUMBER, .binding = FETTLE_ACCESSOR, .get = fails},
    {.name = "typeless", .type = FETTLE_NUMBER, .binding = FETTLE_ACCESSOR, .get = no_type},
    {.name = "wordless", .type = FETTLE_TEXT, .binding = FETTLE_ACCESSOR, .get = no_text},
    {.name = "empty", .type = FETTLE_LIST, .binding = FETTLE_ACCESSOR, .get = no_list},
    {.name = "endless", .type = FETTLE_LIST, .binding = FETTLE_ACCESSOR, .get = endless},
};

#if defined BASE || defined ODDER
static fettle_status make_row(void* context, fettle_handle self, fettle_row* row) {
    (void)context, (void)self;
    *row = 12345;
    return FETTLE_OK;
}
#endif

static fettle_status attach(void* context) {
    fettle_class odd;
    fettle_handle made;
    (void)context;
    memset(&odd, 0, sizeof odd);
    odd.struct_size = sizeof odd;
    odd.name = "Odd";
    odd.properties = (fettle_array)FETTLE_ARRAY(properties);
#if defined NO_DATA
    odd.properties.data = 0;
#elif defined NO_SIZE
    odd.properties.size = 0;
#endif
#if defined BASE
    odd.base = BASE;
#endif
#if defined BASE || defined ODDER
    odd.create = make_row;
#endif
    if (host->define_class(host->self, &odd) != FETTLE_OK) {
        host->fail(host->self, host->last_error(host->self));
        return FETTLE_ERR_FAILED;
    }
#if defined ODDER
    odd.name = "Odder";
    odd.base = "Odd";
    odd.properties.count = 0;
    if (host->define_class(host->self, &odd) != FETTLE_OK) {
        host->fail(host->self, host->last_error(host->self));
        return FETTLE_ERR_FAILED;
    }
#endif
    return host->create(host->self, "Odd", host->root(host->self), "odd", &made);
}

FETTLE_MODULE_EXPORT fettle_status fettle_module_open(const fettle_host* given,
                                                      fettle_module* module) {
    host = given;
    module->abi = FETTLE_ABI;
    module->name = "odd";
    module->version = "1";
    module->attach = attach;
#ifdef HALF_SAVED
    module->save = save;
#endif
    return FETTLE_OK;
}
