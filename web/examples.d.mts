export interface Example {
  id: string;
  title: string;
  hint: string;
  q: number;
  file: string;
  triangles: number;
  /** null: suggested by the solver. */
  cones: { vertex: number; k: number }[] | null;
}
export function examples(): (Example & { bytes: Buffer })[];
