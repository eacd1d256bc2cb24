// Models made by code, so that the page needs no files.
import { BoxGeometry, CylinderGeometry, ExtrudeGeometry, Group, LatheGeometry, Mesh, MeshBasicMaterial, Path, Shape, SphereGeometry, TorusKnotGeometry, Vector2 } from 'three';

const material = new MeshBasicMaterial();

function part(name, geometry, x = 0, y = 0, z = 0) {
  const mesh = new Mesh(geometry, material);
  mesh.name = name;
  mesh.position.set(x, y, z);
  return mesh;
}

function group(...parts) {
  return new Group().add(...parts);
}

function plate(width, height, depth, holes) {
  const shape = new Shape().moveTo(-width / 2, 0).lineTo(width / 2, 0).lineTo(width / 2, height).lineTo(-width / 2, height).closePath();
  for (const [x, y, radius] of holes) shape.holes.push(new Path().absarc(x, y, radius, 0, 2 * Math.PI, true));
  return new ExtrudeGeometry(shape, { depth, bevelEnabled: false, curveSegments: 24 });
}

function bracket() {
  const base = part('base', plate(4, 3, 0.4, [[-1.4, 0.6, 0.25], [1.4, 0.6, 0.25], [-1.4, 2.4, 0.25], [1.4, 2.4, 0.25]]));
  base.rotation.x = -Math.PI / 2;
  const wall = part('wall', plate(4, 2.6, 0.4, [[0, 1.5, 0.7]]), 0, 0.4, -3);
  const rib = part('rib', new ExtrudeGeometry(new Shape().moveTo(0, 0).lineTo(2, 0).lineTo(0, 1.6).closePath(), { depth: 0.3, bevelEnabled: false }), -1.7, 0.4, -2.6);
  rib.rotation.y = -Math.PI / 2;
  const other = rib.clone();
  other.name = 'rib 2';
  other.position.x = 2;
  const shaft = part('shaft', new CylinderGeometry(0.7, 0.7, 3, 48), 0, 1.9, -2.2);
  shaft.rotation.x = Math.PI / 2;
  return group(base, wall, rib, other, shaft);
}

function stairs() {
  const steps = Array.from({ length: 16 }, (_, i) => {
    const step = part(`step ${i + 1}`, new BoxGeometry(1.6, 0.14, 0.55), 1.1 * Math.cos(i * 0.39), 0.32 * i, 1.1 * Math.sin(i * 0.39));
    step.rotation.y = -i * 0.39;
    return step;
  });
  const posts = steps.map((_, i) => part(`post ${i + 1}`, new CylinderGeometry(0.035, 0.035, 1, 12), 1.8 * Math.cos(i * 0.39), 0.32 * i + 0.55, 1.8 * Math.sin(i * 0.39)));
  return group(part('column', new CylinderGeometry(0.22, 0.22, 6.2, 32), 0, 2.6, 0), ...steps, ...posts, part('floor', new CylinderGeometry(2.4, 2.4, 0.2, 64), 0, -0.45, 0));
}

function vase() {
  const profile = [[0, 0], [0.9, 0], [1, 0.1], [1.25, 0.7], [1.2, 1.3], [0.75, 2], [0.55, 2.5], [0.7, 3], [0.6, 3], [0.45, 2.5], [0.65, 2], [1.1, 1.3], [1.12, 0.7], [0.9, 0.18], [0, 0.15]];
  return group(part('vase', new LatheGeometry(profile.map(([x, y]) => new Vector2(x, y)), 72)),
    part('apple', new SphereGeometry(0.55, 48, 32), 1.9, 0.55, 0.6), part('table', new BoxGeometry(6, 0.25, 4), 0.4, -0.125, 0));
}

function knot() {
  return group(part('knot', new TorusKnotGeometry(1.6, 0.5, 240, 32)));
}

export const models = { bracket, stairs, vase, knot };
