#!/usr/bin/env python3
"""Draws the pictures in art/. Run it in this folder after a change: ./draw_art.py"""

import math
import os
import struct
import zlib


class Image:
    """Pixels of a picture, transparent at first; y goes down."""

    def __init__(self, width, height):
        self.width, self.height = width, height
        self.pixels = [(0, 0, 0, 0)] * (width * height)

    def put(self, x, y, color):
        if 0 <= x < self.width and 0 <= y < self.height:
            self.pixels[int(y) * self.width + int(x)] = color if len(color) == 4 else (*color, 255)

    def rectangle(self, left, top, width, height, color):
        for y in range(int(top), int(top + height)):
            for x in range(int(left), int(left + width)):
                self.put(x, y, color)

    def ellipse(self, center_x, center_y, radius_x, radius_y, color):
        for y in range(self.height):
            for x in range(self.width):
                dx, dy = (x + 0.5 - center_x) / radius_x, (y + 0.5 - center_y) / radius_y
                if dx * dx + dy * dy <= 1:
                    self.put(x, y, color)

    def save(self, name):
        rows = b"".join(
            b"\0" + bytes(c for p in self.pixels[y * self.width:(y + 1) * self.width] for c in p)
            for y in range(self.height))

        def chunk(kind, data):
            return (struct.pack(">I", len(data)) + kind + data
                    + struct.pack(">I", zlib.crc32(kind + data)))

        header = struct.pack(">IIBBBBB", self.width, self.height, 8, 6, 0, 0, 0)
        with open(os.path.join("art", name), "wb") as out:
            out.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header)
                      + chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b""))


def hero():
    """Standing, and four frames of walking; 16 x 24 pixels each."""
    skin, shirt, trousers, hair, boot = (
        (244, 200, 160), (212, 74, 66), (56, 76, 128), (96, 58, 34), (52, 40, 36))
    sheet = Image(16 * 5, 24)
    for frame in range(5):
        left = 16 * frame
        phase = 0 if frame == 0 else math.sin(math.pi / 2 * frame)
        bob = 1 if frame in (1, 3) else 0
        for side in (-1, 1):
            swing = round(3 * side * phase)
            sheet.rectangle(left + 6 + (side > 0) * 2 + swing, 17 + bob, 3, 5 - bob, trousers)
            sheet.rectangle(left + 6 + (side > 0) * 2 + swing, 21, 4, 2, boot)
        sheet.rectangle(left + 5, 10 + bob, 7, 8, shirt)
        sheet.rectangle(left + 7 - round(2 * phase), 11 + bob, 3, 6, (180, 56, 52))
        sheet.rectangle(left + 7 - round(2 * phase), 16 + bob, 3, 2, skin)
        sheet.rectangle(left + 5, 3 + bob, 7, 7, skin)
        sheet.rectangle(left + 4, 2 + bob, 8, 3, hair)
        sheet.rectangle(left + 4, 3 + bob, 2, 5, hair)
        sheet.rectangle(left + 10, 6 + bob, 1, 2, (40, 30, 30))
    sheet.save("hero.png")


def coin():
    """Six frames of a turning coin, 16 x 16 pixels each."""
    sheet = Image(16 * 6, 16)
    for frame in range(6):
        width = max(1.2, 6.5 * abs(math.cos(math.pi * frame / 6)))
        middle = 16 * frame + 8
        for y in range(16):
            for x in range(16 * frame, 16 * frame + 16):
                dx, dy = (x + 0.5 - middle) / width, (y + 0.5 - 8) / 6.5
                d = dx * dx + dy * dy
                if d <= 1:
                    sheet.put(x, y, (150, 96, 20) if d > 0.72
                              else (255, 238, 150) if dx + dy < -0.5 else (246, 194, 62))
    sheet.save("coin.png")


def tree():
    picture = Image(48, 64)
    picture.rectangle(21, 38, 6, 26, (104, 70, 44))
    picture.rectangle(21, 38, 2, 26, (126, 88, 56))
    for x, y, radius, color in ((24, 26, 20, (40, 104, 62)), (15, 30, 13, (48, 120, 70)),
                                (33, 30, 12, (44, 110, 64)), (22, 18, 13, (66, 144, 82)),
                                (18, 15, 7, (92, 168, 98))):
        picture.ellipse(x, y, radius, radius * 0.9, color)
    picture.save("tree.png")


def hills(name, height, color, light, waves):
    """A row of hills that repeats without a seam."""
    width = 512
    picture = Image(width, height)
    for x in range(width):
        top = height * 0.5 + sum(size * math.sin(2 * math.pi * n * x / width + shift)
                                 for n, size, shift in waves)
        for y in range(max(0, int(top)), height):
            picture.put(x, y, light if y < top + 3 else color)
    picture.save(name)


def sun():
    picture = Image(96, 96)
    for y in range(96):
        for x in range(96):
            d = math.hypot(x - 47.5, y - 47.5)
            glow = max(0.0, 1 - d / 47)
            if d < 22:
                picture.put(x, y, (255, 244, 200))
            else:
                picture.put(x, y, (255, 226, 150, int(200 * glow ** 2)))
    picture.save("sun.png")


if __name__ == "__main__":
    os.chdir(os.path.dirname(os.path.abspath(__file__)))
    os.makedirs("art", exist_ok=True)
    hero()
    coin()
    tree()
    sun()
    hills("far.png", 160, (110, 136, 170), (132, 158, 190), ((1, 22, 0), (3, 14, 1), (7, 6, 2)))
    hills("near.png", 160, (74, 128, 92), (98, 154, 108), ((2, 20, 2), (5, 10, 0), (9, 4, 1)))
