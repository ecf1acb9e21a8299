#pragma once

// Tests in C. Each returns null, or the place and the text of what was not true.

#ifdef __cplusplus
extern "C" {
#endif

typedef const char* (*c_test)(void);

struct named_c_test {
    const char* name;
    c_test run;
};

// Each list ends with a null name.
extern const struct named_c_test worlds_in_c[];
extern const struct named_c_test callbacks_in_c[];
extern const struct named_c_test positions_in_c[];
extern const struct named_c_test accounts_in_c[];

#ifdef __cplusplus
}
#endif

#define C_TEXT_OF(line) #line
#define C_TEXT(line) C_TEXT_OF(line)
#define CHECK_C(condition) \
    if (!(condition)) return __FILE__ ":" C_TEXT(__LINE__) ": " #condition
#define DONE_C(call) CHECK_C((call) == FETTLE_DONE)
