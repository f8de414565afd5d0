/**
 * A binary message of the program: JSON and arrays, which become views of the message without a copy. `f2` arrays are
 * read as 16-bit words, as the GPU supports half floats.
 */
const PROTOCOL = "pointloom.1";
const VIEW_TYPES = {
  f4: Float32Array, f2: Uint16Array, f8: Float64Array,
  u1: Uint8Array, u2: Uint16Array, u4: Uint32Array, i2: Int16Array, i4: Int32Array,
};

/** Operations and arrays of a message; throws an error if malformed. */
function readBatch(buffer) {
  if (buffer.byteLength < 4) throw new Error("a message of less than four bytes");
  const length = new DataView(buffer).getUint32(0, true);
  if (4 + length > buffer.byteLength) throw new Error("a message that ends within its text");
  const { do: operations = [], arrays = [] } = JSON.parse(new TextDecoder().decode(new Uint8Array(buffer, 4, length)));
  return { operations, arrays: arrays.map((described) => viewArray(buffer, described)) };
}

function viewArray(buffer, [kind, rows, width, offset]) {
  const type = VIEW_TYPES[kind];
  if (!type) throw new Error(`an array of an unknown kind: ${kind}`);
  return { kind, rows, width, data: new type(buffer, offset, rows * width) };
}
