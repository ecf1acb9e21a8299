// A tower that a ball is thrown at. A click throws one more. `?steps=N` makes N steps at once and draws the last.

import { BodyType, World, box, circle, load } from "./node_modules/fettle-physics/index.js";

await load();
const world = new World();
const ground = world.createBody({ type: BodyType.STATIC, position: { x: 0, y: -0.5 } });
ground.add(box(60, 1), { friction: 0.8 });

const crates = [], balls = [];
for (let row = 0; row < 12; ++row)
  for (let i = 0; i < 12 - row; ++i) {
    const crate = world.createBody({ position: { x: 4 + i - (11 - row) / 2, y: 0.5 + row } });
    crate.add(box(0.96, 0.96));
    crates.push(crate);
  }

function throwBall(at) {
  const ball = world.createBody({ position: { x: -14, y: 4 }, velocity: { x: 26, y: at }, bullet: true });
  ball.add(circle(0.8), { density: 4 });
  balls.push(ball);
}
throwBall(6);
addEventListener("resize", draw);
addEventListener("pointerdown", (event) => throwBall(12 * (1 - event.clientY / innerHeight)));

const canvas = document.querySelector("canvas"), pen = canvas.getContext("2d");

function draw() {
  canvas.width = canvas.clientWidth;
  canvas.height = canvas.clientHeight;
  const scale = canvas.width / 34;
  pen.setTransform(scale, 0, 0, -scale, canvas.width / 2, canvas.height - 2 * scale);
  pen.fillStyle = "#708070";
  pen.fillRect(-30, -1, 60, 1);
  const { states } = world;  // poses without copies: eight numbers a slot
  const each = (bodies, color, path) => {
    pen.fillStyle = color;
    for (const body of bodies) {
      const at = 8 * body.slot, cosine = states[at + 6], sine = states[at + 7];
      pen.save();
      pen.transform(cosine, sine, -sine, cosine, states[at], states[at + 1]);
      path();
      pen.restore();
    }
  };
  each(crates, "#ffd700", () => pen.fillRect(-0.47, -0.47, 0.94, 0.94));
  each(balls, "#ff6347", () => {
    pen.beginPath();
    pen.arc(0, 0, 0.8, 0, 7);
    pen.fill();
  });
}

const steps = Number(new URLSearchParams(location.search).get("steps") ?? 0);
for (let i = 0; i < steps; ++i) world.step(1 / 60);
draw();
document.title = `Fettle: ${world.hash.toString(16)}`;

let due = 0, last;
function frame(now) {
  due = Math.min(due + (now - (last ?? now)) / 1000, 0.1);
  last = now;
  for (; due >= 1 / 60; due -= 1 / 60) world.step(1 / 60);
  draw();
  requestAnimationFrame(frame);
}
if (steps === 0) requestAnimationFrame(frame);
