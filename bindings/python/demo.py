"""Boxes and balls in a window of pygame; the mouse drags them.

    python3 demo.py [FRAMES PICTURE.png]    ends after so many frames and saves the last one
"""

import math
import random
import sys

import pygame

import fettle

width, height, scale = 800, 600, 40


def to_screen(p):
    return width / 2 + scale * p[0], height - 40 - scale * p[1]


def to_world(p):
    return (p[0] - width / 2) / scale, (height - 40 - p[1]) / scale


def make_world():
    world = fettle.World(room=200)
    world.body("static", position=(0, -0.5)).add(fettle.Box(18, 1))
    dice = random.Random(3)
    for i in range(60):
        body = world.body(position=(dice.uniform(-4, 4), 1 + i / 4), angle=dice.uniform(0, 6))
        size = dice.uniform(0.3, 1)
        body.add(fettle.Circle(size / 2) if i % 3 == 0 else fettle.Box(size, size), restitution=0.2)
    return world


def draw(screen, world, colors):
    screen.fill((32, 36, 40))
    poses = world.poses  # all at once, without a copy
    for body in world.bodies:
        x, y, angle = poses[body.slot]
        color = colors.setdefault(body, pygame.Color("dimgray") if body.type == "static" else
                                  pygame.Color(random.Random(body.slot).choice(["tomato", "gold", "skyblue", "palegreen"])))
        for shape in body.shapes:
            if shape.type == "circle":
                pygame.draw.circle(screen, color, to_screen((x, y)), shape.radius * scale)
                end = x + shape.radius * math.cos(angle), y + shape.radius * math.sin(angle)
                pygame.draw.line(screen, (32, 36, 40), to_screen((x, y)), to_screen(end))
            else:
                pygame.draw.polygon(screen, color, [to_screen(p) for p in shape.world_vertices])


def main():
    frames, picture = (int(sys.argv[1]), sys.argv[2]) if len(sys.argv) > 2 else (-1, None)
    pygame.init()
    screen = pygame.display.set_mode((width, height))
    clock = pygame.time.Clock()
    world, drag, colors = make_world(), None, {}
    while frames != 0:
        frames -= 1
        for event in pygame.event.get():
            if event.type == pygame.QUIT:
                return
            if event.type == pygame.MOUSEBUTTONDOWN:
                at = to_world(event.pos)
                held = [shape.body for shape in world.query_point(at) if shape.body.type == "dynamic"]
                if held:
                    drag = world.joint("mouse", None, held[0], target=at, max_force=200 * held[0].mass)
            elif event.type == pygame.MOUSEMOTION and drag:
                drag.target = to_world(event.pos)
            elif event.type == pygame.MOUSEBUTTONUP and drag:
                drag.destroy()
                drag = None
        world.step(1 / 60)
        draw(screen, world, colors)
        pygame.display.flip()
        clock.tick(60)
    if picture:
        pygame.image.save(screen, picture)


main()
