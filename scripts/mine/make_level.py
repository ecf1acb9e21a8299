#!/usr/bin/env python3
"""Draws art/tiles.png and writes level.tmj and tiles.tsj. Run it in this folder after a change: ./make_level.py

The level can also be changed in the Tiled editor; then do not run this again, it would write over it."""

import json
import math
import random
import struct
import zlib

SIZE = 16
TILES = ["grass", "dirt", "stone", "plank", "up", "down", "water", "water_2",
         "torch", "torch_2", "flower", "crystal", "wall", "tuft", "wall_2", "dirt_2"]
# The surface from left to right: level, up or down by one cell.
SURFACE = r"------\--------------//--//--/----\-\\\\----------/-/--/--------"

# Cells by row: o is hollow, = a plank, * a crystal.
CAVES = {
    5: ".............................................====",
    7: ".....................====..............====",
    8: "..........................................................===",
    11: "..........===",
    14: "......................................................o*o",
    15: "......................oooooo......*..................oooooo",
    16: "...................ooo*ooooooo......................oooooooo",
    17: "................ooooooooooo==oooo..............oooooooooooooo",
    18: "...............ooooooo===oooooooo==ooooo....ooooooooooooooooo",
    19: "................oooooooooooooo=ooooooooo==ooooo*oooooo==oooo",
    20: "..................*ooooooooo....oooooooooooooooooooo",
}

TORCHES = ((17, 17), (28, 15), (37, 18), (45, 18), (55, 16))


class Image:
    def __init__(self, width, height):
        self.width, self.height = width, height
        self.pixels = [(0, 0, 0, 0)] * (width * height)

    def put(self, x, y, color):
        if 0 <= x < self.width and 0 <= y < self.height:
            self.pixels[int(y) * self.width + int(x)] = color if len(color) == 4 else (*color, 255)

    def save(self, name):
        rows = b"".join(
            b"\0" + bytes(c for p in self.pixels[y * self.width:(y + 1) * self.width] for c in p)
            for y in range(self.height))

        def chunk(kind, data):
            return (struct.pack(">I", len(data)) + kind + data
                    + struct.pack(">I", zlib.crc32(kind + data)))

        header = struct.pack(">IIBBBBB", self.width, self.height, 8, 6, 0, 0, 0)
        with open(name, "wb") as out:
            out.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header)
                      + chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b""))


def shade(color, by):
    return tuple(max(0, min(255, round(c * by))) for c in color)


def soil(dice, color):
    """A surface with some darker and lighter stones in it."""
    pixels = [[shade(color, 1 + dice.uniform(-0.05, 0.05)) for _ in range(SIZE)] for _ in range(SIZE)]
    for _ in range(5):
        x, y, by = dice.randrange(1, 13), dice.randrange(1, 14), dice.choice((0.82, 0.88, 1.14))
        for dx in range(dice.randrange(2, 4)):
            for dy in range(2):
                pixels[y + dy][x + dx] = shade(color, by)
    return pixels


def bricks(dice, color):
    pixels = []
    for y in range(SIZE):
        row = []
        for x in range(SIZE):
            joint = y % 8 == 7 or (x + (y // 8) * 8) % 16 == 15
            row.append(shade(color, 0.72 if joint else 1 + dice.uniform(-0.04, 0.04)))
        pixels.append(row)
    return pixels


def draw(name, dice):
    """Rows of colors; None is transparent."""
    earth, stone, leaf = (140, 92, 62), (98, 96, 116), (104, 176, 84)
    empty = [[None] * SIZE for _ in range(SIZE)]
    if name in ("dirt", "dirt_2"):
        return soil(dice, earth)
    if name == "stone":
        return soil(dice, stone)
    if name in ("wall", "wall_2"):
        return bricks(dice, (58, 54, 74))
    if name in ("grass", "up", "down"):
        pixels = soil(dice, earth)
        for x in range(SIZE):
            surface = {"grass": 0, "up": SIZE - 1 - x, "down": x}[name]
            depth = 4 + (x * 7 % 3)
            for y in range(SIZE):
                if y < surface:
                    pixels[y][x] = None
                elif y < surface + depth:
                    pixels[y][x] = shade(leaf, 1.2 if y == surface else 1 - 0.05 * (y - surface))
        return pixels
    if name == "plank":
        for x in range(SIZE):
            for y in range(5):
                empty[y][x] = shade((186, 132, 78), 1.12 if y == 0 else 0.7 if y == 4 or x == 15 else 1)
        return empty
    if name.startswith("water"):
        phase = math.pi if name.endswith("2") else 0
        for x in range(SIZE):
            top = 3 + round(1.2 * math.sin(2 * math.pi * x / SIZE + phase))
            for y in range(top, SIZE):
                empty[y][x] = (170, 220, 240, 230) if y < top + 1 else (60, 130, 200, 190)
        return empty
    if name.startswith("torch"):
        for y in range(8, 15):
            for x in (7, 8):
                empty[y][x] = (110, 74, 44)
        lean = 1 if name.endswith("2") else 0
        for y in range(1, 9):
            for x in range(4, 12):
                d = math.hypot((x - 7.5 - lean * (8 - y) / 8) / 2.6, (y - 5.5) / 4)
                if d < 1:
                    empty[y][x] = (255, 240, 170) if d < 0.45 else (250, 160, 60)
        return empty
    if name == "crystal":
        pixels = soil(dice, stone)
        for x0, top, color in ((4, 5, (120, 230, 220)), (8, 2, (150, 245, 235)), (11, 6, (90, 200, 210))):
            for y in range(top, 14):
                half = min(2, y - top, 13 - y)
                for x in range(x0 - half, x0 + half + 1):
                    pixels[y][x] = shade(color, 1.1 if x < x0 else 0.85)
        return pixels
    for x in range(1, 15):  # plants
        height = (3 + (x * 5) % 4) if name == "tuft" or x % 3 == 0 else 0
        for y in range(SIZE - height, SIZE):
            empty[y][x] = shade(leaf, 0.8 + 0.1 * (x % 4))
    if name == "flower":
        for x, color in ((4, (240, 110, 130)), (10, (250, 210, 90))):
            for y in range(8, SIZE):
                empty[y][x] = shade(leaf, 0.9)
            for dx, dy in ((0, 0), (1, 0), (-1, 0), (0, 1), (0, -1)):
                empty[8 + dy][x + dx] = color if dx or dy else (255, 255, 230)
    return empty


def write_tiles():
    dice = random.Random(4)
    image = Image(SIZE * 8, SIZE * 2)
    for n, name in enumerate(TILES):
        for y, row in enumerate(draw(name, dice)):
            for x, color in enumerate(row):
                if color is not None:
                    image.put(SIZE * (n % 8) + x, SIZE * (n // 8) + y, color)
    image.save("art/tiles.png")
    coin()


def coin():
    image = Image(SIZE * 6, SIZE)
    for frame in range(6):
        wide = abs(math.cos(math.pi * frame / 6)) * 5.5 + 0.8
        for y in range(SIZE):
            for x in range(SIZE):
                d = math.hypot((x - 7.5) / wide, (y - 7.5) / 6)
                if d <= 1:
                    color = (255, 214, 84) if d < 0.7 else (206, 146, 40)
                    image.put(SIZE * frame + x, y, (255, 246, 190) if d < 0.3 and x < 8 else color)
    image.save("art/coin.png")


def box(*corners):
    return {"objectgroup": {"type": "objectgroup", "objects": [
        {"id": 1, "x": 0, "y": 0, "polygon": [{"x": x, "y": y} for x, y in corners]}]}}


def write_tileset():
    number = {name: n for n, name in enumerate(TILES)}
    solid = [{"name": "solid", "type": "bool", "value": True}]
    tiles = []
    for name in ("grass", "dirt", "dirt_2", "stone"):
        hard = {"name": "hard", "type": "bool", "value": name == "stone"}
        tiles.append({"id": number[name], "properties": [hard] + solid})
    tiles.append({"id": number["crystal"], "properties":
                  [{"name": "gold", "type": "int", "value": 5}] + solid})
    tiles.append({"id": number["up"], **box((0, 16), (16, 16), (16, 0))})
    tiles.append({"id": number["down"], **box((0, 0), (0, 16), (16, 16))})
    # Solid from above only.
    tiles.append({"id": number["plank"], "objectgroup": {"type": "objectgroup", "objects": [
        {"id": 1, "x": 0, "y": 0, "polyline": [{"x": 0, "y": 0}, {"x": 16, "y": 0}]}]}})
    for name, time in (("water", 350), ("torch", 160)):
        light = {"name": "light", "type": "bool", "value": True}
        tiles.append({"id": number[name], "properties": [light] if name == "torch" else [], "animation": [
            {"tileid": number[name], "duration": time}, {"tileid": number[name + "_2"], "duration": time}]})
    tileset = {"type": "tileset", "name": "tiles", "tilewidth": SIZE, "tileheight": SIZE, "tilecount": 16,
               "columns": 8, "image": "art/tiles.png", "imagewidth": 128, "imageheight": 32, "tiles":
               sorted(tiles, key=lambda tile: tile["id"])}
    with open("tiles.tsj", "w", encoding="utf-8") as out:
        json.dump(tileset, out, indent=1)


def make_ground(width, height, dice):
    """Names of tiles by cell, and the row of the surface in each column."""
    cell, tops, top = {}, [], 13
    for x, way in enumerate(SURFACE):
        if way == "/":
            top -= 1
        cell[x, top] = {"-": "grass", "/": "up", "\\": "down"}[way]
        tops.append(top)
        rock = 15.5 + 1.5 * math.sin(0.5 * x) + dice.uniform(-0.4, 0.4)
        for y in range(top + 1, height):
            cell[x, y] = "stone" if y > rock else dice.choice(("dirt", "dirt", "dirt", "dirt_2"))
        if way == "\\":
            top += 1
    for y, line in CAVES.items():
        for x, sign in enumerate(line):
            if sign == "o":
                cell.pop((x, y), None)
            elif sign in "=*":
                cell[x, y] = "plank" if sign == "=" else "crystal"
    return cell, tops


def write_level():
    width, height = len(SURFACE), 22
    dice = random.Random(7)
    cell, tops = make_ground(width, height, dice)
    decoration = {place: "torch" for place in TORCHES}
    for x, top in enumerate(tops):
        if SURFACE[x] == "-" and (x * x) % 7 < 3 and 3 < x:
            decoration[x, top - 1] = "flower" if x % 4 == 1 else "tuft"

    def numbers(of):
        return [TILES.index(of[x, y]) + 1 if (x, y) in of else 0 for y in range(height) for x in range(width)]

    ground = numbers(cell)
    behind = numbers({(x, y): dice.choice(("wall", "wall", "wall_2"))
                      for x in range(width) for y in range(tops[x] + 1, height)})
    water = numbers({(x, 20): "water" for x in range(32, 52) if (x, 20) not in cell})

    def layer(number, name, data, **more):
        return {"type": "tilelayer", "id": number, "name": name, "width": width, "height": height,
                "x": 0, "y": 0, "opacity": 1, "visible": True, "data": data, **more}

    objects, number = [], 0

    def put(kind, x, y, name="", **properties):
        nonlocal number
        number += 1
        objects.append({"id": number, "name": name, "type": kind, "x": x * SIZE, "y": y * SIZE,
                        "width": 0, "height": 0, "point": True, "rotation": 0, "visible": True,
                        "properties": [{"name": k, "value": v, "type": "int"} for k, v in properties.items()]})

    put("", 3, 12, "start")
    for n, (x, y) in enumerate(((11.5, 10.5), (17.5, 8.5), (22.5, 6.5), (35.5, 8.5), (40.5, 6.5), (46.5, 4.5),
                                (59.5, 7.5), (57.5, 9.5), (24.5, 17.3), (30, 18.3), (38.5, 17.3), (56, 18.3))):
        put("Coin", x, y, worth=1 + n // 8)
    for x, y, side in ((9, 12.4, 1), (27.5, 8, 1), (45, 12.4, 1.4), (46, 11, 1)):
        number += 1
        objects.append({"id": number, "name": "crate", "type": "Crate", "x": x * SIZE, "y": y * SIZE,
                        "width": side * SIZE, "height": side * SIZE, "rotation": 0, "visible": True})
    number += 1
    objects.append({"id": number, "name": "hint", "type": "Text", "x": 1.5 * SIZE, "y": 9.5 * SIZE,
                    "width": 6 * SIZE, "height": SIZE, "rotation": 0, "visible": True,
                    "text": {"text": "arrows walk, space jumps,\nthe mouse digs"},
                    "properties": [{"name": "outline", "type": "color", "value": "#ff2a3540"}]})
    level = {
        "type": "map", "version": "1.10", "orientation": "orthogonal", "renderorder": "right-down",
        "width": width, "height": height, "tilewidth": SIZE, "tileheight": SIZE, "infinite": False,
        "tilesets": [{"firstgid": 1, "source": "tiles.tsj"}],
        "layers": [
            layer(1, "behind", behind, tintcolor="#ffd0c8e0"),
            layer(2, "decoration", numbers(decoration)),
            layer(3, "ground", ground, properties=[{"name": "friction", "type": "float", "value": 0.8}]),
            {"type": "objectgroup", "id": 4, "name": "things", "objects": objects, "opacity": 1,
             "visible": True},
            layer(5, "water", water, opacity=0.8,
                  properties=[{"name": "z", "type": "float", "value": 10}]),
        ]}
    with open("level.tmj", "w", encoding="utf-8") as out:
        json.dump(level, out, separators=(",", ":"))
        out.write("\n")


write_tiles()
write_tileset()
write_level()
