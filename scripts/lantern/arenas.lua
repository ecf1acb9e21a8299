-- The three arenas: what they look like, who comes when, and which boss ends them.

-- Rows of waves: kind, first and last second, enemies a second at the first and at the last.
return {
    {
        name = "Moth Meadow", goal = "Hold out until the Great Owl comes", boss = "The Great Owl", boss_hp = 170,
        ground = "art/meadow.png", prop = 1, ink = color("#071420"), glow = color("#ffcf8a"), edge = color("#3f7f7a"),
        length = 70, cap = 260, toughness = 1, tempo = 9, root = 0,
        waves = { { "shade", 0, 70, 1.6, 4.5 }, { "moth", 18, 70, 0.8, 3 }, { "brute", 42, 70, 0.15, 0.5 }, { "shade", 70, 999, 1.5, 1.5 } },
    },
    {
        name = "Stone Garden", goal = "The White Stag guards these graves", boss = "The White Stag", boss_hp = 520,
        ground = "art/graves.png", prop = 2, ink = color("#0c0a1e"), glow = color("#ffd9a0"), edge = color("#7a74b8"),
        length = 75, cap = 520, toughness = 1.7, tempo = 8, root = 3,
        waves = { { "shade", 0, 75, 4, 8 }, { "spitter", 8, 75, 0.3, 1.2 }, { "moth", 25, 75, 2, 7 }, { "brute", 30, 75, 0.4, 1.6 },
            { "shade", 75, 999, 3, 3 }, { "spitter", 75, 999, 0.3, 0.3 } },
    },
    {
        name = "Ember Field", goal = "A thousand come. Keep the light!", boss = "The Eclipse", boss_hp = 1500,
        ground = "art/embers.png", prop = 3, ink = color("#14060e"), glow = color("#ffb27a"), edge = color("#d05a48"),
        length = 80, cap = 1000, toughness = 2.6, tempo = 7, root = 5,
        waves = { { "shade", 0, 45, 7, 14 }, { "moth", 10, 80, 3, 10 }, { "spitter", 15, 80, 0.5, 1.5 }, { "brute", 20, 80, 0.8, 2.5 },
            { "shade", 45, 80, 30, 58 }, { "shade", 80, 999, 24, 24 }, { "moth", 80, 999, 8, 8 } },
    },
}
