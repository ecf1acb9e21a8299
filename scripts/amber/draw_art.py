#!/usr/bin/env python3
"""Draws the pictures in art/. Run it in this folder after a change: ./draw_art.py

Each picture is a function from a point to a color and an opacity, 0 to 1; x and y go from -1 to 1, y up."""

import math
import struct
import zlib


def write(name, width, height, shade, samples=3):
    rows = bytearray()
    for row in range(height):
        rows.append(0)
        for column in range(width):
            red = green = blue = opacity = 0.0
            for i in range(samples * samples):
                x = (column + (i % samples + 0.5) / samples) / width * 2 - 1
                y = 1 - (row + (i // samples + 0.5) / samples) / height * 2
                r, g, b, a = shade(x, y)
                red, green, blue, opacity = red + r * a, green + g * a, blue + b * a, opacity + a
            whole = max(opacity, 1e-9)
            pixel = (red / whole, green / whole, blue / whole, opacity / samples ** 2)
            rows += bytes(min(255, max(0, round(255 * c))) for c in pixel)

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    with open(f"art/{name}.png", "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 6, 0, 0, 0)) +
                   chunk(b"IDAT", zlib.compress(bytes(rows), 9)) + chunk(b"IEND", b""))


def color(text):
    return tuple(int(text[i:i + 2], 16) / 255 for i in (0, 2, 4))


def mix(a, b, share):
    share = min(1, max(0, share))
    return tuple(p + (q - p) * share for p, q in zip(a, b))


GOLD, PALE, DEEP, DARK, INK = color("ffb52e"), color("ffe9a8"), color("b8560a"), color("4d2206"), color("1d1230")


def sky(x, y):
    dusk = mix(color("5a3459"), color("2b1f4d"), (y + 1) / 1.1)
    return (*mix(dusk, color("130f2b"), (y - 0.05) / 0.95), 1)


def glow(x, y):
    return (1, 1, 1, max(0, 1 - math.hypot(x, y)) ** 2.2)


def near(x, y, ax, ay, bx, by):
    """Distance from a line between two points."""
    dx, dy = bx - ax, by - ay
    t = min(1, max(0, ((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy)))
    return math.hypot(x - ax - t * dx, y - ay - t * dy)


def beetle(x, y):
    body = math.hypot((x + 0.06) / 0.3, y / 0.21) < 1 or math.hypot((x - 0.3) / 0.13, y / 0.13) < 1
    legs = any(near(x, abs(y), a, 0.1, b, 0.36) < 0.028 for a, b in ((-0.2, -0.36), (-0.02, -0.04), (0.14, 0.28)))
    feelers = near(x, abs(y), 0.36, 0.06, 0.54, 0.2) < 0.022
    seam = body and abs(y) < 0.015 and x < 0.16
    return (body or legs or feelers) and not seam


def amber(x, y):
    r = math.hypot(x, y)
    if r > 0.98: return (0, 0, 0, 0)
    if r > 0.9: return (*mix(GOLD, PALE, (r - 0.9) * 9), 1)
    base = mix(color("ffc65a"), DEEP, (r / 0.95) ** 2.4 * 0.9)
    swirl = 0.5 + 0.5 * math.sin(7 * r + 2.5 * math.atan2(y, x) + 3 * x)
    base = mix(base, PALE, 0.16 * swirl * (1 - r))
    if beetle(x, y): base = mix(base, DARK, 0.88)
    for bx, by, size in ((-0.45, 0.4, 0.06), (0.42, -0.5, 0.045), (-0.3, -0.52, 0.035), (0.58, 0.34, 0.03)):
        if math.hypot(x - bx, y - by) < size: base = mix(base, PALE, 0.6)
    return (*base, 1)


def shine(x, y):
    upper = max(0, 1 - math.hypot((x + 0.36) / 0.34, (y - 0.46) / 0.24)) ** 1.2
    r = math.hypot(x, y)
    lower = max(0, 1 - abs(r - 0.74) / 0.16) * max(0, (x - y) / (r + 1e-9) / 1.41 - 0.72) * 2.2
    return (1, 1, 0.94, min(1, upper * 1.1 + lower) if r < 0.95 else 0)


def wheel(x, y):
    r, turn = math.hypot(x, y), math.atan2(y, x)
    tooth = math.cos(16 * turn)
    edge = 0.87 + 0.085 * min(1, max(-1, tooth * 2.4))
    spoke = r < 0.7 and abs(math.sin(turn * 2.5)) * r < 0.07 + 0.05 * (r - 0.4) ** 2
    solid = 0.68 < r < edge or r > 0.07 and (r < 0.2 or spoke)
    return (1, 1, 1, 1 if solid else 0)


def spark(x, y):
    x *= 0.68
    if abs(x) / 0.6 + abs(y) / 0.94 > 1: return (0, 0, 0, 0)
    if abs(x) / 0.6 + abs(y) / 0.94 > 0.86: return (*GOLD, 1)
    light = (1.0 if x < 0 else 0.72) if y > 0 else (0.8 if x < 0 else 0.5)
    return (*mix(GOLD, (1, 1, 0.96), light), 1)


def home(x, y):
    r, turn = math.hypot(x, y), math.atan2(y, x)
    if r < 0.52: return (*mix(color("2a1420"), INK, r * 2), 1)
    if r < 0.63: return (*mix(DEEP, PALE, 0.5 + 0.5 * math.sin(turn + 2.2)), 1)
    if 0.74 < r < 0.94 and abs(((turn * 3 / math.pi + 6.5) % 1) - 0.5) < 0.16: return (*GOLD, 1)
    return (0, 0, 0, 0)


write("sky", 4, 200, sky, 2)
write("glow", 96, 96, glow, 1)
write("amber", 128, 128, amber)
write("shine", 64, 64, shine)
write("wheel", 512, 512, wheel)
write("spark", 48, 72, spark)
write("home", 160, 160, home)
