#!/usr/bin/env python3
"""Writes music.ogg, the loop of the game. Run it in this folder after a change: ./make_music.py

Plain Python makes the samples, libsndfile, which SFML brings along, encodes them."""

import array
import ctypes
import math
import random

RATE, BEAT, BARS = 22050, 0.5, 16
LENGTH = int(RATE * BEAT * 4 * BARS)
samples = [0.0] * LENGTH


def note(start, seconds, pitch, loudness, harmonics, attack=0.01, release=3.0):
    """Adds a tone; what goes on after the end of the loop is heard at its beginning."""
    frequency = 440 * 2 ** ((pitch - 69) / 12)
    first = int(start * RATE)
    for i in range(int(seconds * RATE)):
        t = i / RATE
        envelope = min(1, t / attack) * math.exp(-release * t) * min(1, (seconds - t) * 20)
        value = sum(part * math.sin(2 * math.pi * frequency * k * t) for k, part in harmonics)
        samples[(first + i) % LENGTH] += loudness * envelope * value


CHORDS = [(45, 60, 64, 67, 71), (41, 57, 60, 64, 67), (48, 55, 60, 64, 67), (43, 55, 59, 62, 66)]
MELODY = [76, 0, 79, 78, 74, 0, 71, 0, 72, 0, 76, 74, 67, 0, 0, 0, 79, 0, 83, 81, 78, 0, 74, 0, 76, 74, 71, 0, 69, 0, 0, 0]
random.seed(4)
for bar in range(BARS):
    bass, *chord = CHORDS[bar % 4]
    at = bar * 4 * BEAT
    note(at, 4 * BEAT, bass, 0.30, [(1, 1), (2, 0.3)], 0.03, 0.7)
    for pitch in chord:
        note(at, 4 * BEAT + 0.4, pitch, 0.055, [(1, 1), (2, 0.2), (1.005, 0.7)], 0.6, 0.1)
    for eighth in range(8):
        pitch = chord[(eighth * 3 + bar) % 4] + (12 if eighth % 3 else 24)
        note(at + eighth * BEAT / 2, 0.7, pitch, 0.05 + 0.03 * random.random(), [(1, 1), (3, 0.2)], 0.003, 7)
    if bar >= 4:
        for half in range(4):
            pitch = MELODY[(bar % 8) * 4 + half]
            if pitch:
                note(at + half * BEAT, 1.4, pitch, 0.13, [(1, 1), (2, 0.35), (4, 0.08)], 0.008, 2.6)
    for tick in range(4):
        start = int((at + tick * BEAT) * RATE)
        for i in range(600):
            click = random.uniform(-1, 1) * math.exp(-i / (60 if tick % 2 else 110))
            samples[(start + i) % LENGTH] += (0.035 if tick % 2 else 0.02) * click

loudest = max(abs(s) for s in samples)
data = array.array("h", [int(s / loudest * 26000) for s in samples])


class Info(ctypes.Structure):
    _fields_ = [("frames", ctypes.c_int64), ("samplerate", ctypes.c_int), ("channels", ctypes.c_int),
                ("format", ctypes.c_int), ("sections", ctypes.c_int), ("seekable", ctypes.c_int)]


library = ctypes.CDLL("libsndfile.so.1")
library.sf_open.restype = ctypes.c_void_p
library.sf_command.argtypes = [ctypes.c_void_p, ctypes.c_int, ctypes.c_void_p, ctypes.c_int]
library.sf_writef_short.argtypes = [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_int64]
library.sf_close.argtypes = [ctypes.c_void_p]
info = Info(0, RATE, 1, 0x200060, 0, 0)  # OGG with Vorbis
file = library.sf_open(b"music.ogg", 0x20, ctypes.byref(info))
quality = ctypes.c_double(0.25)
library.sf_command(file, 0x1300, ctypes.byref(quality), 8)
for first in range(0, LENGTH, 4096):  # a large piece at once overflows the stack of the encoder
    piece = data[first:first + 4096]
    address, _ = piece.buffer_info()
    library.sf_writef_short(file, address, len(piece))
library.sf_close(file)
