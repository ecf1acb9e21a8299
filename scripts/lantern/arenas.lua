-- The arenas are a scene file: what they look like, who comes when, and which boss ends them. `toughness` multiplies the health of enemies,
-- `tempo` is the number of steps in a sixteenth of the music, `root` its key. A wave lets `first` enemies a second come at its beginning.
Arena = class("Arena", Object) { title = "", goal = "", boss = "", boss_hp = 100.0, ground = "", ink = color("black"), glow = color("white"),
    edge = color("white"), length = 70.0, cap = 100, toughness = 1.0, tempo = 8, root = 0 }
Wave = class("Wave", Object) { kind = "shade", from = 0.0, to = 60.0, first = 1.0, last = 1.0 }

return game:add(scene.load("arenas.json"), "arenas"):children()
