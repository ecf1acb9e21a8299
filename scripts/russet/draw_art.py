#!/usr/bin/env python3
"""Draws art/*.png. Run it in this folder after a change: ./draw_art.py"""

import math
import random
import struct
import zlib

INK, FOX, RUST, CREAM, GOLD, RED, WHITE = ("#2b1d2e", "#ee8434", "#b4532a", "#fff1d6", "#ffcf4a", "#d8434e", "#ffffff")


def rgb(color):
    if isinstance(color, str):
        return tuple(int(color[i:i + 2], 16) for i in range(1, len(color), 2))
    return color


def mix(a, b, t):
    return tuple(round(x + (y - x) * t) for x, y in zip(rgb(a), rgb(b)))


class Image:
    def __init__(self, width, height):
        self.width, self.height, self.pixels = width, height, {}

    def put(self, x, y, color):
        x, y = math.floor(x), math.floor(y)
        if 0 <= x < self.width and 0 <= y < self.height:
            if color is None:
                self.pixels.pop((x, y), None)
            else:
                c = rgb(color)
                self.pixels[x, y] = c if len(c) == 4 else (*c, 255)

    def where(self, inside, color):
        for y in range(self.height):
            for x in range(self.width):
                if inside(x + 0.5, y + 0.5):
                    self.put(x, y, color)

    def oval(self, x, y, rx, ry, color):
        self.where(lambda u, v: ((u - x) / rx) ** 2 + ((v - y) / ry) ** 2 <= 1, color)

    def box(self, x, y, w, h, color):
        self.where(lambda u, v: x <= u < x + w and y <= v < y + h, color)

    def shape(self, points, color):
        def inside(u, v):
            hit = False
            for (ax, ay), (bx, by) in zip(points, points[1:] + points[:1]):
                if (ay > v) != (by > v) and u < (bx - ax) * (v - ay) / (by - ay) + ax:
                    hit = not hit
            return hit
        self.where(inside, color)

    def limb(self, ax, ay, bx, by, width, color):
        def inside(u, v):
            length = (bx - ax) ** 2 + (by - ay) ** 2 or 1
            t = max(0, min(1, ((u - ax) * (bx - ax) + (v - ay) * (by - ay)) / length))
            return math.hypot(u - ax - t * (bx - ax), v - ay - t * (by - ay)) <= width / 2
        self.where(inside, color)

    def outline(self, color=INK):
        edge = {(x + dx, y + dy) for x, y in self.pixels for dx, dy in ((1, 0), (-1, 0), (0, 1), (0, -1))} - set(self.pixels)
        for x, y in edge:
            self.put(x, y, color)

    def paste(self, other, x, y):
        for (u, v), color in other.pixels.items():
            self.put(x + u, y + v, color)

    def save(self, name):
        rows = b"".join(b"\0" + bytes(c for x in range(self.width) for c in self.pixels.get((x, y), (0, 0, 0, 0)))
                        for y in range(self.height))

        def chunk(kind, data):
            return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

        header = struct.pack(">IIBBBBB", self.width, self.height, 8, 6, 0, 0, 0)
        with open(f"art/{name}.png", "wb") as out:
            out.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b""))


def sheet(name, frames):
    whole = Image(sum(f.width for f in frames), frames[0].height)
    for n, frame in enumerate(frames):
        whole.paste(frame, n * frame.width, 0)
    whole.save(name)


def fox(bob=0.0, legs=(0, 0), tail=0.0, ears=0.0, stretch=0.0, eye=True):
    """A cub, 24 x 24, that looks to the right. legs: how far the two pairs swing."""
    image = Image(24, 24)
    y = 15 + bob
    tip = (2.5, y - 4 - tail)
    image.limb(8, y + 1, 5, y - 1 - tail * 0.5, 4, FOX)
    image.limb(5, y - 1 - tail * 0.5, *tip, 4.6, FOX)
    image.oval(tip[0], tip[1] - 0.5, 1.7, 1.8, CREAM)
    for x, swing, color in ((8.5, legs[1], RUST), (14.5, -legs[1], RUST), (9.5, legs[0], FOX), (15.5, -legs[0], FOX)):
        foot = min(22.5, 22.5 + stretch * 0.5)
        image.limb(x, y + 3, x + swing, foot, 2.2, color)
        image.limb(x + swing, foot - 0.3, x + swing + 0.6, foot, 1.8, INK)
    image.oval(11.5, y + 1, 6, 4 + stretch * 0.3, FOX)
    image.oval(13.5, y + 3, 3.6, 2.2, CREAM)
    hx, hy = 16, y - 4.5
    for x in (-3.4, 2.2):
        image.shape([(hx + x - 1.8, hy - 2), (hx + x + 0.2 - ears, hy - 7.5 + abs(ears)), (hx + x + 2.4, hy - 1.5)], FOX)
        image.put(hx + x + 0.2, hy - 4.2, INK)
    image.oval(hx, hy, 5.2, 4.3, FOX)
    image.oval(hx + 2.4, hy + 2, 3.6, 2.2, CREAM)
    image.limb(hx + 4, hy + 1.2, hx + 6.2, hy + 1.7, 2, CREAM)
    image.box(hx + 6, hy + 0.5, 1.4, 1.6, INK)
    if eye:
        image.box(hx + 1.6, hy - 1.6, 1.6, 2.6, INK)
        image.put(hx + 1.6, hy - 1.6, WHITE)
    else:
        image.box(hx + 0.8, hy - 0.4, 3, 1, INK)
    image.outline()
    return image


def draw_fox():
    frames = [fox(0, tail=0), fox(0.8, tail=1)]
    for n in range(6):
        a = 2 * math.pi * n / 6
        frames.append(fox(-abs(math.sin(a)) * 1.2, (3.4 * math.sin(a), 3.4 * math.sin(a + 2)), 1.5 * math.cos(a), 1))
    frames += [fox(-1, (-2.5, -1.5), -3, 1.5, 1), fox(-0.5, (2, 3), 4, -1), fox(1.5, (3, -3), 2, 2, eye=False)]
    sheet("fox", frames)


def beetle(phase):
    image = Image(20, 16)
    for n, x in enumerate((6, 10, 14)):
        image.limb(x, 11, x + math.sin(phase + n * 2) * 1.6, 14.5, 1.4, INK)
    image.oval(10, 9, 7, 5.2, "#7a3b69")
    image.oval(9, 7, 4.4, 2.4, "#a8558c")
    image.box(9.5, 4, 1, 9, "#5a2950")
    image.oval(16, 10.5, 2.6, 2.6, "#4b2547")
    image.box(16.5, 9, 1.6, 1.6, WHITE)
    image.put(17, 9, INK)
    image.box(3, 12, 13, 1.2, "#5a2950")
    image.outline()
    return image


def bat(wing):
    image = Image(24, 16)
    for side in (-1, 1):
        tip = 12 + side * 11
        image.shape([(12, 7), (tip - side * 3, 6 - wing), (tip, 8 - wing * 0.6), (12 + side * 6, 11 - wing * 0.3), (12, 11)], "#4d4a86")
    image.oval(12, 9, 4, 4.2, "#6663ad")
    for side in (-1, 1):
        image.shape([(12 + side * 1, 6), (12 + side * 3.4, 1.8), (12 + side * 4, 7)], "#6663ad")
        image.box(12 + side * 1.8 - 0.8, 7.5, 1.6, 1.8, GOLD)
    image.box(11, 11, 0.9, 1.6, WHITE)
    image.box(12.8, 11, 0.9, 1.6, WHITE)
    image.outline()
    return image


def hopper(pose):
    image = Image(20, 20)
    low = {0: 14, 1: 15.2, 2: 11}[pose]
    reach = 19 if pose == 2 else 18
    for x in (5, 15):
        image.limb(x, low + 1, x + (x - 10) * 0.3, reach, 3, "#3f7d58")
    image.oval(10, low, 7, 4.6 if pose != 2 else 5.4, "#5fae6a")
    image.oval(10, low + 2, 4.6, 2.2, "#d9e8a0")
    for x in (6.2, 13.8):
        image.oval(x, low - 4, 2.5, 2.5, "#5fae6a")
        image.oval(x, low - 4.2, 1.7, 1.7, WHITE)
        image.box(x - 0.4, low - 4.8, 1.4, 1.6, INK)
    image.box(6, low + 0.2, 8, 0.9, "#2f5d45")
    image.outline()
    return image


def boar(pose, swing=0.0):
    """48 x 32, looks to the right. Poses: walk, brace, stun."""
    image = Image(48, 34)
    y = 17 + (2 if pose == "brace" else 0)
    for n, x in enumerate((11, 17, 28, 34)):
        image.limb(x, y + 6, x + math.sin(swing + n * 2.2) * 3, 31, 4.4, "#4a2f3d" if n % 2 else "#5d3b48")
        image.limb(x + math.sin(swing + n * 2.2) * 3, 31, x + 1 + math.sin(swing + n * 2.2) * 3, 31, 3.4, INK)
    image.oval(21, y, 16, 10.5, "#7c4d54")
    image.oval(22, y + 4, 12, 5, "#94626a")
    for n in range(7):
        x = 7 + n * 4.4
        image.shape([(x - 2.4, y - 7 + abs(n - 3) * 0.7), (x - 1.5, y - 14 + abs(n - 3) * 1.2), (x + 2.6, y - 7 + abs(n - 3) * 0.7)], "#3b2433")
    hy = y + (5 if pose == "brace" else 1.5)
    image.oval(36, hy, 8, 7.5, "#7c4d54")
    image.oval(43, hy + 2.5, 4, 4.2, "#c98a86")
    for dx in (-1.2, 1.4):
        image.box(43 + dx, hy + 1.5, 1, 2, INK)
    image.shape([(38, hy + 4), (42, hy + 6), (45.5, hy - 3), (40.5, hy + 2)], CREAM)
    image.shape([(29, hy - 4), (30, hy - 11), (35, hy - 6)], "#5d3b48")
    image.shape([(28, hy - 7.5), (30, hy - 13.5), (33, hy - 9), (35.5, hy - 14.5), (37.5, hy - 8.8), (41, hy - 12.5), (41, hy - 6)], GOLD)
    image.put(35, hy - 10, RED)
    if pose == "stun":
        for d in range(-2, 3):
            image.put(38 + d, hy - 2 + d, INK)
            image.put(38 + d, hy - 2 - d, INK)
    else:
        image.box(37, hy - 3, 2.6, 2.6, "#ffdc5c")
        image.box(38.4, hy - 2.4, 1.2, 1.6, RED)
        image.limb(35.5, hy - 5, 40, hy - 3.4, 1.4, INK)
    image.limb(6, y - 3, 3, y - 6, 1.6, "#5d3b48")
    image.outline()
    return image


def draw_creatures():
    sheet("beetle", [beetle(n * 1.6) for n in range(4)])
    sheet("bat", [bat(w) for w in (5, 1, -4, 1)])
    sheet("hopper", [hopper(n) for n in range(3)])
    sheet("boar", [boar("walk", n * math.pi / 2) for n in range(4)] + [boar("brace"), boar("brace", 1), boar("stun")])


def draw_things():
    frames = []
    for n in range(6):
        image, wide = Image(14, 14), abs(math.cos(math.pi * n / 6)) * 4.6 + 0.9
        image.oval(7, 7, wide, 5, GOLD)
        image.oval(7, 7, wide * 0.55, 3, "#f0a53a")
        image.box(7 - wide * 0.6, 3.5, 1, 4, WHITE)
        image.outline("#8a4b20")
        frames.append(image)
    sheet("coin", frames)
    key = Image(16, 16)
    key.oval(5.5, 6, 4, 4, GOLD)
    key.oval(5.5, 6, 1.6, 1.6, None)
    key.limb(8, 8, 13, 13, 2, GOLD)
    key.limb(11, 11, 13.5, 9.5, 1.8, GOLD)
    key.outline("#8a4b20")
    key.save("key")
    heart = Image(14, 13)
    for x in (4.5, 9.5):
        heart.oval(x, 4.5, 3, 3, RED)
    heart.shape([(1.7, 5.5), (12.3, 5.5), (7, 11.5)], RED)
    heart.box(3, 3, 2, 2, "#ffb3a8")
    heart.outline()
    heart.save("heart")
    crate = Image(16, 16)
    crate.box(0, 0, 16, 16, "#6d4527")
    crate.box(1, 1, 14, 14, "#c98f52")
    for y in (5, 10):
        crate.box(1, y, 14, 1, "#9a6636")
    crate.limb(2.5, 13.5, 13.5, 2.5, 2.2, "#8a5a2e")
    for x, y in ((2, 2), (13, 2), (2, 13), (13, 13)):
        crate.put(x, y, "#ffe0a8")
    crate.save("crate")
    door = Image(16, 48)
    door.box(0, 0, 16, 48, "#4b3347")
    door.box(2, 1, 12, 46, "#7d5577")
    for y in (8, 24, 40):
        door.box(1, y, 14, 3, "#3a2637")
    door.oval(8, 22, 3.4, 3.4, GOLD)
    door.box(7.4, 21, 1.4, 4, INK)
    door.save("door")
    lift = Image(32, 8)
    lift.box(0, 0, 32, 8, "#5c4a68")
    lift.box(1, 1, 30, 2, "#c6b3d6")
    lift.box(1, 3, 30, 3, "#8d7a9e")
    for x in (4, 15, 26):
        lift.box(x, 3, 2, 3, GOLD)
    lift.save("lift")
    springs = []
    for high in (5, 11, 8):
        image = Image(16, 16)
        for n in range(3):
            y = 14 - high * (n + 0.6) / 3.4
            image.limb(4, y, 12, y - 1, 1.6, "#b8c4d6")
        image.box(2, 15 - high - 2, 12, 3, RED)
        image.box(3, 15 - high - 2, 10, 1, "#ff9a8a")
        image.box(1, 14, 14, 2, "#5c4a68")
        image.outline()
        springs.append(image)
    sheet("spring", springs)
    flags = []
    for n in range(5):
        image = Image(16, 32)
        image.box(3, 2, 2, 30, "#d9cbe3")
        image.oval(4, 2.5, 2, 2, GOLD)
        if n == 0:
            image.shape([(5, 20), (12, 23), (5, 26)], "#8d7a9e")
        else:
            wave = math.sin(n * math.pi / 2)
            image.shape([(5, 4), (10, 5 + wave), (15, 7 - wave), (10, 10 + wave), (5, 11)], FOX)
        image.outline()
        flags.append(image)
    sheet("flag", flags)
    dens = []
    for n in range(4):
        image = Image(48, 48)
        image.oval(24, 30, 21, 21, "#6d4a3c")
        image.oval(24, 32, 17, 19, "#8f6348")
        image.oval(24, 34, 11, 14, mix("#ffd36a", "#fff1c0", 0.5 + 0.5 * math.sin(n * math.pi / 2)))
        image.oval(24, 36, 7, 11, "#fff8e0")
        image.box(0, 48, 48, 2, None)
        for k in range(9):
            a = math.pi * (1 + k / 8)
            image.oval(24 + 20 * math.cos(a), 28 + 20 * math.sin(a), 4, 3.4, mix("#5c9a4e", "#8fc25e", (k * 5 % 9) / 8))
        image.outline()
        dens.append(image)
    sheet("den", dens)
    rock = Image(16, 16)
    rock.shape([(2, 8), (5, 2), (11, 1), (14, 7), (13, 13), (6, 15)], "#86798f")
    rock.shape([(4, 7), (6, 3), (10, 3), (8, 8)], "#b3a6ba")
    rock.outline()
    rock.save("rock")
    leaf = Image(6, 6)
    leaf.shape([(0, 5), (1, 1), (5, 0), (5, 3), (2, 6)], WHITE)
    leaf.save("leaf")


# Of each place: soil, its shadow, what grows on it, sky above and below, hills from far to near, kind of plants.
PLACES = [
    ("#b5764a", "#7d4a3a", "#7cc24f", "#6fc0ea", "#fdf0cf", ("#a9d8c9", "#7fbf98", "#559a6c"), "flower"),
    ("#94573f", "#5f3435", "#e0903c", "#f2a65e", "#ffe9b8", ("#e9b176", "#c77f52", "#8d4f47"), "flower"),
    ("#4c5a78", "#2b3350", "#3fb5a3", "#131a35", "#27436b", ("#1d2b50", "#25406a", "#17233f"), "crystal"),
    ("#8fa9cc", "#5a6f9c", "#f4fbff", "#5f86c9", "#e4f1fb", ("#b6cdea", "#8fb0da", "#6b8fc4"), "ice"),
    ("#77658f", "#463a63", "#b19ad0", "#2c2556", "#c06a86", ("#5a4682", "#47376f", "#332a56"), "crystal"),
    ("#70424f", "#43263a", "#d2604a", "#2a1230", "#d4533f", ("#6d2a45", "#521f3c", "#371530"), "thorn"),
]


def tiles(number, soil, dark, leaf, kind):
    image, dice = Image(128, 64), random.Random(number)

    def fill(ox, oy, surface):
        spots = [(dice.randrange(16), dice.randrange(16), dice.choice((-1, 1))) for _ in range(7)]
        for x in range(16):
            for y in range(16):
                color = mix(soil, dark, dice.choice((0, 0, 0, 0.1)))
                for sx, sy, way in spots:
                    if 0 <= x - sx < 3 and 0 <= y - sy < 2:
                        color = mix(soil, dark, 0.3) if way < 0 else mix(soil, WHITE, 0.09)
                depth = y - surface(x)
                if depth < 0:
                    continue
                band = 4 + (x * 5 % 7 > 3) + (x * 3 % 8 == 1) * 2
                if surface(x) > -50 and depth < band:
                    color = mix(leaf, WHITE, 0.35) if depth < 1 else mix(leaf, dark, 0.28) if depth >= band - 1.5 else rgb(leaf)
                image.put(ox + x, oy + y, color)

    for mask in range(16):
        ox, oy = 16 * (mask % 8), 16 * (mask // 8)
        fill(ox, oy, (lambda x: 0) if mask & 1 else (lambda x: -99))
        for y in range(16):
            if mask & 2:
                image.put(ox, oy + y, mix(dark, INK, 0.4) if not mask & 1 or y > 3 else mix(leaf, dark, 0.4))
            if mask & 4:
                image.put(ox + 15, oy + y, mix(dark, INK, 0.4) if not mask & 1 or y > 3 else mix(leaf, dark, 0.4))
        if mask & 8:
            for x in range(16):
                for y in range(13 + (x * 5 % 3), 16):
                    image.put(ox + x, oy + y, mix(dark, INK, 0.3))

    def at(n):
        return 16 * (n % 8), 32 + 16 * (n // 8)

    fill(*at(0), lambda x: 15 - x)
    fill(*at(1), lambda x: x)
    fill(*at(11), lambda x: -1 - x if x < 6 else -99)
    fill(*at(12), lambda x: x - 16 if x > 9 else -99)
    ox, oy = at(2)
    for x in range(16):
        for y in range(6):
            image.put(ox + x, oy + y, mix("#d9a566", WHITE, 0.3) if y == 0 else "#7d5230" if y == 5 or x == 15 else "#b87f48")
    ox, oy = at(3)
    for n in range(4):
        for y in range(10):
            for x in range(-(y // 4), y // 4 + 1):
                image.put(ox + 2 + n * 4 + x, oy + 6 + y, mix("#e8edf5", "#6a7390", (x + 2) / 4))
        image.put(ox + 2 + n * 4, oy + 5, WHITE)
    ox, oy = at(4)
    for x in range(16):
        for y in range(16):
            edge = x in (0, 15) or y in (0, 15)
            light = y == 1 or x == 1
            image.put(ox + x, oy + y, mix(dark, INK, 0.3) if edge else mix(soil, WHITE, 0.35) if light else mix(soil, dark, 0.15 + 0.1 * ((x + y) % 8 == 0)))
    ox, oy = at(5)
    if kind == "flower":
        for x, top, color in ((4, 6, RED), (11, 4, "#ffd85e")):
            for y in range(top, 16):
                image.put(ox + x, oy + y, mix(leaf, dark, 0.35))
            for dx, dy in ((0, 0), (1, 0), (-1, 0), (0, 1), (0, -1)):
                image.put(ox + x + dx, oy + top + dy, color if dx or dy else CREAM)
    elif kind == "thorn":
        for n in range(5):
            for y in range(6 + n % 3 * 3, 16):
                image.put(ox + 2 + n * 3 + (y % 4 == 0), oy + y, mix(dark, INK, 0.2))
    else:
        glow = "#7ef0dc" if kind == "crystal" else "#d8f0ff"
        for x0, top in ((4, 7), (8, 3), (12, 8)):
            for y in range(top, 16):
                half = min(2, (y - top) // 2)
                for x in range(-half, half + 1):
                    image.put(ox + x0 + x, oy + y, mix(glow, WHITE, 0.5) if x == -half else mix(glow, dark, 0.3 * (x == half)))
    ox, oy = at(6)
    for x in range(1, 15):
        for y in range(16 - (3 + x * 5 % 5 if x % 2 else 1), 16):
            image.put(ox + x, oy + y, mix(leaf, dark, 0.1 + 0.12 * (x % 3)))
    ox, oy = at(7)
    for y in range(8, 16):
        image.put(ox + 7, oy + y, "#7d5230")
        image.put(ox + 8, oy + y, "#5c3a22")
    for y in range(1, 10):
        reach = 15 - abs(y - 5)
        for x in range(1, reach):
            edge = y in (1, 9) or x in (1, reach - 1)
            image.put(ox + x, oy + y, "#7d5230" if edge else "#d9a566")
    image.box(ox + 3, oy + 4, 5, 2, INK)
    for d in range(4):
        image.box(ox + 8 + d, oy + 2 + d, 1, 7 - 2 * d if d < 3 else 1, INK)
    sea = mix("#3d9ad6", dark, 0.35 if number != 6 else 0)
    if number == 6:
        sea = rgb("#ff7a3d")
    for n, phase in ((8, 0), (9, math.pi)):
        ox, oy = at(n)
        for x in range(16):
            top = 4 + round(1.3 * math.sin(2 * math.pi * x / 16 + phase))
            for y in range(top, 16):
                image.put(ox + x, oy + y, mix(sea, WHITE, 0.7) if y == top else mix(sea, WHITE, 0.15) if y < top + 3 else sea)
    image.box(*at(10), 16, 16, sea)
    ox, oy = at(13)
    for x in range(16):
        for y in range(16):
            image.put(ox + x, oy + y, mix(soil, dark, 0.5 + 0.08 * (dice.random() < 0.12)))
    for x, y, w in ((2, 3, 5), (9, 8, 4), (3, 12, 6)):
        image.box(ox + x, oy + y, w, 1.5, mix(soil, dark, 0.75))
    ox, oy = at(14)
    image.oval(ox + 8, oy + 13.5, 4.5, 3, mix(soil, WHITE, 0.25))
    image.oval(ox + 7, oy + 13, 2.4, 1.4, mix(soil, WHITE, 0.5))
    ox, oy = at(15)
    for x, y, r in ((4, 13, 3.4), (8, 10.5, 4.4), (12, 13, 3.4)):
        image.oval(ox + x, oy + y, r, r, mix(leaf, dark, 0.3))
    for x, y in ((5, 11), (8, 8), (10, 12), (12, 11), (7, 12)):
        image.put(ox + x, oy + y, mix(leaf, WHITE, 0.3))
    image.save(f"tiles_{number}")


def backdrop(number, above, below, hills, kind):
    dice = random.Random(number * 7)
    sky = Image(4, 160)
    for y in range(160):
        for x in range(4):
            t = y / 159
            sky.put(x, y, mix(above, below, max(0, min(1, round(t * 26) / 26))))
    sky.save(f"sky_{number}")
    clouds = Image(384, 96)
    for _ in range(6 if number != 3 else 0):
        x, y, wide = dice.randrange(90, 294), dice.randrange(14, 80), dice.randrange(14, 34)
        cloud = Image(384, 96)                         # of its own: its flat base must not cut the others
        for n in range(5):
            cloud.oval(x + (n - 2) * wide / 2.4, y - (2 - abs(n - 2)) * 3, wide / 2.6, 6 + (2 - abs(n - 2)) * 2.5, (*mix(below, WHITE, 0.55), 210))
        cloud.box(x - wide * 1.2, y + 5, wide * 2.4, 12, None)
        clouds.paste(cloud, 0, 0)
    if number in (3, 5, 6):
        for _ in range(90):
            clouds.put(dice.randrange(384), dice.randrange(96), (*rgb("#ffe9c0" if number != 3 else "#6ff0dd"), dice.randrange(90, 255)))
    clouds.save(f"clouds_{number}")
    for layer, color in enumerate(hills):
        image = Image(384, 176)
        waves = [(dice.randrange(1, 4) + layer, dice.random() * 6.3, 9.0 / (n + 1)) for n in range(3)]

        def height(x):
            h = sum(a * math.sin(2 * math.pi * k * x / 384 + p) for k, p, a in waves)
            if kind == "ice" or number == 6:
                h = abs((x * (2 + layer) / 96 + layer * 0.4) % 2 - 1) * 34 - 12 + h * 0.4      # whole peaks: it repeats
            return 138 - layer * 22 + h

        for x in range(384):
            top = 176 - height(x)
            for y in range(max(0, round(top)), 176):
                t = (y - top) / 130
                shade = mix(color, below, max(0, 0.25 * t))
                if y - top < 2:
                    shade = mix(color, WHITE, 0.18)
                if kind == "ice" and y - top < 8 + (x * 7 % 5) and layer < 2:
                    shade = mix(color, WHITE, 0.7)
                image.put(x, y, shade)
        for _ in range(0 if kind == "ice" or layer == 0 else 16 + layer * 6):
            x = dice.randrange(10, 374)
            base, tall = 176 - height(x) + 3, dice.randrange(14, 26) + layer * 5
            tone = mix(color, INK, 0.12 + 0.1 * dice.random())
            if number == 3:
                image.shape([(x - 5, base), (x, base - tall * 1.2), (x + 5, base)], tone)
                if dice.random() < 0.4:
                    image.oval(x, base - tall * 0.5, 1.6, 2.6, "#5fe0cc")
            elif number >= 5:
                image.box(x - 4, base - tall, 8, tall + 6, tone)
                image.shape([(x - 6, base - tall), (x, base - tall - 9), (x + 6, base - tall)], tone)
                image.box(x - 1, base - tall + 4, 2, 3, "#ffc46b" if dice.random() < 0.6 else mix(tone, INK, 0.3))
            elif number == 2 or dice.random() < 0.5:
                image.box(x - 1, base - tall * 0.5, 2, tall * 0.5 + 2, mix(color, INK, 0.4))
                for dx, dy, r in ((-4, 0, 5), (4, 0, 5), (0, -5, 6)):
                    image.oval(x + dx, base - tall * 0.6 + dy, r, r, tone)
            else:
                for n in range(3):
                    w = 7 - n * 1.8
                    image.shape([(x - w, base - n * tall * 0.25), (x, base - tall * 0.5 - n * tall * 0.25), (x + w, base - n * tall * 0.25)], tone)
        image.save(f"hills_{number}_{layer + 1}")


draw_fox()
draw_creatures()
draw_things()
for index, (soil, dark, leaf, above, below, hills, kind) in enumerate(PLACES):
    tiles(index + 1, soil, dark, leaf, kind)
    backdrop(index + 1, above, below, hills, kind)
