/** The page's image as a file saved by the page: the scene with color bars and legends. */
const KEYS_TEXT = "13px system-ui, sans-serif";

/** `scene` is the canvas image; visible content of `keys` is drawn beside it. */
async function composePicture(scene, keys) {
  const image = await createImageBitmap(scene);
  const host = byId("scene").getBoundingClientRect();
  const density = image.width / host.width;
  const box = keys.hidden ? { width: 0, height: 0 } : keys.getBoundingClientRect();
  const below = box.width > 0 && box.top >= host.bottom - 1;
  const canvas = make("canvas");
  canvas.width = image.width + (below ? 0 : Math.round(box.width * density));
  canvas.height = image.height + (below ? Math.round(box.height * density) : 0);
  const context = canvas.getContext("2d");
  const style = getComputedStyle(keys);
  context.fillStyle = getComputedStyle(document.documentElement).getPropertyValue("--ground");
  context.fillRect(0, 0, canvas.width, canvas.height);
  context.drawImage(image, 0, 0);
  context.scale(density, density);
  context.translate(-host.left, -host.top);
  Object.assign(context, { font: KEYS_TEXT, textBaseline: "middle", fillStyle: style.color });
  if (box.width > 0) drawKeys(context, keys, style.color);
  return new Promise((done) => canvas.toBlob(done, "image/png"));
}

function drawKeys(context, keys, ink) {
  for (const bar of keys.querySelectorAll("canvas")) {
    const { left, top, width, height } = bar.getBoundingClientRect();
    if (width > 0) context.drawImage(bar, left, top, width, height);
  }
  for (const swatch of keys.querySelectorAll("i")) {
    const { left, top, width, height } = swatch.getBoundingClientRect();
    context.fillStyle = getComputedStyle(swatch).backgroundColor;
    context.fillRect(left, top, width, height);
  }
  context.fillStyle = ink;
  for (const element of keys.querySelectorAll("figcaption, li span")) {
    const { left, top, height, width } = element.getBoundingClientRect();
    if (width > 0) context.fillText(element.textContent, left, top + height / 2, width);
  }
}
