// Scenes that all engines of the table can express: what lies where, and for how many steps.

/** A triangle of boxes, `base` wide. */
function pyramid(base) {
  const bodies = [];
  for (let row = 0; row < base; ++row)
    for (let i = 0; i < base - row; ++i) bodies.push({ x: i - (base - row - 1) / 2, y: 0.5 + row, box: 1 });
  return bodies;
}

/** Boxes and circles in turn that fall into a pit. */
function heap(columns, rows) {
  const bodies = [];
  for (let row = 0; row < rows; ++row)
    for (let i = 0; i < columns; ++i) {
      const x = (i - columns / 2) * 1.1 + (row % 2) * 0.3, y = 2 + row * 1.1;
      bodies.push((row + i) % 2 ? { x, y, box: 0.9 } : { x, y, circle: 0.45 });
    }
  return bodies;
}

export const scenes = [
  { name: "pyramid of 210", bodies: pyramid(20), walls: 40, steps: 300, stands: true },
  { name: "pyramid of 820", bodies: pyramid(40), walls: 80, steps: 200, stands: true },
  { name: "heap of 1000", bodies: heap(25, 40), walls: 16, steps: 400 },
];

export const dt = 1 / 60, gravity = -10, friction = 0.6;
