// Hostile pages from another language than the server's: node fuzz_pages.mjs ADDRESS ORIGIN COUNT SEED IDS
const [address, origin, count, seed, ids] = process.argv.slice(2);
let state = Number(seed) >>> 0;
const random = () => {
  state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
  return state / 2 ** 32;
};
const pick = (values) => values[Math.floor(random() * values.length)];
const numbers = ids.split(",").map(Number);
const HOSTILE = [
  null, true, -1, 0, 2 ** 53, 1e308, -1e308, 5e-324, "", "x", "__proto__", "constructor", "\0", "\ud800", "x".repeat(5000),
  [], [[]], [1, 2], [1, 2, 3], Array(9).fill(0), Array(2000).fill(1), {}, { value: 1 }, [["a"], true], [["a"], 1], [1, 0],
  "2026-11-22", "<img src=x onerror=alert(1)>", [null, null, null], [1e308, 1e308, 1e308],
];
const CAMERA = {
  say: "camera", position: [0, 0, 3], rotation: [1, 0, 0, 0, 1, 0, 0, 0, 1], fov: 1, pivot: [0, 0, 0], size: [800, 600],
  orthographic: false,
};
const KNOWN = [
  () => ({ ...CAMERA }),
  () => ({ say: "hello", size: [800, 600], version: 1 }),
  () => ({ say: "sign", n: 1 }),
  () => ({ say: "value", id: pick(numbers), value: pick(HOSTILE) }),
  () => ({ say: "press", id: pick(numbers), value: pick(HOSTILE) }),
  () => ({ say: "command", id: pick(numbers) }),
  () => ({ say: "click", x: random(), y: random(), shift: false, ctrl: true }),
  () => ({ say: "file", id: pick(numbers), name: "../../x", text: "{}".repeat(1000) }),
  () => ({ say: "resume" }),
];
// What ends a line is said seldom, so that most of the messages are read.
const ENDING = ["", "{", "[1", "null", '{"say":NaN}', "[".repeat(50000), "\u0000", new Uint8Array(100), "x".repeat(70000)];

function message() {
  if (random() < 0.002) return pick(ENDING);
  const said = pick(KNOWN)();
  const fields = Object.keys(said).filter((field) => field !== "say");
  if (random() < 0.8 && fields.length) said[pick(fields)] = pick(HOSTILE);
  if (random() < 0.1 && fields.length) delete said[pick(fields)];
  return JSON.stringify(said);
}

let sent = 0;
let lines = 0;
function open() {
  lines += 1;
  return new Promise((resolve) => {
    const line = new WebSocket(address, { protocols: ["pointloom.1"], headers: { origin } });
    line.onerror = () => resolve();
    line.onclose = () => resolve();
    line.onopen = async () => {
      line.send(JSON.stringify({ say: "hello", size: [800, 600], version: 1 }));
      while (sent < Number(count) && line.readyState === WebSocket.OPEN) {
        for (let k = 0; k < 20 && sent < Number(count); k += 1, sent += 1) line.send(message());
        // About as fast as they are read: what is sent behind the end of a line is lost.
        await new Promise((go) => setTimeout(go, 40));
      }
      line.close();
    };
  });
}

await Promise.all(Array.from({ length: 8 }, async () => {
  while (sent < Number(count)) await open();
}));
console.log(JSON.stringify({ sent, lines }));
