/* A game of Fettle in a window of SDL2: its bodies are drawn here, and the grave key opens its
 * console, which is delivered as triangles.
 *
 *   sdl2_host [FRAMES PICTURE.bmp]    types a command into the console, ends after so many frames
 *                                     and saves the last one
 */

#include <SDL.h>
#include <fettle_host.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { width = 960, height = 640, most_bodies = 256, most_textures = 16 };
static const double scale = 32; /* pixels for a meter */
static const char* const game_in_lua =
    "world.floor = Body { Box { width = 40, height = 1 }, type = 'static' }\n"
    "for i = 0, 59 do\n"
    "  local at = vec(i % 10 - 4.5 + 0.1 * (i // 10), 4 + 1.2 * (i // 10))\n"
    "  world['ball_' .. i] = Body { Circle { radius = 0.45, restitution = 0.4 }, position = at }\n"
    "end\n";

static SDL_Renderer* renderer;
static fettle_hosted* game;

static void require(fettle_code code) {
    if (code == FETTLE_DONE) return;
    fprintf(stderr, "sdl2_host: %s\n", fettle_last_error());
    exit(1);
}

/* --- Bodies: their positions are read by handles --- */

typedef struct body {
    fettle_property_id position, angle;
} body;
static body bodies[most_bodies];
static uint32_t body_count;

static void find_bodies(void) {
    fettle_instance world, children[most_bodies];
    uint32_t count;
    require(fettle_hosted_find(game, "world", &world));
    require(fettle_hosted_children(game, world, children, most_bodies, &count));
    for (uint32_t i = 0; i < count && body_count < most_bodies; ++i) {
        const char* name;
        require(fettle_hosted_name(game, children[i], &name));
        if (strncmp(name, "ball_", 5) != 0) continue;
        body* const found = &bodies[body_count++];
        require(fettle_property_of(game, children[i], "position", &found->position));
        require(fettle_property_of(game, children[i], "angle", &found->angle));
    }
}

static void draw_bodies(void) {
    SDL_SetRenderDrawColor(renderer, 110, 140, 110, 255);
    SDL_RenderFillRect(renderer, &(SDL_Rect){0, height - 60 - 16, width, 32});
    SDL_SetRenderDrawColor(renderer, 250, 190, 70, 255);
    for (uint32_t i = 0; i < body_count; ++i) {
        double x, y, angle;
        SDL_FPoint points[25];
        /* The console may have deleted it. */
        if (fettle_property_get_vec2(game, bodies[i].position, &x, &y) != FETTLE_DONE) continue;
        require(fettle_property_get_number(game, bodies[i].angle, &angle));
        points[0].x = (float)(width / 2 + scale * x);
        points[0].y = (float)(height - 60 - scale * y);
        for (int k = 1; k < 25; ++k) {
            const double t = angle + 6.2831853 * (k - 1) / 23;
            points[k].x = (float)(points[0].x + 0.45 * scale * cos(t));
            points[k].y = (float)(points[0].y - 0.45 * scale * sin(t));
        }
        SDL_RenderDrawLinesF(renderer, points, 25);
    }
}

/* --- The console: textures and triangles --- */

static struct {
    uint32_t id, version;
    SDL_Texture* texture;
} textures[most_textures];

static SDL_Texture* texture_of(const fettle_console_picture* picture, uint32_t id) {
    for (uint32_t i = 0; i < picture->texture_count; ++i) {
        const fettle_console_texture* const of = &picture->textures[i];
        const uint32_t place = of->id % most_textures;
        if (of->id != id) continue;
        if (textures[place].id != id || textures[place].version != of->version) {
            if (textures[place].texture != NULL) SDL_DestroyTexture(textures[place].texture);
            textures[place].id = id;
            textures[place].version = of->version;
            textures[place].texture =
                SDL_CreateTexture(renderer, SDL_PIXELFORMAT_RGBA32, SDL_TEXTUREACCESS_STATIC,
                                  (int)of->width, (int)of->height);
            SDL_UpdateTexture(textures[place].texture, NULL, of->rgba, (int)of->width * 4);
            SDL_SetTextureBlendMode(textures[place].texture, SDL_BLENDMODE_BLEND);
        }
        return textures[place].texture;
    }
    return NULL;
}

static void draw_console(double seconds) {
    fettle_console_picture picture;
    require(fettle_console_draw(game, width, height, seconds, &picture));
    SDL_SetRenderDrawBlendMode(renderer, SDL_BLENDMODE_BLEND);
    for (uint32_t i = 0; i < picture.command_count; ++i) {
        const fettle_console_command* const command = &picture.commands[i];
        const fettle_console_vertex* const v = picture.vertices;
        const SDL_Rect clip = {(int)command->clip.left, (int)command->clip.top,
                               (int)ceilf(command->clip.width), (int)ceilf(command->clip.height)};
        SDL_RenderSetClipRect(renderer, &clip);
        SDL_RenderGeometryRaw(renderer, texture_of(&picture, command->texture), &v->x, sizeof *v,
                              (const SDL_Color*)&v->r, sizeof *v, &v->u, sizeof *v,
                              (int)picture.vertex_count, picture.indices + command->first_index,
                              (int)command->index_count, sizeof *picture.indices);
    }
    SDL_RenderSetClipRect(renderer, NULL);
}

/* --- Input --- */

static const struct {
    SDL_Keycode key;
    const char* name;
} keys[] = {{SDLK_BACKQUOTE, "grave"},
            {SDLK_RETURN, "enter"},
            {SDLK_ESCAPE, "escape"},
            {SDLK_TAB, "tab"},
            {SDLK_BACKSPACE, "backspace"},
            {SDLK_DELETE, "delete"},
            {SDLK_LEFT, "left"},
            {SDLK_RIGHT, "right"},
            {SDLK_UP, "up"},
            {SDLK_DOWN, "down"},
            {SDLK_HOME, "home"},
            {SDLK_END, "end"},
            {SDLK_PAGEUP, "page_up"},
            {SDLK_PAGEDOWN, "page_down"},
            {SDLK_SPACE, "space"},
            {SDLK_LCTRL, "left_control"},
            {SDLK_RCTRL, "right_control"},
            {SDLK_LSHIFT, "left_shift"},
            {SDLK_RSHIFT, "right_shift"},
            {SDLK_LALT, "left_alt"},
            {SDLK_RALT, "right_alt"}};

static const char* name_of(SDL_Keycode key, char letter[2]) {
    for (size_t i = 0; i < sizeof keys / sizeof *keys; ++i)
        if (keys[i].key == key) return keys[i].name;
    letter[0] = (key >= 'a' && key <= 'z') || (key >= '0' && key <= '9') ? (char)key : 0;
    letter[1] = 0;
    return letter;
}

static void send(const fettle_hosted_input* input) {
    /* A command that fails is reported in the console. */
    if (fettle_hosted_handle(game, input, NULL) != FETTLE_DONE)
        fprintf(stderr, "%s\n", fettle_last_error());
}

static void send_text(fettle_hosted_input* input, const char* text) {
    input->kind = FETTLE_INPUT_TEXT;
    for (const unsigned char* at = (const unsigned char*)text; *at != 0;) {
        const int more = *at < 0xc0 ? 0 : *at < 0xe0 ? 1 : *at < 0xf0 ? 2 : 3;
        input->character = *at++ & (more == 0 ? 0x7f : 0x3f >> more);
        for (int i = 0; i < more && *at != 0; ++i)
            input->character = input->character << 6 | (*at++ & 0x3f);
        send(input);
    }
}

static bool handle(const SDL_Event* event) {
    static const char* const buttons[] = {"", "left", "middle", "right", "extra_1", "extra_2"};
    const SDL_Keymod held = SDL_GetModState();
    char letter[2];
    int x, y;
    fettle_hosted_input input;
    require(fettle_hosted_input_init(&input, sizeof input));
    SDL_GetMouseState(&x, &y);
    input.x = (float)x;
    input.y = (float)y;
    input.shift = (held & KMOD_SHIFT) != 0;
    input.control = (held & KMOD_CTRL) != 0;
    input.alt = (held & KMOD_ALT) != 0;
    if (event->type == SDL_KEYDOWN || event->type == SDL_KEYUP) {
        input.kind =
            event->type == SDL_KEYDOWN ? FETTLE_INPUT_KEY_PRESSED : FETTLE_INPUT_KEY_RELEASED;
        input.name = name_of(event->key.keysym.sym, letter);
        input.repeated = event->key.repeat != 0;
        if (input.name[0] != 0) send(&input);
    } else if (event->type == SDL_TEXTINPUT) {
        send_text(&input, event->text.text);
    } else if (event->type == SDL_MOUSEMOTION) {
        input.kind = FETTLE_INPUT_MOUSE_MOVED;
        send(&input);
    } else if (event->type == SDL_MOUSEBUTTONDOWN || event->type == SDL_MOUSEBUTTONUP) {
        input.kind = event->type == SDL_MOUSEBUTTONDOWN ? FETTLE_INPUT_MOUSE_PRESSED
                                                        : FETTLE_INPUT_MOUSE_RELEASED;
        input.name = buttons[event->button.button < 6 ? event->button.button : 0];
        send(&input);
    } else if (event->type == SDL_MOUSEWHEEL) {
        input.kind = FETTLE_INPUT_WHEEL;
        input.delta = (float)event->wheel.y;
        send(&input);
    }
    return event->type != SDL_QUIT;
}

/* Simulated input, for the run that makes a picture. */
static void push_key(SDL_Keycode key) {
    SDL_Event event = {.type = SDL_KEYDOWN};
    event.key.keysym.sym = key;
    SDL_PushEvent(&event);
    event.type = SDL_KEYUP;
    SDL_PushEvent(&event);
}
static void simulate_input(int frame) {
    SDL_Event event = {.type = SDL_TEXTINPUT};
    if (frame == 20) push_key(SDLK_BACKQUOTE);
    if (frame == 30) {
        strcpy(event.text.text, "world.gravity = vec(2, -4)");
        SDL_PushEvent(&event);
    }
    if (frame == 31) push_key(SDLK_RETURN);
    if (frame == 40) {
        fettle_instance ball;
        require(fettle_hosted_find(game, "world.ball_59", &ball));
        require(fettle_console_select(game, ball));
    }
}

static void save_picture(const char* file) {
    SDL_Surface* picture =
        SDL_CreateRGBSurfaceWithFormat(0, width, height, 24, SDL_PIXELFORMAT_BGR24);
    SDL_RenderReadPixels(renderer, NULL, SDL_PIXELFORMAT_BGR24, picture->pixels, picture->pitch);
    if (SDL_SaveBMP(picture, file) != 0) fprintf(stderr, "sdl2_host: %s\n", SDL_GetError());
    SDL_FreeSurface(picture);
}

int main(int argc, char** argv) {
    const int frames = argc > 2 ? atoi(argv[1]) : -1;
    const double view[] = {scale, 0, 0, -scale, width / 2, height - 60};
    SDL_Window* window;
    fettle_hosted_value gravity;
    if (SDL_Init(SDL_INIT_VIDEO) != 0 ||
        SDL_CreateWindowAndRenderer(width, height, 0, &window, &renderer) != 0) {
        fprintf(stderr, "sdl2_host: %s\n", SDL_GetError());
        return 1;
    }
    require(fettle_hosted_create(NULL, &game));
    require(fettle_hosted_run(game, game_in_lua, "game"));
    require(fettle_console_set_view(game, view));
    find_bodies();

    bool running = true;
    for (int frame = 0; running && frame != frames; ++frame) {
        if (frames > 0) simulate_input(frame);
        for (SDL_Event event; SDL_PollEvent(&event);) running = running && handle(&event);
        if (fettle_hosted_frame(game, 1.0 / 60, NULL) != FETTLE_DONE)
            fprintf(stderr, "%s\n", fettle_last_error());
        SDL_SetRenderDrawColor(renderer, 60, 80, 110, 255);
        SDL_RenderClear(renderer);
        draw_bodies();
        draw_console(1.0 / 60);
        if (frame + 1 == frames) save_picture(argv[2]);
        SDL_RenderPresent(renderer);
        SDL_Delay(frames > 0 ? 1 : 16);
    }
    require(fettle_hosted_get(game, "world.gravity", &gravity));
    printf("gravity is %g, %g\n", gravity.as.vec2[0], gravity.as.vec2[1]);
    require(fettle_hosted_destroy(game));
    SDL_Quit();
    return 0;
}
