/* Boxes and balls in a window of SDL2. The mouse drags them; a right click makes a new one.
 *
 *   sdl2 [FRAMES PICTURE.bmp]    ends after so many frames and saves the last one
 */

#include <SDL.h>
#include <fettle_physics.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { width = 800, height = 600 };
static const float scale = 40; /* pixels for a meter */

static SDL_Renderer* renderer;
static fettle_world* world;
static fettle_id mouse_joint;

static void require(fettle_code code) {
    if (code == FETTLE_DONE) return;
    fprintf(stderr, "sdl2: %s\n", fettle_last_error());
    exit(1);
}

static SDL_FPoint to_screen(fettle_vec2 p) {
    return (SDL_FPoint){width / 2 + scale * p.x, height - 40 - scale * p.y};
}

static fettle_vec2 to_world(int x, int y) {
    return (fettle_vec2){((float)x - width / 2) / scale, (height - 40 - (float)y) / scale};
}

static void make(int32_t body_type, int32_t shape_type, fettle_vec2 at, float w, float h) {
    fettle_body_def body_def;
    fettle_geometry geometry;
    fettle_id body;
    require(fettle_body_def_init(&body_def, sizeof body_def));
    body_def.type = body_type;
    body_def.position = at;
    require(fettle_world_create_body(world, &body_def, &body));
    require(fettle_geometry_init(&geometry, sizeof geometry, shape_type));
    geometry.width = w;
    geometry.height = h;
    geometry.radius = w / 2;
    require(fettle_body_add(world, body, &geometry, NULL, NULL));
}

static void set_color(uint32_t color) {
    SDL_SetRenderDrawColor(renderer, color >> 16 & 255, color >> 8 & 255, color & 255, 255);
}

static void draw_polygon(void* user, const fettle_vec2* points, uint32_t count, bool closed,
                         uint32_t color) {
    (void)user;
    set_color(color);
    for (uint32_t i = closed ? 0 : 1; i < count; ++i) {
        const SDL_FPoint a = to_screen(points[(i + count - 1) % count]), b = to_screen(points[i]);
        SDL_RenderDrawLineF(renderer, a.x, a.y, b.x, b.y);
    }
}

static void draw_segment(void* user, fettle_vec2 from, fettle_vec2 to, uint32_t color) {
    draw_polygon(user, (fettle_vec2[]){from, to}, 2, false, color);
}

static void draw_circle(void* user, fettle_vec2 center, float radius, float angle, uint32_t color) {
    fettle_vec2 points[25] = {center}; /* the first line shows the angle */
    for (int i = 0; i < 24; ++i) {
        const float t = angle + 6.2831853f * (float)i / 23;
        points[i + 1] = (fettle_vec2){center.x + radius * cosf(t), center.y + radius * sinf(t)};
    }
    draw_polygon(user, points, 25, false, color);
}

static void grab(fettle_vec2 at) {
    fettle_id shape, body = 0;
    uint32_t count;
    int32_t type = FETTLE_BODY_STATIC;
    fettle_mouse_joint_def def;
    require(fettle_world_query_point(world, at.x, at.y, NULL, &shape, 1, &count));
    if (count == 0) return;
    require(fettle_shape_body(world, shape, &body));
    require(fettle_body_type(world, body, &type));
    if (type != FETTLE_BODY_DYNAMIC) return;
    require(fettle_mouse_joint_def_init(&def, sizeof def));
    def.body = body;
    def.target = at;
    require(fettle_world_create_mouse_joint(world, &def, &mouse_joint));
}

static bool handle(const SDL_Event* event) {
    if (event->type == SDL_MOUSEBUTTONDOWN && event->button.button == SDL_BUTTON_LEFT)
        grab(to_world(event->button.x, event->button.y));
    else if (event->type == SDL_MOUSEBUTTONDOWN)
        make(FETTLE_BODY_DYNAMIC, FETTLE_SHAPE_BOX, to_world(event->button.x, event->button.y), 1,
             1);
    else if (event->type == SDL_MOUSEMOTION && fettle_joint_is_valid(world, mouse_joint)) {
        const fettle_vec2 at = to_world(event->motion.x, event->motion.y);
        require(fettle_mouse_joint_set_target(world, mouse_joint, at.x, at.y));
    } else if (event->type == SDL_MOUSEBUTTONUP && fettle_joint_is_valid(world, mouse_joint))
        require(fettle_joint_destroy(world, mouse_joint));
    return event->type != SDL_QUIT;
}

static void save_picture(const char* file) {
    SDL_Surface* picture =
        SDL_CreateRGBSurfaceWithFormat(0, width, height, 24, SDL_PIXELFORMAT_BGR24);
    SDL_RenderReadPixels(renderer, NULL, SDL_PIXELFORMAT_BGR24, picture->pixels, picture->pitch);
    if (SDL_SaveBMP(picture, file) != 0) fprintf(stderr, "sdl2: %s\n", SDL_GetError());
    SDL_FreeSurface(picture);
}

int main(int argc, char** argv) {
    const int frames = argc > 2 ? atoi(argv[1]) : -1;
    SDL_Window* window;
    fettle_debug_draw draw;
    if (SDL_Init(SDL_INIT_VIDEO) != 0 ||
        SDL_CreateWindowAndRenderer(width, height, 0, &window, &renderer) != 0) {
        fprintf(stderr, "sdl2: %s\n", SDL_GetError());
        return 1;
    }
    require(fettle_world_create(NULL, &world));
    make(FETTLE_BODY_STATIC, FETTLE_SHAPE_BOX, (fettle_vec2){0, -0.5f}, 18, 1);
    for (int i = 0; i < 28; ++i) {
        const fettle_vec2 at = {(float)(i % 7) - 3 + 0.1f * (float)(i / 7),
                                1 + 1.5f * (float)(i / 7)};
        make(FETTLE_BODY_DYNAMIC, i % 3 == 0 ? FETTLE_SHAPE_CIRCLE : FETTLE_SHAPE_BOX, at, 0.9f,
             0.7f);
    }
    require(fettle_debug_draw_init(&draw, sizeof draw));
    draw.polygon = draw_polygon;
    draw.circle = draw_circle;
    draw.segment = draw_segment;

    bool running = true;
    for (int frame = 0; running && frame != frames; ++frame) {
        for (SDL_Event event; SDL_PollEvent(&event);) running = running && handle(&event);
        require(fettle_world_step(world, 1.0f / 60));
        set_color(0x202428);
        SDL_RenderClear(renderer);
        require(fettle_world_draw(world, &draw));
        if (frame + 1 == frames) save_picture(argv[2]);
        SDL_RenderPresent(renderer);
        SDL_Delay(16);
    }
    require(fettle_world_destroy(world));
    SDL_Quit();
    return 0;
}
