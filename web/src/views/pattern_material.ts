// One material for everything: patterns computed from (u, v) in the shader, so that they are sharp at any
// scale; overlays as a colour per corner; lit by the studio.

import {
  Color,
  DataTexture,
  DoubleSide,
  GLSL3,
  Matrix3,
  RepeatWrapping,
  ShaderMaterial,
  SRGBColorSpace,
  Texture,
} from 'three';
import { lights, type Light, type Pattern } from '../model/types';
import { irradiance } from './studio_light';

const vertexShader = /* glsl */ `
in vec4 tint;
out vec2 vUv;
out vec3 vNormal;
out vec3 vEye;
out vec4 vTint;
void main() {
  vUv = uv;
  vTint = tint;
  vec4 eye = modelViewMatrix * vec4(position, 1.0);
  vEye = eye.xyz;
  vNormal = normalMatrix * normal;
  gl_Position = projectionMatrix * eye;
}`;

const fragmentShader = /* glsl */ `
in vec2 vUv;
in vec3 vNormal;
in vec3 vEye;
in vec4 vTint;
uniform int q;
uniform float scale;
uniform float repeat; // number of tiles after which a texture repeats
uniform bool isAligned;
uniform float lit;
uniform float irradiance[9];
uniform mat3 toStudio; // from the coordinates of the eye
uniform int light;
uniform float dim;
uniform bool isMirrored;
uniform vec3 paper;
uniform vec3 ink;
uniform vec3 second;
uniform sampler2D image;
out vec4 colour;

// Coverage of lines of a given width at integer x; fades to its mean where lines are too fine.
float lines(float x, float width) {
  float w = fwidth(x);
  float d = abs(fract(x - 0.5) - 0.5);
  float line = 1.0 - smoothstep(width - w * 0.7, width + w * 0.7, d);
  return mix(line, 2.0 * width, smoothstep(0.35, 0.8, w));
}
float fold(float x) {
  float w = fwidth(x);
  float d = abs(fract(x) - 0.5) - 0.25;
  return mix(smoothstep(-w, w, d), 0.5, smoothstep(0.4, 0.9, w));
}
const float s3 = 1.7320508;

float hash(vec2 c) {
  return fract(sin(dot(c, vec2(127.1, 311.7))) * 43758.5453);
}
// Periodic, so that a texture made of it continues wherever its tiles do.
float noise(vec2 p, vec2 every) {
  vec2 c = floor(p), f = fract(p);
  f = f * f * (3.0 - 2.0 * f);
  vec2 near = mod(c, every), far = mod(c + 1.0, every);
  return mix(mix(hash(near), hash(vec2(far.x, near.y)), f.x), mix(hash(vec2(near.x, far.y)), hash(far), f.x), f.y);
}
// Two courses and one brick length per tile, centred on a brick: invariant under half turns.
vec3 brick(vec2 p) {
  vec2 b = vec2(p.x + 0.5, p.y * 2.0 + 0.5);
  float row = floor(b.y);
  float isOdd = mod(row, 2.0);
  b.x += 0.5 * isOdd;
  vec2 cell = vec2(floor(b.x), row), size = vec2(repeat, 2.0 * repeat);
  vec2 opposite = vec2(isOdd - cell.x, -row);
  float w = fwidth(p.x) + fwidth(p.y);
  vec2 d = vec2(abs(fract(b.x - 0.5) - 0.5), abs(fract(b.y - 0.5) - 0.5) * 0.5);
  float joint = 1.0 - smoothstep(0.025 - w * 0.4, 0.025 + w * 0.7, min(d.x, d.y));
  float grain = noise(p * 24.0, vec2(24.0 * repeat)) + noise(-p * 24.0, vec2(24.0 * repeat)) - 1.0;
  float tone = 0.82 + 0.15 * (hash(mod(cell, size)) + hash(mod(opposite, size)));
  tone += 0.08 * grain * (1.0 - smoothstep(0.02, 0.06, w));
  vec3 clay = vec3(0.44, 0.115, 0.065) * tone;
  return mix(mix(clay, vec3(0.52, 0.49, 0.45), joint), vec3(0.44, 0.16, 0.11), smoothstep(0.4, 1.2, w));
}
vec3 wood(vec2 p) {
  float plank = mod(floor(p.y * 3.0), 3.0 * repeat);
  float w = fwidth(p.x) + fwidth(p.y);
  float place = hash(vec2(plank, 3.0)) * 7.0;
  float grain = noise(vec2(p.x * 1.5 + place, p.y * 26.0), vec2(1.5, 26.0) * repeat);
  grain += 0.5 * noise(vec2(p.x * 4.0 + place, p.y * 70.0), vec2(4.0, 70.0) * repeat);
  float wave = noise(vec2(p.x + place, p.y * 2.0), vec2(1.0, 2.0) * repeat);
  float ring = 0.5 + 0.5 * sin(6.2831853 * (p.y * 5.0 + 0.5 * wave));
  float fine = 1.0 - smoothstep(0.03, 0.15, w);
  vec3 base = mix(vec3(0.36, 0.17, 0.065), vec3(0.56, 0.32, 0.14), 0.5 + fine * (0.35 * grain + 0.25 * ring - 0.45));
  base *= 0.88 + 0.22 * hash(vec2(plank, 9.0));
  float d = abs(fract(p.y * 3.0 - 0.5) - 0.5) / 3.0;
  float gap = 1.0 - smoothstep(0.006, 0.006 + w, d);
  return mix(base, vec3(0.1, 0.05, 0.025), gap * (1.0 - smoothstep(0.1, 0.4, w)));
}
float band(float x, float centre, float half_) {
  float w = fwidth(x);
  float d = abs(fract(x - centre + 0.5) - 0.5);
  return mix(1.0 - smoothstep(half_ - w, half_ + w, d), 2.0 * half_, smoothstep(0.35, 0.9, w));
}
// The same along u and v and symmetric, so that it continues across quarter turns.
vec3 plaid(vec2 p) {
  float a = band(p.x, 0.0, 0.17), b = band(p.y, 0.0, 0.17);
  float c = band(p.x, 0.5, 0.035), d = band(p.y, 0.5, 0.035);
  float e = band(p.x, 0.36, 0.012) + band(p.x, 0.64, 0.012);
  float f = band(p.y, 0.36, 0.012) + band(p.y, 0.64, 0.012);
  vec3 red = vec3(0.42, 0.035, 0.045), navy = vec3(0.025, 0.05, 0.14), gold = vec3(0.86, 0.62, 0.16);
  vec3 colour = mix(red, navy, 0.5 * (a + b));
  colour = mix(colour, gold, 0.5 * (c + d));
  return mix(colour, vec3(0.9), 0.4 * (e + f));
}

// A program for each pattern: where a program has them all, each pixel costs what all of them cost together, because
// software, which draws for virtual machines and in remote sessions, takes every branch.
vec3 shade(vec2 p) {
#if PATTERN == 2 // grid: squares, or triangles for q = 3 and 6
  float c;
  if (q % 3 == 0) {
    c = max(lines(p.y * 2.0 / s3, 0.04), max(lines(p.x - p.y / s3, 0.04), lines(p.x + p.y / s3, 0.04)));
  } else {
    c = max(lines(p.x, 0.05), lines(p.y, 0.05));
  }
  return mix(paper, ink, c);
#elif PATTERN == 3 // centred on a square, which is invariant under quarter turns
  float a = fold(p.x * 0.5), b = fold(p.y * 0.5);
  return mix(second, ink, a + b - 2.0 * a * b);
#elif PATTERN == 4 // hexagons centred on a triangular lattice, stretched to fit squares if aligned
  if (isAligned) p.y *= 0.5 * s3;
  vec2 s = vec2(1.0, s3);
  vec2 a = mod(p, s) - s * 0.5;
  vec2 b = mod(p - s * 0.5, s) - s * 0.5;
  vec2 h = abs(dot(a, a) < dot(b, b) ? a : b);
  float d = 0.5 - max(h.x, h.x * 0.5 + h.y * s3 * 0.5);
  float w = fwidth(p.x) + fwidth(p.y);
  float c = 1.0 - smoothstep(0.05, 0.05 + w, d);
  return mix(paper, ink, mix(c, 0.2, smoothstep(0.4, 1.0, w)));
#elif PATTERN == 5 // circles
  float d = length(fract(p) - 0.5);
  float w = fwidth(p.x) + fwidth(p.y);
  float ring = smoothstep(0.30 - w, 0.30, d) - smoothstep(0.40, 0.40 + w, d);
  return mix(paper, ink, mix(ring, 0.22, smoothstep(0.4, 1.0, w)));
#elif PATTERN == 6
  return texture(image, vec2(p.x, p.y)).rgb;
#elif PATTERN == 7
  return brick(p);
#elif PATTERN == 8
  return wood(p);
#elif PATTERN == 9
  return plaid(p);
#else
  return paper;
#endif
}

// As in studio_light.ts.
float reflected(vec3 n) {
  float c[9] = irradiance;
  return c[0] + c[1] * n.y + c[2] * n.z + c[3] * n.x + c[4] * n.x * n.y + c[5] * n.y * n.z
    + c[6] * (3.0 * n.z * n.z - 1.0) + c[7] * n.x * n.z + c[8] * (n.x * n.x - n.y * n.y);
}

void main() {
  vec3 base = shade(vUv * scale);
  base = mix(base, vTint.rgb, vTint.a);
  vec3 n = normalize(vNormal + vec3(0.0, 0.0, 1e-12));
  // Not where the smooth normal is still on this side: there, at an outline, a triangle behind shows by a pixel, because
  // the offset of depths grows with the slope.
  bool isBack = gl_FrontFacing == isMirrored && n.z < 0.05;
  if (isBack) n = -n;
  float shade = mix(1.0, reflected(toStudio * n), lit);
  if (lit > 0.5 && light == 2) {
    float facing = 0.5 + 0.5 * dot(n, normalize(vec3(0.3, 0.6, 0.75)));
    shade = 0.16 + 0.84 * facing * facing;
    base += 0.4 * pow(max(dot(n, normalize(vec3(0.35, 0.5, 0.8))), 0.0), 36.0);
  }
  if (light == 3) shade = 1.0;
  else if (lit > 0.5 && isBack) shade *= mix(1.0, 0.55, smoothstep(0.0, 0.35, n.z));
  base *= shade;
  float grey = dot(base, vec3(0.3, 0.6, 0.1));
  base = mix(base, mix(vec3(grey), paper, 0.55), dim);
  colour = vec4(base, 1.0);
  #include <colorspace_fragment>
}`;

const numbers: Record<Pattern, number> = {
  plain: 0,
  material: 0,
  cross: 1,
  grid: 2,
  checker: 3,
  hex: 4,
  circles: 5,
  image: 6,
  brick: 7,
  wood: 8,
  plaid: 9,
};

/** Of all surfaces that are lit, as there is one 3D view. */
const sharedLight = { value: 0 };
const noLight = { value: 0 };

export function setLight(light: Light): void {
  sharedLight.value = lights.indexOf(light);
}

export interface Palette {
  paper: Color;
  ink: Color;
  second: Color;
}

const blank = new DataTexture(new Uint8Array([200, 200, 200, 255]), 1, 1);
blank.needsUpdate = true;

/** `toStudio`: shared by all materials of a scene, which turns it. */
export function surfaceMaterial(isLit: boolean, toStudio = new Matrix3()): ShaderMaterial {
  const material = new ShaderMaterial({
    glslVersion: GLSL3,
    vertexShader,
    fragmentShader: fragmentShader
      .replace('out vec4 colour;', 'layout(location = 0) out vec4 colour;')
      .replace('#include <colorspace_fragment>', 'colour = linearToOutputTexel(colour);'),
    defines: { PATTERN: 0 },
    side: DoubleSide,
    polygonOffset: true,
    polygonOffsetFactor: 1,
    polygonOffsetUnits: 1,
    uniforms: {
      q: { value: 4 },
      scale: { value: 1 },
      repeat: { value: 64 },
      isAligned: { value: false },
      lit: { value: isLit ? 1 : 0 },
      irradiance: { value: irradiance },
      toStudio: { value: toStudio },
      light: isLit ? sharedLight : noLight,
      dim: { value: 0 },
      isMirrored: { value: false },
      paper: { value: new Color(0xdfe5ec) },
      ink: { value: new Color(0x17324d) },
      second: { value: new Color(0xf5b642) },
      image: { value: blank as Texture },
    },
  });
  // Attributes that a geometry lacks are not uploaded.
  const absent = { tint: [0, 0, 0, 0], uv: [0, 0], normal: [0, 0, 1] };
  material.defaultAttributeValues = absent as unknown as typeof material.defaultAttributeValues;
  return material;
}

export interface PatternPlace {
  q: number;
  /** Tiles per unit of uv. */
  scale: number;
  /** Tiles continue across every seam: textures then repeat after two tiles, so that they continue as well. */
  isAligned: boolean;
}

function choose(material: ShaderMaterial, number: number): void {
  if (material.defines.PATTERN === number) return;
  material.defines.PATTERN = number;
  material.needsUpdate = true; // the program, which is kept where it was compiled before
}

/** Draws the bare surface with `draw`. */
export function withoutPattern(material: ShaderMaterial, draw: () => void): void {
  const usual = material.defines.PATTERN as number;
  choose(material, 0);
  draw();
  choose(material, usual);
}

export function setPattern(
  material: ShaderMaterial,
  pattern: Pattern,
  { q, scale, isAligned }: PatternPlace,
): void {
  const { uniforms } = material;
  choose(material, numbers[pattern]);
  uniforms.q.value = q;
  uniforms.scale.value = scale;
  uniforms.isAligned.value = isAligned;
  uniforms.repeat.value = isAligned ? 2 : 64;
}

export function setPalette(material: ShaderMaterial, { paper, ink, second }: Palette): void {
  Object.assign(material.uniforms, { paper: { value: paper }, ink: { value: ink } });
  material.uniforms.second = { value: second };
}

export function setImage(material: ShaderMaterial, image: ImageBitmap): void {
  const texture = new Texture(image);
  texture.wrapS = texture.wrapT = RepeatWrapping;
  texture.colorSpace = SRGBColorSpace;
  texture.anisotropy = 4;
  texture.needsUpdate = true;
  (material.uniforms.image.value as Texture).dispose();
  material.uniforms.image.value = texture;
}
