// Where three.js has the nodes of a character that moves: run by character_check.py in a folder with three.js as
// node --input-type=module -e "..." FILE.glb RATE_HZ ANSWER.json
import { readFileSync, writeFileSync } from 'fs';
import { AnimationMixer, Vector3 } from 'three';
import { GLTFLoader } from 'three/examples/jsm/loaders/GLTFLoader.js';

globalThis.self = globalThis;
const [file, rate, answer] = process.argv.slice(1);
const bytes = readFileSync(file);
const gltf = await new GLTFLoader().parseAsync(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length), '');
const mixer = new AnimationMixer(gltf.scene);
const clip = gltf.animations[0];
mixer.clipAction(clip).play();
const nodes = [];
for (let n = 0; n < gltf.parser.json.nodes.length; ++n) nodes.push(await gltf.parser.getDependency('node', n));
const frames = Math.round(clip.duration * rate) + 1;
const places = nodes.map(() => []);
for (let frame = 0; frame < frames; ++frame) {
  mixer.setTime(Math.min(frame / rate, clip.duration * (1 - 1e-9)));
  gltf.scene.updateMatrixWorld(true);
  nodes.forEach((node, n) => places[n].push(node.getWorldPosition(new Vector3()).toArray()));
}
writeFileSync(answer, JSON.stringify({ frames, nodes: places }));
