-- Going back in time while the ball goes on. In each frame the whole tree is taken to an earlier step, and then the ball is put
-- back to where it was. For the step that follows, all other bodies are driven backwards along their way, so they push the ball
-- and carry it. What must not be undone is kept here and in `restored`, and not in the tree.
local rewind = { active = false, first = 0, restored = function() end }
local target, seen = 0, 0       -- the step to go to, the step that the game was in after the last restore
local kept                      -- of the ball, from before the restore
local driven = false            -- whether the bodies already move backwards since the last restore

-- From now on time goes back no further than here.
function rewind.begin() rewind.active, rewind.first, kept = false, time.step + 2, nil end

local function ball() return world:has("level") and world.level:has("ball") and world.level.ball end
local function dawn() return math.max(rewind.first, time.oldest) end                        -- the first step of the past
function rewind.past() return math.max(0, time.step - dawn()) * time.dt end                 -- how long it is, in seconds

-- Once a frame, with whether the player holds the button.
function rewind.update(held)
    if not rewind.active then
        if not held or rewind.past() == 0 then return end
        rewind.active, target, seen = true, time.step, time.step - 1
    end
    local made = time.step - seen
    if made > 0 then
        target = math.max(dawn(), target - made)
        local b = ball()
        kept = b and { vec(b.position), vec(b.velocity), b.angle, b.angular_velocity }
        time:go_to(target)
        seen = target
    end
    rewind.active = held
end

-- Before each step: everything but the ball moves backwards, or stands still at the dawn of time.
function rewind.step()
    if not rewind.active or driven then return end
    driven = true
    local way = target > dawn() and -1 or 0
    for _, body in ipairs(world.level:find("Body", function(body) return body.type ~= "static" and body.name ~= "ball" end)) do
        local velocity, turn = body.velocity * way, body.angular_velocity * way
        body.type = "kinematic"
        body.velocity, body.angular_velocity = velocity, turn
    end
    for _, belt in ipairs(world.level:find("Belt")) do belt.surface.surface_speed = belt.surface.surface_speed * way end
end

game:on("restored", function()
    driven = false
    local b = ball()
    if b and kept then b.position, b.velocity, b.angle, b.angular_velocity = table.unpack(kept) end
    rewind.restored()
end)

return rewind
