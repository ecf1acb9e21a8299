#!/usr/bin/env python3
"""Writes music.ogg and fight.ogg, the loops of the game. Run it in this folder after a change: ./make_music.py

Plain Python makes the samples, libsndfile, which SFML brings along, encodes them."""

import array
import ctypes
import math
import random

RATE = 22050


class Tune:
    def __init__(self, beat, bars):
        self.beat, self.bars = beat, bars
        self.samples = [0.0] * int(RATE * beat * 4 * bars)

    def note(self, at, beats, pitch, loud, wave, release=4.0):
        """A tone; what goes on after the end of the loop is heard at its beginning."""
        seconds, first = beats * self.beat, int(at * self.beat * RATE)
        step = 440 * 2 ** ((pitch - 69) / 12) / RATE
        for i in range(int(seconds * RATE)):
            t = i / RATE
            envelope = min(1, t * 200) * math.exp(-release * t) * min(1, (seconds - t) * 60)
            self.samples[(first + i) % len(self.samples)] += loud * envelope * wave(i * step % 1)

    def drum(self, at, loud, fall, tone):
        first, phase, noise = int(at * self.beat * RATE), 0.0, 0.0
        for i in range(int(RATE * 0.16)):
            t = i / RATE
            phase += 2 * math.pi * (50 + 140 * math.exp(-t * 40)) / RATE
            noise = noise * (0.2 if tone == 0 else 0.7) + random.uniform(-1, 1)
            value = math.sin(phase) if tone == 2 else noise * 0.5
            self.samples[(first + i) % len(self.samples)] += loud * math.exp(-t * fall) * value


def pulse(p):
    return (1 if p < 0.25 else -1) * 0.6


def triangle(p):
    return 4 * abs(p - 0.5) - 1


def soft(p):
    return math.sin(2 * math.pi * p) + 0.25 * math.sin(4 * math.pi * p)


def theme():
    tune = Tune(0.40, 16)
    chords = [(48, 64, 67, 72), (45, 60, 64, 69), (41, 60, 65, 69), (43, 59, 62, 67)] * 2 + \
             [(41, 60, 65, 69), (43, 59, 62, 67), (40, 59, 64, 67), (45, 60, 64, 69)] * 2
    verse = [76, 0, 79, 76, 74, 72, 74, 0, 72, 0, 76, 72, 69, 67, 69, 0, 69, 72, 77, 0, 76, 74, 72, 74, 71, 0, 74, 79, 74, 0, 0, 0]
    bridge = [81, 0, 77, 0, 81, 84, 81, 77, 79, 0, 74, 0, 79, 83, 79, 74, 76, 79, 83, 79, 76, 0, 71, 0, 72, 74, 76, 79, 81, 0, 0, 0]
    for bar, (bass, *chord) in enumerate(chords):
        at = bar * 4
        for n, beats in enumerate((0, 1.5, 2, 3)):
            tune.note(at + beats, 0.9, bass - 12 * (n % 2 == 0) + 12, 0.26, triangle, 3)
        for n in range(8):
            tune.note(at + n / 2, 0.45, chord[(n * 2 + bar) % 3] + 12 * (n % 4 == 3), 0.05, pulse, 9)
        line = verse if bar < 8 else bridge
        for n in range(8):
            pitch = line[bar % 4 * 8 + n]
            if pitch:
                tune.note(at + n / 2, 1.1, pitch, 0.13, soft, 3.4)
        for n in range(8):
            tune.drum(at + n / 2, 0.05 if n % 2 else 0.03, 60, 0)
        for beat in (0, 2):
            tune.drum(at + beat, 0.3, 16, 2)
            tune.drum(at + beat + 1, 0.12, 26, 1)
    return tune


def fight():
    tune = Tune(0.33, 8)
    riff = [0, 0, 12, 0, 3, 0, 10, 7]
    lead = [72, 0, 75, 74, 72, 0, 67, 0, 68, 0, 72, 75, 74, 0, 70, 0, 72, 0, 75, 79, 80, 79, 75, 0, 74, 75, 74, 71, 67, 0, 71, 74]
    for bar, root in enumerate((36, 36, 32, 34, 36, 36, 32, 31)):
        at = bar * 4
        for n in range(8):
            tune.note(at + n / 2, 0.5, root + riff[n] * (root != 31 or n != 4), 0.22, pulse, 5)
            tune.drum(at + n / 2, 0.07, 50, 0)
            pitch = lead[bar % 4 * 8 + n]
            if pitch:
                tune.note(at + n / 2, 0.9, pitch + (12 if bar > 3 and n % 2 else 0), 0.12, triangle, 3)
        for beat in (0, 0.75, 2, 2.5):
            tune.drum(at + beat, 0.32, 16, 2)
        for beat in (1, 3):
            tune.drum(at + beat, 0.18, 22, 1)
    return tune


class Info(ctypes.Structure):
    _fields_ = [("frames", ctypes.c_int64), ("samplerate", ctypes.c_int), ("channels", ctypes.c_int),
                ("format", ctypes.c_int), ("sections", ctypes.c_int), ("seekable", ctypes.c_int)]


def write(name, samples):
    loudest = max(abs(s) for s in samples)
    data = array.array("h", [int(s / loudest * 26000) for s in samples])
    library = ctypes.CDLL("libsndfile.so.1")
    library.sf_open.restype = ctypes.c_void_p
    library.sf_command.argtypes = [ctypes.c_void_p, ctypes.c_int, ctypes.c_void_p, ctypes.c_int]
    library.sf_writef_short.argtypes = [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_int64]
    library.sf_close.argtypes = [ctypes.c_void_p]
    info = Info(0, RATE, 1, 0x200060, 0, 0)  # OGG with Vorbis
    file = library.sf_open(name.encode(), 0x20, ctypes.byref(info))
    quality = ctypes.c_double(0.2)
    library.sf_command(file, 0x1300, ctypes.byref(quality), 8)
    for first in range(0, len(data), 4096):  # a large piece at once overflows the stack of the encoder
        piece = data[first:first + 4096]
        library.sf_writef_short(file, piece.buffer_info()[0], len(piece))
    library.sf_close(file)


random.seed(4)
write("music.ogg", theme().samples)
write("fight.ogg", fight().samples)
