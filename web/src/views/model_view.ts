// The 3D view: surface, pattern, overlay, seams, cones, cursor, highlight; before and after.

import {
  BufferGeometry,
  type Intersection,
  Matrix3,
  Mesh,
  PerspectiveCamera,
  type Ray,
  Raycaster,
  Vector2,
  Vector3,
} from 'three';
import type { MeshBVH } from 'three-mesh-bvh';
import type { QuadShape } from '../model/quad_shape';
import type { LiveMap } from '../model/live';
import type { Cone, Prescription } from '../model/prescription';
import { isAligned, tilesPerUnit } from '../model/grid';
import type { ScenePart, SerializedBvh } from '../model/scene';
import type { Look, Solution, Surface } from '../model/types';
import { Orbit, type Shape } from './camera';
import { CanvasView, nearestOf, type Hit } from './canvas_view';
import { ContactShadow } from './contact_shadow';
import { ConeMarkers, type Marker } from './cone_markers';
import { bvhAtOnce, bvhFrom, pickGeometry, setTint, surfaceGeometry } from './corner_geometry';
import type { OwnInstance, OwnScene } from './gltf_scene';
import { hiding } from './hiding';
import { LiveGeometry } from './live_geometry';
import {
  setImage,
  setLight,
  setPalette,
  setPattern,
  surfaceMaterial,
  type Palette,
  withoutPattern,
} from './pattern_material';
import { QuadsView } from './quads_view';
import { drawWhenUploaded } from './sliced_uploads';
import { StudioLight } from './studio_light';
import { placeOf, SurfaceMarks } from './surface_marks';
import { shapeOf, WholeScene, type SceneContent } from './whole_scene';

type Place = { clientX: number; clientY: number };

export class ModelView extends CanvasView {
  readonly camera = new PerspectiveCamera(32, 1, 0.01, 100);
  readonly orbit: Orbit;
  readonly #toStudio = new Matrix3();
  readonly #mesh = new Mesh(new BufferGeometry(), surfaceMaterial(true, this.#toStudio));
  readonly #markers = new ConeMarkers(true);
  readonly #ghost = new ConeMarkers(false, 12);
  readonly marks = new SurfaceMarks();
  readonly #quads = new QuadsView(this.#toStudio);
  readonly #studio: StudioLight;
  readonly #live = new LiveGeometry(false);
  #surface?: Surface;
  #solution?: Solution;
  #bvh?: MeshBVH;
  #image?: ImageBitmap;
  readonly #shadow = new ContactShadow();
  readonly #others = new WholeScene(this.#toStudio);
  #original?: OwnScene;
  /** The instance of the open mesh in it. */
  #ownOpen?: OwnInstance;
  #isOriginalShown = false;
  /** Fraction of the width, from the left, in which the original model is shown. */
  #wipe = 0;

  constructor(canvas: HTMLCanvasElement) {
    super(canvas);
    this.scene.add(this.#mesh, this.#others, this.#shadow, this.#quads);
    this.scene.add(this.marks, this.#markers, this.#ghost);
    this.#mesh.visible = false;
    this.#mesh.frustumCulled = false; // it is nearly always visible
    this.#ghost.setStyle(1.1, 0.75);
    this.#studio = new StudioLight(this.renderer, this.scene, this.#toStudio);
    this.beforeDraw(() => {
      this.#studio.turn(this.camera, this.orbit.controls.target);
      this.marks.lift(this.camera.position, this.orbit.lift);
    });
    this.orbit = new Orbit(this.camera, canvas, () => this.draw());
  }

  protected onResize(width: number, height: number): void {
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.orbit.reshaped();
  }

  protected override onRestored(): void {
    this.#studio.restore();
  }

  /** Shows a surface and its solution. What is new is framed with the parts beside it. */
  setModel(
    surface: Surface | undefined,
    solution: Solution | undefined,
    { parts, isSameFile }: { parts: readonly ScenePart[]; isSameFile: boolean },
  ): void {
    if (surface === this.#surface && solution === this.#solution) return;
    const isNew = surface !== this.#surface;
    this.#surface = surface;
    this.#solution = solution;
    this.#live.restore();
    const before = this.#mesh.geometry;
    this.marks.hide(isNew);
    if (isNew) [this.#ghost.visible, this.#bvh] = [false, undefined];
    if (!surface) {
      this.#mesh.geometry = new BufferGeometry();
      this.#markers.show([]);
    } else {
      this.#mesh.geometry = surfaceGeometry(surface, solution, isNew ? undefined : before);
      this.#mesh.material.uniforms.isMirrored.value = surface.isMirrored;
      for (const markers of [this.#markers, this.#ghost]) markers.setLift(0.08 * surface.radius);
      if (isNew) drawWhenUploaded(this.#mesh);
      if (isNew) this.#frame(surface, parts, isSameFile);
    }
    before.dispose();
    this.#shadow.show(shapeOf(parts)?.places ?? surface?.places);
    this.#showOriginal();
    this.draw();
  }

  #frame(surface: Surface, parts: readonly ScenePart[], isSameFile: boolean): void {
    const own: Shape = { ...surface, center: new Vector3(...surface.center) };
    if (isSameFile) return this.orbit.workOn(own);
    const all = shapeOf(parts);
    this.orbit.frame(all ?? own, all && own);
  }

  /** Shows the meshes beside the open one. */
  setScene(content: SceneContent): void {
    this.#others.show(content);
    this.#ownOpen = this.#original?.instances.get(content.open)?.[0];
    if (content.parts.length > 0) this.#studio.lightMaterials();
    this.#showOriginal();
    this.draw();
  }

  /** Sets the tree for picking on a surface that is too large to build it synchronously. */
  setBvh(surface: Surface, serialized: SerializedBvh): void {
    if (surface === this.#surface) this.#bvh = bvhFrom(serialized, pickGeometry(surface));
  }

  setLook(look: Look, q: number, isStale: boolean, palette: Palette): void {
    const material = this.#mesh.material;
    const surface = this.#surface;
    const solution = this.#solution;
    if (!surface || !solution) setPattern(material, 'plain', { q, scale: 1, isAligned: false });
    else {
      const scale = tilesPerUnit(look, surface, solution);
      setPattern(material, look.pattern, { q, scale, isAligned: isAligned(solution) });
    }
    setPalette(material, palette);
    setLight(look.light);
    this.#studio.isFromSide = look.light === 'side';
    material.uniforms.dim.value = isStale ? 0.65 : 0;
    if (look.image && look.image !== this.#image) setImage(material, (this.#image = look.image));
    this.canvas.dataset.seams = look.seams;
    this.marks.setLook(look, palette, { surface, solution, geometry: this.#mesh.geometry });
    this.draw();
  }

  /** Fades the markers after Run, until cones are edited again. */
  setMarkers(areFaded: boolean): void {
    this.#markers.setStyle(areFaded ? 0.46 : 1, areFaded ? 0.8 : 1);
    this.draw();
  }

  /** Shows a map that is not stored in place of the solution's; undefined: the solution's again. */
  setLive(live: LiveMap | undefined): void {
    this.#live.show(this.#mesh.geometry, live, this.#surface);
    if (live) for (const lines of this.marks.ofMap) lines.visible = false;
    this.draw();
  }

  setOverlay(colours: Uint8Array): void {
    setTint(this.#mesh.geometry, colours);
    this.draw();
  }

  setCrosses(points: Float32Array, palette: Palette): void {
    this.marks.setCrosses(points, palette);
    this.draw();
  }

  setHandles(loops: Float32Array[]): void {
    this.marks.setHandles(loops);
    this.draw();
  }

  /** Sets the model with its own materials, shown instead of the pattern or as the state before. */
  setOriginal(original: OwnScene | undefined, mesh: number, isShown: boolean): void {
    if (original !== this.#original) {
      this.#original?.group.removeFromParent();
      this.#original = original;
      if (original) this.scene.add(original.group);
      if (original) this.#studio.lightMaterials();
      this.#others.setOwn(original?.instances);
    }
    this.#ownOpen = original?.instances.get(mesh)?.[0];
    this.#isOriginalShown = isShown;
    this.#showOriginal();
    this.draw();
  }

  /** Shows quads instead of the model. */
  setQuads(shape: QuadShape | undefined, matrix: readonly number[], palette: Palette): void {
    this.#quads.show(shape, matrix, palette);
    this.#showOriginal();
    this.draw();
  }

  setWipe(part: number): void {
    this.#wipe = part;
    this.draw();
  }

  #showOriginal(): void {
    const isOriginal = !!this.#ownOpen && this.#isOriginalShown && !this.#quads.visible;
    if (this.#ownOpen) this.#ownOpen.visible = isOriginal;
    this.#mesh.visible = this.#surface !== undefined && !isOriginal && !this.#quads.visible;
    this.marks.visible = this.#markers.visible = !this.#quads.visible;
    this.canvas.dataset.original = isOriginal ? 'shown' : 'none';
  }

  /** Draws twice if before and after are shown side by side. */
  protected override render(): void {
    const { renderer, scene, camera } = this;
    if (this.#wipe <= 0 || !this.#solution || this.#quads.visible)
      return renderer.render(scene, camera);
    const { clientWidth: width, clientHeight: height } = this.canvas;
    const split = Math.round(width * this.#wipe);
    renderer.setScissorTest(true);
    renderer.setScissor(split, 0, width - split, height);
    renderer.render(scene, camera);
    const over = [...this.marks.ofMap, this.#markers];
    const wasVisible = over.map(({ visible }) => visible);
    for (const thing of over) thing.visible = false;
    if (this.#ownOpen) {
      this.#ownOpen.visible = true;
      this.#mesh.visible = false;
    }
    renderer.setScissor(0, 0, split, height);
    withoutPattern(this.#mesh.material, () => renderer.render(scene, camera));
    over.forEach((thing, i) => (thing.visible = wasVisible[i]));
    this.#showOriginal();
    renderer.setScissorTest(false);
  }

  setCones({ cones, q }: Prescription, bad: boolean[], selected: number): void {
    const surface = this.#surface;
    if (!surface) return;
    const markers = cones.flatMap(({ vertex, k }, i): Marker[] =>
      vertex < surface.vertexCount
        ? [{ at: placeOf(this.#surface!, vertex), k, q, isSelected: i === selected, isBad: bad[i] }]
        : [],
    );
    this.#markers.show(markers);
    this.draw();
  }

  /** Shows the cone that a click would place. */
  setGhost(cone: Cone | undefined, q = 4): void {
    if (!cone && !this.#ghost.visible) return;
    const at = cone && this.#surface ? placeOf(this.#surface, cone.vertex) : undefined;
    const plain = { isSelected: false, isBad: false };
    this.#ghost.show(cone && at ? [{ at, k: cone.k, q, ...plain }] : []);
    this.canvas.dataset.ghost = cone ? String(cone.k) : '';
    this.draw();
  }

  point(vertex: number): Vector3 {
    return new Vector3(...placeOf(this.#surface!, vertex));
  }

  /** Shows where the keyboard's cursor is; −1: nowhere. */
  setCursor(vertex: number): void {
    this.marks.setCursor(this.#surface, vertex);
    this.draw();
  }

  /** Outlines triangles, and edges given by two vertices. */
  highlight(triangles: number[], edges: [number, number][] = []): void {
    if (this.marks.highlight(this.#surface, triangles, edges)) this.draw();
  }

  #rayOf(event: Place): Ray {
    const { x, y } = this.pointer(event);
    const caster = new Raycaster();
    caster.setFromCamera(new Vector2(x, y), this.camera);
    return caster.ray;
  }

  #onSurface(ray: Ray): Intersection | undefined {
    if (this.#surface) this.#bvh ??= bvhAtOnce(pickGeometry(this.#surface));
    return this.#bvh?.raycastFirst(ray, 2) ?? undefined;
  }

  /** The mesh under a pointer, in front of the open one; −1: none. */
  pickPart(event: Place): number {
    const ray = this.#rayOf(event);
    return this.#others.pick(ray, this.#onSurface(ray)?.distance ?? Infinity);
  }

  /** Shows that a click would choose a mesh; −1: none. */
  pointAt(mesh: number): void {
    if (this.#others.pointAt(mesh)) this.draw();
  }

  /** The front triangle under a pointer, and its vertex nearest to the pointer. */
  pick(event: Place): Hit | undefined {
    const surface = this.#surface;
    if (!surface) return undefined;
    const ray = this.#rayOf(event);
    const hit = this.#onSurface(ray);
    if (hit?.faceIndex === undefined || hit.faceIndex === null) return undefined;
    if (this.#others.pick(ray, hit.distance) >= 0) return undefined;
    const corners = surface.triangles.subarray(3 * hit.faceIndex, 3 * hit.faceIndex + 3);
    const box = this.canvas.getBoundingClientRect();
    return nearestOf(hit.faceIndex, corners, (vertex) => {
      const at = this.toScreen(vertex);
      return Math.hypot(at.x - (event.clientX - box.left), at.y - (event.clientY - box.top));
    });
  }

  /** The position of a vertex in CSS pixels from the corner of the canvas. */
  toScreen(vertex: number): { x: number; y: number } {
    const at = this.point(vertex).project(this.camera);
    const { clientWidth, clientHeight } = this.canvas;
    return { x: ((at.x + 1) / 2) * clientWidth, y: ((1 - at.y) / 2) * clientHeight };
  }

  /** Centres a vertex, or only brings it into view, from a side from which it is seen. */
  lookAt(vertex: number, isCentred = true): void {
    if (!this.#surface) return;
    const [normal, point] = [new Vector3().fromArray(this.#surface.normals, 3 * vertex), this.point(vertex)]; // prettier-ignore
    this.orbit.lookAt(point, normal, hiding(point, (ray) => this.#onSurface(ray)?.distance), isCentred); // prettier-ignore
  }

  /** Centres the point under a pointer. */
  centre(event: Place): void {
    const hit = this.pick(event);
    if (hit) this.lookAt(hit.vertex);
  }
}
