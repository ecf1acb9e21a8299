-- Sounds and music. A voice is state, so going back in time would end it: those that the player hears while time goes back are
-- kept here, and are begun again after each restore at the place where they were.
local sound = {}
local heard = {}                -- what was begun lately
local lasting = {}              -- time, volume and pitch of the two voices that never end

scene.load("sounds.json", game, "sounds")

function sound.play(name, volume, pitch)
    local note = { synth = sounds[name], since = time.real, volume = volume or 1, pitch = pitch or 1 }
    note.synth:play { volume = note.volume, pitch = note.pitch }
    if #heard > 6 then table.remove(heard, 1) end
    heard[#heard + 1] = note
end

function sound.start()
    audio.buses.music.volume, audio.buses.effects.volume, audio.buses.music.pauses = 0.7, 0.8, false
    sounds.music:play { fade = 1.5 }
    sounds.tide:play { volume = 0 }
end

-- Once a frame, with whether time goes back: then it hums, and the music is slower.
function sound.update(back)
    for name, wanted in pairs { music = { 1, back and 0.75 or 1 }, tide = { back and 1 or 0, 1 } } do
        local voice = sounds[name]:children()[1]
        if not voice then return end         -- the console has stopped it
        voice.volume = voice.volume + (wanted[1] - voice.volume) * 0.15
        voice.pitch = voice.pitch + (wanted[2] - voice.pitch) * 0.1
        lasting[name] = { voice.time, voice.volume, voice.pitch }
    end
end

function sound.restored()
    for _, voice in ipairs(audio.voices) do
        local kept = lasting[voice.parent.name]
        if kept then voice.time, voice.volume, voice.pitch = table.unpack(kept) else voice:delete() end
    end
    for _, note in ipairs(heard) do
        local age = (time.real - note.since) * note.pitch
        if age < note.synth.duration then note.synth:play { volume = note.volume, pitch = note.pitch, time = age } end
    end
end

return sound
