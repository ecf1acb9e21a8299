/* Input: keys, text, mouse and gamepads, for the console and for the game's own `input`. */

#pragma once

#include <fettle/host/basics.h>

FETTLE_HOST_BEGIN

/** What happened. */
enum fettle_input_kind {
    FETTLE_INPUT_KEY_PRESSED = 0,
    FETTLE_INPUT_KEY_RELEASED = 1,
    FETTLE_INPUT_TEXT = 2,
    FETTLE_INPUT_MOUSE_PRESSED = 3,
    FETTLE_INPUT_MOUSE_RELEASED = 4,
    FETTLE_INPUT_MOUSE_MOVED = 5,
    FETTLE_INPUT_WHEEL = 6,
    FETTLE_INPUT_RESIZED = 7,
    FETTLE_INPUT_FOCUS = 8,
    FETTLE_INPUT_CLOSING = 9,
    FETTLE_INPUT_GAMEPAD_PRESSED = 10,
    FETTLE_INPUT_GAMEPAD_RELEASED = 11,
    FETTLE_INPUT_GAMEPAD_AXIS = 12,
    FETTLE_INPUT_GAMEPAD_CONNECTED = 13,
    FETTLE_INPUT_GAMEPAD_DISCONNECTED = 14
};

/** One event. fettle_hosted_input_init makes all members 0 and null. */
typedef struct fettle_hosted_input {
    uint32_t size;
    int32_t kind; /* one of fettle_input_kind */
    /* Key: "a" to "z", "0" to "9", "f1" to "f15", "space", "enter", "escape", "tab", "backspace",
       "delete", "insert", "left", "right", "up", "down", "home", "end", "page_up", "page_down",
       "left_shift", "right_shift", "left_control", "right_control", "left_alt", "right_alt",
       "grave", "minus", "equal", "left_bracket", "right_bracket", "backslash", "semicolon",
       "apostrophe", "comma", "period", "slash", "numpad_0" to "numpad_9". Mouse: "left", "right",
       "middle", "extra_1", "extra_2". Gamepad: number of a button, from "1", or name of an axis:
       "left_x". Null or another name: none of these; the console and the game ignore it. */
    const char* name;
    uint32_t character; /* of FETTLE_INPUT_TEXT: one Unicode character */
    int32_t gamepad;    /* from 1 */
    float x, y;         /* mouse: pixels from the top left; new size of FETTLE_INPUT_RESIZED */
    float delta;        /* wheel: notches, away from the user positive; axis: -1 to 1 */
    bool control, shift, alt; /* keys that are held down */
    bool repeated;            /* a key that is held down */
    bool focused;             /* of FETTLE_INPUT_FOCUS: gained */
} fettle_hosted_input;

/** Makes all members 0 and null, and writes `size`. FETTLE_INVALID unless `size` is the size of the
    structure. */
fettle_code fettle_hosted_input_init(fettle_hosted_input* input, size_t size);

/** Gives an event to the console and then to the game. `used` may be null; true: the console has
    used it, and the program should not. Not in a callback. */
fettle_code fettle_hosted_handle(fettle_hosted* game, const fettle_hosted_input* input, bool* used);

FETTLE_HOST_END
