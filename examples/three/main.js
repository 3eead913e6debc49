// A torus knot from three.js with a checkerboard on seamless texture coordinates, and its seams in red.

import { createClient } from 'hgp';
import { parametrizeGeometry } from 'hgp/three';
import * as THREE from 'three';

/** A repeating checkerboard texture of two by two squares. */
function checkerboard() {
  const texture = new THREE.DataTexture(
    Uint8Array.of(250, 250, 245, 255, 70, 110, 160, 255, 70, 110, 160, 255, 250, 250, 245, 255),
    2,
    2,
  );
  texture.wrapS = texture.wrapT = THREE.RepeatWrapping;
  texture.colorSpace = THREE.SRGBColorSpace;
  texture.needsUpdate = true;
  return texture;
}

const client = await createClient();
const knot = new THREE.TorusKnotGeometry(1, 0.35, 192, 24);
const { geometry, seams, certificate } = await parametrizeGeometry(client, knot, { q: 4 });
client.terminate();

const texture = checkerboard();
texture.repeat.set(6, 6); // squares per unit of the surface
// The surface is drawn slightly farther away, so that the seams are in front of it.
const offset = { polygonOffset: true, polygonOffsetFactor: 2, polygonOffsetUnits: 2 };
const material = new THREE.MeshStandardMaterial({ map: texture, ...offset });
const model = new THREE.Mesh(geometry, material);
seams.material.color.set('crimson');
model.add(seams);

const scene = new THREE.Scene();
scene.background = new THREE.Color('#f4f4f2');
scene.add(model, new THREE.HemisphereLight('white', '#999999', 3));
const camera = new THREE.PerspectiveCamera(40, innerWidth / innerHeight, 0.1, 50);
camera.position.set(0, 0, 6);
const renderer = new THREE.WebGLRenderer({
  canvas: document.querySelector('canvas'),
  antialias: true,
});
renderer.setPixelRatio(devicePixelRatio);
renderer.setSize(innerWidth, innerHeight, false);
renderer.setAnimationLoop((milliseconds) => {
  if (!matchMedia('(prefers-reduced-motion: reduce)').matches) {
    model.rotation.y = milliseconds / 4000;
  }
  renderer.render(scene, camera);
});

const verdict = certificate.certified ? 'certified' : 'not certified';
document.querySelector('p').textContent =
  `${certificate.triangles} triangles, ${certificate.seamEdges} seam edges: ${verdict}`;
document.title = verdict;
