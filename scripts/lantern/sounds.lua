-- All sounds, and the music, from synths.
local arenas = require "arenas"
local function music(values) values.bus = "music" return Synth(values) end

game.sounds = Object {
    shot = Synth { wave = "triangle", frequency = 880, slide = -3, sustain = 0.02, decay = 0.08, volume = 0.16, max_voices = 4 },
    hit = Synth { wave = "noise", frequency = 3000, sustain = 0.01, decay = 0.05, volume = 0.12, high_pass = 900, max_voices = 4 },
    pop = Synth { wave = "sine", frequency = 320, slide = -4, sustain = 0.03, decay = 0.1, volume = 0.25, max_voices = 5 },
    gem = Synth { duty = 0.25, frequency = 1050, arpeggio = 7, arpeggio_time = 0.04, sustain = 0.04, volume = 0.1, low_pass = 5000, max_voices = 4 },
    hurt = Synth { wave = "saw", frequency = 220, slide = -3, sustain = 0.08, decay = 0.2, volume = 0.4, low_pass = 1800 },
    heal = Synth { wave = "sine", frequency = 523, arpeggio = 12, arpeggio_time = 0.12, sustain = 0.15, decay = 0.3, volume = 0.35 },
    level = Synth.power_up { volume = 0.35 },
    dash = Synth { wave = "noise", frequency = 5000, slide = -6, attack = 0.03, sustain = 0.05, decay = 0.15, volume = 0.2, low_pass = 3000 },
    nova = Synth { wave = "sine", frequency = 110, slide = 3, sustain = 0.1, decay = 0.4, volume = 0.35 },
    zap = Synth { wave = "saw", frequency = 1600, slide = -8, vibrato = 6, vibrato_rate = 60, sustain = 0.04, decay = 0.16, volume = 0.16, max_voices = 3 },
    boom = Synth.explosion { volume = 0.4, max_voices = 3 },
    roar = Synth { wave = "saw", frequency = 90, slide = -0.6, vibrato = 3, vibrato_rate = 22, attack = 0.1, sustain = 0.5, decay = 0.6, low_pass = 900 },
    blip = Synth.blip { volume = 0.2 },
    bass = music { wave = "triangle", frequency = 55, sustain = 0.12, decay = 0.16 },
    lead = music { duty = 0.3, frequency = 220, sustain = 0.05, decay = 0.3, volume = 0.11, low_pass = 2200 },
    pad = music { wave = "triangle", frequency = 220, attack = 0.4, sustain = 0.9, decay = 1.2, volume = 0.12, vibrato = 0.15, vibrato_rate = 5 },
    kick = music { wave = "sine", frequency = 130, slide = -6, sustain = 0.04, decay = 0.12, volume = 0.6 },
    hat = music { wave = "noise", frequency = 9000, sustain = 0.005, decay = 0.04, volume = 0.09, high_pass = 6000 },
}

-- Four chords of a minor key, in semitones; a note of the lead for each sixteenth, by its place in the chord.
local chords = { { 0, 3, 7, 10 }, { -4, 0, 3, 7 }, { -7, -4, 0, 3 }, { -2, 2, 5, 8 } }
local melody = { 1, 0, 3, 0, 4, 0, 3, 2, 0, 3, 0, 4, 2, 0, 3, 0 }

-- One sixteenth of the music, every `tempo` steps.
return function(count)
    local arena = arenas[night.arena]
    if count % arena.tempo ~= 0 then return end
    local beat = count // arena.tempo
    local place, chord = beat % 16, chords[beat // 16 % 4 + 1]
    local function note(synth, semitones) synth:play { pitch = 2 ^ ((semitones + arena.root) / 12) } end
    for i = 1, place == 0 and 3 or 0 do note(sounds.pad, chord[i]) end
    local tone = chord[melody[place + 1]]
    if tone and (night.running or place % 4 == 0) then note(sounds.lead, tone + (beat // 64 % 2) * 12) end
    if not night.running then return end
    if place % 4 == 0 or place == 14 then note(sounds.bass, chord[1]) end
    if place % 8 == 0 or night.boss and place % 4 == 0 then sounds.kick:play() end
    if place % 4 == 2 or night.clock > 30 and place % 2 == 1 then sounds.hat:play() end
end
