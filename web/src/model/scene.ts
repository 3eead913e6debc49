// The meshes of a file beside the open one, and trees for picking.

/** A tree for picking, as the geometry worker sends it. */
export interface SerializedBvh {
  roots: ArrayBuffer[];
  index: null;
  indirectBuffer: Uint32Array | Uint16Array | null;
}

/** A mesh of a scene as it is drawn beside the open one: corner by corner, in its own coordinates. */
export interface ScenePart {
  readonly mesh: number;
  readonly cornerPositions: Float32Array;
  /** Four bytes per corner, 127 for 1. */
  readonly cornerNormals: Int8Array;
  readonly tree: SerializedBvh;
  /** Whether it belongs to the scene: meshes that no node uses, beside others that one does, are drawn only while open. */
  readonly isPlaced: boolean;
  /** Where the nodes of the file put it, by columns. */
  readonly matrices: readonly (readonly number[])[];
}
