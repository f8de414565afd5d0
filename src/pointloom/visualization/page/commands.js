/** Key commands for camera and appearance. */
const STEP_OF_SIZE = 1.25;
const LARGEST_FACTOR = 32;
const KEY_ANGLE = 0.1; // [rad]

function commandsOf(engine) {
  const { looks } = engine;
  const look = (change) => () => {
    change();
    engine.redraw();
  };
  const sized = (by) => look(() => (looks.pointFactor = clamp(looks.pointFactor * by, 1 / LARGEST_FACTOR, LARGEST_FACTOR)));
  const camera = () => engine.views.camera;
  const command = (group) => (key, label, run) => ({ key, label, group, run });
  const view = command("camera");
  const shown = command("look");
  return [
    view("R", "back to the first view", () => engine.home()),
    view("F", "fit the scene", () => engine.fit()),
    view("O", "parallel or perspective", () => engine.setOrthographic(!camera().orthographic)),
    view("U", "Y or Z up", () => engine.setUp(Math.abs(camera().up[2]) > 0.9 ? "y" : "z")),
    ...["x", "y", "z"].flatMap((axis) => [
      view(axis.toUpperCase(), `look along +${axis}`, () => engine.lookAlong(`+${axis}`)),
      view(`Shift+${axis.toUpperCase()}`, `look along \u2212${axis}`, () => engine.lookAlong(`-${axis}`)),
    ]),
    view("M", "one, two, four views", () => engine.setViews({ 1: 2, 2: 4, 4: 1 }[engine.views.cameras.length], engine.views.linked)),
    view("Shift+M", "views linked or free", () => (engine.views.linked = !engine.views.linked)),
    ...[["Left", -1, 0], ["Right", 1, 0], ["Up", 0, -1], ["Down", 0, 1]].map(([name, right, down]) =>
      view(`Shift+Arrow${name}`, `rotate ${name.toLowerCase()}`, () => engine.orbit(KEY_ANGLE * right, KEY_ANGLE * down))),
    shown("+", "larger points", sized(STEP_OF_SIZE)),
    shown("-", "smaller points", sized(1 / STEP_OF_SIZE)),
    shown("W", "edges of triangles", look(() => (looks.wireframe = !looks.wireframe))),
    shown("N", "colors from normals", look(() => (looks.normals = !looks.normals))),
    shown("L", "light: automatic, everywhere, none", look(() => (looks.light = (looks.light + 1) % 3))),
  ];
}
