/**
 * Decodes the arrays embedded in the page: base64 of deflated byte planes per block of rows. Decoded on first use; the
 * text is kept to decode freed arrays again.
 */
const ARRAY_TYPES = { f4: Float32Array, f8: Float64Array, i2: Int16Array, i4: Int32Array, u1: Uint8Array };

class Arrays {
  constructor(table, block) {
    this.table = table;
    this.block = block;
    this.pieces = table.map(() => []);
    for (const element of document.querySelectorAll("script[data-array]")) {
      this.pieces[Number(element.dataset.array)].push(element);
    }
  }

  /** One array, row by row. */
  async read(number) {
    const { kind, rows, width } = this.table[number];
    const type = ARRAY_TYPES[kind];
    const stride = width * type.BYTES_PER_ELEMENT;
    const bytes = new Uint8Array(rows * stride);
    const parted = new Uint8Array(Math.min(this.block, rows) * stride);
    let row = 0;
    let filled = 0;
    const inflate = new DecompressionStream("deflate-raw");
    const feeding = this.feed(number, inflate.writable.getWriter());
    const reader = inflate.readable.getReader();
    for (let { done, value } = await reader.read(); !done; { done, value } = await reader.read()) {
      for (let start = 0; start < value.length; ) {
        const count = Math.min(this.block, rows - row);
        const part = value.subarray(start, start + count * stride - filled);
        if (part.length === 0) throw new Error(`the page is damaged: array ${number} is longer than it should be`);
        parted.set(part, filled);
        filled += part.length;
        start += part.length;
        if (filled === count * stride) {
          joinBytes(parted, count, stride, bytes, row * stride);
          row += count;
          filled = 0;
        }
      }
    }
    await feeding;
    if (row !== rows) throw new Error(`the page is damaged: array ${number} ends at row ${row} of ${rows}`);
    return new type(bytes.buffer);
  }

  async feed(number, writer) {
    for (const element of this.pieces[number]) {
      await writer.write(bytesOfBase64(element.textContent));
    }
    await writer.close();
  }
}

function bytesOfBase64(text) {
  const letters = atob(text);
  const bytes = new Uint8Array(letters.length);
  for (let i = 0; i < letters.length; i++) bytes[i] = letters.charCodeAt(i);
  return bytes;
}

/** Reassembles byte planes of `count` rows. */
function joinBytes(parted, count, stride, bytes, start) {
  for (let k = 0; k < stride; k++) {
    const plane = k * count;
    for (let i = 0, to = start + k; i < count; i++, to += stride) bytes[to] = parted[plane + i];
  }
}
