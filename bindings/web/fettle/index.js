export * from "./interface.js";
export { FettleError, Handle, Invalid, Locked, NoMemory, Stale, load } from "./runtime.js";
export { Replay } from "./replay.js";

import { ShapeType } from "./interface.js";

// Geometry of shapes by type, in body coordinates, m.
export const circle = (radius = 0.5, more = {}) => ({ type: ShapeType.CIRCLE, radius, ...more });
export const box = (width = 1, height = 1, more = {}) => ({ type: ShapeType.BOX, width, height, ...more });
export const segment = (from, to, more = {}) => ({ type: ShapeType.SEGMENT, from, to, ...more });
export const polygon = (points, more = {}) => ({ type: ShapeType.POLYGON, points, ...more });
export const ellipse = (radiusX = 0.5, radiusY = 0.25, more = {}) => ({ type: ShapeType.ELLIPSE, radiusX, radiusY, ...more });
export const concave = (points) => ({ type: ShapeType.CONCAVE, points });
export const chain = (points, closed = false) => ({ type: ShapeType.CHAIN, points, closed });
