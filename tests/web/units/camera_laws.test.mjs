// Laws of the camera that orbits a model: what stays in the picture, what moves it, and how it goes from place to place.
// Pictures are computed from the camera alone.

import assert from 'node:assert/strict';
import test from 'node:test';
import { PerspectiveCamera, Vector3 } from 'three';
import { randomFrom } from '../../mutation/draw.mjs';
import { Orbit } from '../../../web/src/views/camera.ts';
import { hiding } from '../../../web/src/views/hiding.ts';
import { Canvas, withCanvases } from './canvases.mjs';

const near = (a, b, what, within = 1e-9) =>
  assert.ok(Math.abs(a - b) <= within * Math.max(1, Math.abs(b)), `${what}: ${a} and ${b}`);
const together = (a, b, what, within = 1e-9) => near(a.distanceTo(b), 0, what, within);

function orbitIn(width = 800, height = 600) {
  const camera = new PerspectiveCamera(32, width / height, 0.01, 100);
  const orbit = new Orbit(camera, new Canvas(), () => {});
  const target = () => orbit.controls.target.clone();
  const back = () => camera.position.clone().sub(target());
  /** Where points are in the picture: −1 to 1, the third one in depth. */
  const seen = (...points) => {
    camera.updateMatrixWorld(true);
    return points.map((p) => p.clone().project(camera));
  };
  /** The directions to the right and up in the picture, and towards the viewer. */
  const axes = () => {
    camera.updateMatrixWorld(true);
    return [0, 1, 2].map((i) => new Vector3().setFromMatrixColumn(camera.matrixWorld, i));
  };
  return { camera, orbit, target, back, seen, axes };
}

/** Points of a ball, and what framing is told of them. */
function ball(radius, count = 500, center = new Vector3()) {
  const random = randomFrom(count);
  const points = Array.from({ length: count }, () =>
    new Vector3(random() - 0.5, random() - 0.5, random() - 0.5).setLength(radius).add(center));
  return { points, shape: { center, radius, places: points.flatMap((p) => p.toArray()) } };
} // prettier-ignore

test('nothing of a model is cut off, and its depths are told apart, however near or far, in perspective or parallel', () => {
  for (const size of [0.01, 1, 300]) {
    const { points, shape } = ball(size);
    for (const isParallel of [false, true]) {
      const { orbit, seen, back, axes } = orbitIn();
      orbit.frame(shape);
      if (isParallel) orbit.toggleParallel();
      for (const factor of [1, 0.7, 10, 5]) {
        orbit.move(0.1, 0.1, factor);
        assert.ok(
          seen(...points).every(({ z }) => z > -1 && z < 1),
          `${size} ${isParallel}`,
        );
        // Of the twenty-four bits of a depth buffer, over the depth of the model in a picture that it fills.
        if (factor > 1) continue;
        const apart = axes()[2].multiplyScalar(size / 1000);
        const [{ z: front }, { z: behind }] = seen(apart, apart.clone().negate());
        assert.ok((behind - front) * 2 ** 23 > 2, `${size} ${isParallel}: ${behind - front}`);
      }
      // So near that a hundredth of the model fills the picture.
      if (isParallel) continue;
      orbit.frame(shape);
      orbit.move(0, 0, (0.02 * size) / back().length());
      const [{ z }] = seen(new Vector3().addScaledVector(back(), 0.6));
      assert.ok(z > -1, `${size}: ${z}`);
    }
  }
});

test('what is farther from a model than forty times its size is cut off, so that its depths keep their bits', () => {
  const { orbit, seen, axes } = orbitIn();
  orbit.frame(ball(1).shape);
  const [, , out] = axes();
  const [inside, outside] = seen(...[-30, -60].map((x) => out.clone().multiplyScalar(x)));
  assert.ok(inside.z < 1 && outside.z > 1);
});

test('switching to parallel keeps the centre, its direction and what is there in size and depth, both ways', () => {
  const { orbit, seen, target, back, axes } = orbitIn();
  orbit.frame(ball(1, 500, new Vector3(3, -2, 5)).shape);
  orbit.move(0.7, -0.4, 0.6);
  const middle = target();
  const [right, up] = axes();
  const sizes = () => {
    const [a, b, c] = seen(middle, ...[right, up].map((one) => middle.clone().addScaledVector(one, 0.3))); // prettier-ignore
    return [b.x - a.x, c.y - a.y];
  };
  const [before, from, lifted] = [sizes(), back(), orbit.lift * back().length()];
  orbit.toggleParallel();
  sizes().forEach((x, i) => near(x, before[i], 'size'));
  together(target(), middle, 'centre');
  near(back().angleTo(from), 0, 'direction', 1e-6);
  // Lines are lifted by a share of their distance.
  near(orbit.lift * back().length(), lifted, 'lift');
  // Parallel lines look parallel: what is nearer by the size of the model is hardly larger.
  const [, , out] = axes();
  const [a, b] = seen(out.clone().add(middle), out.clone().add(middle).addScaledVector(right, 0.3));
  near((b.x - a.x) / before[0], 1, 'parallel', 0.02);
  orbit.toggleParallel();
  together(back(), from, 'back again');
});

test('a flat thing fills the picture to its margin of a seventh, wherever it lies, whichever way it is long', () => {
  for (const [width, height] of [
    [900, 600],
    [500, 900],
  ]) {
    // prettier-ignore
    for (const [long, high] of [[1, 1], [5, 0.2], [0.1, 3]]) {
      // prettier-ignore
      const { orbit, seen, axes, target } = orbitIn(width, height);
      orbit.frame(ball(1).shape);
      const [right, up] = axes();
      const center = new Vector3(7, -3, 2);
      // Its centre, as it is told, is not the middle of its points.
      const middle = center.clone().addScaledVector(right, 0.3).addScaledVector(up, -0.1);
      const corners = [[-1, -1], [-1, 1], [1, -1], [1, 1]].map(([x, y]) =>
        middle.clone().addScaledVector(right, x * long).addScaledVector(up, y * high)); // prettier-ignore
      const radius = Math.max(...corners.map((p) => p.distanceTo(center)));
      const places = corners.flatMap((p) => p.toArray());
      orbit.frame({ center, radius, places: [...places, NaN, 0, 0, Infinity, 0, 0] });
      const most = Math.max(...seen(...corners).flatMap(({ x, y }) => [Math.abs(x), Math.abs(y)]));
      near(most, 6 / 7, 'share of the picture', 0.02);
      together(target(), middle, 'in the middle', 0.01 * radius);
    }
  }
});

test('one point, and a model of which no points are known, are framed from a finite distance', () => {
  for (const shape of [
    { center: new Vector3(1, 2, 3), radius: 0, places: [1, 2, 3] },
    { center: new Vector3(1, 2, 3), radius: 2, places: [] },
  ]) {
    const { camera, orbit, seen, target, back } = orbitIn();
    orbit.frame(shape);
    together(target(), shape.center, 'centre');
    const far = back().length();
    assert.ok(far > 2 && far < 20, `${far}`);
    assert.ok(camera.near > 0 && seen(shape.center)[0].z < 1);
    // The ball is in the picture.
    near(Math.sin(Math.atan(Math.tan((16 * Math.PI) / 180))) * far, 1.16 * (shape.radius || 1), 'ball', 1e-6); // prettier-ignore
  }
});

test('framing looks at every point of a small model, and at some tens of thousands of a large one, from all of it', () => {
  const framedFor = (count, odd) => {
    const { orbit, seen } = orbitIn();
    let reads = 0;
    const far = new Vector3(0, 40, 0);
    const places = new Proxy({ length: 3 * count }, {
      get(all, key) {
        if (key === 'length') return all.length;
        reads += 1;
        const [point, i] = [Math.floor(key / 3), key % 3];
        if (odd(point)) return far.getComponent(i);
        return Math.sin((point % 1000) + i);
      },
    }); // prettier-ignore
    orbit.frame({ center: new Vector3(), radius: 1.8, places });
    return { isSeen: Math.abs(seen(far)[0].y) < 1, reads };
  };
  for (const last of [0, 1, 7778, 19_999])
    assert.ok(framedFor(20_000, (v) => v === last).isSeen, `${last} of 20 000`);
  for (const count of [20_001, 400_000, 3_000_000]) {
    // Every part of it, a tenth each.
    const tenth = count / 10;
    for (const part of [0, 4, 9]) {
      const { isSeen, reads } = framedFor(count, (v) => Math.floor(v / tenth) === part);
      assert.ok(isSeen, `${part} of ${count}`);
      assert.ok(reads <= 3 * 3 * 20_000 && reads > 3 * 9000, `${count}: ${reads}`);
    }
  }
});

test('every way of moving the camera counts as moving: the view then stays when the window changes; a click does not', () => {
  const ways = {
    move: ({ orbit }) => orbit.move(0.1, 0),
    pan: ({ orbit }) => orbit.pan(0.1, 0),
    address: ({ orbit }) => orbit.fromText('5,4,3,1,0,0'),
    drag: ({ orbit, camera }) => {
      orbit.controls.dispatchEvent({ type: 'start' });
      camera.position.x += 0.5;
      orbit.controls.update();
      orbit.controls.dispatchEvent({ type: 'end' });
    },
  };
  const nothing = {
    click: ({ orbit }) => ['start', 'end'].forEach((type) => orbit.controls.dispatchEvent({ type })), // prettier-ignore
    afterwards: ({ orbit, camera }) => {
      nothing.click({ orbit });
      camera.position.x += 0.5;
      orbit.controls.update();
    },
    projection: ({ orbit }) => orbit.toggleParallel(),
    address: ({ orbit }) => ['', '1,2,3', '1,2,3,4,5,6,7', 'a,2,3,4,5,6', '1,2,3,4,5,Infinity'].forEach((text) => orbit.fromText(text)), // prettier-ignore
    'all of it again': (one) => Object.values(ways).forEach((way) => (way(one), one.orbit.reset())),
    'fitted again': (one) => Object.values(ways).forEach((way) => (way(one), one.orbit.fit())),
  };
  for (const [isMoved, all] of [
    [true, ways],
    [false, nothing],
  ]) {
    // prettier-ignore
    for (const [name, act] of Object.entries(all)) {
      const one = orbitIn();
      one.orbit.frame(ball(1).shape);
      act(one);
      const before = one.back().length();
      one.camera.aspect = 0.3;
      one.orbit.reshaped();
      assert.equal(one.back().length() > 1.5 * before, !isMoved, name);
    }
  }
});

test('the part that was fitted stays the one that fits when the window changes, until the whole is asked for', () => {
  const { camera, orbit, target, seen } = orbitIn();
  const whole = ball(1);
  const part = ball(0.1, 100, new Vector3(0.5, 0.5, 0));
  orbit.frame(whole.shape, part.shape);
  const isAll = ({ points }) => seen(...points).every(({ x, y }) => Math.abs(x) < 1 && Math.abs(y) < 1); // prettier-ignore
  assert.ok(isAll(whole));
  const middle = target();
  orbit.fit();
  together(target(), part.shape.center, 'at the part', 0.02);
  camera.aspect = 0.4;
  orbit.reshaped();
  together(target(), part.shape.center, 'still', 0.02);
  assert.ok(isAll(part) && !isAll(whole));
  orbit.reset();
  together(target(), middle, 'the whole', 0.05);
  assert.ok(isAll(whole));
});

test('the address has the camera to four digits, in no more characters than that takes', () => {
  const random = randomFrom(9);
  for (let i = 0; i < 30; i++) {
    const one = orbitIn();
    const size = 10 ** (6 * random() - 3);
    const at = () => new Vector3(random() - 0.5, random() - 0.5, random() - 0.5).multiplyScalar(size); // prettier-ignore
    one.orbit.controls.target.copy(at());
    one.camera.position.copy(at());
    const [position, target] = [one.camera.position.clone(), one.target()];
    const text = one.orbit.toText();
    assert.ok(text.length < 6 * 12, text);
    const other = orbitIn();
    other.orbit.fromText(text);
    together(other.camera.position, position, 'position', 1e-4 * size);
    together(other.target(), target, 'target', 1e-4 * size);
  }
});

test('an address that lacks any of its six numbers, or has another word or more of them, moves nothing', () => {
  const words = ['5', '-4.5', '3e-2', '1', '0', '-7'];
  const changed = (act) => {
    const all = [...words];
    act(all);
    return all.join(',');
  };
  const wrong = ['', ' ', 'x', '1x', 'NaN', '-Infinity', '1e999'];
  const texts = words.flatMap((_, i) => [
    changed((all) => all.splice(i, 1)),
    changed((all) => all.splice(i, 0, '2')),
    changed((all) => all.splice(i, 0, '')),
    ...wrong.map((word) => changed((all) => (all[i] = word))),
  ]);
  const { camera, orbit, target } = orbitIn();
  orbit.frame(ball(1).shape);
  const [position, middle] = [camera.position.toArray(), target().toArray()];
  for (const text of [...texts, `${words},`, `,${words}`, words.join(' ')]) {
    orbit.fromText(text);
    assert.deepEqual([camera.position.toArray(), target().toArray()], [position, middle], text);
  }
  orbit.fromText(`${words}`);
  together(camera.position, new Vector3(5, -4.5, 0.03), 'position');
  together(target(), new Vector3(1, 0, -7), 'target');
});

test('turning goes around the target to the right and down, at the same distance, and never over the poles', () => {
  const { camera, orbit, back, target, axes } = orbitIn();
  orbit.frame(ball(1, 500, new Vector3(1, 2, 3)).shape);
  const [right, up] = axes();
  const [from, middle] = [camera.position.clone(), target()];
  const far = back().length();
  orbit.move(0.01, 0);
  const moved = camera.position.clone().sub(from);
  // By radians around the vertical axis.
  near(moved.dot(right), 0.01 * Math.hypot(from.x - middle.x, from.z - middle.z), 'right', 1e-3);
  near(moved.y, 0, 'level');
  const now = camera.position.clone();
  orbit.move(0, 0.01);
  near(camera.position.clone().sub(now).dot(up), -0.01 * far, 'down', 1e-2);
  for (const way of [1, -1]) {
    orbit.move(0, 9 * way);
    near(back().length(), far, 'as far away');
    const steep = back().angleTo(new Vector3(0, -way, 0));
    assert.ok(steep > 0.01 && steep < 0.1, `${steep} from the pole`);
    const before = back();
    orbit.move(0, 9 * way);
    near(back().angleTo(before), 0, 'no farther', 1e-6);
    orbit.move(0, -0.4 * way);
    near(back().angleTo(new Vector3(0, -way, 0)), steep + 0.4, 'back from there', 1e-6);
  }
  together(target(), middle, 'around the target');
  orbit.move(0, 0, 3);
  near(back().length(), 3 * far, 'farther');
});

test('panning shifts the picture by shares of its height in both directions, and turns nothing', () => {
  for (const [x, y] of [
    [0.2, 0],
    [0, 0.3],
    [-0.1, -0.2],
  ]) {
    // prettier-ignore
    for (const isParallel of [false, true]) {
      const { camera, orbit, back, target, seen } = orbitIn(900, 600);
      orbit.frame(ball(1).shape);
      if (isParallel) orbit.toggleParallel();
      const [middle, from] = [target(), back()];
      seen(middle);
      orbit.pan(x, y);
      together(back(), from, 'the same direction and distance');
      const [at] = seen(middle);
      near(at.x * camera.aspect, -2 * x, 'across', 1e-6);
      near(at.y, -2 * y, 'up', 1e-6);
    }
  }
});

test('a place that faces the viewer is looked at from the same direction; one seen at less than some ten degrees from in front', () => {
  for (const [degrees, stays] of [
    [0, true],
    [45, true],
    [80, true],
    [83, false],
    [90, false],
    [135, false],
    [180, false],
  ]) {
    // prettier-ignore
    const { orbit, back, target, axes } = orbitIn();
    orbit.frame(ball(1).shape);
    const [right, , out] = axes();
    const angle = (degrees * Math.PI) / 180;
    const normal = out.clone().multiplyScalar(Math.cos(angle)).addScaledVector(right, Math.sin(angle)); // prettier-ignore
    const [from, point] = [back(), new Vector3(0.2, 0.3, -0.1)];
    withoutMotion(() => orbit.lookAt(point, normal));
    together(target(), point, 'in the middle');
    near(back().length(), from.length(), 'as near as before');
    assert.equal(back().angleTo(from) < 1e-6, stays, `${degrees}`);
    if (!stays) assert.ok(back().angleTo(normal) < 0.5, `${degrees}: from in front`);
    // As everything is at first: from somewhat above.
    if (!stays && degrees < 180)
      assert.ok(back().normalize().y > normal.y + 0.03, `${degrees}: from above`);
    // The vertical stays vertical: never from straight above.
    assert.ok(Math.abs(back().normalize().y) < 0.999);
  }
  const { orbit, back } = orbitIn();
  orbit.frame(ball(1).shape);
  const from = back();
  withoutMotion(() => orbit.lookAt(new Vector3(0.1, 0, 0), new Vector3()));
  together(back(), from, 'what has no sides');
  for (const y of [1, -1]) {
    withoutMotion(() => orbit.lookAt(new Vector3(0, 0.3, 0), new Vector3(0, y, 0)));
    withoutMotion(() => orbit.lookAt(new Vector3(0, 0.3, 0), new Vector3(0, -y, 0)));
    const tilt = back().angleTo(new Vector3(0, -y, 0));
    assert.ok(tilt > 0.1 && tilt < 0.6, `${y}: ${tilt}`);
  }
});

test('of a place that is hidden from in front, sides all around are tried, a third of a right angle or more from its normal', () => {
  const random = randomFrom(4);
  const normals = [[0, 1, 0], [0, -1, 0], [0, 0.95, 0.1], [1, 0, 0], [0, 0, -1]].map((n) => new Vector3(...n)); // prettier-ignore
  for (let i = 0; i < 20; i++) normals.push(new Vector3(random() - 0.5, random() - 0.5, random() - 0.5)); // prettier-ignore
  for (const normal of normals.map((one) => one.normalize())) {
    const { orbit, back } = orbitIn();
    orbit.frame(ball(1).shape);
    const [from, tried] = [back(), []];
    withoutMotion(() => orbit.lookAt(new Vector3(), normal, (side) => !tried.push(side.clone()) || true)); // prettier-ignore
    const around = tried.slice(-8);
    for (const side of around) {
      near(side.length(), from.length(), 'as near as before');
      const off = side.angleTo(normal);
      assert.ok(off > Math.PI / 6 && off < Math.PI / 3, `${off}`);
    }
    // Eight directions, none far from all others.
    const flat = around.map((side) => side.clone().projectOnPlane(normal));
    const across = flat.reduce((sum, one) => sum.add(one), new Vector3()).divideScalar(8);
    const angles = flat.map((one) => {
      const [a, b] = [one.clone().sub(across), flat[0].clone().sub(across)];
      return (Math.atan2(a.clone().cross(b).dot(normal), a.dot(b)) + 7) % (2 * Math.PI);
    }).sort((a, b) => a - b); // prettier-ignore
    angles.forEach((x, i) => {
      const gap = i === 7 ? angles[0] + 2 * Math.PI - x : angles[i + 1] - x;
      assert.ok(gap > 0.4 && gap < 1.2, `${gap}`);
    });
  }
});

test('a place is well in view up to four fifths of the way to the nearest edge, at any depth; else it comes into the middle', () => {
  for (const [width, height] of [
    [800, 600],
    [400, 800],
  ]) {
    // prettier-ignore
    for (const isUp of [false, true])
      for (const depth of [0.4, 1, 1.7])
        for (const [share, stays] of [[0.75, true], [-0.78, true], [0.82, false], [-0.9, false]]) {
          // prettier-ignore
          const { camera, orbit, back, target, axes } = orbitIn(width, height);
          orbit.frame(ball(1).shape);
          const [right, up, out] = axes();
          const far = depth * back().length();
          const edge = far * Math.tan((16 * Math.PI) / 180) * Math.min(1, width / height);
          const point = camera.position.clone().addScaledVector(out, -far).addScaledVector(isUp ? up : right, share * edge); // prettier-ignore
          const [from, middle] = [camera.position.clone(), target()];
          withoutMotion(() => orbit.lookAt(point, new Vector3(), undefined, false));
          const what = `${width} ${isUp} ${depth} ${share}`;
          together(target(), stays ? middle : point, what);
          if (stays) together(camera.position, from, what);
        }
  }
  // Behind the camera nothing is in view.
  const { camera, orbit, back, target } = orbitIn();
  orbit.frame(ball(1).shape);
  const behind = camera.position.clone().addScaledVector(back(), 0.5);
  withoutMotion(() => orbit.lookAt(behind, new Vector3(), undefined, false));
  together(target(), behind, 'behind');
});

/** Where no motion is wanted. */
function withoutMotion(act) {
  const before = Object.getOwnPropertyDescriptor(globalThis, 'matchMedia');
  Object.defineProperty(globalThis, 'matchMedia', { value: () => ({ matches: true }), configurable: true, writable: true }); // prettier-ignore
  try {
    act();
  } finally {
    if (before) Object.defineProperty(globalThis, 'matchMedia', before);
    else delete globalThis.matchMedia;
  }
}

test('the camera glides to a place steadily in a fraction of a second, keeps what the user does meanwhile, then rests', (t) =>
  withCanvases(({ frame }) => {
    let clock = 5000;
    t.mock.method(performance, 'now', () => clock);
    const asked = [];
    globalThis.matchMedia = (query) => ({ matches: (asked.push(query), false) });
    const point = new Vector3(0.6, -0.2, 0.1);
    const normal = new Vector3(-1, 0.2, -0.3).normalize();
    const reached = () => {
      const still = orbitIn();
      still.orbit.frame(ball(1).shape);
      withoutMotion(() => still.orbit.lookAt(point, normal));
      assert.equal(frame(), 0, 'without motion no frames');
      return still.camera.position.clone();
    };
    const goal = reached();
    for (const isPanned of [false, true]) {
      const { camera, orbit, target } = orbitIn();
      orbit.frame(ball(1).shape);
      const [from, start] = [camera.position.clone(), target()];
      orbit.lookAt(point, normal);
      assert.match(asked.pop(), /prefers-reduced-motion: reduce/);
      together(camera.position, from, 'no jump');
      const way = goal.clone().sub(from);
      let [frames, done, added] = [0, 0, new Vector3()];
      for (; frames < 100; frames++) {
        clock += 10;
        const before = camera.position.clone();
        if (frame() === 0) break;
        const step = camera.position.clone().sub(before).length() / way.length();
        assert.ok(step < 0.25 && step > 0, `${step} of the way in a frame`);
        done += step;
        if (isPanned && frames === 3) {
          const there = target();
          orbit.pan(0.2, 0.1);
          added = target().sub(there);
        }
      }
      near(done, 1, 'straight', 1e-6);
      assert.ok(frames >= 5 && frames <= 50, `${10 * frames} milliseconds`);
      together(camera.position, goal.clone().add(added), 'there');
      together(target(), point.clone().add(added), 'there');
      assert.ok(start.distanceTo(target()) > 0.1);
    }
  }));

test('what hides a place is in front of it by two hundredths of the way at least; the triangles around it do not', () => {
  for (const far of [0.1, 3, 500]) {
    const [point, back] = [new Vector3(1, 2, 3), new Vector3(2, -1, 2).setLength(far)];
    const toPlane = (share) => (ray) => {
      // A plane across the way to the camera.
      const away = point.clone().addScaledVector(back, share).sub(ray.origin).dot(ray.direction);
      near(ray.direction.length(), 1, 'distances are those of the ray');
      return away < 0 ? undefined : away;
    };
    const hides = (share) => hiding(point, toPlane(share))(back);
    assert.deepEqual([0, 0.002, 0.02, 0.5, 0.98, 0.999, 1.001, 2].map(hides), [false, false, true, true, true, true, false, false]); // prettier-ignore
  }
  // Neither the place nor the way is changed.
  const [point, back] = [new Vector3(1, 2, 3), new Vector3(0, 0, 2)];
  hiding(point, () => 1)(back);
  assert.deepEqual([point.toArray(), back.toArray()], [[1, 2, 3], [0, 0, 2]]); // prettier-ignore
});
