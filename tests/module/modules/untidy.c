/* A module with one mistake, which the environment variable FETTLE_TEST_UNTIDY names. */

#include <fettle/module/abi.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const fettle_host* host;

static int is(const char* mistake) {
    const char* const wanted = getenv("FETTLE_TEST_UNTIDY");
    return wanted != 0 && strcmp(wanted, mistake) == 0;
}

static fettle_status get(void* context, fettle_row row, fettle_value* value) {
    (void)context, (void)row;
    value->type = FETTLE_NUMBER;
    value->as.number = is("nan getter") ? NAN : is("inf getter") ? INFINITY : 1.5;
    return FETTLE_OK;
}

static fettle_status call(void* context, fettle_handle self, fettle_row row,
                          const fettle_value* arguments, uint32_t count, fettle_result* result) {
    (void)context, (void)self, (void)row, (void)arguments, (void)count;
    result->value.type = FETTLE_NUMBER;
    result->value.as.number = is("nan result") ? NAN : 2.5;
    if (is("nil result")) result->value.type = FETTLE_NIL;
    if (is("text result")) {
        result->value.type = FETTLE_TEXT;
        result->value.as.text = "much";
        result->value.count = 4;
    }
    return FETTLE_OK;
}

static fettle_status attach(void* context) {
    fettle_property property = {.name = "value",
                                .type = FETTLE_NUMBER,
                                .flags = FETTLE_READ_ONLY,
                                .min = 1,
                                .max = 5,
                                .default_value = {.type = FETTLE_NUMBER, .as.number = 1},
                                .binding = FETTLE_ACCESSOR,
                                .get = get};
    fettle_field parameter = {.name = "weight", .type = FETTLE_NUMBER};
    fettle_field answer = {.type = FETTLE_NUMBER};
    fettle_method method = {.name = "answer", .call = call};
    fettle_class untidy = {.struct_size = sizeof untidy, .name = "Untidy"};
    (void)context;
    if (is("range")) property.min = 9;
    if (is("flags")) property.flags = 0xffffffff;
    if (is("class flags")) untidy.flags = 12;
    if (is("binding")) property.binding = 9;
    if (is("doc")) property.doc = "gr\xfcn";
    if (is("class doc")) untidy.doc = "a\xff";
    if (is("size")) untidy.struct_size = 4;
    if (is("parameter")) parameter.min = 3, parameter.max = 2;
    if (is("property name")) property.name = "children";
    if (is("method name")) method.name = "add";
    method.parameters.data = &parameter, method.parameters.count = 1;
    method.parameters.size = sizeof parameter;
    method.returns.data = &answer, method.returns.count = 1, method.returns.size = sizeof answer;
    untidy.properties.data = &property, untidy.properties.count = 1;
    untidy.properties.size = sizeof property;
    untidy.methods.data = &method, untidy.methods.count = 1, untidy.methods.size = sizeof method;
    return host->define_class(host->self, &untidy);
}

FETTLE_MODULE_EXPORT fettle_status fettle_module_open(const fettle_host* given,
                                                      fettle_module* module) {
    host = given;
    module->abi = FETTLE_ABI;
    module->name = "untidy";
    module->attach = attach;
    return FETTLE_OK;
}
