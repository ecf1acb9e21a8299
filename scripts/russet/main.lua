-- Russet, a fox cub, runs home through six places.
local fx = require("fx")
for _, name in ipairs { "hero", "things", "boar" } do require(name) end
local menus = require("menus")
scene.load("sounds.json", game, "sounds")
for name, value in pairs { lives = 5, hearts = 3, coins = 0, points = 0 } do state(name, value) end
input.actions.jump = { "space", "z", "gamepad.a", "mouse.left" }
input.actions.pause = { "escape", "p", "gamepad.start" }
class("Level", World) { number = 1, clock = 0.0, coins = 0, all_coins = 0, hits = 0, chain = 0, respawn = vec(0, 0), over = false,
    gravity = vec(0, -36), had = { 0, 0, 5 } }     -- had: coins, points and lives at its beginning
function Level:enter(args)
    self.number, self.had = args.number, { coins, points, lives }
    time.paused, time.scale = false, 1
    view.height, view.follow_damping, view.dead_zone = 13, 0.12, vec(1.5, 2)
    self:add(Tilemap { map = "levels/" .. self.number .. ".tmj", pixels_per_unit = 16 }, "map")
    self.all_coins = #self.map.things:children("Coin")
    self.respawn = vec(self.map.things:children("Start")[1].position)
    view.limits, view.center = { vec(0, 0), self.map.size }, self.respawn
    fx.backdrop(self, self.number)
    self:add(Hero { position = self.respawn }, "hero")
    view.follow = self.hero
    menus.hud(self)
    fx.tune(self.number == 6 and sounds.fight or sounds.music, fx.places[self.number].pitch)
end
-- Whether the cell at a point is solid; what is beside the map counts as solid.
function Level:solid(point)
    local cell = self.map:cell_at(point)
    if cell.x < 0 or cell.x >= self.map.columns then return true end
    local tile = self.map:tile(cell.x, cell.y, "ground")
    return tile > 0 and (tile <= 18 or tile == 21 or tile >= 28 and tile <= 30)
end
function Level:score(count, at)
    points = points + count
    if at then fx.pop(at + vec(0, 0.6), tostring(count)) end
end
function Level:stomp(enemy)
    self.chain = self.chain + 1
    self:score(enemy.worth * self.chain, enemy.position)
    sounds.stomp:play { pitch = 0.9 + 0.1 * self.chain }
    view:shake(0.1, 0.2)
    fx.puff(enemy.position, { color("#fff1d6"), color("#b46ea000") }, 14, { speed = 5 })
end
-- The cub is hurt by something at a point; without one it fell.
function Level:hit(from)
    local hero = self.hero
    if self.over or from and hero.hurt > 0 then return end
    hearts, self.hits = hearts - 1, self.hits + 1
    sounds.hurt:play()
    view:shake(0.25, 0.4)
    fx.puff(hero.position, { color("#ffffff"), color("#ee843400") }, 16, { speed = 6 })
    if hearts <= 0 then self:lose() return end
    hero.hurt = 1.4
    if not from then self:place_back() return end
    hero.velocity, hero.rising, hero.coyote, hero.grounded = vec(hero.position.x < from.x and -6 or 6, 8), false, 0.0, false
end
function Level:place_back()
    local hero = self.hero
    hero.position, hero.velocity, hero.hurt = self.respawn + vec(0, 0.3), vec(0, 0), 1.0
    for _, crate in ipairs(self.map.things:children("Crate")) do crate:back() end
end
function Level:lose()
    local hero = self.hero
    self.over, hero.type, hero.look.animation, hero.look.visible = true, "static", "11-11", true
    hero.look:tween("angle", 6, 0.8)
    hero.look:tween("position", vec(0, 3), 0.8, "out_quad")
    hero.look:tween("tint", color("#ffffff00"), 0.8)
    lives = lives - 1
    sounds.lost:play()
    self:after(1.1, function(level)
        if lives <= 0 then menus.game_over() return end
        hearts, level.over = 3, false
        hero.type, hero.look.angle, hero.look.tint, hero.look.position = "dynamic", 0, color("white"), vec(0, -0.6)
        level:place_back()
        if level.map.things:has("boar") then level.map.things.boar:state("rest") end
    end)
end
function Level:win()
    if self.over then return end
    self.over = true
    local bonus = { time = math.max(0, 120 - math.floor(self.clock)) * 5, hearts = hearts * 100,
        coins = self.coins == self.all_coins and 500 or 0, hits = self.hits == 0 and 300 or 0 }
    for _, count in pairs(bonus) do points = points + count end
    sounds.win:play()
    self.hero.type, self.hero.look.animation = "static", "1-2"
    self.hero:tween("position", self.hero.position + vec(0, 0.8), 0.25, "out_quad")
    fx.puff(self.hero.position, { color("#ffcf4a"), color("#ee8434"), color("#ffffff00") }, 60, { speed = 9, lifetime = 1 })
    store.reached = math.max(store.reached or 1, math.min(6, self.number + 1))
    self:after(1.2, function(level) menus.won(level, bonus) end)
end
function Level:step(dt)
    local hero = self.hero
    self.air.position = view.center
    if self.over or not hero then return end
    self.clock = self.clock + dt
    for _, thing in ipairs(self.map.things:children("Thing")) do
        if thing:overlaps(hero) then thing:touch(hero) end
        if self.over then return end
    end
    if hero.grounded then self.chain = 0 end
    local at = hero.position
    if at.y < -1.5 then self:hit() return end
    for _, dx in ipairs { -0.2, 0.2 } do
        local cell = self.map:cell_at(at + vec(dx, -0.35))
        for _, layer in ipairs { "decor", "water" } do
            local tile = self.map:tile(cell.x, cell.y, layer)
            if tile > 0 and self.map:tile_property(tile, "hurts") and not self.over then
                if layer == "water" then fx.puff(at, { color("#bfe8ff"), color("#3d9ad600") }, 20, { speed = 6 }) end
                return self:hit(layer == "decor" and at + vec(hero.facing, 0) or nil)
            end
        end
    end
    if at.x < 0.4 then hero.position = vec(0.4, at.y) end
end
function action_pressed(action)
    if action == "pause" and game.scene:is_a(Level) and not game.scene.over then menus.pause() end
end
function start()
    view.fit, view.background = "expand", color("#2b1d2e")
    audio.buses.music.volume, audio.buses.effects.volume, audio.buses.music.pauses = 0.6, 0.8, false
    go_to_scene("Title")
end
