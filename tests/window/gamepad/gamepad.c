// A gamepad of Linux that is not there, for programs that this library is preloaded into. It stands
// between SFML and the system: the search for devices by libudev finds one, whose events come from
// the named pipe $FETTLE_TEST_GAMEPAD (struct js_event; the path must contain "/js").

#define _GNU_SOURCE
#include <dlfcn.h>
#include <linux/input.h>
#include <linux/joystick.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>

// What libudev gives is only passed back to it, so any address will do.
static char device, entry;

void* udev_new(void) {
    return &device;
}
void* udev_monitor_new_from_netlink(void* context, const char* name) {
    return (void)context, (void)name, NULL;
}
void* udev_enumerate_new(void* context) {
    return (void)context, (void*)&device;
}
int udev_enumerate_add_match_subsystem(void* all, const char* name) {
    return (void)all, (void)name, 0;
}
int udev_enumerate_scan_devices(void* all) {
    return (void)all, 0;
}
void* udev_enumerate_get_list_entry(void* all) {
    return (void)all, (void*)&entry;
}
void* udev_enumerate_unref(void* all) {
    return (void)all, NULL;
}
void* udev_list_entry_get_next(void* of) {
    return (void)of, NULL;
}
const char* udev_list_entry_get_name(void* of) {
    return (void)of, "/sys/class/input/js0";
}
void* udev_device_new_from_syspath(void* context, const char* path) {
    return (void)context, (void)path, (void*)&device;
}
void* udev_device_get_parent_with_subsystem_devtype(void* of, const char* subsystem,
                                                    const char* type) {
    return (void)subsystem, (void)type, of;
}
const char* udev_device_get_devnode(void* of) {
    return (void)of, getenv("FETTLE_TEST_GAMEPAD");
}
void* udev_device_unref(void* of) {
    return (void)of, NULL;
}
void* udev_unref(void* context) {
    return (void)context, NULL;
}

// A DualShock 4.
static const char* value(const char* name) {
    if (strcmp(name, "ID_INPUT_JOYSTICK") == 0) return "1";
    if (strstr(name, "endor") != NULL || strcmp(name, "ID_VENDOR_ID") == 0) return "054c";
    if (strstr(name, "roduct") != NULL || strcmp(name, "ID_MODEL_ID") == 0) return "09cc";
    return NULL;
}
const char* udev_device_get_property_value(void* of, const char* name) {
    return (void)of, value(name);
}
const char* udev_device_get_sysattr_value(void* of, const char* name) {
    return (void)of, value(name);
}

int ioctl(int file, unsigned long request, ...) {
    static const unsigned char axes[] = {ABS_X,  ABS_Y,  ABS_Z,     ABS_RX,
                                         ABS_RY, ABS_RZ, ABS_HAT0X, ABS_HAT0Y};
    va_list more;
    va_start(more, request);
    void* const answer = va_arg(more, void*);
    va_end(more);
    if (request == JSIOCGAXES) return *(unsigned char*)answer = sizeof axes, 0;
    if (request == JSIOCGBUTTONS) return *(unsigned char*)answer = 13, 0;
    if (_IOC_TYPE(request) == 'j' && _IOC_NR(request) == _IOC_NR(JSIOCGAXMAP))
        return memcpy(answer, axes, sizeof axes), 0;
    if (_IOC_TYPE(request) == 'j' && _IOC_NR(request) == _IOC_NR(JSIOCGNAME(0)))
        return strcpy(answer, "pretended"), 9;
    int (*const real)(int, unsigned long, ...) =
        (int (*)(int, unsigned long, ...))dlsym(RTLD_NEXT, "ioctl");
    return real(file, request, answer);
}
