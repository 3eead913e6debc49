// The picture of two by two tiles that a grid as material is made of: a file beside the page.

export async function gridImage(): Promise<Uint8Array> {
  const response = await fetch('./grid.png');
  if (!response.ok) throw new Error(`The grid image could not be read (${response.status}).`);
  return new Uint8Array(await response.arrayBuffer());
}
