// Updates the two views when the document changes: in a fixed order, in a separate task. A failure is reported and does
// not stop the other updates.

import { effect } from '@preact/signals-core';
import { Color } from 'three';
import type { ReadonlyDocument } from '../model/document';
import { isAligned, tilesPerUnit } from '../model/grid';
import { identity } from '../model/matrix';
import type { Model, QuadPreview, Solution } from '../model/types';
import { isCertified } from '../model/verdict';
import type { UiState } from '../model/ui_state';
import type { GeometryClient } from '../services/geometry_client';
import { isGltfModel } from '../formats/glb';
import { cornersAtOnce } from './corner_geometry';
import { disposeScene, loadGltfScene, type OwnScene } from './gltf_scene';
import { isStale, lastConcerns, liveConcern, markersConcern } from './small_concerns';
import type { ModelView } from './model_view';
import type { Palette } from './pattern_material';
import type { UvView } from './uv_view';
import type { PartMap } from './whole_scene';

const palettes: Record<'light' | 'dark', Palette> = {
  light: { paper: new Color('#e9edf2'), ink: new Color('#1d3f63'), second: new Color('#f3b63f') },
  dark: { paper: new Color('#b9c4d0'), ink: new Color('#14304d'), second: new Color('#f0b038') },
};

/** Of meshes that are not open. */
const quietPalettes: typeof palettes = {
  light: { ...palettes.light, paper: new Color('#d5dce4') },
  dark: { ...palettes.dark, paper: new Color('#4a5663') },
};

const maxTime = 8; // milliseconds per task
const maxForMaterials = 300_000; // triangles: for more, the model's materials are shown only on request

export interface ViewSources {
  doc: ReadonlyDocument;
  ui: UiState;
  geometry: GeometryClient;
  model: ModelView;
  uv: UvView;
  /** Called when the surface changes. */
  onSurface: () => void;
}

/** One aspect of the views: what it depends on, and how it is shown. */
interface Concern {
  key(): unknown[];
  show(): unknown;
}

const isSameKey = (a: unknown[] | undefined, b: unknown[]): boolean =>
  a !== undefined && a.every((one, i) => Object.is(one, b[i]));

export class ViewUpdates {
  readonly #in: ViewSources;
  readonly #concerns: Concern[];
  readonly #shown = new Map<Concern, unknown[]>();
  readonly #waiting = new Set<unknown>();
  /** Whether a pass over all concerns is waiting for its first or next task. */
  #isScheduled = false;
  #pass = 0;
  #original?: { of: unknown; scene?: OwnScene };

  constructor(sources: ViewSources) {
    this.#in = sources;
    this.#concerns = [
      this.#models(),
      this.#looks(this.#in.model),
      this.#looks(this.#in.uv),
      this.#overlays(),
      this.#crosses(),
      liveConcern(this.#in.doc, [this.#in.model, this.#in.uv], (view) => this.#showLook(view)),
      this.#cones(),
      markersConcern(this.#in),
      this.#originals(),
      this.#scene(),
      this.#quads(),
      ...lastConcerns(this.#in),
    ];
    effect(() => {
      for (const concern of this.#concerns) concern.key();
      this.#schedule();
    });
  }

  #schedule(): void {
    document.body.dataset.pending = '';
    this.#later(++this.#pass, 0);
  }

  /** Schedules the rest of a pass; a change in the meantime starts a new pass. */
  #later(pass: number, first: number): void {
    this.#isScheduled = true;
    setTimeout(() => pass === this.#pass && this.#updateFrom(pass, first));
  }

  /** Updates one concern after another; if that takes long, the rest follows in another task. */
  #updateFrom(pass: number, first: number): void {
    const begin = performance.now();
    for (let i = first; i < this.#concerns.length; i++) {
      if (performance.now() - begin > maxTime) return this.#later(pass, i);
      this.#update(this.#concerns[i]);
    }
    this.#isScheduled = false;
    this.#settle();
  }

  #update(concern: Concern): void {
    const key = concern.key();
    if (isSameKey(this.#shown.get(concern), key)) return;
    this.#shown.set(concern, key);
    try {
      const done = concern.show();
      if (done instanceof Promise) this.#waitFor(done);
    } catch (error) {
      this.#say(error);
    }
  }

  #waitFor(work: Promise<unknown>): void {
    this.#waiting.add(work);
    void work
      .catch((error: unknown) => this.#say(error))
      .finally(() => {
        this.#waiting.delete(work);
        this.#settle();
      });
  }

  #settle(): void {
    if (!this.#isScheduled && this.#waiting.size === 0) delete document.body.dataset.pending;
  }

  #say(error: unknown): void {
    console.warn(error);
    this.#in.doc.say(`The view could not be updated: ${(error as Error).message}`, 'error');
  }

  get #palette(): Palette {
    return palettes[this.#in.ui.isDark ? 'dark' : 'light'];
  }
  get #q(): number {
    const { displayed, prescription } = this.#in.doc;
    return displayed?.prescription.q ?? prescription.q;
  }

  #models(): Concern {
    const { doc, geometry, model, uv, onSurface } = this.#in;
    let last: unknown;
    let lastFiles: unknown;
    return {
      key: () => [doc.model?.surface, doc.displayed],
      show: () => {
        const surface = doc.model?.surface;
        const solution = doc.displayed;
        const isNew = surface !== last;
        const isSameFile = doc.model !== undefined && doc.model.files === lastFiles;
        [last, lastFiles] = [surface, doc.model?.files];
        if (isNew) onSurface();
        model.setModel(surface, solution, { parts: doc.parts, isSameFile });
        uv.setModel(surface, solution);
        if (!surface || surface.triangles.length <= cornersAtOnce) return undefined;
        const trees: Promise<void>[] = [];
        if (isNew) {
          trees.push(
            geometry.call('surfaceBvh', [surface.id]).then((tree) => model.setBvh(surface, tree)),
          );
        }
        if (solution) {
          trees.push(
            geometry.call('mapBvh', [solution.id]).then((tree) => uv.setBvh(solution, tree)),
          );
        }
        return Promise.all(trees);
      },
    };
  }

  #looks(view: ModelView | UvView): Concern {
    const { doc } = this.#in;
    return {
      key: () => [
        doc.look,
        doc.model?.surface,
        doc.displayed,
        isStale(doc),
        this.#q,
        this.#palette,
      ],
      show: () => this.#showLook(view),
    };
  }

  #showLook(view: ModelView | UvView): void {
    const { doc } = this.#in;
    view.setLook(doc.look, this.#q, isStale(doc), this.#palette);
  }

  #overlays(): Concern {
    const { doc, geometry, model, uv } = this.#in;
    return {
      key: () => [doc.displayed, doc.look.overlay],
      show: async () => {
        const { displayed, look } = doc;
        if (!displayed || (look.overlay === 'none' && !this.#isTinted(displayed))) return;
        const colours = await geometry.call('overlay', [displayed.id, look.overlay]);
        if (doc.displayed !== displayed || doc.look.overlay !== look.overlay) return;
        model.setOverlay(colours);
        uv.setOverlay(colours);
        this.#tinted = displayed;
      },
    };
  }
  #tinted?: Solution;
  /** Whether colours are needed: flipped triangles are red even without an overlay, and old colours must be replaced. */
  #isTinted(solution: Solution): boolean {
    return this.#tinted === solution || solution.distortion.flipped.length > 0;
  }

  #crosses(): Concern {
    const { doc, geometry, model, uv } = this.#in;
    const isShown = (): boolean => doc.look.pattern === 'cross' && doc.look.overlay !== 'flips';
    return {
      key: () => [doc.displayed, isShown(), doc.look.tiles, this.#q, this.#palette],
      show: async () => {
        const { displayed, look } = doc;
        const none = new Float32Array(0);
        if (!displayed || !isShown()) {
          model.setCrosses(none, this.#palette);
          return uv.setCrosses(none, this.#palette);
        }
        const lines = await geometry.call('crosses', [displayed.id, look.tiles, this.#q]);
        if (doc.displayed !== displayed || doc.look.tiles !== look.tiles || !isShown()) return;
        model.setCrosses(lines.onSurface, this.#palette);
        uv.setCrosses(lines.inMap, this.#palette);
      },
    };
  }

  #cones(): Concern {
    const { doc, model, uv } = this.#in;
    return {
      key: () => [
        doc.prescription,
        doc.selected,
        doc.budget,
        doc.model?.surface,
        doc.displayed,
        doc.live,
      ],
      show: () => {
        const bad = doc.budget?.cones.map(({ isGood }) => !isGood) ?? [];
        for (const view of [model, uv]) view.setCones(doc.prescription, bad, doc.selected);
      },
    };
  }

  /** The file from which the model's materials are read: the original or the written one. */
  #originalSource(): { key: unknown; isShown: boolean } | undefined {
    const { doc } = this.#in;
    const { model, displayed, look } = doc;
    if (!model || !isGltfModel(model)) return undefined;
    if (look.pattern === 'material') return { key: displayed ?? model.files, isShown: true };
    const isSmall = model.info.triangles <= maxForMaterials;
    return isSmall ? { key: model.files, isShown: displayed === undefined } : undefined;
  }

  #originals(): Concern {
    const { doc, model: view } = this.#in;
    return {
      key: () => {
        const source = this.#originalSource();
        return [source?.key, source?.isShown];
      },
      show: async () => {
        const source = this.#originalSource();
        const { model, displayed } = doc;
        const old = this.#original;
        const mesh = model?.info.surface ?? 0;
        if (old && old.of === source?.key)
          return view.setOriginal(old.scene, mesh, source!.isShown);
        const own: { of: unknown; scene?: OwnScene } = { of: source?.key };
        this.#original = own;
        view.setOriginal(undefined, mesh, false);
        disposeScene(old?.scene?.group);
        if (!source || !model) return;
        const isWritten = displayed !== undefined && source.key === displayed;
        const file = model.files.get(model.main)!;
        const bytes = file instanceof Blob ? new Uint8Array(await file.arrayBuffer()) : file;
        const written = isWritten ? displayed.files : [{ name: model.main, bytes }];
        const { files, matrix } = model;
        const meshes = doc.parts.length > 0 ? doc.parts : [{ mesh, matrices: [matrix] }];
        try {
          const scene = await loadGltfScene({ written, files, meshes });
          if (this.#original !== own) return disposeScene(scene.group);
          own.scene = scene;
          const open = doc.model?.info.surface ?? mesh;
          view.setOriginal(scene, open, this.#originalSource()?.isShown ?? false);
        } catch (error) {
          // The materials were not requested: the shape without them is shown instead.
          if (doc.look.pattern !== 'material') return;
          doc.say(`The materials cannot be shown: ${(error as Error).message}`, 'error');
        }
      },
    };
  }

  /** The other meshes of the file, with the maps that they have. */
  #scene(): Concern {
    const { doc, model: view } = this.#in;
    return {
      key: () => [doc.parts, doc.model, doc.displayed, doc.meshes, doc.look, this.#palette],
      show: () => {
        const { model, look, displayed } = doc;
        const maps = new Map<number, PartMap>();
        const add = ({ surface, info }: Model, solution: Solution | undefined): void => {
          if (!solution || look.pattern === 'material') return;
          const { prescription, cornerUv } = solution;
          const scale = tilesPerUnit(look, surface, solution);
          const pattern = look.pattern === 'image' ? 'checker' : look.pattern;
          const about = { isAligned: isAligned(solution), isCertified: isCertified(solution) };
          maps.set(info.surface, { cornerUv, pattern, q: prescription.q, scale, ...about });
        };
        for (const { model: waiting, solutions } of doc.meshes.values())
          add(waiting, solutions.at(-1));
        if (model) add(model, displayed);
        const open = model?.info.surface ?? -1;
        const isOwnShown = look.pattern === 'material';
        const palette = quietPalettes[this.#in.ui.isDark ? 'dark' : 'light'];
        view.setScene({ parts: doc.parts, open, maps, isOwnShown, palette });
      },
    };
  }

  #quads(): Concern {
    const { doc, model: view } = this.#in;
    const shown = (): QuadPreview | undefined => {
      const { quads, displayed } = doc;
      return quads?.isShown && quads.of === displayed ? quads : undefined;
    };
    return {
      key: () => [shown(), doc.model, this.#palette],
      show: () => view.setQuads(shown()?.shape, doc.model?.matrix ?? identity, this.#palette),
    };
  }
}
