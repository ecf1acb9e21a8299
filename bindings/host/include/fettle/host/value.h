/* Values of properties, arguments and results. */

#pragma once

#include <fettle/host/basics.h>

FETTLE_HOST_BEGIN

/** The type of a value. */
enum fettle_value_type {
    FETTLE_VALUE_NIL = 0,
    FETTLE_VALUE_BOOLEAN = 1,
    FETTLE_VALUE_INTEGER = 2,
    FETTLE_VALUE_NUMBER = 3,
    FETTLE_VALUE_TEXT = 4,
    FETTLE_VALUE_VEC2 = 5,
    FETTLE_VALUE_COLOR = 6,
    FETTLE_VALUE_INSTANCE = 7,
    FETTLE_VALUE_LIST = 8
};

/** A value. To the library: the text need not end with a zero; a list may be nested up to 64 deep
    and have a million elements. From the library: a zero follows the text. */
typedef struct fettle_hosted_value {
    int32_t type;   /* one of fettle_value_type */
    uint32_t count; /* bytes of a text, elements of a list */
    union {
        int64_t integer;
        double number;
        double vec2[2];
        float color[4]; /* red, green, blue, opacity: 0 to 1, sRGB */
        fettle_instance instance;
        int32_t boolean; /* 0 is false */
        const char* text;
        const struct fettle_hosted_value* list;
    } as; /* the member that the type names */
} fettle_hosted_value;

FETTLE_HOST_END
