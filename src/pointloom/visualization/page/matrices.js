/**
 * Vectors are arrays of 3, rotations 9 and poses 12 numbers (3 x 4), row by row, in float64; cast for the GPU last, so
 * that scenes far from the origin stay precise.
 */
const add = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
const subtract = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const scale = (a, s) => [a[0] * s, a[1] * s, a[2] * s];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const length = (a) => Math.hypot(a[0], a[1], a[2]);
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const column = (m, k) => [m[k], m[3 + k], m[6 + k]];
const clamp = (value, low, high) => Math.min(Math.max(value, low), high);

const rotate = (m, v) => [0, 3, 6].map((k) => m[k] * v[0] + m[k + 1] * v[1] + m[k + 2] * v[2]);

function multiply(a, b) {
  const product = [];
  for (const row of [0, 3, 6]) {
    for (const k of [0, 1, 2]) product.push(a[row] * b[k] + a[row + 1] * b[3 + k] + a[row + 2] * b[6 + k]);
  }
  return product;
}

/** Rotation by an angle about a unit axis (Rodrigues). */
function rotationAbout([x, y, z], angle) {
  const c = Math.cos(angle);
  const s = Math.sin(angle);
  const k = 1 - c;
  return [
    ...[c + x * x * k, x * y * k - z * s, x * z * k + y * s],
    ...[y * x * k + z * s, c + y * y * k, y * z * k - x * s],
    ...[z * x * k - y * s, z * y * k + x * s, c + z * z * k],
  ];
}

/** Shape to camera in units of the scene's size: 12 numbers, column by column. */
function modelToCamera(r, eye, pose, unit) {
  const columns = new Float32Array(12);
  for (let k = 0; k < 4; k++) {
    const last = k === 3;
    const x = last ? pose[3] - eye[0] : pose[k];
    const y = last ? pose[7] - eye[1] : pose[4 + k];
    const z = last ? pose[11] - eye[2] : pose[8 + k];
    for (let axis = 0; axis < 3; axis++) columns[3 * k + axis] = (r[axis] * x + r[3 + axis] * y + r[6 + axis] * z) / unit;
  }
  return columns;
}

/** Normal matrix of `modelToCamera`: its cofactors, valid for scaled poses, too. */
function normalMatrix(m) {
  const columns = [m.slice(0, 3), m.slice(3, 6), m.slice(6, 9)];
  const cofactors = [cross(columns[1], columns[2]), cross(columns[2], columns[0]), cross(columns[0], columns[1])].flat();
  const largest = Math.max(...cofactors.map(Math.abs)) || 1;
  return cofactors.map((value) => value / largest);
}

const IDENTITY = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0];

function compose(a, b) {
  const product = new Float64Array(12);
  for (const row of [0, 4, 8]) {
    for (const k of [0, 1, 2, 3]) product[row + k] = a[row] * b[k] + a[row + 1] * b[4 + k] + a[row + 2] * b[8 + k];
    product[row + 3] += a[row + 3];
  }
  return product;
}

/** Scale of a pose: cube root of its determinant. */
function scaleOf(m) {
  const [a, b, c] = [0, 1, 2].map((k) => [m[k], m[4 + k], m[8 + k]]);
  return Math.cbrt(Math.abs(dot(a, cross(b, c))));
}
