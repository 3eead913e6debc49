// GLB and JSON text taken apart and put together, without any library.

export const chunkType = { json: 0x4e4f534a, bin: 0x004e4942 };

/** @returns {{text: string, bin?: Uint8Array, others: {type: number, bytes: Uint8Array}[]}} */
export function openFile(bytes) {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  if (view.getUint32(0, true) !== 0x46546c67) {
    return { text: new TextDecoder().decode(bytes), others: [] };
  }
  const out = { others: [] };
  const says = view.getUint32(8, true); // bytes behind that are no part of the file
  for (let at = 12; at < bytes.length && at !== says;) {
    const length = view.getUint32(at, true);
    const type = view.getUint32(at + 4, true);
    const content = bytes.subarray(at + 8, at + 8 + length);
    if (type === chunkType.json) out.text = new TextDecoder().decode(content);
    else if (type === chunkType.bin) out.bin = content;
    else out.others.push({ type, bytes: content });
    at += 8 + length;
  }
  return out;
}

/** chunks: [type, bytes] in order; lengths are padded to 4. */
export function packChunks(chunks) {
  const parts = [];
  let total = 12;
  for (const [type, content] of chunks) {
    const padded = Math.ceil(content.length / 4) * 4;
    const bytes = new Uint8Array(8 + padded).fill(type === chunkType.json ? 0x20 : 0);
    const view = new DataView(bytes.buffer);
    view.setUint32(0, padded, true);
    view.setUint32(4, type, true);
    bytes.set(content, 8);
    parts.push(bytes);
    total += bytes.length;
  }
  const header = new Uint8Array(12);
  const view = new DataView(header.buffer);
  view.setUint32(0, 0x46546c67, true);
  view.setUint32(4, 2, true);
  view.setUint32(8, total, true);
  return concat([header, ...parts]);
}

export function packGlb(json, bin, others = []) {
  const text = typeof json === 'string' ? json : JSON.stringify(json);
  const chunks = [[chunkType.json, new TextEncoder().encode(text)]];
  if (bin) chunks.push([chunkType.bin, bin]);
  return packChunks([...chunks, ...others]);
}

export function concat(parts) {
  const out = new Uint8Array(parts.reduce((sum, part) => sum + part.length, 0));
  let at = 0;
  for (const part of parts) {
    out.set(part, at);
    at += part.length;
  }
  return out;
}

/** End of the JSON value that starts at `at`. */
function valueEnd(text, at) {
  if (text[at] === '"') {
    for (at += 1; text[at] !== '"'; at += 1) if (text[at] === '\\') at += 1;
    return at + 1;
  }
  if (text[at] !== '{' && text[at] !== '[') {
    while (at < text.length && !',]} \t\r\n'.includes(text[at])) at += 1;
    return at;
  }
  let depth = 0;
  for (; ; at += 1) {
    if (text[at] === '"') at = valueEnd(text, at) - 1;
    else if ('{['.includes(text[at])) depth += 1;
    else if ('}]'.includes(text[at]) && --depth === 0) return at + 1;
  }
}

const skipBlanks = (text, at) => {
  while (' \t\r\n,:\uFEFF'.includes(text[at])) at += 1;
  return at;
};

/** Members of an object text as they are spelled: key → raw value, in order. */
export function rawMembers(text) {
  const out = new Map();
  for (let at = skipBlanks(text, text.indexOf('{') + 1); text[at] !== '}';) {
    const keyEnd = valueEnd(text, at);
    const key = JSON.parse(text.slice(at, keyEnd));
    const begin = skipBlanks(text, keyEnd);
    const end = valueEnd(text, begin);
    out.set(key, text.slice(begin, end));
    at = skipBlanks(text, end);
  }
  return out;
}

/** Elements of an array text as they are spelled. */
export function rawElements(text) {
  const out = [];
  if (text === undefined) return out;
  for (let at = skipBlanks(text, text.indexOf('[') + 1); text[at] !== ']';) {
    const end = valueEnd(text, at);
    out.push(text.slice(at, end));
    at = skipBlanks(text, end);
  }
  return out;
}
