// Line segments with a width in pixels: seams, crosses, highlights; and a wireframe of thin ones.
//
// Every segment has its own two triangles instead of being an instance: in software renderers (a browser
// without a graphics card) each instance costs about as much as a whole draw call.

import {
  BufferAttribute,
  BufferGeometry,
  type Color,
  GLSL3,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  ShaderMaterial,
  Vector2,
  type Vector3,
  type WebGLRenderer,
} from 'three';
import type { Solution, Surface } from '../model/types';
import { chainColour } from './seam_marks';
import { triangleSides } from './gathered_attribute';

const vertexShader = /* glsl */ `
in vec3 from;
in vec3 to;
in vec3 tint;
uniform vec2 size; // of the view, in pixels
uniform float width;
out vec2 at; // along the segment and across it, in pixels
flat out float reach;
out vec3 vTint;

// A point behind the eye has no position in the picture: the segment is cut off just in front of it.
void cut(inout vec4 behind, vec4 before) {
  float near = -0.5 * projectionMatrix[3][2] / projectionMatrix[2][2];
  behind.xyz = mix(before.xyz, behind.xyz, (near - before.z) / (behind.z - before.z));
}

void main() {
  vec4 a = modelViewMatrix * vec4(from, 1.0);
  vec4 b = modelViewMatrix * vec4(to, 1.0);
  if (projectionMatrix[2][3] == -1.0) {
    if (a.z < 0.0 && b.z >= 0.0) cut(b, a);
    else if (b.z < 0.0 && a.z >= 0.0) cut(a, b);
  }
  a = projectionMatrix * a;
  b = projectionMatrix * b;
  a.xyz /= a.w;
  b.xyz /= b.w;
  vec2 along = 0.5 * size * (b.xy - a.xy);
  reach = length(along);
  along = reach > 0.0 ? along / reach : vec2(1.0, 0.0);
  bool isEnd = (gl_VertexID & 2) != 0;
  float beyond = isEnd ? 0.5 * width : -0.5 * width;
  float side = (gl_VertexID & 1) != 0 ? 0.5 * width : -0.5 * width;
  at = vec2(isEnd ? reach + beyond : beyond, side);
  vec3 place = isEnd ? b.xyz : a.xyz;
  place.xy += 2.0 * (along * beyond + vec2(-along.y, along.x) * side) / size;
  gl_Position = vec4(place, 1.0);
  vTint = tint;
}`;

const fragmentShader = /* glsl */ `
in vec2 at;
flat in float reach;
in vec3 vTint;
uniform float width;
uniform vec3 colour;
uniform bool isTinted;
layout(location = 0) out vec4 seen;
void main() {
  float beyond = max(max(-at.x, at.x - reach), 0.0); // the ends are round
  if (beyond * beyond + at.y * at.y > 0.25 * width * width) discard;
  seen = linearToOutputTexel(vec4(isTinted ? vTint : colour, 1.0));
}`;

const corners = [0, 2, 1, 1, 2, 3]; // of the two triangles of one segment

/** Three out of every `step` numbers, repeated for the four corners of a segment. */
function fourTimes(values: ArrayLike<number>, step: number, from: number): BufferAttribute {
  const count = values.length / step;
  const out = new Float32Array(12 * count);
  for (let s = 0, at = 0; s < count; s++) {
    const x = values[step * s + from];
    const y = values[step * s + from + 1];
    const z = values[step * s + from + 2];
    for (let corner = 0; corner < 4; corner++) {
      out[at++] = x;
      out[at++] = y;
      out[at++] = z;
    }
  }
  return new BufferAttribute(out, 3);
}

function flatColours(colours: Color[]): Float32Array {
  const flat = new Float32Array(3 * colours.length);
  for (let i = 0; i < colours.length; i++) colours[i].toArray(flat, 3 * i);
  return flat;
}

function geometryOf(points: ArrayLike<number>, colours: Color[] | undefined): BufferGeometry {
  const geometry = new BufferGeometry();
  const count = points.length / 6;
  geometry.setAttribute('from', fourTimes(points, 6, 0));
  geometry.setAttribute('to', fourTimes(points, 6, 3));
  if (colours) geometry.setAttribute('tint', fourTimes(flatColours(colours), 3, 0));
  const index = new Uint32Array(6 * count);
  for (let s = 0, at = 0; s < count; s++) {
    for (let corner = 0; corner < 6; corner++) index[at++] = 4 * s + corners[corner];
  }
  geometry.setIndex(new BufferAttribute(index, 1));
  return geometry;
}

/** Moves an object slightly towards the eye, so that it is in front of the surface at the same place in the picture. */
function lift(thing: Mesh | LineSegments, eye: Vector3, by: number): void {
  thing.scale.setScalar(1 - by);
  thing.position.copy(eye).multiplyScalar(by);
}

export class Lines extends Mesh<BufferGeometry, ShaderMaterial> {
  constructor(width: number, options: { depth?: boolean; order?: number; bias?: number } = {}) {
    const uniforms = {
      size: { value: new Vector2(1, 1) },
      width: { value: width },
      colour: { value: undefined as Color | undefined },
      isTinted: { value: false },
    };
    const material = new ShaderMaterial({
      glslVersion: GLSL3,
      vertexShader,
      fragmentShader,
      uniforms,
      depthTest: options.depth ?? true,
      depthWrite: false,
    });
    if (options.bias) {
      material.polygonOffset = true;
      material.polygonOffsetFactor = -options.bias;
      material.polygonOffsetUnits = -options.bias;
    }
    super(new BufferGeometry(), material);
    this.renderOrder = options.order ?? 2;
    this.frustumCulled = false;
    this.visible = false;
    this.onBeforeRender = (renderer: WebGLRenderer) => renderer.getSize(uniforms.size.value);
  }

  lift(eye: Vector3, by: number): void {
    lift(this, eye, by);
  }

  /** Sets the segments as pairs of points, with one colour for all or one per segment. */
  set(points: ArrayLike<number>, colours: Color | Color[]): void {
    this.geometry.dispose();
    this.visible = points.length > 0;
    const isTinted = Array.isArray(colours);
    this.geometry = geometryOf(points, isTinted ? colours : undefined);
    this.material.uniforms.isTinted.value = isTinted;
    this.material.uniforms.colour.value = isTinted ? colours[0] : colours;
    this.material.uniformsNeedUpdate = true;
  }
}

/** The edges of all triangles, one pixel wide. */
export class Wire extends LineSegments<BufferGeometry, LineBasicMaterial> {
  constructor(order: number, hasDepth: boolean) {
    super(new BufferGeometry(), new LineBasicMaterial({ depthTest: hasDepth, depthWrite: false }));
    this.renderOrder = order;
    this.frustumCulled = false;
    this.visible = false;
  }

  lift(eye: Vector3, by: number): void {
    lift(this, eye, by);
  }

  /** Forgets the triangles. */
  forget(): void {
    this.visible = false;
    this.geometry.dispose();
    this.geometry = new BufferGeometry();
  }

  /** Shares the corners of the triangles' geometry. */
  set(triangles: BufferGeometry, colour: Color): void {
    this.visible = true;
    this.material.color.copy(colour);
    const position = triangles.getAttribute('position');
    if (this.geometry.getAttribute('position') === position) return;
    this.geometry.dispose();
    this.geometry = new BufferGeometry().setAttribute('position', position);
    this.geometry.boundingSphere = triangles.boundingSphere;
    this.geometry.setIndex(triangleSides(position.count));
  }
}

/** Seams on the surface: one segment per seam edge. */
export function seamsOnSurface(surface: Surface, { seams, chains, result }: Solution) {
  const points = new Float32Array(6 * seams.length);
  seams.forEach(({ a }, s) => {
    a.forEach((end, k) => {
      const v = 3 * result.uvToVertex[end];
      for (let i = 0; i < 3; i++) points[6 * s + 3 * k + i] = surface.places[v + i];
    });
  });
  return { points, colours: seams.map((_, s) => chainColour(chains[s])) };
}

/** Both sides of every seam edge, in the same colour. */
export function seamsInMap({ seams, chains, result: { uv } }: Solution) {
  const points = new Float32Array(12 * seams.length);
  const colours: Color[] = [];
  let at = 0;
  for (let s = 0; s < seams.length; s++) {
    const { a, b } = seams[s];
    const colour = chainColour(chains[s]);
    for (const side of [a, b]) {
      for (const end of side) {
        points[at++] = uv[2 * end];
        points[at++] = uv[2 * end + 1];
        points[at++] = 0.001;
      }
      colours.push(colour);
    }
  }
  return { points, colours };
}
