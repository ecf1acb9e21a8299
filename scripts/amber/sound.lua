-- Sounds and music. A voice is state, so going back in time would end it: those that the player hears while time goes back are
-- kept here, and are begun again after each restore at the place where they were.

local sound = {}
local heard = {}                -- what was begun lately
local music_time = 0.0
local humming                   -- since when time goes back

scene.load("sounds.json", game, "sounds")

function sound.play(name, volume, pitch)
    local note = { synth = sounds[name], since = time.real, volume = volume or 1, pitch = pitch or 1 }
    note.synth:play { volume = note.volume, pitch = note.pitch }
    if #heard > 6 then table.remove(heard, 1) end
    heard[#heard + 1] = note
end

-- The volumes of the player come from the store, since a rewind would undo them.
function sound.apply_volumes()
    audio.buses.music.volume, audio.buses.effects.volume = (store.music or 7) / 10, (store.effects or 8) / 10
end

-- Once a frame, with whether time goes back: then it hums, and the music is slower.
function sound.update(back)
    if back and not humming then sounds.tide:play {} end
    if humming and not back then sounds.tide:stop(0.15) end
    humming = back and (humming or time.real) or nil
    local voice = sounds.music:children()[1]
    if not voice then return end
    music_time, voice.pitch = voice.time, voice.pitch + ((back and 0.75 or 1) - voice.pitch) * 0.1
end

function sound.restored()
    sound.apply_volumes()
    for _, voice in ipairs(audio.voices) do
        if voice.parent == sounds.music then voice.time = music_time else voice:delete() end
    end
    if humming then sounds.tide:play { time = (time.real - humming) % 4 } end
    for _, note in ipairs(heard) do
        local age = (time.real - note.since) * note.pitch
        if age < note.synth.duration then note.synth:play { volume = note.volume, pitch = note.pitch, time = age } end
    end
end

return sound
