-- Stay alive: move with WASD or the arrow keys, aim with the mouse, hold the left button to shoot.
-- With a gamepad: the left stick moves, the right stick aims and shoots.

local speed, bullet_speed = 7, 22   -- m/s
local shot_pause = 0.14             -- s between two shots
local field = vec(15, 9)            -- half of the size of the field, m

-- What changes in the game is in the tree, so that saves and going back in time hold it.
game.fight = Object { score = 0, lives = 3, over = false, next_shot = 0, next_enemy = 1, hurt_until = 0 }

-- `input.move` has WASD, the arrow keys and the left stick of a gamepad from the beginning.
input.actions.aim = { "gamepad.right" }
input.actions.again = { "space", "gamepad.a" }

game.sounds = Object {
    shot = Synth.blip { volume = 0.25 }, gone = Synth.explosion { volume = 0.4 }, hurt = Synth.hit(), over = Synth.explosion(),
}

Enemy = class("Enemy", Body) { speed = 2.5 }

function Enemy:step()
    local to_hero = world.hero.position - self.position
    self.velocity = self.velocity:lerp(to_hero:normalized() * self.speed, 0.08)
end

Shot = class("Shot", Body) { ends = 0.0 }

function Shot:step()
    if time.now > self.ends then self:delete() end
end

function Shot:contact_begin(contact)
    if contact.other:is_a("Enemy") then
        world:add(Emitter {
            position = contact.other.position, rate = 0, burst = 14, speed = 5, damping = 3, lifetime = 0.4,
            size = { 0.3, 0 }, color = { color("#f72585") },
            finished = function(event) event.instance:delete() end,
        })
        sounds.gone:play { pitch = 0.8 + 0.4 * random() }
        contact.other:delete()
        fight.score = fight.score + 1
    end
    self:delete()
end

local function hurt_hero(contact)
    if not contact.other:is_a("Enemy") or time.now < fight.hurt_until or fight.over then return end
    fight.lives = fight.lives - 1
    fight.hurt_until = time.now + 1
    sounds.hurt:play()
    view:shake(0.3, 0.3)
    if fight.lives == 0 then
        fight.over = true
        sounds.over:play()
        if fight.score > (store.best or 0) then store.best = fight.score end
    end
end

local function begin()
    fight.score, fight.lives, fight.over = 0, 3, false
    fight.next_shot, fight.next_enemy, fight.hurt_until = 0, time.now + 1, 0
    world.enemies, world.shots = Object {}, Object {}
    world.hero = Body {
        locked_rotation = true, can_sleep = false,
        Circle { radius = 0.5, color = color("#4cc9f0"), border = color("#1b6f8a") },
    }
    world.hero:on("contact_begin", hurt_hero)
end

local function add_enemy()
    local angle = random() * 2 * math.pi
    world.enemies:add(Enemy {
        position = vec(math.cos(angle) * (field.x - 1), math.sin(angle) * (field.y - 1)),
        speed = 2 + math.min(3, fight.score * 0.05),
        Circle { radius = 0.45, color = color("#f72585"), border = color("#7a0f45") },
    })
end

local function aim()
    if input.aim.held then return input.aim.direction:normalized() end
    local direction = input.mouse.world - world.hero.position
    return direction:length() > 0 and direction:normalized() or vec(1, 0)
end

local function shoot()
    local direction = aim()
    sounds.shot:play { pitch = 0.95 + 0.1 * random() }
    world.shots:add(Shot {
        position = world.hero.position + direction * 0.8, velocity = direction * bullet_speed, bullet = true,
        ends = time.now + 1,
        Circle { radius = 0.14, density = 0.2, group = -1, color = color("#ffd166") },
    })
end

-- What is written here, outside of functions, follows the file while the game runs.
view.background = color("#12141c")
view.height = 20
world.gravity = vec(0, 0)
world.bounds = { -field, field }

function start()
    begin()
end

function step()
    if fight.over then
        world.hero.velocity = vec(0, 0)
        world.enemies:each("Enemy", function(enemy) enemy.velocity = vec(0, 0) end)
        return
    end
    world.hero.velocity = world.hero.velocity:lerp(input.move * speed, 0.25)
    if (input.mouse.left or input.aim.held) and time.now >= fight.next_shot then
        fight.next_shot = time.now + shot_pause
        shoot()
    end
    if time.now >= fight.next_enemy then
        fight.next_enemy = time.now + math.max(0.25, 1.2 - fight.score * 0.02)
        add_enemy()
    end
end

function action_pressed(action)
    if action == "again" and fight.over then begin() end
end

function draw(pen)
    pen.box(vec(0, 0), 2 * field.x, 2 * field.y, false, "#3a4256", 3)
    local place = world.hero:drawn_position()
    pen.line(place + aim() * 0.3, place + aim() * 0.85, "#caf0f8", 6)
    if time.now < fight.hurt_until then pen.circle(place, 0.7, false, "#ff6b6b", 3) end
    pen.screen(function()
        pen.text(vec(20, 26), "Score " .. fight.score .. "   Lives " .. fight.lives, 22, "white", "left")
    end)
    if fight.score == 0 and not fight.over then
        pen.text(vec(0, 7), "WASD: move    Mouse: aim and shoot", 0.7, "#a0a8b8")
    elseif fight.over then
        pen.text(vec(0, 1), "Game over", 1.6, "white")
        pen.text(vec(0, -0.5), "Best: " .. (store.best or 0) .. "   Space: again", 0.7, "#a0a8b8")
    end
end
