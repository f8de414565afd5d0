/** Images on triangles: PNG or JPEG, decoded asynchronously; until then the surface has its plain color. */
class Texture {
  /** `changed` is called when the image is ready. */
  constructor(gl, bytes, changed) {
    Object.assign(this, { gl, texture: null, bytes: 0, released: false });
    this.ready = this.read(bytes).then(changed, () => changed()); // invalid images leave the plain color
  }

  async read(bytes) {
    const { gl } = this;
    const plain = { premultiplyAlpha: "none", colorSpaceConversion: "none" };
    let bitmap = await createImageBitmap(new Blob([bytes]), plain);
    const maxSize = gl.getParameter(gl.MAX_TEXTURE_SIZE);
    const share = maxSize / Math.max(bitmap.width, bitmap.height);
    if (share < 1) {
      const size = { resizeWidth: Math.floor(bitmap.width * share), resizeHeight: Math.floor(bitmap.height * share) };
      const smaller = await createImageBitmap(bitmap, { ...size, resizeQuality: "high" });
      bitmap.close();
      bitmap = smaller;
    }
    if (!this.released && !gl.isContextLost()) this.send(bitmap);
    bitmap.close();
  }

  /** The first image row is at v = 0. */
  send(bitmap) {
    const { gl } = this;
    this.texture = gl.createTexture();
    gl.activeTexture(gl.TEXTURE2);
    gl.bindTexture(gl.TEXTURE_2D, this.texture);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA8, gl.RGBA, gl.UNSIGNED_BYTE, bitmap);
    gl.generateMipmap(gl.TEXTURE_2D);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.LINEAR_MIPMAP_LINEAR);
    const smooth = gl.getExtension("EXT_texture_filter_anisotropic");
    if (smooth) gl.texParameterf(gl.TEXTURE_2D, smooth.TEXTURE_MAX_ANISOTROPY_EXT, 8);
    this.bytes = Math.round((bitmap.width * bitmap.height * 4 * 4) / 3);
  }

  free() {
    this.released = true;
    if (this.texture) this.gl.deleteTexture(this.texture);
    this.texture = null;
  }
}
