#!/usr/bin/env python3
"""Writes levels/*.tmj for the Tiled editor. Run it in this folder after a change: ./make_levels.py

A level is laid from left to right by a cursor at (x, g): g is the height of the ground. A level that was changed in Tiled is
written over, so then do not run this again."""

import json
import random

SIZE, ROWS = 16, 20
# Tiles 0 to 15 are ground: bits say which sides are open, 1 above, 2 left, 4 right, 8 below.
NAMED = ["up", "down", "ledge", "spikes", "block", "plant", "tuft", "arrow",
         "water", "water_2", "deep", "under_up", "under_down", "depth", "stone", "bush"]
TILE = {name: 17 + n for n, name in enumerate(NAMED)}  # numbers in the map, from 1


class Level:
    def __init__(self, theme, ground=4):
        self.theme, self.x, self.g = theme, 0, ground
        self.solid, self.tile, self.decor, self.water = set(), {}, {}, {}
        self.objects, self.dice = [], random.Random(theme)
        self.quiet = False

    def column(self, top):
        for y in range(top):
            self.solid.add((self.x, y))

    def flat(self, count):
        for _ in range(count):
            self.column(self.g)
            if (self.x, self.g) not in self.decor and self.dice.random() < 0.4:
                self.decor[self.x, self.g] = self.dice.choice(("plant", "tuft", "tuft", "bush", "stone"))
            self.x += 1
        return self

    def up(self, count=1):
        for _ in range(count):
            self.column(self.g)
            self.tile[self.x, self.g] = "up"
            self.g += 1
            self.x += 1
        return self

    def down(self, count=1):
        for _ in range(count):
            self.g -= 1
            self.column(self.g)
            self.tile[self.x, self.g] = "down"
            self.x += 1
        return self

    def step(self, by):
        self.g += by
        return self

    def gap(self, count, water=False):
        if water:
            for x in range(self.x, self.x + count):
                self.solid.add((x, 0))
                for y in range(1, self.g - 1):
                    self.water[x, y] = "water" if y == self.g - 2 else "deep"
        self.x += count
        return self

    def fill(self, dx, dy, width, height):
        """Solid ground over the ground: the lowest cell is dy above it."""
        for x in range(width):
            for y in range(height):
                self.solid.add((self.x + dx + x, self.g + dy + y))
        return self

    def blocks(self, dx, dy, width, height=1):
        for x in range(width):
            for y in range(height):
                self.tile[self.x + dx + x, self.g + dy + y] = "block"
        return self

    def ledge(self, dx, dy, count):
        """One can jump through it from below; its top is dy above the ground."""
        for x in range(count):
            self.tile[self.x + dx + x, self.g + dy - 1] = "ledge"
        return self

    def spikes(self, dx, count, dy=0):
        for x in range(count):
            self.decor[self.x + dx + x, self.g + dy] = "spikes"
        return self

    def arrow(self, dx):
        self.decor[self.x + dx, self.g] = "arrow"
        return self

    def roof(self, count, height):
        """Rock from here to the upper edge, height above the ground."""
        for x in range(self.x, self.x + count):
            for y in range(self.g + height + (x // 3 * 7 % 5 > 2), ROWS):
                self.solid.add((x, y))
        return self

    def put(self, kind, dx, dy, width=1, height=1, name="", /, **properties):
        """An object whose lower left corner is in this cell."""
        self.objects.append((kind, self.x + dx, self.g + dy, width, height, name, properties))
        return self

    def coins(self, dx, dy, count, arc=0.0):
        for n in range(count):
            rise = arc * (1 - (2 * n / max(1, count - 1) - 1) ** 2)
            self.put("Coin", dx + n, dy + rise)
        return self

    def numbers(self):
        width = self.x
        ground, decor, water = ([0] * (width * ROWS) for _ in range(3))
        full = self.solid | {place for place, name in self.tile.items() if name in ("up", "down")}

        def is_open(x, y):
            return 0 <= x < width and y >= 0 and (x, y) not in full

        for x in range(width):
            for y in range(ROWS):
                at = (ROWS - 1 - y) * width + x
                if (x, y) in self.tile:
                    ground[at] = TILE[self.tile[x, y]]
                elif (x, y) in self.solid:
                    over = self.tile.get((x, y + 1))
                    mask = (is_open(x, y + 1) * 1 + is_open(x - 1, y) * 2 + is_open(x + 1, y) * 4 + is_open(x, y - 1) * 8)
                    ground[at] = TILE["under_" + over] if over in ("up", "down") and mask == 0 else 1 + mask
                    if all((x, y + n) in self.solid for n in range(3)) and mask == 0 or y < 2 and mask == 0:
                        ground[at] = TILE["depth"]
                elif (x, y) in self.decor:
                    decor[at] = TILE[self.decor[x, y]]
                if (x, y) in self.water:
                    water[at] = TILE[self.water[x, y]]
        return ground, decor, water

    def write(self, number):
        ground, decor, water = self.numbers()
        width, objects = self.x, []
        for n, (kind, x, y, w, h, name, properties) in enumerate(self.objects):
            made = {"id": n + 1, "name": name, "type": kind, "x": x * SIZE, "y": (ROWS - y - h) * SIZE,
                    "width": w * SIZE, "height": h * SIZE, "rotation": 0, "visible": True}
            if properties:
                made["properties"] = [{"name": k, "type": "float", "value": v} for k, v in properties.items()]
            objects.append(made)

        def layer(id, name, data, **more):
            return {"type": "tilelayer", "id": id, "name": name, "width": width, "height": ROWS,
                    "x": 0, "y": 0, "opacity": 1, "visible": True, "data": data, **more}

        def z(value):
            return [{"name": "z", "type": "float", "value": value}]

        level = {
            "type": "map", "version": "1.10", "orientation": "orthogonal", "renderorder": "right-down",
            "width": width, "height": ROWS, "tilewidth": SIZE, "tileheight": SIZE, "infinite": False,
            "nextlayerid": 5, "nextobjectid": len(objects) + 1,
            "tilesets": [tileset(self.theme)],
            "layers": [
                layer(1, "decor", decor, properties=z(-1)),
                layer(2, "ground", ground, properties=[{"name": "friction", "type": "float", "value": 0.8}]),
                {"type": "objectgroup", "id": 3, "name": "things", "objects": objects, "opacity": 1, "visible": True,
                 "x": 0, "y": 0},
                layer(4, "water", water, opacity=0.8, properties=z(10)),
            ]}
        with open(f"levels/{number}.tmj", "w", encoding="utf-8") as out:
            json.dump(level, out, separators=(",", ":"))
            out.write("\n")


def tileset(theme):
    def shape(*corners, kind="polygon"):
        return {"objectgroup": {"type": "objectgroup", "objects": [
            {"id": 1, "x": 0, "y": 0, kind: [{"x": x, "y": y} for x, y in corners]}]}}

    solid = [{"name": "solid", "type": "bool", "value": True}]
    tiles = [{"id": n, "properties": solid} for n in range(16)]
    for name in ("block", "under_up", "under_down", "depth"):
        tiles.append({"id": TILE[name] - 1, "properties": solid})
    tiles.append({"id": TILE["up"] - 1, **shape((0, 16), (16, 16), (16, 0))})
    tiles.append({"id": TILE["down"] - 1, **shape((0, 0), (0, 16), (16, 16))})
    tiles.append({"id": TILE["ledge"] - 1, **shape((0, 0), (16, 0), kind="polyline")})
    for name in ("spikes", "water", "deep"):
        hurts = [{"name": "hurts", "type": "bool", "value": True}]
        more = {"animation": [{"tileid": TILE[n] - 1, "duration": 400} for n in ("water", "water_2")]} if name == "water" else {}
        tiles.append({"id": TILE[name] - 1, "properties": hurts, **more})
    tiles.sort(key=lambda tile: tile["id"])
    return {"firstgid": 1, "name": "tiles", "tilewidth": SIZE, "tileheight": SIZE, "tilecount": 32, "columns": 8, "margin": 0,
            "spacing": 0, "image": f"../art/tiles_{theme}.png", "imagewidth": 128, "imageheight": 64, "tiles": tiles}


def meadow():
    """Running, jumping, the first beetle, a spring, a ledge."""
    m = Level(1)
    m.put("Start", 3, 0).arrow(5).coins(8, 1, 3).flat(12)
    m.up(2).coins(0, 1, 4).flat(6).down(2).flat(3)
    m.step(1).flat(3).step(1).coins(0, 1, 3).flat(5).step(-2)
    m.coins(0, 1.4, 3, 1).gap(3, True).flat(3).put("Beetle", 4, 0).coins(2, 3, 4).flat(10)
    m.ledge(1, 2, 4).coins(1, 3, 4).ledge(6, 4, 4).coins(6, 5, 4).put("Heart", 9, 5).flat(12)
    m.put("Checkpoint", 1, 0).flat(4).coins(0, 1.5, 4, 1.5).gap(4, True).flat(4)
    m.put("Spring", 3, 0).coins(3, 3, 1).coins(3, 5, 1).flat(6).step(4).coins(1, 1, 4).flat(8)
    m.put("Beetle", 1, 0).flat(6).down(4).put("Beetle", 4, 0).coins(1, 1, 3).flat(9)
    m.put("Lift", 1, -1, 2, 0.5, dx=5, period=5).coins(3, 1.5, 3).gap(9, True)
    m.flat(5).put("Crate", 2, 0).arrow(5).flat(8).step(3).coins(1, 1, 3).flat(6).down(3)
    m.put("Goal", 6, 0).arrow(2).flat(14)
    return m


def wood():
    """Keys, doors, bats, springs, lifts that rise."""
    m = Level(2)
    m.put("Start", 3, 0).arrow(6).flat(9).up(1).flat(2).up(1).put("Bat", 5, 2.5).coins(3, 1, 4).flat(9)
    m.coins(0, 1.2, 3, 1).gap(3).flat(2).step(1).put("Beetle", 2, 0).flat(7).coins(0, 1.3, 4, 1).gap(4)
    m.flat(4).ledge(0, 2, 3).ledge(4, 4, 3).ledge(0, 6, 3).put("Key", 1, 6).coins(4, 5, 3).flat(9)
    m.put("Door", 2, 0, 1, 3).fill(2, 3, 1, 13).flat(5)
    m.put("Checkpoint", 0, 0).put("Beetle", 6, 0).put("Beetle", 9, 0).coins(4, 3, 5).flat(13)
    m.put("Lift", 0.5, -0.5, 2, 0.5, dy=4.5, period=5).gap(3).step(4).coins(1, 1, 4).put("Bat", 6, 3).flat(9)
    m.spikes(1, 2).coins(1, 2.4, 2).flat(4).spikes(2, 3).coins(2, 2.4, 3).flat(8).down(5).put("Beetle", 5, 0).flat(9)
    m.put("Crate", 2, 0).flat(8).step(3).put("Heart", 2, 0).flat(4).put("Checkpoint", 0, 0).flat(4)
    m.put("Lift", 1, -1, 2, 0.5, dx=4, period=4.5).coins(2, 1, 4).gap(8).ledge(1, 0, 2).gap(4)
    m.put("Hopper", 4, 0).coins(1, 1, 4).flat(9).down(3).put("Spring", 4, 0).coins(4, 4, 1).flat(6).step(5).coins(1, 1, 3).flat(5).down(3)
    m.put("Bat", 2, 2.2).put("Goal", 8, 0).flat(15)
    return m


def caves():
    """Rock over the head, spikes, hoppers; a key behind a shaft with lifts."""
    m = Level(3, 5)
    m.put("Start", 3, 0).arrow(6).roof(14, 7).coins(7, 1, 4).flat(14)
    m.roof(12, 6).down(3).roof(14, 6).put("Hopper", 6, 0).coins(4, 3, 5).flat(11)
    m.roof(4, 6).coins(0, 1.3, 4, 1).gap(4, True).roof(10, 6).spikes(3, 2).flat(4).spikes(3, 2).flat(6)
    m.roof(10, 10).put("Bat", 4, 5).flat(3).step(2).coins(0, 1, 3).flat(3).step(2).coins(0, 1, 3).flat(4).step(1).roof(10, 5).coins(2, 1, 5).flat(8)
    m.put("Checkpoint", 0, 0).flat(4).roof(12, 6).down(4).put("Beetle", 4, 0).put("Bat", 8, 2.6).flat(12)
    m.put("Lift", 1, -1, 2, 0.5, dx=3, period=4).coins(2, 1.5, 3).gap(7, True).flat(3).step(2).flat(4)
    m.roof(20, 10).put("Crate", 3, 0).blocks(9, 0, 3, 3).ledge(6, 5, 2).put("Key", 6, 5).coins(9, 3, 3).flat(20)
    m.put("Door", 1, 0, 1, 3).fill(1, 3, 1, 11).flat(3).put("Checkpoint", 0, 0).roof(16, 6).put("Hopper", 6, 0).put("Hopper", 12, 0).coins(5, 3, 4).flat(16)
    m.roof(12, 6).gap(3, True).flat(4).gap(3, True).flat(3).coins(0, 1.2, 4, 1).gap(4, True)
    m.put("Heart", 2, 1).flat(5).roof(10, 7).up(2).spikes(3, 3).coins(3, 2.5, 3).flat(9).put("Bat", 3, 2.5).roof(16, 7).flat(7).put("Goal", 4, 0).flat(9)
    return m


def ridge():
    """Ice: less grip, wind of bats, long gaps with lifts, higher walls."""
    m = Level(4, 3)
    m.put("Start", 3, 0).arrow(6).flat(9).up(3).put("Bat", 3, 2.5).coins(1, 1, 4).flat(7).up(2).flat(3).down(3).put("Beetle", 3, 0).flat(8)
    m.coins(0, 1.5, 4, 1).gap(4).flat(2).gap(3).flat(2).coins(0, 1.5, 4, 1).gap(4).put("Checkpoint", 1, 0).put("Hopper", 6, 0).flat(10)
    m.put("Lift", 0.5, -0.5, 2, 0.5, dy=5, period=5).gap(3).step(5).put("Checkpoint", 1, 0).coins(3, 1, 3).flat(7)
    m.put("Lift", 0.5, -1, 2, 0.5, dx=4, period=4).put("Bat", 5, 2.5).put("Lift", 8.5, -1, 2, 0.5, dx=3, period=3.5).coins(3, 1.5, 8).gap(14)
    m.flat(4).spikes(1, 2).flat(4).spikes(0, 2).flat(4).down(4).put("Beetle", 3, 0).put("Beetle", 6, 0).flat(9)
    m.put("Spring", 2, 0).ledge(4, 5, 3).put("Key", 5, 5).coins(2, 4, 1).ledge(8, 4, 3).coins(8, 5, 3).put("Hopper", 9, 0).flat(14)
    m.put("Door", 1, 0, 1, 3).fill(1, 3, 1, 13).flat(4).put("Checkpoint", 0, 0).put("Heart", 3, 0).flat(5)
    m.up(4).put("Bat", 2, 2.2).flat(4).put("Spring", 3, 0).coins(3, 4, 1).flat(5).step(5).flat(4).coins(0, 1.5, 5, 1).gap(5).flat(3)
    m.down(5).put("Checkpoint", 1, 0).put("Hopper", 5, 0).flat(8).coins(0, 1.5, 4, 1).gap(4).flat(4).put("Lift", 0.5, -1, 2, 0.5, dx=4, period=4).gap(8).flat(3).up(2)
    m.put("Goal", 7, 0).flat(14)
    return m


def keep():
    """Everything at once, and little ground below the feet."""
    m = Level(5, 4)
    m.put("Start", 3, 0).arrow(6).flat(8).step(2).put("Hopper", 4, 0).flat(7).coins(0, 1.5, 3, 1).gap(3).put("Bat", 2, 2.6).flat(4)
    m.coins(0, 1.5, 4, 1).gap(4).put("Checkpoint", 0, 0).flat(4).put("Lift", 0.5, -0.5, 2, 0.5, dy=4, period=4).gap(3).step(4).spikes(5, 2).coins(5, 2.5, 2).flat(9)
    m.put("Checkpoint", 0, 0).flat(3).blocks(1, 0, 2).blocks(4, 1, 2).blocks(7, 2, 2).put("Bat", 6, 5.8).coins(4, 2, 2).coins(7, 3, 2).gap(10).step(2).put("Beetle", 5, 0).flat(7)
    m.down(3).put("Hopper", 3, 0).put("Hopper", 8, 0).coins(3, 3, 6).flat(12).put("Crate", 2, 0).flat(8).step(3).put("Key", 3, 0).flat(5)
    m.put("Lift", 0.5, -1, 2, 0.5, dx=4, period=3.6).put("Lift", 8.5, 0, 2, 0.5, dy=3, period=3.4).coins(3, 1.5, 4).gap(12).step(2)
    m.put("Door", 3, 0, 1, 3).fill(3, 3, 1, 9).flat(6).put("Checkpoint", 0, 0).put("Heart", 2, 0).flat(5)
    m.down(4).put("Beetle", 2, 0).put("Beetle", 5, 0).put("Bat", 7, 2.6).flat(10).spikes(0, 1).flat(4).spikes(0, 2).flat(5).spikes(0, 3).coins(0, 2.6, 3).flat(5)
    m.put("Spring", 2, 0).flat(3).coins(0, 3, 5, 2.5).gap(7).put("Spring", 5, 0).put("Checkpoint", 2, 0).flat(8).step(5).coins(1, 1, 3).flat(6)
    m.coins(0, 1.5, 5, 1).gap(5).flat(3).coins(0, 1.5, 4, 1).gap(4).flat(4).put("Bat", 3, 2.4).down(3).put("Goal", 6, 0).flat(13)
    return m


def throne():
    """The arena of the boar."""
    m = Level(6, 7)
    m.put("Start", 3, 0).arrow(5).put("Heart", 6, 0).flat(9).step(-3)
    m.put("Boar", 18, 0, 3, 2, "boar").put("Heart", 12, 5).ledge(3, 3, 3).ledge(11, 4, 3).ledge(19, 3, 3).flat(25)
    m.fill(0, 0, 6, 16).flat(6)
    return m


for index, make in enumerate((meadow, wood, caves, ridge, keep, throne)):
    make().write(index + 1)
