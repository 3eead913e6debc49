// One material for everything: patterns drawn from (u, v) itself, so that they are sharp at any
// scale; overlays as a colour per corner; light from the viewer.

import {
  Color,
  DataTexture,
  DoubleSide,
  GLSL3,
  RepeatWrapping,
  ShaderMaterial,
  SRGBColorSpace,
  Texture,
} from 'three';
import type { Pattern } from '../state/app';

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
uniform int pattern;
uniform int q;
uniform float scale;
uniform float lit;
uniform float dim;
uniform vec3 paper;
uniform vec3 ink;
uniform vec3 second;
uniform sampler2D image;
out vec4 colour;

// Coverage of lines of a given width at whole values of x; fades to its mean where it gets too fine.
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

vec3 shade(vec2 p) {
  if (pattern == 2) { // grid: squares, or triangles where q asks for them
    float c;
    if (q % 3 == 0) {
      c = max(lines(p.y * 2.0 / s3, 0.04), max(lines(p.x - p.y / s3, 0.04), lines(p.x + p.y / s3, 0.04)));
    } else {
      c = max(lines(p.x, 0.05), lines(p.y, 0.05));
    }
    return mix(paper, ink, c);
  }
  if (pattern == 3) {
    float a = fold(p.x * 0.5), b = fold(p.y * 0.5);
    return mix(second, ink, a + b - 2.0 * a * b);
  }
  if (pattern == 4) { // hexagons with their centres on a triangular lattice
    vec2 s = vec2(1.0, s3);
    vec2 a = mod(p, s) - s * 0.5;
    vec2 b = mod(p - s * 0.5, s) - s * 0.5;
    vec2 h = abs(dot(a, a) < dot(b, b) ? a : b);
    float d = 0.5 - max(h.x, h.x * 0.5 + h.y * s3 * 0.5);
    float w = fwidth(p.x) + fwidth(p.y);
    float c = 1.0 - smoothstep(0.05, 0.05 + w, d);
    return mix(paper, ink, mix(c, 0.2, smoothstep(0.4, 1.0, w)));
  }
  if (pattern == 5) {
    float d = length(fract(p) - 0.5);
    float w = fwidth(p.x) + fwidth(p.y);
    float ring = smoothstep(0.30 - w, 0.30, d) - smoothstep(0.40, 0.40 + w, d);
    return mix(paper, ink, mix(ring, 0.22, smoothstep(0.4, 1.0, w)));
  }
  if (pattern == 6) return texture(image, vec2(p.x, p.y)).rgb;
  return paper;
}

void main() {
  vec3 base = shade(vUv * scale);
  base = mix(base, vTint.rgb, vTint.a);
  vec3 n = normalize(vNormal) * (gl_FrontFacing ? 1.0 : -1.0);
  float key = max(dot(n, normalize(vec3(0.35, 0.55, 0.75))), 0.0);
  float fill = 0.5 + 0.5 * n.y;
  float light = mix(1.0, 0.42 + 0.5 * key + 0.16 * fill, lit);
  if (lit > 0.5 && !gl_FrontFacing) light *= 0.55;
  base *= light;
  float grey = dot(base, vec3(0.3, 0.6, 0.1));
  base = mix(base, mix(vec3(grey), paper, 0.55), dim);
  colour = vec4(base, 1.0);
  #include <colorspace_fragment>
}`;

const numbers: Record<Pattern, number> = {
  ...{ plain: 0, material: 0, cross: 1, grid: 2, checker: 3, hex: 4, circles: 5, image: 6 },
};

export interface Palette {
  paper: Color;
  ink: Color;
  second: Color;
}

const blank = new DataTexture(new Uint8Array([200, 200, 200, 255]), 1, 1);
blank.needsUpdate = true;

export function surfaceMaterial(isLit: boolean): ShaderMaterial {
  return new ShaderMaterial({
    glslVersion: GLSL3,
    vertexShader,
    fragmentShader: fragmentShader
      .replace('out vec4 colour;', 'layout(location = 0) out vec4 colour;')
      .replace('#include <colorspace_fragment>', 'colour = linearToOutputTexel(colour);'),
    side: DoubleSide,
    polygonOffset: true,
    polygonOffsetFactor: 1,
    polygonOffsetUnits: 1,
    uniforms: {
      pattern: { value: 0 },
      q: { value: 4 },
      scale: { value: 1 },
      lit: { value: isLit ? 1 : 0 },
      dim: { value: 0 },
      paper: { value: new Color(0xdfe5ec) },
      ink: { value: new Color(0x17324d) },
      second: { value: new Color(0xf5b642) },
      image: { value: blank as Texture },
    },
  });
}

export function setPattern(material: ShaderMaterial, pattern: Pattern, q: number): void {
  material.uniforms.pattern.value = numbers[pattern];
  material.uniforms.q.value = q;
}

export function setPalette(material: ShaderMaterial, { paper, ink, second }: Palette): void {
  Object.assign(material.uniforms, { paper: { value: paper }, ink: { value: ink } });
  material.uniforms.second = { value: second };
}

export function setImage(material: ShaderMaterial, image: ImageBitmap): void {
  const texture = new Texture(image);
  texture.wrapS = texture.wrapT = RepeatWrapping;
  texture.colorSpace = SRGBColorSpace;
  texture.generateMipmaps = true;
  texture.anisotropy = 4;
  texture.needsUpdate = true;
  (material.uniforms.image.value as Texture).dispose();
  material.uniforms.image.value = texture;
}
