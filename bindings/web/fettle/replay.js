// Repeating the recording of a world.

import { allocate, begin, bytes, c, check, classes, Stale, view } from "./runtime.js";

const collected = new FinalizationRegistry((pointer) => c.fettle_replay_destroy(pointer));

/** Repeats a recording, step by step. */
export class Replay {
  #pointer = 0;
  constructor(recording) {
    begin();
    const given = bytes(recording, "recording"), out = allocate(4);
    check(c.fettle_replay_create(...given, out));
    this.#pointer = view.u32[out >> 2];
    collected.register(this, this.#pointer, this);
    // A misspelt property is an error. Classes that a program derives may add properties.
    if (new.target === Replay) Object.preventExtensions(this);
  }
  get #live() {
    if (this.#pointer === 0) throw new Stale("replay: it was destroyed");
    return this.#pointer;
  }
  destroy() {
    collected.unregister(this);
    c.fettle_replay_destroy(this.#pointer);
    this.#pointer = 0;
  }
  get steps() {
    begin();
    const out = allocate(8);
    check(c.fettle_replay_steps(this.#live, out));
    return view.u64[out >> 3];
  }
  get isCutOff() {
    begin();
    const out = allocate(1);
    check(c.fettle_replay_is_cut_off(this.#live, out));
    return view.u8[out] !== 0;
  }
  step() {
    begin();
    const { size, read } = classes.replayedStep, out = allocate(size), repeated = allocate(1);
    check(c.fettle_replay_step(this.#live, out, repeated));
    return view.u8[repeated] === 0 ? null : read(out, null);
  }
  *[Symbol.iterator]() {
    for (let step; (step = this.step()) !== null;) yield step;
  }
  get world() {
    begin();
    const out = allocate(4);
    check(c.fettle_replay_world(this.#live, out));
    return classes.World.of(view.u32[out >> 2]);
  }
}
