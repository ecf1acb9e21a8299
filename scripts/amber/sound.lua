-- Sounds and music. A voice is state, so going back in time would end it: those that the player hears while time goes back are
-- kept here, and are begun again after each restore at the place where they were.

local sound = {}
local heard = {}                -- { synth, since, volume, pitch } of what was begun lately
local music_time = 0.0

game.sounds = Object {
    cut = Synth { wave = "noise", sustain = 0.01, decay = 0.12, high_pass = 2500, slide = -3, volume = 0.5 },
    knock = Synth { wave = "sine", frequency = 190, slide = -4, sustain = 0.02, decay = 0.14, low_pass = 1400, volume = 0.7 },
    spark = Synth { wave = "triangle", frequency = 784, arpeggio = 7, arpeggio_time = 0.07, sustain = 0.08, decay = 0.5, volume = 0.4 },
    home = Synth { wave = "triangle", frequency = 392, slide = 0.9, vibrato = 0.4, sustain = 0.25, decay = 0.8, volume = 0.45 },
    lost = Synth { wave = "sine", frequency = 320, slide = -2.2, sustain = 0.12, decay = 0.5, volume = 0.5 },
    tick = Synth { wave = "sine", frequency = 620, sustain = 0.015, decay = 0.06, volume = 0.25 },
    press = Synth { wave = "triangle", frequency = 520, arpeggio = 5, arpeggio_time = 0.05, sustain = 0.05, decay = 0.16, volume = 0.35 },
    tide = Synth { wave = "saw", frequency = 98, vibrato = 0.7, vibrato_rate = 3, low_pass = 500, resonance = 0.4,
                   flanger = 9, attack = 0.1, sustain = 4, decay = 0, loop = true, volume = 0.22 },
    music = Music { file = "music.ogg", loop = true, bus = "music", volume = 0.8 },
}

function sound.play(name, volume, pitch)
    local note = { synth = sounds[name], since = time.real, volume = volume or 1, pitch = pitch or 1 }
    note.synth:play { volume = note.volume, pitch = note.pitch }
    if #heard > 6 then table.remove(heard, 1) end
    heard[#heard + 1] = note
end

function sound.start_music() sounds.music:play { fade = 1.5 } end

-- The hum of time that goes back.
local humming
function sound.hum(on)
    if on == (humming ~= nil) then return end
    if on then
        humming = time.real
        sounds.tide:play {}
    else
        humming = nil
        sounds.tide:stop(0.15)
    end
end

-- The volumes of the player, from the store, since a rewind would undo them.
function sound.apply_volumes()
    audio.buses.music.volume = (store.music or 7) / 10
    audio.buses.effects.volume = (store.effects or 8) / 10
end

function sound.update()
    local voice = sounds.music:children()[1]
    if voice then
        music_time = voice.time
        voice.pitch = voice.pitch + ((humming and 0.75 or 1) - voice.pitch) * 0.1
    end
end

function sound.restored()
    sound.apply_volumes()
    for _, voice in ipairs(audio.voices) do
        if voice.parent == sounds.music then voice.time = music_time else voice:delete() end
    end
    if humming then sounds.tide:play { time = (time.real - humming) % 4 } end
    for _, note in ipairs(heard) do
        local age = (time.real - note.since) * note.pitch
        if age < note.synth.duration then
            note.synth:play { volume = note.volume, pitch = note.pitch, time = age }
        end
    end
end

return sound
