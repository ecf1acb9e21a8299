#!/usr/bin/env python3
"""Draws the pictures in art/. Run it in this folder after a change: ./draw_art.py"""

import math
import os
import random
import struct
import zlib


class Image:
    """Pixels of a picture with soft edges, transparent at first. A place is x to the right, y up."""

    def __init__(self, width, height):
        self.width, self.height = width, height
        self.pixels = [[0.0, 0.0, 0.0, 0.0] for _ in range(width * height)]

    def blend(self, x, y, color, cover):
        pixel = self.pixels[y * self.width + x]
        part = cover * (color[3] / 255 if len(color) == 4 else 1)
        whole = part + pixel[3] * (1 - part)
        if whole <= 0:
            return
        for i in range(3):
            pixel[i] = (color[i] * part + pixel[i] * pixel[3] * (1 - part)) / whole
        pixel[3] = whole

    def cell(self, size, column, row):
        return Cell(self, size, column * size, row * size)

    def save(self, name):
        rows = b"".join(
            b"\0" + bytes(v for p in self.pixels[y * self.width:(y + 1) * self.width]
                          for v in (*(min(255, max(0, round(c))) for c in p[:3]), round(255 * p[3])))
            for y in range(self.height))

        def chunk(kind, data):
            return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

        header = struct.pack(">IIBBBBB", self.width, self.height, 8, 6, 0, 0, 0)
        with open(os.path.join("art", name), "wb") as out:
            out.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header)
                      + chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b""))


class Cell:
    """A square part of an image, in which coordinates go from -1 to 1."""

    def __init__(self, image, size, left, top):
        self.image, self.size, self.left, self.top = image, size, left, top

    def fill(self, shape, color, soft=0.0):
        """Fills where the distance that the shape gives is below 0; a color may be a function of the place."""
        half = self.size / 2
        for j in range(1, self.size - 1):
            for i in range(1, self.size - 1):
                x, y = (i + 0.5) / half - 1, 1 - (j + 0.5) / half
                distance = shape(x, y) * half
                cover = 0.5 - distance / (1 + soft * half)
                if cover > 0:
                    self.image.blend(self.left + i, self.top + j, color(x, y) if callable(color) else color,
                                     min(1, cover))

    def outlined(self, shape, color, rim, width=0.07):
        self.fill(lambda x, y: shape(x, y) - width, rim)
        self.fill(shape, color)

    def glow(self, cx, cy, radius, color, power=2.0):
        self.fill(lambda x, y: math.hypot(x - cx, y - cy) - radius,
                  lambda x, y: (*color, 255 * max(0, 1 - math.hypot(x - cx, y - cy) / radius) ** power))


def circle(cx, cy, r):
    return lambda x, y: math.hypot(x - cx, y - cy) - r


def ellipse(cx, cy, rx, ry, turn=0.0):
    c, s = math.cos(turn), math.sin(turn)

    def shape(x, y):
        dx, dy = x - cx, y - cy
        u, v = (c * dx + s * dy) / rx, (c * dy - s * dx) / ry
        return (math.hypot(u, v) - 1) * min(rx, ry)
    return shape


def capsule(x1, y1, x2, y2, r1, r2=None):
    r2 = r1 if r2 is None else r2

    def shape(x, y):
        dx, dy = x2 - x1, y2 - y1
        t = max(0, min(1, ((x - x1) * dx + (y - y1) * dy) / (dx * dx + dy * dy)))
        return math.hypot(x - x1 - t * dx, y - y1 - t * dy) - (r1 + t * (r2 - r1))
    return shape


def polygon(*points):
    def shape(x, y):
        inside, nearest = False, 9.0
        for (ax, ay), (bx, by) in zip(points, points[1:] + points[:1]):
            nearest = min(nearest, capsule(ax, ay, bx, by, 0)(x, y))
            if (ay > y) != (by > y) and x < (bx - ax) * (y - ay) / (by - ay) + ax:
                inside = not inside
        return -nearest if inside else nearest
    return shape


def union(*shapes):
    return lambda x, y: min(shape(x, y) for shape in shapes)


def without(shape, hole):
    return lambda x, y: max(shape(x, y), -hole(x, y))


def fade(low, high, bottom=-0.8, top=0.8):
    """A color that changes from the bottom to the top."""
    def color(_, y):
        t = max(0, min(1, (y - bottom) / (top - bottom)))
        return tuple(a + t * (b - a) for a, b in zip(low, high))
    return color


SHADOW = (6, 6, 18, 110)
EYE = (255, 236, 170)


def eyes(cell, x, y, r, color=EYE, gap=0.24, slant=0.0):
    for side in (-1, 1):
        cell.glow(x + side * gap, y, r * 2.6, color, 2.5)
        cell.fill(ellipse(x + side * gap, y, r, r * 1.25, side * slant), color)
        cell.fill(circle(x + side * gap, y - r * 0.1, r * 0.42), (30, 14, 40))


def shade(cell, frame):
    """A drop of the dark, with a hem that waves."""
    phase = frame * math.pi / 2
    bob = 0.04 * math.sin(phase)
    cell.fill(ellipse(0, -0.78, 0.5, 0.13), SHADOW, 0.1)
    hem = [circle(x, -0.42 + 0.07 * math.sin(phase + 2.4 * i) + bob, 0.2) for i, x in enumerate((-0.38, 0, 0.38))]
    body = union(circle(0, 0.1 + bob, 0.58), ellipse(0, -0.18 + bob, 0.58, 0.42), *hem)
    cell.outlined(body, fade((44, 32, 84), (92, 70, 168)), (150, 124, 235))
    cell.fill(ellipse(-0.2, 0.42 + bob, 0.2, 0.1, 0.5), (150, 130, 220, 150))
    eyes(cell, 0, 0.08 + bob, 0.13)


def moth(cell, frame):
    lift = (0.5, 0.15, -0.3, 0.15)[frame]
    cell.fill(ellipse(0, -0.8, 0.35, 0.09), SHADOW, 0.1)
    for side in (-1, 1):
        wing = union(ellipse(side * 0.46, 0.16 + 0.45 * lift, 0.42, 0.27, side * (0.5 + lift)),
                     ellipse(side * 0.36, -0.22 + 0.2 * lift, 0.28, 0.2, side * (lift - 0.4)))
        cell.outlined(wing, fade((140, 36, 110), (236, 110, 176), -0.6, 0.6), (255, 168, 214), 0.05)
        cell.fill(circle(side * 0.5, 0.16 + 0.45 * lift, 0.09), (255, 214, 236))
        cell.fill(capsule(side * 0.05, 0.38, side * 0.24, 0.68, 0.03), (255, 168, 214))
    cell.outlined(ellipse(0, 0.04, 0.17, 0.42), fade((70, 22, 70), (128, 44, 110)), (255, 168, 214), 0.04)
    eyes(cell, 0, 0.24, 0.07, gap=0.09)


def brute(cell, frame):
    sway = 0.05 * math.sin(frame * math.pi / 2)
    cell.fill(ellipse(0, -0.82, 0.62, 0.13), SHADOW, 0.1)
    for side in (-1, 1):
        horn = union(capsule(side * 0.4, 0.42, side * 0.72, 0.58, 0.13, 0.09),
                     capsule(side * 0.72, 0.58, side * 0.7, 0.84, 0.09, 0.03))
        cell.outlined(horn, (236, 214, 190), (120, 70, 70), 0.05)
        cell.outlined(circle(side * 0.66, -0.32 + side * sway, 0.22), (128, 30, 54), (240, 96, 104), 0.05)
        cell.outlined(ellipse(side * 0.3, -0.7 - side * sway, 0.22, 0.15), (92, 20, 44), (240, 96, 104), 0.05)
    cell.outlined(union(circle(0, 0.08 + sway, 0.6), ellipse(0, -0.3 + sway, 0.6, 0.42)),
                  fade((98, 18, 46), (186, 54, 72)), (255, 120, 116), 0.06)
    eyes(cell, 0, 0.16 + sway, 0.12, (255, 220, 120), 0.25, 0.5)
    cell.fill(capsule(-0.25, -0.26 + sway, 0.25, -0.26 + sway, 0.07), (50, 8, 26))
    for x in (-0.18, 0.0, 0.18):
        cell.fill(polygon((x - 0.06, -0.21 + sway), (x + 0.06, -0.21 + sway), (x, -0.33 + sway)), (255, 240, 220))


def spitter(cell, frame):
    """A floating eye with tendrils."""
    phase = frame * math.pi / 2
    cell.fill(ellipse(0, -0.84, 0.4, 0.1), SHADOW, 0.1)
    for i, x in enumerate((-0.34, -0.12, 0.12, 0.34)):
        sway = 0.12 * math.sin(phase + 1.3 * i)
        cell.outlined(capsule(x, -0.2, x + sway, -0.62 + 0.1 * (i % 2), 0.09, 0.04), (22, 96, 92), (110, 236, 190), 0.04)
    cell.outlined(circle(0, 0.18, 0.52), fade((20, 92, 96), (64, 190, 150), -0.4, 0.7), (140, 255, 206), 0.06)
    cell.fill(circle(0, 0.18, 0.32), (245, 255, 240))
    cell.fill(circle(0.0, 0.16, 0.2), (240, 120, 60))
    cell.fill(circle(0, 0.16, 0.1), (30, 14, 40))
    cell.fill(circle(-0.08, 0.3, 0.06), (255, 255, 255))


def hero(cell, frame, walking):
    """A hooded keeper who carries a lantern."""
    phase = frame * math.pi / 2
    bob = (0.05 if walking else 0.025) * math.sin(phase * (2 if walking else 1))
    cell.fill(ellipse(0, -0.82, 0.5, 0.12), SHADOW, 0.1)
    for side in (-1, 1):
        swing = 0.12 * math.sin(phase) * side if walking else 0
        cell.fill(capsule(side * 0.17, -0.5, side * 0.17 + swing, -0.74, 0.1), (46, 30, 40))
    hem = 0.06 * math.sin(phase)
    cloak = polygon((-0.5 - hem, -0.6), (0.44 - hem, -0.6), (0.32, 0.2 + bob), (0, 0.5 + bob), (-0.34, 0.2 + bob))
    cell.outlined(lambda x, y: cloak(x, y) - 0.08, fade((140, 46, 40), (222, 96, 58)), (255, 196, 120), 0.05)
    cell.outlined(union(circle(0, 0.34 + bob, 0.36), capsule(0, 0.5 + bob, -0.24, 0.76 + bob, 0.2, 0.05)),
                  fade((168, 60, 46), (240, 122, 70), 0, 0.8), (255, 206, 134), 0.05)
    cell.fill(ellipse(0.08, 0.26 + bob, 0.25, 0.24), (36, 22, 44))
    for x in (0.0, 0.19):
        cell.fill(ellipse(x, 0.27 + bob, 0.05, 0.08), (255, 244, 200))
    cell.fill(capsule(0.3, -0.02 + bob, 0.6, 0.02 + bob, 0.07), (222, 96, 58))
    cell.glow(0.64, -0.22 + bob, 0.36, (255, 210, 110), 1.4)
    cell.fill(capsule(0.62, 0.02 + bob, 0.64, -0.1 + bob, 0.03), (92, 64, 40))
    cell.outlined(ellipse(0.64, -0.23 + bob, 0.12, 0.16), (255, 246, 190), (110, 74, 40), 0.045)


def flame(cell, frame):
    lean = 0.12 * math.sin(frame * math.pi / 2)
    cell.glow(0, 0, 0.95, (255, 150, 50), 1.8)
    cell.fill(union(circle(0, -0.1, 0.36), capsule(0, 0, lean, 0.6, 0.3, 0.03)), (255, 140, 50))
    cell.fill(union(circle(0, -0.14, 0.24), capsule(0, -0.1, lean * 0.8, 0.34, 0.2, 0.03)), (255, 214, 100))
    cell.fill(circle(0, -0.18, 0.12), (255, 255, 230))


def things(sheet, row):
    gem = sheet.cell(64, 0, row)
    gem.outlined(polygon((0, 0.7), (0.5, 0.1), (0, -0.7), (-0.5, 0.1)), (214, 214, 214), (255, 255, 255), 0.08)
    gem.fill(polygon((0, 0.7), (0.5, 0.1), (0, 0.0)), (255, 255, 255))
    gem.fill(polygon((0, -0.7), (0.5, 0.1), (0, 0.0)), (170, 170, 170))
    bolt = sheet.cell(64, 1, row)
    bolt.glow(0.1, 0, 0.85, (255, 190, 80), 1.6)
    bolt.fill(capsule(-0.75, 0, 0.45, 0, 0.03, 0.24), (255, 196, 84))
    bolt.fill(capsule(-0.2, 0, 0.45, 0, 0.03, 0.15), (255, 255, 224))
    orb = sheet.cell(64, 2, row)
    orb.glow(0, 0, 0.95, (255, 70, 120), 1.4)
    orb.outlined(circle(0, 0, 0.42), (255, 90, 130), (255, 214, 226), 0.1)
    orb.fill(circle(-0.1, 0.12, 0.16), (255, 255, 255))
    heart = sheet.cell(64, 3, row)
    shape = union(circle(-0.26, 0.2, 0.33), circle(0.26, 0.2, 0.33), polygon((-0.56, 0.06), (0.56, 0.06), (0, -0.66)))
    heart.outlined(shape, fade((214, 40, 80), (255, 110, 130)), (255, 220, 220), 0.1)
    heart.fill(ellipse(-0.26, 0.3, 0.12, 0.08, 0.6), (255, 255, 255, 200))
    star = sheet.cell(64, 4, row)
    points = [(math.sin(i * math.pi / 4) * (0.9 if i % 2 == 0 else 0.22), math.cos(i * math.pi / 4) * (0.9 if i % 2 == 0 else 0.22))
              for i in range(8)]
    star.glow(0, 0, 0.9, (255, 255, 255), 1.8)
    star.fill(polygon(*points), (255, 255, 255))
    sheet.cell(64, 5, row).glow(0, 0, 0.95, (255, 255, 255), 1.5)
    ring = sheet.cell(64, 6, row)
    ring.fill(lambda x, y: abs(math.hypot(x, y) - 0.78) - 0.12,
              lambda x, y: (255, 255, 255, 255 * max(0, 1 - abs(math.hypot(x, y) - 0.78) / 0.14)))
    chest = sheet.cell(64, 7, row)
    chest.glow(0, 0, 0.95, (255, 220, 130), 1.5)
    chest.outlined(polygon((-0.5, -0.5), (0.5, -0.5), (0.5, 0.3), (-0.5, 0.3)), fade((120, 66, 30), (206, 132, 60)), (255, 226, 150), 0.07)


def owl(cell):
    cell.fill(ellipse(0, -0.86, 0.6, 0.08), SHADOW, 0.1)
    for side in (-1, 1):
        cell.outlined(ellipse(side * 0.66, -0.1, 0.24, 0.56, side * 0.35), fade((46, 44, 90), (96, 92, 170)), (170, 170, 250), 0.04)
        cell.outlined(polygon((side * 0.2, 0.62), (side * 0.56, 0.44), (side * 0.58, 0.94)), (96, 92, 170), (170, 170, 250), 0.04)
    cell.outlined(ellipse(0, -0.06, 0.66, 0.76), fade((46, 40, 92), (110, 104, 190)), (170, 170, 250), 0.04)
    cell.fill(ellipse(0, -0.36, 0.42, 0.4), (150, 146, 214))
    for row in range(3):
        for i in range(-2 + row % 2, 3, 2):
            cell.fill(polygon((i * 0.13 - 0.09, -0.16 - 0.16 * row), (i * 0.13 + 0.09, -0.16 - 0.16 * row),
                              (i * 0.13, -0.28 - 0.16 * row)), (92, 86, 160))
    for side in (-1, 1):
        cell.outlined(circle(side * 0.3, 0.28, 0.26), (255, 246, 210), (64, 54, 120), 0.05)
        cell.glow(side * 0.3, 0.28, 0.3, (255, 190, 60), 0.8)
        cell.fill(circle(side * 0.28, 0.27, 0.11), (26, 14, 40))
        cell.fill(circle(side * 0.25, 0.33, 0.04), (255, 255, 255))
    cell.outlined(polygon((-0.11, 0.14), (0.11, 0.14), (0, -0.1)), (255, 168, 60), (120, 60, 30), 0.03)


def stag(cell):
    cell.fill(ellipse(0, -0.88, 0.5, 0.07), SHADOW, 0.1)
    horns = []
    for side in (-1, 1):
        for a, b, c, d, r, q in ((0.16, 0.3, 0.42, 0.62, 0.06, 0.045), (0.42, 0.62, 0.86, 0.74, 0.045, 0.015), (0.42, 0.62, 0.46, 0.96, 0.045, 0.015),
                                 (0.6, 0.67, 0.72, 0.95, 0.035, 0.012), (0.28, 0.44, 0.66, 0.46, 0.04, 0.012)):
            horns.append(capsule(side * a, b, side * c, d, r, q))
    cell.outlined(union(*horns), fade((190, 220, 200), (240, 255, 236), 0.3, 1), (60, 110, 96), 0.035)
    for side in (-1, 1):
        cell.outlined(ellipse(side * 0.46, 0.2, 0.2, 0.09, side * 0.3), (40, 96, 84), (120, 220, 190), 0.035)
    cell.outlined(union(ellipse(0, -0.5, 0.52, 0.36), capsule(0, 0.12, 0, -0.4, 0.36, 0.3)),
                  fade((14, 48, 54), (44, 110, 96)), (120, 220, 190), 0.04)
    cell.outlined(capsule(0, 0.16, 0, -0.3, 0.32, 0.2), fade((232, 240, 220), (250, 255, 244), -0.4, 0.4), (90, 140, 120), 0.03)
    eyes(cell, 0, 0.1, 0.09, (120, 255, 190), 0.18, 0.5)
    cell.fill(polygon((-0.08, -0.28), (0.08, -0.28), (0, -0.4)), (40, 40, 50))


def eclipse(cell):
    for i in range(16):
        a, far = i * math.pi / 8, 0.95 if i % 2 == 0 else 0.8
        cell.fill(capsule(0.55 * math.cos(a), 0.55 * math.sin(a), far * math.cos(a), far * math.sin(a), 0.1, 0.01),
                  fade((255, 70, 50), (255, 170, 70), -0.9, 0.9))
    cell.glow(0, 0, 0.98, (255, 110, 60), 1.0)
    cell.outlined(circle(0, 0, 0.6), fade((24, 8, 30), (70, 20, 50), -0.6, 0.6), (255, 190, 110), 0.05)
    eyes(cell, 0, 0.12, 0.13, (255, 120, 70), 0.25, 0.6)
    cell.fill(without(ellipse(0, -0.16, 0.36, 0.24), ellipse(0, -0.02, 0.44, 0.24)), (255, 150, 80))


def tree(cell):
    cell.fill(ellipse(0, -0.8, 0.5, 0.14), SHADOW, 0.1)
    cell.outlined(capsule(0, -0.3, 0, -0.74, 0.1, 0.15), (66, 46, 60), (30, 22, 40), 0.04)
    for x, y, r in ((-0.3, 0.02, 0.4), (0.3, 0.0, 0.4), (0, 0.34, 0.46)):
        cell.outlined(circle(x, y, r), fade((20, 62, 70), (52, 128, 108), -0.4, 0.9), (14, 36, 50), 0.04)
    for x, y, r in ((-0.34, 0.12, 0.16), (0.02, 0.52, 0.2), (0.34, 0.14, 0.14)):
        cell.fill(circle(x, y, r), (86, 168, 132, 120), 0.1)


def tomb(cell):
    cell.fill(ellipse(0, -0.72, 0.6, 0.16), SHADOW, 0.1)
    stone = union(circle(0, 0.18, 0.44), polygon((-0.44, 0.18), (0.44, 0.18), (0.5, -0.68), (-0.5, -0.68)))
    cell.outlined(stone, fade((66, 66, 92), (138, 140, 168)), (30, 30, 50), 0.05)
    cell.fill(union(capsule(0, 0.34, 0, -0.2, 0.05), capsule(-0.17, 0.16, 0.17, 0.16, 0.05)), (70, 72, 100))
    cell.fill(union(ellipse(-0.34, -0.66, 0.3, 0.13), ellipse(0.36, -0.68, 0.26, 0.11)), (44, 92, 84))


def crystal(cell):
    cell.fill(ellipse(0, -0.74, 0.6, 0.16), SHADOW, 0.1)
    cell.glow(0, -0.1, 0.98, (255, 90, 60), 2.2)
    for x, top, w, lean in ((-0.34, 0.3, 0.2, -0.2), (0.36, 0.2, 0.19, 0.24), (0, 0.78, 0.26, 0.04)):
        cell.outlined(polygon((x - w, -0.7), (x + w, -0.7), (x + w + lean, top - 0.25), (x + lean, top), (x - w + lean, top - 0.2)),
                      fade((90, 20, 50), (255, 120, 80)), (255, 190, 140), 0.03)
        cell.fill(polygon((x, -0.7), (x + w, -0.7), (x + w + lean, top - 0.25), (x + lean, top)), (60, 10, 40, 90))


def ground(name, seed, base, light, dark, kind):
    """A tile of 256 pixels that continues at its edges: patches, and small marks upon them."""
    chance = random.Random(seed)
    picture = Image(256, 256)
    waves = [(chance.randint(1, 3), chance.randint(1, 3), chance.random() * 6.3, chance.random()) for _ in range(6)]
    for y in range(256):
        for x in range(256):
            n = sum(w * math.sin(2 * math.pi * (a * x + b * y) / 256 + p) for a, b, p, w in waves) / 3
            picture.pixels[y * 256 + x] = [c + 5 * n for c in base] + [1.0]

    def stroke(x, y, dx, dy, radius, color):
        shape = capsule(x, y, x + dx, y + dy, radius, radius * 0.5)
        reach = int(abs(dx) + abs(dy) + radius + 2)
        for j in range(int(y) - reach, int(y) + reach):
            for i in range(int(x) - reach, int(x) + reach):
                cover = 0.5 - shape(i, j)
                if cover > 0:
                    picture.blend(i % 256, j % 256, color, min(1, cover))

    for n in range(90):
        x, y, color = chance.random() * 256, chance.random() * 256, light if n % 3 else dark
        if kind == "grass":
            for lean in (-3, 0, 3):
                stroke(x + lean, y, lean, -5 - chance.random() * 3, 1.2, color)
        elif kind == "stone":
            stroke(x, y, chance.uniform(-9, 9), chance.uniform(-2, 2), chance.uniform(2, 6), color)
        else:
            for _ in range(3):
                dx, dy = chance.uniform(-12, 12), chance.uniform(-12, 12)
                stroke(x, y, dx, dy, 1.1, color)
                x, y = x + dx, y + dy
    picture.save(name)


def zigzag(*points):
    return union(*(capsule(*a, *b, 0.09) for a, b in zip(points, points[1:])))


def icons():
    """What the gifts look like on cards."""
    gold, cream, sky = (255, 190, 80), (255, 244, 206), (138, 208, 255)
    drawn = {
        "sparks": [(capsule(-0.6, -0.6, 0.35, 0.35, 0.02, 0.22), gold), (capsule(0, 0, 0.35, 0.35, 0.02, 0.13), cream)],
        "nova": [(lambda x, y: abs(math.hypot(x, y) - 0.7) - 0.09, gold), (lambda x, y: abs(math.hypot(x, y) - 0.42) - 0.06, cream),
                 (circle(0, 0, 0.14), cream)],
        "storm": [(zigzag((0.2, 0.8), (-0.3, 0.05), (0.2, 0.05), (-0.2, -0.8)), sky),
                  (lambda x, y: zigzag((0.2, 0.8), (-0.3, 0.05), (0.2, 0.05), (-0.2, -0.8))(x, y) + 0.05, (240, 250, 255))],
        "comet": [(capsule(-0.3, -0.3, 0.75, 0.75, 0.3, 0.02), (80, 140, 240)), (circle(-0.3, -0.3, 0.32), sky), (circle(-0.32, -0.32, 0.18), (240, 250, 255))],
        "might": [(union(circle(0, -0.25, 0.48), capsule(0, 0, 0, 0.75, 0.36, 0.02)), (240, 150, 50)), (circle(-0.12, -0.3, 0.2), cream)],
        "haste": [(polygon((-0.5, 0.75), (0.5, 0.75), (0, 0)), (150, 120, 230)), (polygon((-0.5, -0.75), (0.5, -0.75), (0, 0)), gold),
                  (capsule(-0.55, 0.75, 0.55, 0.75, 0.08), cream), (capsule(-0.55, -0.75, 0.55, -0.75, 0.08), cream)],
        "swift": [(union(capsule(-0.2, 0.6, -0.2, -0.4, 0.24), capsule(-0.2, -0.45, 0.45, -0.5, 0.2)), (206, 120, 60)),
                  (capsule(-0.4, -0.72, 0.6, -0.72, 0.07), cream),
                  (union(capsule(-0.3, 0.3, -0.85, 0.6, 0.1, 0.03), capsule(-0.3, 0.1, -0.85, 0.25, 0.09, 0.03)), cream)],
        "heart": [(union(circle(-0.3, 0.22, 0.36), circle(0.3, 0.22, 0.36), polygon((-0.62, 0.06), (0.62, 0.06), (0, -0.75))), (240, 70, 104)),
                  (ellipse(-0.3, 0.34, 0.13, 0.09, 0.6), (255, 220, 226))],
        "magnet": [(without(union(circle(0, 0, 0.66), polygon((-0.66, 0), (0.66, 0), (0.66, -0.6), (-0.66, -0.6))),
                            union(circle(0, 0, 0.3), polygon((-0.3, 0), (0.3, 0), (0.3, -0.7), (-0.3, -0.7)))), (224, 60, 90)),
                   (union(polygon((-0.66, -0.4), (-0.3, -0.4), (-0.3, -0.7), (-0.66, -0.7)), polygon((0.66, -0.4), (0.3, -0.4), (0.3, -0.7), (0.66, -0.7))),
                    (220, 226, 240))],
    }
    for name, layers in drawn.items():
        picture = Image(96, 96)
        cell = picture.cell(96, 0, 0)
        cell.glow(0, 0, 0.98, layers[0][1], 2.0)
        for i, (shape, color) in enumerate(layers):
            if i == 0:
                cell.fill(lambda x, y: shape(x, y) - 0.07, (26, 18, 48))
            cell.fill(shape, color)
        picture.save(f"icon_{name}.png")
    picture = Image(96, 96)
    flame(picture.cell(96, 0, 0), 1)
    picture.save("icon_orbit.png")


def main():
    icons()
    ring = Image(128, 128)
    ring.cell(128, 0, 0).fill(lambda x, y: abs(math.hypot(x, y) - 0.77) - 0.2,
                              lambda x, y: (255, 255, 255, 255 * max(0, 1 - abs(math.hypot(x, y) - 0.77) / 0.2) ** 2))
    ring.save("ring.png")
    sheet = Image(512, 256)
    for frame in range(4):
        for row, column, draw in ((0, 0, shade), (0, 4, moth), (1, 0, brute), (1, 4, spitter)):
            draw(sheet.cell(64, column + frame, row), frame)
        hero(sheet.cell(64, frame, 2), frame, False)
        hero(sheet.cell(64, 4 + frame, 2), frame, True)
    things(sheet, 3)
    sheet.save("sheet.png")
    flames = Image(256, 64)
    for frame in range(4):
        flame(flames.cell(64, frame, 0), frame)
    flames.save("flame.png")
    bosses = Image(192 * 3, 192)
    for column, draw in enumerate((owl, stag, eclipse)):
        draw(bosses.cell(192, column, 0))
    bosses.save("bosses.png")
    props = Image(128 * 3, 128)
    for column, draw in enumerate((tree, tomb, crystal)):
        draw(props.cell(128, column, 0))
    props.save("props.png")
    glow = Image(128, 128)
    glow.cell(128, 0, 0).glow(0, 0, 0.98, (255, 255, 255), 2.0)
    glow.save("glow.png")
    dark = Image(128, 128)
    for y in range(128):
        for x in range(128):
            far = math.hypot(x - 63.5, y - 63.5) / 64
            dark.pixels[y * 128 + x] = [255, 255, 255, min(1, max(0, (far - 0.25) / 0.75)) ** 1.5]
    dark.save("dark.png")
    ground("meadow.png", 3, (26, 46, 62), (44, 78, 86), (18, 34, 52), "grass")
    ground("graves.png", 5, (38, 36, 58), (54, 52, 80), (28, 26, 46), "stone")
    ground("embers.png", 8, (46, 26, 40), (120, 46, 44), (30, 16, 32), "cracks")


if __name__ == "__main__":
    os.chdir(os.path.dirname(os.path.abspath(__file__)))
    os.makedirs("art", exist_ok=True)
    main()
