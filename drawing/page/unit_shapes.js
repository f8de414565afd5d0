/** What instances are copies of: triangles for solid ones, segments for edges. */
const BOX_CORNERS = [0, 1, 2, 3, 4, 5, 6, 7].map((k) => [0, 1, 2].map((axis) => ((k >> axis) & 1 ? 0.5 : -0.5)));
const BOX_FACES = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
const FRUSTUM_CORNERS = [[0, 0, 0], [-1, -1, 1], [1, -1, 1], [1, 1, 1], [-1, 1, 1]];
const FRUSTUM_FACES = [[0, 2, 1], [0, 3, 2], [0, 4, 3], [0, 1, 4], [1, 2, 3, 4]];
const RING = 32; // segments of a circle

/** Corners, corners of triangles, and normals where the shape is round. */
function solidShape(shape, fine) {
  if (shape === "ball") return ballShape(fine ? 3 : 2);
  const [corners, faces] = shape === "frustum" ? [FRUSTUM_CORNERS, FRUSTUM_FACES] : [BOX_CORNERS, BOX_FACES];
  const indices = faces.flatMap((face) => face.slice(2).flatMap((corner, k) => [face[0], face[k + 1], corner]));
  return { positions: new Float32Array(corners.flat()), indices: new Uint16Array(indices), normals: null };
}

/** An octahedron whose faces are parted `times` times and put onto the sphere. */
function ballShape(times) {
  const places = [[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]];
  let faces = [[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]];
  for (let time = 0; time < times; time++) {
    const middles = new Map();
    const middle = (a, b) => {
      const key = Math.min(a, b) * 65536 + Math.max(a, b);
      if (!middles.has(key)) {
        const sum = add(places[a], places[b]);
        middles.set(key, places.push(scale(sum, 1 / length(sum))) - 1);
      }
      return middles.get(key);
    };
    faces = faces.flatMap(([a, b, c]) => {
      const [ab, bc, ca] = [middle(a, b), middle(b, c), middle(c, a)];
      return [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]];
    });
  }
  const normals = Int16Array.from(places.flat(), (value) => Math.round(value * 32767));
  return { positions: Float32Array.from(places.flat(), (value) => value / 2), indices: new Uint16Array(faces.flat()), normals };
}

/** Both ends of each edge; of a ball three circles. */
function edgesOfShape(shape) {
  if (shape === "ball") {
    const at = (k) => [Math.cos((2 * Math.PI * k) / RING) / 2, Math.sin((2 * Math.PI * k) / RING) / 2];
    const circle = (turned) => Array.from({ length: RING }, (_, k) => [turned(...at(k)), turned(...at(k + 1))]);
    return [...circle((x, y) => [x, y, 0]), ...circle((x, y) => [0, x, y]), ...circle((x, y) => [y, 0, x])];
  }
  const [corners, faces] = shape === "frustum" ? [FRUSTUM_CORNERS, FRUSTUM_FACES] : [BOX_CORNERS, BOX_FACES];
  const pairs = new Map();
  for (const face of faces) {
    face.forEach((corner, k) => {
      const ends = [corner, face[(k + 1) % face.length]].sort((a, b) => a - b);
      pairs.set(String(ends), ends.map((end) => corners[end]));
    });
  }
  return [...pairs.values()];
}

/** The edges as the line program takes them of instances: both ends again for each of six corners. */
function edgeCorners(shape) {
  return new Float32Array(edgesOfShape(shape).flatMap(([a, b]) => Array(6).fill([...a, ...b]).flat()));
}
