/** Loads the library, once. Without a source it is fettle.wasm beside this file, in a browser and in node. */
export declare function load(source?: BufferSource | WebAssembly.Module | Response | Promise<BufferSource | WebAssembly.Module | Response>): Promise<void>;

/** A call was refused, and has changed nothing. */
export declare class FettleError extends Error {}
/** An argument without meaning: NaN, out of range, of a wrong type. */
export declare class Invalid extends FettleError {}
/** The world, body, shape, joint or field does not exist any more. */
export declare class Stale extends FettleError {}
export declare class Locked extends FettleError {}
export declare class NoMemory extends FettleError {}

/** A body, shape, joint or field of a world. The same object always has the same handle. */
export declare class Handle {
  protected constructor();
  readonly world: World;
  readonly id: bigint;
  /** Where it is in the columns of its world. */
  readonly slot: number;
  readonly isValid: boolean;
}

/** What `world.draw` calls. */
export interface DrawTarget {
  polygon?(points: Vec2[], closed: boolean, color: number): void;
  circle?(center: Vec2, radius: number, angle: number, color: number): void;
  segment?(from: Vec2, to: Vec2, color: number): void;
  point?(at: Vec2, color: number): void;
  /** The color of a shape. Without this method it shows whether the shape is a sensor, and otherwise the state of its body. */
  colorOf?(body: Body, shape: Shape): number;
}

/** Repeats a recording of `world.startRecording`, step by step. */
export declare class Replay implements Iterable<ReplayedStep> {
  /** A copy of the bytes. Throws `Invalid` if they are damaged, of another version of the library, or end within the first part. */
  constructor(recording: Uint8Array);
  /** Number of steps in the recording. */
  readonly steps: bigint;
  /** Whether the recording ends within a part that was given to the function; the parts before are replayed. */
  readonly isCutOff: boolean;
  /** Repeats the next step; null at the end, and after a step that was not the same. */
  step(): ReplayedStep | null;
  /** A copy of the world after the last repeated step. */
  readonly world: World;
  [Symbol.iterator](): Iterator<ReplayedStep>;
  destroy(): void;
}

declare class WorldBase {
  constructor(definition?: WorldDef);
  /** Destroys the world and all in it. A world that nothing refers to any more is destroyed too, at some time. */
  destroy(): void;
  /** Calls the methods of `target` for everything that is to be drawn; methods that it does not have are skipped. Colors are 0xRRGGBB. */
  draw(target: DrawTarget, options?: Partial<DebugDraw>): void;
  /** x, y, angle, angular velocity, velocity x and y, cosine and sine of the body in each slot. A view without a copy, until
      bodies are made or a step needs more memory. */
  readonly states: Float32Array;
  /** x, y and angle before the last step, of the body in each slot; a view as `states` is. */
  readonly previousPoses: Float32Array;
}

/** A character that moves through a world. It need not be destroyed: it consists of a definition and a state, and is not part of the world. */
declare class MoverBase {
  constructor(world: World, definition?: MoverDef, position?: Vec2);
  readonly world: World;
  /** All settings. Members that are missing when it is set get their defaults. */
  get definition(): Required<MoverDef>;
  set definition(definition: MoverDef);
  /** Everything that it keeps from move to move, to be saved and set again. */
  get state(): Required<MoverState>;
  set state(state: MoverState);
  /** Of its feet, m. Where it is set, the mover leaves the ground. */
  get position(): Vec2;
  set position(position: Vec2);
}

/** Geometry of shapes by type, in body coordinates, m. */
export declare function circle(radius?: number, more?: Partial<Geometry>): Geometry;
export declare function box(width?: number, height?: number, more?: Partial<Geometry>): Geometry;
export declare function segment(from: Vec2, to: Vec2, more?: Partial<Geometry>): Geometry;
export declare function polygon(points: readonly Vec2[], more?: Partial<Geometry>): Geometry;
export declare function ellipse(radiusX?: number, radiusY?: number, more?: Partial<Geometry>): Geometry;
export declare function concave(points: readonly Vec2[]): Geometry;
/** A line of segments, solid for bodies on its left: points from left to right are ground. */
export declare function chain(points: readonly Vec2[], closed?: boolean): Geometry;

