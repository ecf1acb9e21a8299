-- The three arenas: what they look like, who comes when, and which boss ends them. `toughness` multiplies the health of enemies, `tempo` is
-- the number of steps in a sixteenth of the music, `root` its key. Rows of waves: kind, first and last second, enemies a second then.
return {
    { name = "Moth Meadow", goal = "Hold out until the owl comes", boss = "The Great Owl", boss_hp = 170, ground = "art/meadow.png",
      ink = color("#071420"), glow = color("#ffcf8a38"), edge = color("#3f7f7a"), length = 70, cap = 260, toughness = 1, tempo = 9, root = 0,
      waves = { { "shade", 0, 70, 1.9, 5 }, { "moth", 18, 70, 0.8, 3 }, { "brute", 42, 70, 0.15, 0.5 }, { "shade", 70, 250, 1.5, 30 } } },
    { name = "Stone Garden", goal = "A stag guards these graves", boss = "The White Stag", boss_hp = 480, ground = "art/graves.png",
      ink = color("#0c0a1e"), glow = color("#ffd9a034"), edge = color("#7a74b8"), length = 75, cap = 520, toughness = 2, tempo = 8, root = 3,
      waves = { { "shade", 0, 75, 4, 9 }, { "spitter", 8, 75, 0.3, 1.2 }, { "moth", 25, 75, 2, 8 }, { "brute", 30, 75, 0.4, 1.8 },
                { "shade", 75, 250, 4, 50 }, { "spitter", 75, 250, 0.4, 3 } } },
    { name = "Ember Field", goal = "A thousand come. Keep the light!", boss = "The Eclipse", boss_hp = 1200, ground = "art/embers.png",
      ink = color("#14060e"), glow = color("#ffb27a34"), edge = color("#d05a48"), length = 80, cap = 1000, toughness = 2.4, tempo = 7, root = 5,
      waves = { { "shade", 0, 45, 8, 20 }, { "moth", 10, 80, 4, 14 }, { "spitter", 15, 80, 0.5, 2 }, { "brute", 20, 80, 1, 3 },
                { "shade", 45, 80, 45, 100 }, { "shade", 80, 250, 35, 150 }, { "moth", 80, 250, 8, 30 } } },
}
