// As much of JSON Schema as docs/schema uses.
import { readFileSync } from 'node:fs';
import path from 'node:path';

const folder = path.join(import.meta.dirname, '../../docs/schema');
const load = (name) => JSON.parse(readFileSync(path.join(folder, name), 'utf8'));

const isOfType = {
  object: (x) => typeof x === 'object' && x !== null && !Array.isArray(x),
  array: Array.isArray,
  string: (x) => typeof x === 'string',
  number: (x) => typeof x === 'number',
  integer: Number.isInteger,
  boolean: (x) => typeof x === 'boolean',
  null: (x) => x === null,
};

/** Paths where `value` breaks the schema `name` ("hgp-report"); empty when it is fine. */
export function problems(name, value) {
  const root = load(`${name}.schema.json`);
  return check(root, root, value, '');
}

function check(root, schema, value, at) {
  if (schema.$ref?.startsWith('#/$defs/')) {
    return check(root, root.$defs[schema.$ref.slice(8)], value, at);
  }
  if (schema.$ref) {
    const other = load(schema.$ref);
    return check(other, other, value, at);
  }
  if (schema.oneOf) {
    const fits = schema.oneOf.filter((one) => check(root, one, value, at).length === 0);
    return fits.length === 1 ? [] : [`${at}: fits ${fits.length} of oneOf`];
  }
  const types = [schema.type ?? []].flat();
  if (types.length > 0 && !types.some((type) => isOfType[type](value))) {
    return [`${at}: ${JSON.stringify(value)} is not ${types.join(' or ')}`];
  }
  const wrong = [];
  const isObject = isOfType.object(value);
  if ('const' in schema && value !== schema.const) wrong.push(`${at}: not ${schema.const}`);
  if (schema.enum && !schema.enum.includes(value)) wrong.push(`${at}: ${value} is not in the enum`);
  if (value < schema.minimum || value > schema.maximum) wrong.push(`${at}: ${value} out of range`);
  for (const key of isObject ? (schema.required ?? []) : []) {
    if (!(key in value)) wrong.push(`${at}/${key} is missing`);
  }
  for (const [key, part] of Object.entries(isObject ? (schema.properties ?? {}) : {})) {
    if (key in value) wrong.push(...check(root, part, value[key], `${at}/${key}`));
  }
  if (isObject && schema.properties) {
    for (const key of Object.keys(value)) {
      if (!(key in schema.properties)) wrong.push(`${at}/${key} is not documented`);
    }
  }
  if (Array.isArray(value) && schema.items) {
    value.forEach((item, i) => wrong.push(...check(root, schema.items, item, `${at}/${i}`)));
  }
  return wrong;
}
