/* The console and the inspector as triangles, for any way of drawing. The grave key, as an event of
 * input.h, opens and closes it. Its settings are properties of the instance `console`:
 * `console.font_size` in pixels, `console.scale`. If the game was created without a console, the
 * functions give FETTLE_INVALID. */

#pragma once

#include <fettle/host/basics.h>

FETTLE_HOST_BEGIN

/** A corner of a triangle. */
typedef struct fettle_console_vertex {
    float x, y;         /* pixels from the top left */
    float u, v;         /* in the texture, 0 to 1 */
    uint8_t r, g, b, a; /* straight alpha; multiplied with the color of the texture */
} fettle_console_vertex;

/** Pixels that a command may show. */
typedef struct fettle_console_clip {
    float left, top, width, height; /* pixels */
} fettle_console_clip;

/** Triangles to be drawn one after another: three indices each, blended with straight alpha. */
typedef struct fettle_console_command {
    uint32_t texture;                  /* id of a texture; 0: none, a plain color */
    uint32_t first_index, index_count; /* its part of the indices of the picture */
    fettle_console_clip clip;          /* nothing is drawn outside */
} fettle_console_command;

/** Pixels: four bytes each (red, green, blue, alpha), rows from the top. */
typedef struct fettle_console_texture {
    uint32_t id;            /* as in fettle_console_command */
    uint32_t width, height; /* pixels */
    uint32_t version;       /* another one when the pixels have changed */
    const uint8_t* rgba;    /* 4 * width * height bytes */
} fettle_console_texture;

/** A picture of the console. Its arrays are valid until the next picture of the game. */
typedef struct fettle_console_picture {
    const fettle_console_vertex* vertices;                            /* corners of the triangles */
    const uint32_t* indices;                                          /* of vertices */
    const fettle_console_command* commands;                           /* in the order of drawing */
    const fettle_console_texture* textures;                           /* all that there are */
    uint32_t vertex_count, index_count, command_count, texture_count; /* lengths */
} fettle_console_picture;

/** The console over a picture of that size in pixels (1 to 32768), `seconds` of real time after the
    last one. A closed console has pinned values and messages, or nothing. Not in a callback. */
fettle_code fettle_console_draw(fettle_hosted* game, float width, float height, double seconds,
                                fettle_console_picture* picture);

/** Whether it is open; the grave key of an input opens and closes it, too. */
fettle_code fettle_console_open(fettle_hosted* game, bool open);
fettle_code fettle_console_is_open(fettle_hosted* game, bool* is_open);

/** Shows the instance in the inspector; 0: nothing is selected. */
fettle_code fettle_console_select(fettle_hosted* game, fettle_instance instance);
fettle_code fettle_console_selected(fettle_hosted* game, fettle_instance* instance);

/** Writes a line into the console. */
fettle_code fettle_console_print(fettle_hosted* game, const char* line);

/** Where the world is on the screen, for clicks on bodies and for the outline of what is selected:
    `map` has six numbers a, b, c, d, x, y, and the point (px, py) of the world is at the pixel
    (a px + b py + x, c px + d py + y). Null: where the game's own `view` shows it. */
fettle_code fettle_console_set_view(fettle_hosted* game, const double* map);

/** The clipboard of the system. A text that `read` gives must stay valid until the next call of it;
    null is an empty one. Without these, copied text stays inside the console. */
typedef const char* (*fettle_clipboard_read)(void* user);
typedef void (*fettle_clipboard_write)(void* user, const char* text);
fettle_code fettle_console_set_clipboard(fettle_hosted* game, fettle_clipboard_read read,
                                         fettle_clipboard_write write, void* user);

FETTLE_HOST_END
