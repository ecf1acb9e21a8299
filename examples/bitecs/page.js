// Draws the game in a page. `?steps=N` makes N steps at once and draws the last.

import { query } from "bitecs";
import { load } from "fettle-physics";
import { Body } from "./bodies.js";
import { Crate, Health, Stone, createGame, stepGame } from "./game.js";

await load();
const game = createGame();
const canvas = document.querySelector("canvas"), pen = canvas.getContext("2d");

function draw() {
  canvas.width = canvas.clientWidth;
  canvas.height = canvas.clientHeight;
  const scale = canvas.width / 34;
  pen.setTransform(scale, 0, 0, -scale, canvas.width / 2, canvas.height - 2 * scale);
  pen.fillStyle = "#708070";
  pen.fillRect(-30, -1, 60, 1);
  const { states } = game.physics;  // poses without copies: eight numbers a body
  const drawEach = (components, path) => {
    for (const entity of query(game.entities, components)) {
      const at = 8 * Body[entity].slot, cosine = states[at + 6], sine = states[at + 7];
      pen.save();
      pen.transform(cosine, sine, -sine, cosine, states[at], states[at + 1]);
      path(entity);
      pen.restore();
    }
  };
  drawEach([Body, Crate], (entity) => {
    const width = Crate.width[entity] - 0.05, height = Crate.height[entity] - 0.05;
    pen.fillStyle = "#5a4a2a";
    pen.fillRect(-width / 2, -height / 2, width, height);
    pen.fillStyle = "#ffd700";  // filled as far as it has health
    pen.fillRect(-width / 2, -height / 2, width, height * Health[entity]);
  });
  drawEach([Body, Stone], (entity) => {
    pen.fillStyle = "#ff6347";
    pen.beginPath();
    pen.arc(0, 0, Stone.radius[entity], 0, 7);
    pen.fill();
  });
}

const steps = Number(new URLSearchParams(location.search).get("steps") ?? 0);
for (let i = 0; i < steps; ++i) stepGame(game);
draw();
addEventListener("resize", draw);

let due = 0, last;
function frame(now) {
  due = Math.min(due + (now - (last ?? now)) / 1000, 0.1);
  last = now;
  for (; due >= 1 / 60; due -= 1 / 60) stepGame(game);
  draw();
  requestAnimationFrame(frame);
}
if (steps === 0) requestAnimationFrame(frame);
