// Repeating the recording of a world.

import { begin, bytes, c, classes, done, room, view } from "./runtime.js";

const forgotten = new FinalizationRegistry((pointer) => c.fettle_replay_destroy(pointer));

/** Repeats a recording, step by step. */
export class Replay {
  #pointer = 0;
  constructor(recording) {
    begin();
    const given = bytes(recording, "recording"), out = room(4);
    done(c.fettle_replay_create(...given, out));
    this.#pointer = view.u32[out >> 2];
    forgotten.register(this, this.#pointer, this);
  }
  destroy() {
    forgotten.unregister(this);
    c.fettle_replay_destroy(this.#pointer);
    this.#pointer = 0;
  }
  get steps() {
    begin();
    const out = room(8);
    done(c.fettle_replay_steps(this.#pointer, out));
    return view.u64[out >> 3];
  }
  get isCutOff() {
    begin();
    const out = room(1);
    done(c.fettle_replay_is_cut_off(this.#pointer, out));
    return view.u8[out] !== 0;
  }
  step() {
    begin();
    const { size, read } = classes.replayedStep, out = room(size), repeated = room(1);
    done(c.fettle_replay_step(this.#pointer, out, repeated));
    return view.u8[repeated] === 0 ? null : read(out, null);
  }
  *[Symbol.iterator]() {
    for (let step; (step = this.step()) !== null;) yield step;
  }
  get world() {
    begin();
    const out = room(4);
    done(c.fettle_replay_world(this.#pointer, out));
    return classes.World.of(view.u32[out >> 2]);
  }
}
