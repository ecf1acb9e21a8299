/* A module that uses what a game has: its own test looks for classes, instances, values, methods and
 * events of the game, and fails with the first that is not as trial_test.cpp has made it. */

#include <fettle/module/abi.h>
#include <string.h>

static const fettle_host* host;

static fettle_status missing(const char* what) {
    host->fail(host->self, what);
    return FETTLE_ERR_FAILED;
}

static fettle_handle find(const char* path) {
    fettle_handle found = {0, 0};
    host->find(host->self, path, &found);
    return found;
}

static double number(fettle_handle of, const char* property) {
    fettle_value value;
    if (host->get(host->self, of, property, &value) != FETTLE_OK) return -1;
    return value.type == FETTLE_NUMBER ? value.as.number : -2;
}

static fettle_status check(void* context) {
    const fettle_handle one = find("one"), two = find("one.two");
    fettle_value value, arguments[1];
    fettle_result result;
    const char* base;
    (void)context;
    memset(&value, 0, sizeof value);
    memset(arguments, 0, sizeof arguments);
    memset(&result, 0, sizeof result);
    if (one.generation == 0 || two.generation == 0) return missing("instances");
    if (!host->is_a(host->self, two, "Buoy")) return missing("base class");
    base = host->base_class(host->self, "Beacon");
    if (base == 0 || strcmp(base, "Buoy") != 0) return missing("name of the base class");
    if (host->step(host->self) != 12) return missing("step");
    if (number(one, "depth") != 5) return missing("accessor");
    if (number(two, "depth") != 3) return missing("default of a derived class");
    if (number(two, "charge") != 0.5) return missing("stored value");
    if (number(one, "wear") != 7) return missing("read-only value");
    if (number(one, "extra") != 2.5) return missing("property of one instance");
    if (host->get(host->self, one, "neighbors", &value) != FETTLE_OK ||
        value.type != FETTLE_LIST || value.count != 1 ||
        value.as.list[0].as.reference.index != two.index)
        return missing("list of references");
    value.type = FETTLE_NUMBER;
    value.as.number = 101;
    if (host->set(host->self, one, "depth", &value) == FETTLE_OK) return missing("range");
    value.as.number = 50;
    if (host->set(host->self, one, "depth", &value) != FETTLE_OK || number(one, "depth") != 50)
        return missing("write");
    if (host->call(host->self, one, "spawn", 0, 0, &result) != FETTLE_OK ||
        result.kind != FETTLE_ONE_VALUE || result.value.type != FETTLE_REFERENCE ||
        !host->is_a(host->self, result.value.as.reference, "Beacon"))
        return missing("method that returns an instance");
    arguments[0].type = FETTLE_TEXT;
    arguments[0].as.text = "deep";
    arguments[0].count = 4;
    if (host->call(host->self, one, "measure", arguments, 1, &result) != FETTLE_OK ||
        result.kind != FETTLE_RECORD || result.fields != 2)
        return missing("method that returns a record");
    if (host->call(host->self, one, "mesure", 0, 0, &result) != FETTLE_ERR_UNKNOWN_NAME)
        return missing("error of an unknown method");
    return FETTLE_OK;
}

static fettle_status attach(void* context) {
    fettle_class visit;
    (void)context;
    memset(&visit, 0, sizeof visit);
    visit.struct_size = sizeof visit;
    visit.name = "Visit";
    return host->define_class(host->self, &visit);
}

FETTLE_MODULE_EXPORT fettle_status fettle_module_open(const fettle_host* given,
                                                      fettle_module* module) {
    host = given;
    module->abi = FETTLE_ABI;
    module->name = "visitor";
    module->attach = attach;
    module->check = check;
    return FETTLE_OK;
}
