/**
 * GPU programs. Camera coordinates: x right, y down, z forward, also for the lights: one at the camera, one above left,
 * and ambient light, as in rendered images.
 * Alpha of drawn elements selects eye-dome lighting (Boucheny, thesis, Grenoble 2009, chapter 4), used for unlit
 * points; for transparent elements, drawn last, it is the opacity.
 */
const TO_CLIP = `
uniform mat4x3 to_camera;
uniform vec4 lens;
uniform vec2 depth_of;
uniform bool parallel;
vec4 clip(vec3 p) {
  float w = parallel ? 1.0 : p.z;
  return vec4(lens.xy * p.xy + lens.zw * w, depth_of.x * p.z + depth_of.y, w);
}
`;

const LIGHT = `
uniform int lit;
uniform bool paint_normals;
uniform bool from_afar;
uniform float opacity;
uniform mat3 to_world;
vec4 look(vec3 color, vec3 normal, vec3 point, float relief) {
  float size = length(normal);
  if (size > 0.0) {
    normal /= size;
    float cosine = dot(normal, from_afar ? vec3(0.0, 0.0, 1.0) : normalize(point));
    if (paint_normals) {
      color = 0.5 + 0.5 * (to_world * normal);
    } else if (lit == 1) {
      float side = dot(normal, vec3(0.45, 0.65, 0.612));
      if (cosine < 0.0) side = -side;
      color *= 0.34 + 0.36 * abs(cosine) + 0.38 * max(side, 0.0);
    }
  }
  return vec4(color, opacity < 1.0 ? opacity : relief);
}
`;

const SOLID_VERTEX = `
precision highp float;
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 color;
layout(location = 3) in vec2 uv;
${TO_CLIP}
uniform mat3 normal_to_camera;
uniform float size;
uniform bool metric;
uniform vec2 sizes;
out vec3 v_place;
out vec3 v_normal;
out vec3 v_color;
out vec2 v_uv;
flat out float v_size;
void main() {
  v_place = to_camera * vec4(position, 1.0);
  v_normal = normal_to_camera * normal;
  v_color = color;
  v_uv = uv;
  gl_Position = clip(v_place);
  v_size = metric ? clamp(size / max(gl_Position.w, 1e-12), sizes.x, sizes.y) : size;
  gl_PointSize = v_size;
}
`;

const POINT_FRAGMENT = `
precision highp float;
in vec3 v_place;
in vec3 v_normal;
in vec3 v_color;
flat in float v_size;
uniform float relief;
${LIGHT}
out vec4 result;
void main() {
  vec2 from_middle = 2.0 * gl_PointCoord - 1.0;
  if (v_size > 2.5 && dot(from_middle, from_middle) > 1.0) discard;
  result = look(v_color, v_normal, v_place, relief);
}
`;

const FACE_FRAGMENT = `
precision highp float;
in vec3 v_place;
in vec3 v_normal;
in vec3 v_color;
in vec2 v_uv;
uniform bool flat_faces;
uniform bool textured;
uniform sampler2D image;
${LIGHT}
out vec4 result;
void main() {
  vec3 face = cross(dFdx(v_place), dFdy(v_place));
  if (dot(face, from_afar ? vec3(0.0, 0.0, 1.0) : v_place) > 0.0) face = -face;
  vec3 color = textured ? texture(image, v_uv).rgb : v_color;
  result = look(color, flat_faces ? face : v_normal, v_place, 0.0);
}
`;

// A segment is a strip of two triangles of the requested screen width, clipped behind the camera:
// a strip with corners there would fan out.
const LINE_VERTEX = `
precision highp float;
layout(location = 0) in vec3 a;
layout(location = 1) in vec3 b;
layout(location = 2) in vec3 color;
layout(location = 3) in vec3 color_b;
${TO_CLIP}
uniform float near;
uniform float lift;
uniform float size;
uniform vec2 window;
out vec3 v_color;
void main() {
  int corner = gl_VertexID;
  vec3 p = to_camera * vec4(a, 1.0);
  vec3 q = to_camera * vec4(b, 1.0);
  bool hidden = p.z < near && q.z < near;
  if (p.z < near && !hidden) p = mix(p, q, (near - p.z) / (q.z - p.z));
  if (q.z < near && !hidden) q = mix(q, p, (near - q.z) / (p.z - q.z));
  vec4 start = clip(p);
  vec4 end = clip(q);
  vec2 along = (end.xy / end.w - start.xy / start.w) * window;
  along = length(along) > 0.0 ? normalize(along) : vec2(1.0, 0.0);
  float across = (corner & 1) == 0 ? -1.0 : 1.0;
  float onward = corner < 2 ? -0.5 : 0.5;
  vec4 corner_position = corner < 2 ? start : end;
  corner_position.xy += (vec2(-along.y, along.x) * across + along * onward) * size / window * corner_position.w;
  // a little nearer than the faces that it lies on
  corner_position.z = parallel ? corner_position.z - lift : (depth_of.x + depth_of.y / (corner_position.w * 0.9995)) * corner_position.w;
  gl_Position = hidden ? vec4(0.0, 0.0, 2.0, 1.0) : corner_position;
  v_color = corner < 2 ? color : color_b;
}
`;

const LINE_FRAGMENT = `
precision highp float;
in vec3 v_color;
uniform float opacity;
out vec4 result;
void main() {
  result = vec4(v_color, opacity < 1.0 ? opacity : 0.0);
}
`;

const WHOLE_VERTEX = `
void main() {
  gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0);
}
`;

// Strength, limit and radius of eye-dome lighting as in rendered images (kernels/drawing/shading.py).
// For parallel rays, depths are compared relative to the depth of the pivot.
const RELIEF_FRAGMENT = `
precision highp float;
precision highp sampler2D;
uniform sampler2D colors;
uniform sampler2D depths;
uniform vec2 depth_of;
uniform bool parallel;
uniform float pivot;
uniform ivec4 box;
uniform int radius;
out vec4 result;
float log_depth(float d) {
  if (parallel) return (2.0 * d - 1.0 - depth_of.y) / depth_of.x / pivot;
  return log(depth_of.y / (2.0 * d - 1.0 - depth_of.x));
}
void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 color = texelFetch(colors, pixel, 0);
  float shade = 1.0;
  if (color.a > 0.0) {
    float depth = log_depth(texelFetch(depths, pixel, 0).r);
    float hidden = 0.0;
    for (int k = 0; k < 8; k++) {
      int cell = k + k / 4;
      ivec2 near = pixel + radius * ivec2(cell % 3 - 1, cell / 3 - 1);
      if (near == clamp(near, box.xy, box.zw)) {
        float d = texelFetch(depths, near, 0).r;
        if (d < 1.0) hidden += clamp(depth - log_depth(d), 0.0, 0.025);
      }
    }
    shade = mix(1.0, exp(-45.0 * 0.125 * hidden), color.a);
  }
  result = vec4(color.rgb * shade, 1.0);
}
`;

// Depths around a pixel as three bytes each, as depths cannot be read back.
const PROBE_FRAGMENT = `
precision highp float;
precision highp int;
precision highp sampler2D;
uniform sampler2D depths;
uniform ivec2 corner;
uniform ivec4 box;
out vec4 result;
void main() {
  ivec2 pixel = clamp(corner + ivec2(gl_FragCoord.xy), box.xy, box.zw);
  uint depth = uint(texelFetch(depths, pixel, 0).r * 16777215.0);
  result = vec4(float(depth >> 16), float((depth >> 8) & 255u), float(depth & 255u), 255.0) / 255.0;
}
`;
