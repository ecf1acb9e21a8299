-- The music: one sixteenth of it every `tempo` steps. The sounds are in sounds.json.
local arenas = require "arenas"
game:add(scene.load("sounds.json"), "sounds")
-- Four chords of a minor key, in semitones; a note of the lead for each sixteenth, by its place in the chord.
local chords = { { 0, 3, 7, 10 }, { -4, 0, 3, 7 }, { -7, -4, 0, 3 }, { -2, 2, 5, 8 } }
local melody = { 1, 0, 3, 0, 4, 0, 3, 2, 0, 3, 0, 4, 2, 0, 3, 0 }

return function(count)
    local arena = arenas[night.arena]
    if count % arena.tempo ~= 0 then return end
    local beat = count // arena.tempo
    local place, chord = beat % 16, chords[beat // 16 % 4 + 1]
    local tone = chord[melody[place + 1]]
    local function note(synth, semitones) synth:play { pitch = 2 ^ ((semitones + arena.root) / 12) } end
    for i = 1, place == 0 and 3 or 0 do note(sounds.pad, chord[i]) end
    if tone and (night.running or place % 4 == 0) then note(sounds.lead, tone + (beat // 64 % 2) * 12) end
    if not night.running then return end
    if place % 4 == 0 or place == 14 then note(sounds.bass, chord[1]) end
    if place % 8 == 0 or night.boss and place % 4 == 0 then sounds.kick:play() end
    if place % 4 == 2 or night.clock > 30 and place % 2 == 1 then sounds.hat:play() end
end
