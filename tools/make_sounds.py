#!/usr/bin/env python3
"""Synthesises every sound of GpuWars into assets/sounds: effects and the music loop, 16-bit mono WAV.

Every run gives the same bytes, on every machine: random numbers have fixed seeds, and of arithmetic only
+ - * / is used, because sin, exp and pow differ in their last bit between C libraries.

    tools/make_sounds.py [output folder]        needs nothing but Python's standard library
"""
import random
import struct
import sys
import wave
from pathlib import Path

EFFECT_RATE = 44100    # samples a second
MUSIC_RATE = 24000     # neon is soft; half the bytes
PEAK = 0.85            # of full scale, of every file: resampling overshoots
TABLE = 4096           # samples of one period in a wavetable
SEMITONE = 1.0594630943592953
PI = 3.141592653589793

# --- Arithmetic that is the same everywhere ---


def taylor_sine(x):
    """Sine for |x| <= pi/2."""
    term = total = x
    for n in range(1, 14):
        term = -term * x * x / ((2 * n) * (2 * n + 1))
        total += term
    return total


def sine_of_turn(t):
    t -= int(t)
    if t > 0.5:
        return -sine_of_turn(t - 0.5)
    return taylor_sine(2 * PI * (t if t <= 0.25 else 0.5 - t))


def fall(seconds, rate):
    """The factor per sample of a decay to 1/e in that time."""
    x, term, total = -1 / (seconds * rate), 1.0, 1.0
    for n in range(1, 20):
        term = term * x / n
        total += term
    return total


def note(semitones):
    """Hertz, counted from A4 = 440."""
    hertz = 440.0
    for _ in range(abs(semitones)):
        hertz = hertz * SEMITONE if semitones > 0 else hertz / SEMITONE
    return hertz


SINE = [sine_of_turn(i / TABLE) for i in range(TABLE)]


def wavetable(harmonics):
    """One period from {harmonic: amplitude}, peak 1."""
    table = [0.0] * TABLE
    for k, amplitude in harmonics.items():
        table = [v + amplitude * SINE[(i * k) % TABLE] for i, v in enumerate(table)]
    peak = max(abs(v) for v in table)
    return [v / peak for v in table]


def saw(most):
    return wavetable({k: 1 / k for k in range(1, most + 1)})


def square(most):
    return wavetable({k: 1 / k for k in range(1, most + 1, 2)})


# --- Parts ---


def sweep(table, seconds, first_hz, last_hz, decay_s, rate=EFFECT_RATE, attack_s=0.002):
    """A tone whose pitch closes the gap to last_hz exponentially and whose level decays."""
    out, phase, hertz, level = [], 0.0, first_hz, 1.0
    glide, decay, attack = fall(seconds / 4, rate), fall(decay_s, rate), max(1, int(attack_s * rate))
    for i in range(int(seconds * rate)):
        out.append(table[int(phase * TABLE) % TABLE] * level * min(1.0, i / attack))
        phase += hertz / rate
        hertz = last_hz + (hertz - last_hz) * glide
        level *= decay
    return out


def noise(seed, seconds, decay_s, rate=EFFECT_RATE):
    source, level, decay = random.Random(seed), 1.0, fall(decay_s, rate)
    out = []
    for _ in range(int(seconds * rate)):
        out.append((2 * source.random() - 1) * level)
        level *= decay
    return out


def low_pass(signal, first, last=None):
    """One pole; the share of the gap closed per sample moves from `first` to `last`."""
    last = first if last is None else last
    out, held, step = [], 0.0, (last - first) / max(1, len(signal))
    for i, v in enumerate(signal):
        held += (v - held) * (first + step * i)
        out.append(held)
    return out


def high_pass(signal, share):
    return [v - l for v, l in zip(signal, low_pass(signal, share))]


def mix(*parts):
    """Adds (gain, signal) or (gain, signal, from_s); as long as the longest."""
    placed = [(g, s, int((at[0] if at else 0) * EFFECT_RATE)) for g, s, *at in parts]
    out = [0.0] * max(len(s) + at for _, s, at in placed)
    for gain, signal, at in placed:
        for i, v in enumerate(signal, at):
            out[i] += gain * v
    return out


def finish(signal, rate=EFFECT_RATE, fade_s=0.02):
    """Ends in silence without a click, and reaches PEAK."""
    fade = min(len(signal), int(fade_s * rate))
    for i in range(fade):
        signal[-1 - i] *= i / fade
    peak = max(abs(v) for v in signal)
    return [v * PEAK / peak for v in signal]


# --- Effects ---


def shot():
    """Ten a second for minutes: short, soft, little treble."""
    body = sweep(SINE, 0.1, 1150, 430, 0.022, attack_s=0.003)
    edge = low_pass(sweep(square(7), 0.1, 2300, 860, 0.010, attack_s=0.003), 0.25)
    return finish(mix((1, body), (0.25, edge)))


def kill():
    """A crisp pluck on A4, which the game tunes by type, with a click in front."""
    tone = sweep(wavetable({1: 1, 2: 0.45, 3: 0.3, 5: 0.12}), 0.24, 440, 440, 0.05)
    click = high_pass(noise(11, 0.03, 0.004), 0.3)
    return finish(mix((1, tone), (0.5, click)))


def kill_heavy():
    """The same note with weight: a fourth below it, a crunch, and a thump. It is played down to an octave lower."""
    tone = sweep(saw(12), 0.5, 440, 440, 0.11)
    fourth = sweep(saw(8), 0.5, note(-5), note(-5), 0.09)
    crunch = low_pass(noise(12, 0.3, 0.05), 0.35)
    thump = sweep(SINE, 0.4, 520, 200, 0.06)
    return finish(mix((1, tone), (0.3, fourth), (0.5, crunch), (0.5, thump)))


def contact():
    """Low and alarming: two saws that beat against each other, over a blow."""
    growl = low_pass(mix((1, sweep(saw(16), 0.7, 98, 92, 0.3)), (1, sweep(saw(16), 0.7, 104, 97, 0.3))), 0.16, 0.05)
    pulse = [v * (0.6 + 0.4 * SINE[int(i * 15 / EFFECT_RATE * TABLE) % TABLE]) for i, v in enumerate(growl)]
    blow = sweep(SINE, 0.5, 210, 45, 0.13)
    crack = low_pass(noise(13, 0.15, 0.03), 0.3)
    return finish(mix((1, pulse), (1, blow), (0.5, crack)))


def bit():
    """A small bright blip: two notes, the second a fifth higher."""
    first = sweep(SINE, 0.06, note(24), note(24), 0.02)
    second = sweep(wavetable({1: 1, 2: 0.15}), 0.11, note(31), note(31), 0.03)
    return finish(mix((0.7, first), (1, second, 0.04)))


def wave_start():
    """Four rising notes over a riser."""
    parts = [(0.6, low_pass(sweep(saw(10), 0.4, note(n), note(n), 0.1), 0.2, 0.08), 0.09 * i)
             for i, n in enumerate((-24, -17, -12, -9))]
    riser = low_pass(noise(14, 0.8, 10), 0.01, 0.25)
    riser = [v * i / len(riser) * (1 - i / len(riser)) for i, v in enumerate(riser)]
    return finish(mix(*parts, (1.2, riser)))


def flush():
    """A big whoosh: noise that opens and closes, over a falling sub."""
    rush = noise(15, 1.3, 10)
    half = len(rush) // 4
    opened = low_pass(rush[:half], 0.02, 0.5) + low_pass(rush[half:], 0.5, 0.01)
    shaped = [v * min(1, i / half) * (1 - i / len(opened)) for i, v in enumerate(high_pass(opened, 0.01))]
    sub = sweep(SINE, 1.2, 130, 34, 0.4, attack_s=0.02)
    return finish(mix((1.1, shaped), (0.8, sub)))


def game_over():
    """The machine runs down: a chord glides below hearing, and something heavy lands."""
    chord = [(0.5, sweep(saw(14), 1.9, note(n), note(n) / 5, 0.8)) for n in (-12, -9, -5)]
    down = low_pass(mix(*chord), 0.3, 0.02)
    landing = sweep(SINE, 0.7, 120, 36, 0.2)
    return finish(mix((1, down), (0.8, landing, 1.1)))


# --- Music: 16 bars in A minor, 128 beats a minute, 30 s ---

BEAT = MUSIC_RATE * 60 // 128    # 11250 samples, exactly
BAR = 4 * BEAT
BARS = 16
LENGTH = BARS * BAR

# Two bars each: semitones from A4 of the root and of the chord.
CHORDS = [(-24, (0, 3, 7)), (-28, (-4, 0, 3)), (-21, (3, 7, 10)), (-26, (-2, 2, 5)),
          (-24, (0, 3, 7)), (-28, (-4, 0, 3)), (-31, (5, 8, 12)), (-29, (-5, -1, 2))]
# Lead of the second half: (bar, sixteenth, length in sixteenths, semitones).
LEAD = [(8, 0, 6, 12), (8, 6, 2, 15), (8, 8, 8, 19), (9, 4, 4, 17), (9, 8, 6, 15), (10, 0, 6, 12), (10, 6, 2, 8),
        (10, 8, 8, 12), (11, 6, 2, 10), (11, 8, 8, 15), (12, 0, 6, 20), (12, 6, 2, 19), (12, 8, 8, 17), (13, 4, 4, 15),
        (13, 8, 8, 12), (14, 0, 6, 14), (14, 6, 2, 11), (14, 8, 8, 16), (15, 4, 4, 14), (15, 8, 4, 11)]


def add(track, signal, at, gain):
    """What rings past the end rings on at the beginning: that is why the loop has no seam."""
    at %= LENGTH
    head = min(len(signal), LENGTH - at)
    track[at:at + head] = [a + gain * b for a, b in zip(track[at:at + head], signal[:head])]
    if head < len(signal):
        add(track, signal[head:], 0, gain)


def tone(table, hertz, samples, decay_s, attack=48, release=480):
    out, level, decay, step = [], 1.0, fall(decay_s, MUSIC_RATE), hertz * TABLE / MUSIC_RATE
    for i in range(samples):
        out.append(table[int(i * step) % TABLE] * level)
        level *= decay
    for i in range(min(attack, samples)):
        out[i] *= i / attack
    for i in range(min(release, samples)):
        out[-1 - i] *= i / release
    return out


def ducked(track):
    """Makes room for the kick on every beat: the pump of the genre."""
    shape = [0.35 + 0.65 * min(1.0, i / (BEAT * 0.6)) for i in range(BEAT)]
    return [v * shape[i % BEAT] for i, v in enumerate(track)]


def drums(track):
    kick = sweep(SINE, 0.22, 170, 46, 0.09, MUSIC_RATE, 0.001)
    snare = [a + b for a, b in zip(high_pass(noise(21, 0.18, 0.05, MUSIC_RATE), 0.2),
                                   sweep(SINE, 0.18, 260, 180, 0.04, MUSIC_RATE))]
    hat = high_pass(noise(22, 0.05, 0.012, MUSIC_RATE), 0.6)
    for beat in range(BARS * 4):
        add(track, kick, beat * BEAT, 0.85)
        if beat % 2:
            add(track, snare, beat * BEAT, 0.28)
        add(track, hat, beat * BEAT + BEAT // 2, 0.16)
        if beat >= BARS * 2:
            add(track, hat, beat * BEAT + BEAT // 4, 0.07)
            add(track, hat, beat * BEAT + 3 * BEAT // 4, 0.09)
    for step in range(4):  # the last beat leads back to the first
        add(track, snare, LENGTH - BEAT + step * BEAT // 4, 0.12 + 0.04 * step)


def bass(track):
    table = saw(9)
    for pair, (root, _) in enumerate(CHORDS):
        low, high = (low_pass(tone(table, note(n), BEAT // 2 - 300, 0.16), 0.22, 0.1) for n in (root, root + 12))
        for eighth in range(16):
            add(track, high if eighth % 4 == 3 else low, pair * 2 * BAR + eighth * BEAT // 2, 0.6)


def arpeggio(track):
    table = square(9)
    for pair, (_, chord) in enumerate(CHORDS):
        notes = [chord[0], chord[1], chord[2], chord[0] + 12, chord[2], chord[1]]
        played = {n: low_pass(tone(table, note(n), 3000, 0.06), 0.45, 0.2) for n in set(notes)}
        for step in range(32):
            signal = played[notes[step % 6]]
            at = pair * 2 * BAR + step * BEAT // 4
            add(track, signal, at, 0.2)
            add(track, signal, at + 3 * BEAT // 4, 0.08)  # echoes
            add(track, signal, at + 6 * BEAT // 4, 0.035)


def pads(track):
    table = saw(6)
    for pair, (_, chord) in enumerate(CHORDS):
        for n in chord:
            for detune in (0.9965, 1.0035):
                signal = tone(table, note(n - 12) * detune, 2 * BAR + 4000, 30, attack=6000, release=6000)
                add(track, signal, pair * 2 * BAR - 2000, 0.085)


def lead(track):
    table = wavetable({1: 1, 2: 0.5, 3: 0.35, 4: 0.2, 5: 0.1})
    for bar, step, length, semitones in LEAD:
        signal = tone(table, note(semitones), length * BEAT // 4, 0.5, attack=200, release=1500)
        at = bar * BAR + step * BEAT // 4
        add(track, signal, at, 0.2)
        add(track, signal, at + 3 * BEAT // 4, 0.07)


def music():
    steady, pumped = [0.0] * LENGTH, [0.0] * LENGTH
    drums(steady)
    lead(steady)
    for part in (bass, arpeggio, pads):
        part(pumped)
    track = [a + b for a, b in zip(steady, ducked(pumped))]
    # A soft knee for the moments when everything coincides, so that the rest may be louder.
    track = [v / (1 + 0.25 * abs(v)) for v in track]
    peak = max(abs(v) for v in track)
    return [v * PEAK / peak for v in track]


def write(path, samples, rate):
    whole = [int(v * 32767 + 32768.5) - 32768 for v in samples]
    with wave.open(str(path), "wb") as file:
        file.setnchannels(1)
        file.setsampwidth(2)
        file.setframerate(rate)
        file.writeframes(struct.pack(f"<{len(whole)}h", *whole))


EFFECTS = {"shot": shot, "kill": kill, "kill_heavy": kill_heavy, "contact": contact, "bit": bit, "wave": wave_start,
           "flush": flush, "over": game_over}


def main():
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).resolve().parent.parent / "assets" / "sounds"
    folder.mkdir(parents=True, exist_ok=True)
    for name, make in EFFECTS.items():
        write(folder / f"{name}.wav", make(), EFFECT_RATE)
    write(folder / "music.wav", music(), MUSIC_RATE)


if __name__ == "__main__":
    main()
